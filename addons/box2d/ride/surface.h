// The true surface, and which pushes it can give. A *kick* is a push in a direction that the surface does not have in
// that place. On any terrain and in any ride that is a ghost collision.
#pragma once

#include <box2d/box2d.h>
#include <lgs/box2d/frame.h>
#include <lgs/world.h>

#include <map>
#include <vector>

namespace lgs::bench {

class Surface {
 public:
  Surface(const World& world, const box2d::Frame& frame);

  /// Whether a part of the surface near `point` (within 6 cm) faces `normal`, to within a degree. A part is a side, or
  /// a convex corner between two sides.
  bool faces(b2Vec2 point, b2Vec2 normal) const;

 private:
  struct Facet {
    b2Vec2 start, end;
    b2Vec2 normal;
    b2Vec2 next;  // the normal of the successor, if the corner at `end` is convex; else the same as `normal`
  };
  box2d::Frame frame_;
  std::map<Cell, std::vector<Facet>> facets_;  // by cell
};

}  // namespace lgs::bench
