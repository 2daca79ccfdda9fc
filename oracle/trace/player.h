// Plays a trace into a World, edit by edit or step by step. Beside the world it keeps what is placed.
//
// It is an error without a refusal if the engine accepts an edit but answers it wrongly, for instance with the handle
// of another polygon. So is a name that is taken, or unknown.
#pragma once

#include "oracle/trace/model.h"
#include "oracle/trace/step.h"
#include "oracle/trace/trace.h"

#include <lgs/world.h>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tl/expected.hpp>
#include <unordered_map>

namespace lgs {
struct BrushResult;
}

namespace lgs::oracle {

/// What happened beside the edits, to find out whether anybody notices: how often, by the names that chose it.
struct Detours {
  std::uint64_t saved = 0;      ///< the world was saved, and the one that was loaded took its place
  std::uint64_t undone = 0;     ///< the world was edited wrongly, and went back
  std::uint64_t marked = 0;     ///< a mark was made, to which the world never goes back
  std::uint64_t grouped = 0;    ///< the edit was a group
  std::uint64_t repainted = 0;  ///< a polygon had another block at first
  std::uint64_t unloaded = 0;   ///< chunks with uncommitted edits left memory, and came back

  Detours& operator+=(const Detours& other) {
    saved += other.saved;
    undone += other.undone;
    marked += other.marked;
    grouped += other.grouped;
    repainted += other.repainted;
    unloaded += other.unloaded;
    return *this;
  }
};

/// What a brush did, as edits by hand.
struct Brushed {
  std::vector<Edit> edits;        ///< removes of what it changed in any way, then adds of what is there now
  std::vector<std::string> bent;  ///< of those that are removed: what it is said to have bent against law 9
};

/// An error without a refusal.
inline tl::unexpected<TraceError> wrong(std::string text) { return tl::unexpected(TraceError{0, std::move(text), {}}); }

/// Whether a player may save its world and go on with what it loads. Ids and handles stay, and World::version() does
/// not: for those who follow the changes of one world.
enum class Loads : bool { never, sometimes };

class Player {
 public:
  explicit Player(PreservePairs preserve, Loads loads = Loads::sometimes);

  /// Applies an edit through the door that its name chooses. The edit is no commit: there is commit() for that. If it
  /// is refused, everything stays as it was.
  tl::expected<void, TraceError> apply(const Edit& edit);

  /// The same for all edits of a step, by one call.
  tl::expected<void, TraceError> apply(const Step& step);

  /// Commits, with or without an executor. The name of the edit before it decides that.
  const Changes& commit();

  World& world() { return world_; }
  const World& world() const { return world_; }
  const Model& standing() const { return placed_; }  ///< uncommitted edits included
  Scene scene() const { return placed_.scene(preserve_); }
  bool pending() const { return pending_; }  ///< edits since the last commit
  bool isAlive(const std::string& name) const { return placed_.isAlive(name); }
  PolygonHandle handleOf(const std::string& name) const { return handles_.at(name); }  ///< of a name alive
  Cell cellOf(const std::string& name) const { return placed_.cellOf(name); }
  const Detours& detours() const { return detours_; }
  const Brushed& brushed() const { return brushed_; }    ///< by the last edit; empty if that was none of a brush
  std::size_t shapes() const { return shapes_.size(); }  ///< the number of different ones that the world has made

 private:
  using Shape = std::vector<std::vector<LocalPoint>>;
  using Done = tl::expected<void, TraceError>;
  using Handles = tl::expected<std::vector<PolygonHandle>, TraceError>;

  Done leaveAndComeBack(const Step& step);
  Done inGroup(const Step& step);
  Done make(const Step& step);
  Done add(const Step& step);
  Done remove(const Step& step);
  Done setBlock(const Step& step);
  Done brush(const Edit& edit);
  Done readBack(const Edit& edit, const BrushResult& result);
  Done checkNames(const Step& step) const;
  Handles call(const Step& step, Block block);
  Handles addByPoints(const Step& step, Block block);
  Handles addByShape(const Step& step, Block block);
  Handles fill(const Step& step, Block block);
  Expected<ShapeId> made(const Shape& polygons, std::uint64_t chance);
  tl::expected<ShapeId, TraceError> checked(const Expected<ShapeId>& id, const Shape& shape, Cell cell);
  Done wear(Cell cell, unsigned times);
  PolygonHandle find(const ScenePolygon& polygon) const;
  tl::unexpected<TraceError> refused(const Error& error) const;
  void note(const Edit& add, PolygonHandle handle);
  void forget(const std::string& name);

  World world_;
  PreservePairs preserve_;
  Model placed_;
  std::unordered_map<std::string, PolygonHandle> handles_;
  std::map<Shape, ShapeId> shapes_;
  std::set<ShapeId> shapeIds_;
  Brushed brushed_;
  std::size_t brushNames_ = 0;               // that were given to what brushes made
  std::map<std::string, std::size_t> lost_;  // names that brushes have taken away, and the lines of these
  bool pending_ = false;
  std::uint64_t chance_ = 0;  // of the last step
  std::optional<Mark> mark_;
  Loads loads_;
  Detours detours_;
};

/// Called after each commit; false stops the play.
using CommitCallback = std::function<bool(Player&, const Changes&)>;

/// Plays all of a trace, and commits what is pending at its end. Stops at the first edit that is refused.
tl::expected<void, TraceError> play(const Trace& trace, Player& player, const CommitCallback& afterCommit = {});

}  // namespace lgs::oracle
