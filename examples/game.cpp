// A walker on a floor of blocks, in a loop of frames: each second a bomb takes away the block below. The walker falls
// in and climbs out. c_game.c and ctypes_game.py are the same game in C and in Python.
#include <lgs/world.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace {

constexpr auto U = lgs::kUnitsPerCell;

// The game's own copy of the outline, by id. A game with a physics engine would have a body's edges there.
struct Edge {
  bool alive = false;
  lgs::Point start, end;
};

class Outline {
 public:
  // Takes over what a commit has changed, and nothing else. A relinked segment has other ghosts only, which this
  // game does not need.
  void update(const lgs::World& world, const lgs::Changes& changes) {
    for (const lgs::SegmentId id : changes.removed) edges_[id.value].alive = false;
    edges_.resize(world.maxSegmentId() + 1);
    for (const lgs::SegmentId id : changes.added)
      if (const auto s = world.segment(id)) edges_[id.value] = {true, s->start, s->end};
  }

  std::size_t count() const {
    return static_cast<std::size_t>(std::count_if(edges_.begin(), edges_.end(), [](const Edge& e) { return e.alive; }));
  }

  // How high the ground is below a point. The solid is on the left of an edge, so edges to the left are floors.
  std::int64_t floorBelow(lgs::Point p) const {
    std::int64_t height = 0;
    for (const Edge& e : edges_)
      if (e.alive && e.end.x <= p.x && p.x < e.start.x && e.start.y <= p.y) height = std::max(height, e.start.y);
    return height;
  }

  // Whether a step to the right ends at a wall: an edge that goes down.
  bool isBlocked(lgs::Point p, std::int64_t step) const {
    return std::any_of(edges_.begin(), edges_.end(), [&](const Edge& e) {
      return e.alive && e.start.x == e.end.x && e.end.y <= p.y && p.y < e.start.y && p.x < e.start.x &&
             e.start.x <= p.x + step;
    });
  }

 private:
  std::vector<Edge> edges_;
};

}  // namespace

int main() {
  lgs::World world;
  const auto square = world.shape(lgs::kUnitSquare);
  if (!square || !world.fill({.min = {0, 0}, .max = {15, 3}}, *square, 1)) return 1;

  Outline outline;
  lgs::Point walker{U / 2, 5 * U};
  for (int frame = 0; frame < 300; ++frame) {
    if (frame % 60 == 59) {  // a bomb, where the walker stands
      const auto done = world.clear(lgs::cellAt({walker.x, walker.y - 1}));
      if (!done) return std::printf("%s\n", lgs::message(done.error()).c_str()), 1;
    }
    const lgs::Changes& changes = world.commit();  // once in each frame; it costs what was edited
    outline.update(world, changes);
    if (!changes.added.empty()) {
      std::printf("frame %d: %zu removed, %zu added, %zu relinked; %zu edges\n", frame, changes.removed.size(),
                  changes.added.size(), changes.relinked.size(), outline.count());
    }
    if (outline.isBlocked(walker, U / 32)) {
      walker.y += U / 16;  // it climbs
    } else {
      walker.x += U / 32;
      walker.y = std::max(outline.floorBelow(walker), walker.y - U / 8);  // it falls
    }
  }
  std::printf("the walker is at (%.3f, %.3f)\n", static_cast<double>(walker.x) / U, static_cast<double>(walker.y) / U);
}
