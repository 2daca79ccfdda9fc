// Islands: pieces of ground that hang together. A view beside the world reports, after each commit, which islands were
// cut off, joined, added and removed, and which of them are anchored; takes an island out of the ground as a body, and
// puts one back.
//
//   const auto isBedrock = [](lgs::Block block, lgs::Cell) { return block == kBedrock; };
//   if (!world.followCells(true)) …
//   lgs::Islands islands(world, isBedrock);              // looks at everything once
//   islands.update(world, world.commit());               // and from now on, after each commit or roll-back
//   for (const lgs::IslandId id : islands.loose()) fall(lgs::take(world, islands, id));
//
// Solids that share at least a point are one island (law 3): two blocks that touch with a corner hang together. So an
// island has exactly one outer loop, and a cut shows as one loop that became two, before any look at a cell of the
// part. An island that lies in a hole of another one is a separate island.
//
// The edge of memory: what lies in unloaded chunks (World::unload()), and whatever hangs together with it as their
// borders show, is one island, kBeyond. What anchors it is not known, so it never falls; it is not among all() and has
// no facts. When a chunk leaves, the islands there are reported as joined with it; when it comes back they are reported
// as cut off from it, and loose() names those that nothing anchors. So unload and reload are followed as edits are.
// With AtEdge::open unloaded ground counts as empty instead, in a second world (loops.h): there is no kBeyond, an island
// ends at the edge of memory, and only anchors in memory hold it. What leaves is reported as removed, or as changed.
//
// The view follows loops (loops.h) and has one inside: loops(). What loops.h has on preserve relations, copies, threads
// and memory holds here. Under a preserve relation commit before you unload; and chunks that are unloaded when the view
// begins, or at a roll-back, count as solid, so that what touches their squares is beyond. Where such a chunk comes back
// its islands are reported as added or as cut off: which of the two is not promised.
#pragma once

#include <lgs/body.h>
#include <lgs/loops.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace lgs {

/// One island. What is said of LoopId holds for it.
struct IslandId {
  std::uint32_t value = 0;                                         ///< good as an index
  constexpr explicit operator bool() const { return value != 0; }  ///< whether it is not null
  friend constexpr auto operator<=>(IslandId, IslandId) = default;
};

/// The island of all ground that is unloaded, or hangs together with such ground.
inline constexpr IslandId kBeyond{UINT32_MAX};

/// What is known of an island.
struct IslandFacts {
  IslandId id;                ///< its name
  LoopFacts outer;            ///< its outer loop. The area is with all holes, as they are separate loops
  std::uint64_t anchors = 0;  ///< how many of its polygons are anchors; 0: nothing anchors it
  friend constexpr bool operator==(const IslandFacts&, const IslandFacts&) = default;
};

/// Whether a polygon of this block in this cell anchors its island. It must give the same answer every time, throw
/// nothing and not call back into the world.
using IsAnchor = std::function<bool(Block, Cell)>;

/// An island of before, and one of now.
struct IslandPair {
  IslandId from;  ///< of before
  IslandId into;  ///< of now
  friend constexpr auto operator<=>(const IslandPair&, const IslandPair&) = default;
};

/// What an update did to the islands. It compares the moment before with the moment after. Islands of before and of now
/// *correspond* if the solid of both moments together, one laid upon the other, connects them: what was one, is one, or
/// hangs together by what was removed or added.
///
/// Of islands that correspond the one of now with the largest outer area gets the id of that of before with the
/// largest; of equals it is the one whose `outer.west` is least, then the least LoopId. Each other island keeps its id
/// if its outer loop keeps its id, and if that of the island is not taken. All others of now have new ids.
///
/// kBeyond is there before and after, and is larger than all others. To it corresponds also what was or is in a chunk
/// that was or is unloaded; and what was removed and touched the square of such a chunk. (One that holds nothing may
/// count or not; so may one that was forgotten, until ground is added there, and ground that is not there when its
/// chunk comes back.)
struct IslandChanges {
  std::vector<IslandId> added;    ///< new ids of islands to which none of before corresponds
  std::vector<IslandId> removed;  ///< ids that are no more, of islands to which none of now corresponds
  std::vector<IslandId> changed;  ///< ids that stay, of islands with another outer loop or another count of anchors
  std::vector<IslandPair>
      cutOff;  ///< `into` is a new id. `from` is the largest that corresponds, which keeps an id; or kBeyond
  std::vector<IslandPair> joined;   ///< `from` is no more. `into` is the largest that corresponds; or kBeyond
  std::vector<IslandFacts> before;  ///< what all islands were that changed, or that are no more; by id
};

/// The islands of a world. The comment at the top of this file has an example.
class Islands {
 public:
  /// Looks at all polygons of a world that has no edits that are not committed. If it has some, what the view returns
  /// may be wrong, and nothing worse. Without `isAnchor` nothing is an anchor, and nothing is ever counted. Cost: in
  /// proportion to the world.
  explicit Islands(const World& world, IsAnchor isAnchor = {}, AtEdge atEdge = AtEdge::holds) noexcept;
  ~Islands() noexcept;
  Islands(const Islands& other) noexcept;             ///< cost: in proportion to what it knows
  Islands& operator=(const Islands& other) noexcept;  ///< the same
  Islands(Islands&&) noexcept;                        ///< what was moved from can only be assigned to or destroyed
  Islands& operator=(Islands&&) noexcept;             ///< the same

