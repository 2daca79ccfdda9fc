// An edge as both adapters give it to Box2D: in metres, relative to the body of its chunk.
#pragma once

#include <lgs/box2d/edges.h>

namespace lgs::box2d {

struct LocalEdge {
  Metres ghost1;
  Metres start;
  Metres end;
  Metres ghost2;
};

/// Box2D needs both ghosts, and needs them further from the edge than `shortest` metres. A ghost that is missing, or
/// that is nearer because the edge welds a zigzag, is replaced by one straight on.
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
