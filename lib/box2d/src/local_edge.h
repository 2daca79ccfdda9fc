// An edge as the body of its chunk sees it: what both adapters hand on.
#pragma once

#include <lgs/box2d/edges.h>

namespace lgs::box2d {

struct LocalEdge {
  Metres ghost1;
  Metres start;
  Metres end;
  Metres ghost2;
};

/// A ghost that is not there, or closer than `shortest` metres to its end of the edge (a welded zigzag), is put straight on.
inline LocalEdge localEdge(const Edge& edge, Chunk chunk, const Frame& frame, float shortest) {
  const Metres start = frame.local(edge.start, chunk);
  const Metres end = frame.local(edge.end, chunk);
  const auto ghost = [&](const std::optional<Point>& p, Metres near, Metres far) -> Metres {
    if (p) {
      const Metres g = frame.local(*p, chunk);
      if (std::hypot(g.x - near.x, g.y - near.y) > shortest) return g;
    }
    return {2 * near.x - far.x, 2 * near.y - far.y};
  };
  return {ghost(edge.ghost1, start, end), start, end, ghost(edge.ghost2, end, start)};
}

}  // namespace lgs::box2d
