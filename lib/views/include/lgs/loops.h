// Loops that live: the closed chains of a world's outline, each with an id, its area and its box, kept up to date at
// the cost of what a commit changed. The view stands beside the world, and the world knows nothing of it:
//
//   lgs::Loops loops(world);                            // walks all segments once
//   if (!loops.update(world, world.commit()))           // and from now on, after each commit
//     loops = lgs::Loops(world);                        // one was missed
//   for (const lgs::LoopPair& p : loops.changes().split) …   // a part of p.from is a new loop: p.into
//   if (world.rollBack(mark)) …                          // and update() likewise, with changesOfRollBack()
//
// A loop with positive area runs around solid ground; it is the outline of an island (islands.h). One with negative
// area runs around a hole. The segments of a loop follow each other by law 2.
//
// Under a preserve relation the loops of a world may be open. The view then follows the outline that the world would
// have without the relation. It keeps that in a second world, outline(), which takes as much memory again, and each
// commit is made there as well. Such a world must follow its cells: World::followCells(true).
//
// A chain that leads into an unloaded chunk (World::unload()) is no loop as long as it does. With AtEdge::open it closes
// along the edge of memory: the view then has a second world as under a preserve relation, in which unloaded ground is
// empty.
//
// Every function is noexcept: when memory runs out the program ends. A copy of a world works with a copy of its view.
// Calls that are const are safe beside each other.
#pragma once

#include <lgs/int128.h>
#include <lgs/unloaded.h>
#include <lgs/world.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace lgs {

/// One loop. Ids are small dense integers. An id stays with its loop until an update reports that the loop is no more;
/// from the next update on it may name another one. Ids are names of the moment: law 12 does not hold for them. After a
/// roll-back the same loop may have another id, and so may the loops of a view that began at another time. Views that
/// begin and go on alike have the same ids everywhere. Zero is null.
struct LoopId {
  std::uint32_t value = 0;                                         ///< good as an index
  constexpr explicit operator bool() const { return value != 0; }  ///< whether it is not null
  friend constexpr auto operator<=>(LoopId, LoopId) = default;
};

/// What is known of a loop.
struct LoopFacts {
  LoopId id;                   ///< its name
  Int128 doubleArea;           ///< twice the signed area in square lattice units, exact: negative for a hole
  std::uint32_t segments = 0;  ///< how many it has
  Point min;                   ///< the lower-left corner of its box
  Point max;                   ///< the upper-right corner of its box
  Point west;                  ///< its westernmost vertex; of several the southernmost
  SegmentId first;             ///< a segment that starts at `west`: to walk from by Segment::successor

  constexpr bool isHole() const { return doubleArea.isNegative(); }  ///< whether it runs around free space
  double area() const;                                               ///< signed, in cells, rounded once
  friend constexpr bool operator==(const LoopFacts&, const LoopFacts&) = default;
};

/// A loop of before, and one of now that has a segment of it.
struct LoopPair {
  LoopId from;  ///< of before
  LoopId into;  ///< of now
  friend constexpr auto operator<=>(const LoopPair&, const LoopPair&) = default;
};

/// What an update did to the loops. It compares the moment before with the moment after, whatever happened between. A
/// segment counts as the same one if it has the same ends, whichever polygon owns it.
///
/// Which loop keeps its id: a loop of before hands it to the loop of now that has most of its segments, of equals to
/// the one whose `west` is least, then the one whose area is least, then the one whose `first` is least. One that is
/// handed several ids takes that of the loop which had most segments, of equals the least id. Only outer loops inherit
/// from outer loops, and only holes from holes.
struct LoopChanges {
  std::vector<LoopId> added;    ///< new ids of loops without any segment of before
  std::vector<LoopId> removed;  ///< ids that are no more, of loops of which no segment is left
  std::vector<LoopId> changed;  ///< ids that stay, of loops whose segments or links are others
  std::vector<LoopPair> split;  ///< `into` is a new id. It is named with each loop of which it has segments
  /// `from` is an id that is no more. It is named with each loop that has segments of it.
  std::vector<LoopPair> joined;
  std::vector<LoopFacts> before;  ///< what all loops were that changed, or that are no more; by id
  std::vector<LoopId> closed;     ///< loops of now with segments of chains that led into unloaded ground before
};

/// The loops of a world. The comment at the top of this file has an example.
class Loops {
 public:
  /// Walks all segments of a world, as of its last commit. Where it has a second world no edit may be pending. Cost: in
  /// proportion to the segments; to the world, where there is a second one.
  explicit Loops(const World& world, AtEdge atEdge = AtEdge::holds) noexcept;
  ~Loops() noexcept;
  Loops(const Loops& other) noexcept;             ///< cost: in proportion to what it knows
  Loops& operator=(const Loops& other) noexcept;  ///< the same
  Loops(Loops&&) noexcept;                        ///< what was moved from can only be assigned to or destroyed
  Loops& operator=(Loops&&) noexcept;             ///< the same

  /// Takes over what the world's last commit or roll-back changed: World::commit() or World::changesOfRollBack(). If
  /// these do not lead from the version() that the view shows, or are made-up lists, or if there is a second world and
  /// the cells are not followed, it stays as it is, and the result is false: then begin again with another view. Cost:
  /// O(k log n) expected, for k segments in the three lists and loops of n segments. A search for the worst commit, among
  /// 160×12 cells, found some 900 basic blocks for a segment; a test holds it below 2,000. Allocates nothing once world
  /// and view have reached their size.
  [[nodiscard]] bool update(const World& world, const Changes& changes) noexcept;

  /// Of the last update. Empty after construction.
  const LoopChanges& changes() const noexcept;

  /// What is known of a loop; nothing, if the id names none. Cost: O(log n) expected, for its first segment.
  std::optional<LoopFacts> loop(LoopId id) const noexcept;

  /// The loop that a segment of outline() is on; null, if the id names none. Cost: O(log n) expected.
  LoopId of(SegmentId segment) const noexcept;

  /// All loops, by id.
  std::vector<LoopId> all() const noexcept;

  /// The world whose segments the loops consist of: `world` itself, which must be the one that is followed. Under a
  /// preserve relation, and with AtEdge::open, it is the second world.
  const World& outline(const World& world) const noexcept;

  /// That of the world's segments which the view shows.
  std::uint64_t version() const noexcept;

  /// How many nodes of trees all updates have visited so far: what tests of the cost count.
  std::uint64_t visited() const noexcept;

  struct Impl;  ///< of the implementation

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace lgs

/// Equal ids have equal hashes.
template <>
struct std::hash<lgs::LoopId> {
  std::size_t operator()(lgs::LoopId id) const noexcept { return std::hash<std::uint32_t>{}(id.value); }
};