  /// Takes over what the world's last commit or roll-back changed. To be called once for each commit and roll-back,
  /// before anything else is edited, unloaded or reloaded, for it walks through the ground as it is. Returns false, and
  /// nothing changes, where Loops::update() does so, if the world does not follow its cells, and, but with
  /// AtEdge::open, if it World::hasUncommitted(), as after a roll-back to a mark that was made while edits were pending:
  /// then begin again with another view, after the next commit.
  ///
  /// Cost: that of the loops; the polygons and vertices of the changed cells; the segments in and around those where
  /// polygons were taken away, each with the vertices of these, if that may have cut something off. Of n islands that
  /// were added, removed or changed it is O(n log n), whichever correspond. Where an island was cut, and there is
  /// `isAnchor`, all parts but the largest are walked through. While chunks are unloaded so are all that are cut off
  /// from kBeyond; and, at each update, those that run around an unloaded chunk.
  ///
  /// To know which island a hole, an anchor that changed, or one that joined is of, a ray passes the cells west of it,
  /// up to where it leaves the island; behind a hole it goes on. One update passes no hole twice, and rays of one
  /// height that end at the same wall pass it once, unless another one of that height comes between them. So n rays at
  /// n heights, through w cells each, pass n·w cells.
  ///
  /// A search for the worst commit, in a field of 160×12 cells, found some 1,200 basic blocks for each segment in the
  /// lists, changed cell, edge in these, polygon walked through, and cell of four rows. A test holds it below 2,500.
  [[nodiscard]] bool update(const World& world, const Changes& changes) noexcept;

  /// Of the last update. Empty after construction.
  const IslandChanges& changes() const noexcept;

  /// What is known of an island; nothing, if the id names none. Cost: as of Loops::loop().
  std::optional<IslandFacts> island(IslandId id) const noexcept;

  /// The island that a polygon in a cell is of, as of the last update; null, if there is no such polygon. Of one that
  /// was placed since it may be any, or null. Of one that is unloaded it is kBeyond. Cost: the cells passed to the next
  /// segment in the west, and so on, as in update().
  IslandId of(const World& world, PolygonHandle polygon) const noexcept;

  /// The island of an outer loop; null, if the id names a hole, or nothing.
  IslandId of(LoopId outer) const noexcept;

  /// All islands, by id, but for kBeyond.
  std::vector<IslandId> all() const noexcept;

  /// The islands of now that the last update names and that nothing anchors, by id: both sides of a cut are looked at,
  /// and those that lost an anchor. They may fall. After construction none. Cost: that of island() for each that is
  /// named.
  std::vector<IslandId> loose() const noexcept;

  /// The loops that are followed.
  const Loops& loops() const noexcept;

  /// How many polygons all walks so far have looked at: what tests of the cost count.
  std::uint64_t walked() const noexcept;

  struct Impl;  ///< of the implementation

 private:
  std::unique_ptr<Impl> impl_;
};

/// Takes an island out of the ground: its polygons are removed by one edit, which the next commit reports, and come as
/// a body. What lies in its holes stays. Edits that were made since the view's last update count: then it is what hangs
/// together with the first polygon of the outer loop. Returns the body. Refused: staleHandle, if that polygon is gone,
/// or if the id names no island or is kBeyond; unloaded and capacity, as by World::removeMany(). Cost: in proportion to
/// the polygons of the island and those in the eight cells around each.
[[nodiscard]] Expected<Body> take(World& world, const Islands& islands, IslandId island) noexcept;

/// The same with solids apart that touch in points only. Returns a body for each part of the island whose polygons
/// share more than points. All of them leave the ground. Refused: as by take().
[[nodiscard]] Expected<std::vector<Body>> takeApart(World& world, const Islands& islands, IslandId island) noexcept;

/// What an edit would do.
struct Foreseen {
  IslandChanges changes;           ///< with the ids that there would be
  std::vector<IslandFacts> after;  ///< the islands that `changes` names and that there would be then
};

/// What an edit would do to the islands: makes it, commits, and rolls back. The world and the view are as before, but
/// for the ids of loops and islands (see LoopId), and the redo is over, as after any edit; ids in the result name
/// nothing. An edit that is refused, so that it returns false, would do nothing; nor would an empty function; and in a
/// world that hasUncommitted() nothing is tried. Cost: that of the edit, of two updates and of a roll-back.
[[nodiscard]] Foreseen foresee(World& world, Islands& islands, const std::function<bool(World&)>& edit) noexcept;

}  // namespace lgs

/// Equal ids have equal hashes.
template <>
struct std::hash<lgs::IslandId> {
  std::size_t operator()(lgs::IslandId id) const noexcept { return std::hash<std::uint32_t>{}(id.value); }
};
