// The true surface, and whether a push is one that it can give: a *kick* is a push in a direction that the surface does
// not have where it happens. That is what a ghost collision is, on any terrain, whatever the ride.
#pragma once

#include <box2d/box2d.h>
#include <lgs/box2d/frame.h>
#include <lgs/world.h>

#include <map>
#include <vector>

namespace lgs::oracle {

class Surface {
 public:
  Surface(const World& world, const box2d::Frame& frame);

  /// Whether the surface near `point` (within 6 cm) has a part that faces `normal`, to within a degree: a side, or a
  /// convex corner between two sides.
  bool faces(b2Vec2 point, b2Vec2 normal) const;

 private:
  struct Facet {
    b2Vec2 start, end;
    b2Vec2 normal;
    b2Vec2 next;  // the normal of the successor, if the corner at `end` is convex; else the facet's own
  };
  box2d::Frame frame_;
  std::map<Cell, std::vector<Facet>> facets_;  // by each cell that one touches
};

}  // namespace lgs::oracle
