// Which islands of before and of now are kin (islands.h): the solid of both moments, one laid upon the other, connects
// them. The solid of both is that of now, and what was taken away. So kin is found by looking at each polygon that was
// taken away: which loops of now does it meet, and which others that were taken away does it touch? What hangs together
// with ground beyond the edge of memory has one node, that of the null loop: so have chains that lead there.
#pragma once

#include "locator.h"
#include "rings.h"

#include <lgs/loops.h>

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace lgs::detail {

/// A polygon that was taken away.
struct Taken {
  Cell cell;
  WorldRing ring;
  bool wasAnchor = false;
  bool isAway = false;  ///< it stands where it did, in a chunk that was unloaded
};

class Kin {
 public:
  /// Kin among the loops of now and the polygons taken away, which are sorted by cell; and the chunks that were unloaded
  /// before, and are loaded now.
  Kin(const World& world, const World& outline, const Loops& loops, std::span<const Taken> taken,
      std::span<const CellRect> back);

  using Node = std::uint32_t;

  /// Looks at everything that was taken away. To be called before the first question about something of that.
  void connectAll();

  /// The node of what lies beyond the edge of memory.
  Node beyond() { return nodeOf({}); }
  /// What was or is solid at a point, the island of a loop of now, and that of a polygon that stands, hang together with
  /// what lies there.
  void isBeyond(Point point) { unite(at(point), beyond()); }
  void isBeyond(LoopId loop) { unite(nodeOf(locator_.ofLoop(loop)), beyond()); }
  void isBeyond(Cell cell, std::span<const LocalPoint> vertices) { unite(ofStanding(cell, vertices), beyond()); }

  /// The node of an outer loop of now.
  Node ofOuter(LoopId outer) { return nodeOf(outer); }
  /// The node of what was or is solid at a point, connected with the outer loop of its island, if that is there.
  Node at(Point point);
  /// The same of a polygon that was taken away, by its index.
  Node ofTaken(std::size_t index);
  /// The same of a polygon that stands.
  Node ofStanding(Cell cell, std::span<const LocalPoint> vertices) {
    return ofOuter(locator_.ofPolygon(cell, vertices));
  }

  /// Nodes are kin if they have the same root.
  Node root(Node node);
  /// All outer loops that have a node.
  std::vector<LoopId> outers() const;

 private:
  struct Link {
    Node parent;
    LoopId loop;              ///< of a root: one of the loops; null: there is none
    std::uint32_t loops = 0;  ///< of a root: how many loops
  };

  Node nodeOf(LoopId loop);
  void unite(Node a, Node b);
  void connect(std::size_t index);
  std::optional<Node> standingAt(Point point);
  bool isBesideUnloaded(const Taken& taken) const;
  template <class Visit>
  void forTakenNear(Cell cell, Visit&& visit) const;

  const World& world_;
  const World& outline_;
  const Loops& loops_;
  Locator locator_;
  std::span<const Taken> taken_;
  std::span<const CellRect> back_;
  std::vector<Link> links_;                        ///< by node: first those of what was taken away, then those of loops
  std::vector<LoopId> loop_;                       ///< by node - taken_.size()
  std::unordered_map<std::uint64_t, Node> nodes_;  ///< by LoopId
};

}  // namespace lgs::detail
