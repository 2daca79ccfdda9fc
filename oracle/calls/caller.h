// Makes calls in a world, and remembers what it was given.
#pragma once

#include "oracle/calls/call.h"
#include "oracle/calls/timeline.h"

#include <lgs/brush.h>
#include <lgs/islands.h>
#include <lgs/world.h>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace lgs::oracle {

/// The three lists of changes, without versions, which no two worlds share.
struct ChangeLists {
  std::vector<SegmentId> removed, added, relinked;
  friend bool operator==(const ChangeLists&, const ChangeLists&) = default;
};
inline ChangeLists copyOf(const Changes& c) { return {c.removed, c.added, c.relinked}; }

/// Whether two errors say the same, field by field.
bool areAlike(const Error& a, const Error& b);

/// What a call gave.
struct Outcome {
  std::optional<Error> refusal;
  ShapeId shape;                       ///< that was made for it; the last one, if there are several
  std::vector<PolygonHandle> told;     ///< handles that the call returned, or wrote to where it was told to
  std::vector<PolygonHandle> handles;  ///< of all that it placed
  std::uint64_t count = 0;             ///< that it returned
  ChangeLists changes;                 ///< of a commit, or of a roll-back or redo
  std::vector<Cell> chunks;            ///< that came back, by their lower-left cells
  BrushResult brushed;                 ///< of a brush
  std::vector<Body> bodies;            ///< that were taken
  Foreseen foreseen;                   ///< what would be done
  std::vector<Outcome> parts;          ///< of a group, or of what was foreseen
  friend bool operator==(const Outcome& a, const Outcome& b);
};

/// What a brush is told, and what it does.
Region regionOf(const BrushEdit& brush);
Expected<BrushResult> stroke(World& world, const BrushEdit& brush);

/// A body, moved and turned by whole cells.
Body laid(Body body, const Lies& lies);

/// What holds the islands of a view that foresees.
bool isAnchorOfView(Block block, Cell cell);

class Caller {
 public:
  /// Cells of calls are counted from the origin.
  explicit Caller(World start = World(), Cell origin = {}) : world(std::move(start)), origin_(origin) {}

  static constexpr PolygonHandle kUntouched{7, 7};
  static constexpr std::uint32_t kFar = 3;  ///< places

  Outcome make(const Call& call) { return makeResolved(resolved(call)); }

  /// The same call with the handles that it names and the cells where it is made. A group's calls stay as they are:
  /// what they name depends on those before them.
  Call resolved(const Call& call) const;
  Outcome makeResolved(const Call& call);

  /// Makes a group in another way: `make` makes a part, and says whether it is accepted. Returns whether it is kept.
  bool makeGroup(const Call& call, const std::function<bool(const Call&)>& make);
  /// The same with what is foreseen.
  void foresee(const Call& call, Outcome& out, const std::function<void(const Call&)>& make);

  /// Makes the shapes that a resolved call makes, up to one that is refused, and nothing else. Whether all are made.
  bool makeShapes(const Call& call);

  /// Of the last commit, or of a roll-back or redo: valid until the next one.
  const Changes* changes = nullptr;

  /// The world may be edited beside; then nothing is remembered of it.
  World world;
  std::vector<PolygonHandle> given;  ///< handles of all that was placed, in the order in which that was done
  std::vector<Body> bodies;          ///< that were taken, in that order
  bool hasMarks() const { return timeline_.hasMarks(); }

  struct Remembered {
    Mark mark;
    std::vector<PolygonHandle> given;
    std::vector<Body> bodies;
  };
  const Timeline<Remembered>& timeline() const { return timeline_; }

 private:
  using Bytes = std::vector<std::byte>;

  void place(const Call& call, Outcome& out);
  void addMany(const Call& call, Outcome& out);
  void exchange(const Call& call, Outcome& out);
  void fill(const Call& call, Outcome& out);
  void rollBack(const Call& call, Outcome& out);
  void redo(const Call& call, Outcome& out);
  void remember(const Remembered& moment);
  void load(Outcome& out);
  void unload(const Call& call, Outcome& out);
  void reload(const Call& call, Outcome& out);
  void take(const Call& call, Outcome& out);
  void putBack(const Call& call, Outcome& out);
  bool makeShape(const Call& call, const Coming& coming, Outcome& out);
  void keepLast(Cell cell, std::size_t count, Outcome& out);

  Cell origin_;
  Timeline<Remembered> timeline_;
  std::map<Cell, std::vector<Bytes>> shelf_;  // what chunks were unloaded as, the newest last
};

}  // namespace lgs::oracle
