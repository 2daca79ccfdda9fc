// Plays a trace into a World, call by call. Beside the world it keeps what is placed.
//
// Each answer is held against the model (call_model.h). An error says whether the engine is wrong, or the edit was
// rightly refused. A name that is taken, or unknown, is refused without a call.
#pragma once

#include "oracle/trace/row.h"

#include <lgs/world.h>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tl/expected.hpp>

namespace lgs {
struct BrushResult;
}

namespace lgs::oracle {

/// How often each detour was made (way.h).
using Detours = std::array<std::uint64_t, kDetours>;

/// What a brush did, as edits by hand.
struct Brushed {
  std::vector<Edit> edits;                   ///< removes of what it changed in any way, then adds of what is there now
  std::map<std::string, ScenePolygon> went;  ///< what these removed
  std::vector<std::string> bent;             ///< of those that are removed: what it is said to have bent against law 9
};

/// The engine is wrong.
inline tl::unexpected<TraceError> wrong(std::string text) {
  return tl::unexpected(TraceError{0, std::move(text), {}, true});
}

/// Whether a player may save its world and go on with what it loads. Ids and handles stay, and World::version() does
/// not: for those who follow the changes of one world.
enum class Loads : bool { never, sometimes };

class Player {
 public:
  explicit Player(PreservePairs preserve, Loads loads = Loads::sometimes);

  /// Makes a row, or an edit by itself, that is no commit: there is commit() for that. If it is refused, everything
  /// stays as it was.
  tl::expected<void, TraceError> apply(const Row& row);
  tl::expected<void, TraceError> apply(const Edit& edit) { return apply(rowOf(edit, calls_)); }

  /// Commits, with or without an executor: that of useExecutor(), if it was called since the last commit.
  const Changes& commit();
  void useExecutor(std::uint32_t number) { executor_ = number; }

  World& world() { return caller_.world; }
  const World& world() const { return caller_.world; }
  const CallModel& calls() const { return calls_; }
  const Model& standing() const { return calls_.standing(); }  ///< uncommitted edits included
  Scene scene() const { return standing().scene(preserve_); }
  bool pending() const { return pending_; }  ///< edits since the last commit
  bool isAlive(const std::string& name) const { return standing().isAlive(name); }
  PolygonHandle handleOf(const std::string& name) const { return standing().handleOf(name); }  ///< of a name alive
  const Detours& detours() const { return detours_; }
  const Brushed& brushed() const { return brushed_; }    ///< by the last edit; empty if that was none of a brush
  std::size_t shapes() const { return shapes_.size(); }  ///< the number of different ones that the world has made

 private:
  using Done = tl::expected<void, TraceError>;

  Done detour(const Row& row);
  Done make(const Row& row);
  Done makeCall(const Row& row);
  Done brush(const Edit& edit);
  Done readBack(const Edit& edit, const BrushResult& result);
  Done checkShapes(const Call& call, const Outcome& outcome);
  Done wear(Cell cell, unsigned times);
  std::string badName(const Edit& edit) const;
  tl::unexpected<TraceError> refused(const Error& error) const;

  Caller caller_;
  PreservePairs preserve_;
  CallModel calls_;
  std::map<Shape, ShapeId> shapes_;
  std::set<ShapeId> shapeIds_;
  Brushed brushed_;
  std::size_t brushNames_ = 0;               // that were given to what brushes made
  std::map<std::string, std::size_t> lost_;  // names that brushes have taken away, and the lines of these
  bool pending_ = false;
  std::uint32_t executor_ = 0;
  std::optional<Mark> mark_;
  Loads loads_;
  Detours detours_{};
};

/// Called after each commit; false stops the play.
using CommitCallback = std::function<bool(Player&, const Changes&)>;

/// Plays all of a trace, and commits what is pending at its end. Stops at the first edit that is refused.
tl::expected<void, TraceError> play(const Trace& trace, Player& player, const CommitCallback& afterCommit = {});

}  // namespace lgs::oracle
