// Which islands of before and of now are kin (islands.h): the solid of both moments, one laid upon the other, connects
// them. The solid of both is that of now, and what was taken away. So kin is found by looking at each polygon that was
// taken away: which loops of now does it meet, and which others that were taken away does it touch?
#pragma once

#include "locator.h"
#include "rings.h"

#include <lgs/loops.h>

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace lgs::detail {

/// A polygon that was taken away.
struct Taken {
  Cell cell;
  WorldRing ring;
  bool wasAnchor = false;
};

class Kin {
 public:
  /// Kin among the loops of now and the polygons taken away, which are sorted by cell.
  Kin(const World& world, const World& outline, const Loops& loops, std::span<const Taken> taken);

  using Node = std::uint32_t;

  /// Looks at everything that was taken away. To be called before the first question about something of that.
  void connectAll();

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
  template <class Visit>
  void forTakenNear(Cell cell, Visit&& visit) const;

  const World& world_;
  const World& outline_;
  const Loops& loops_;
  Locator locator_;
  std::span<const Taken> taken_;
  std::vector<Link> links_;                        ///< by node: first those of what was taken away, then those of loops
  std::vector<LoopId> loop_;                       ///< by node - taken_.size()
  std::unordered_map<std::uint64_t, Node> nodes_;  ///< by LoopId
};

}  // namespace lgs::detail
