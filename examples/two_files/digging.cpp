// Two craters in a floor of rock, in a loop of frames: a small game with the amalgamation. To build it, write them
// beside it (`scripts/amalgamate.py .`), then `c++ -std=c++20 digging.cpp localgridseg.cpp -o digging`.
#include "localgridseg.h"

#include <cstdio>
#include <map>

namespace {

// What a physics engine would have: an edge with its two ghost vertices for each segment.
struct Edge {
  lgs::Point ghost1, start, end, ghost2;
};

class Physics {
 public:
  // Takes over what has changed, and nothing else.
  void update(const lgs::World& world, const lgs::Changes& changes) {
    for (const lgs::SegmentId id : changes.removed) edges_.erase(id.value);
    for (const auto* const list : {&changes.added, &changes.relinked})
      for (const lgs::SegmentId id : *list)
        if (const auto s = world.segment(id)) edges_[id.value] = {s->ghost1, s->start, s->end, s->ghost2};
  }
  std::size_t count() const { return edges_.size(); }

 private:
  std::map<std::uint32_t, Edge> edges_;
};

// A refused edit has changed nothing. Its error says what is wrong, and where.
int refused(const lgs::Error& error) {
  std::printf("%s\n", lgs::message(error).c_str());
  return 1;
}

}  // namespace

int main() {
  const lgs::Version version = lgs::version();
  std::printf("LocalGridSeg %u.%u.%u\n", version.major, version.minor, version.patch);

  lgs::World world;
  const auto square = world.shape(lgs::kUnitSquare);
  if (!square) return refused(square.error());
  const auto floor = world.fill({.min = {0, 0}, .max = {39, 9}}, *square, 1);
  if (!floor) return refused(floor.error());

  Physics physics;
  for (int frame = 0; frame < 3; ++frame) {
    if (frame > 0) {  // an explosion; the craters overlap
      const lgs::Point center = lgs::latticePoint({18.0 + 3 * frame, 10.0});
      const auto hole = lgs::carve(world, lgs::circle(center, 2 * lgs::kUnitsPerCell, 16));
      if (!hole) return refused(hole.error());
    }
    const lgs::Changes& changes = world.commit();
    physics.update(world, changes);
    std::printf("frame %d: %zu removed, %zu added, %zu relinked; %zu edges\n", frame, changes.removed.size(),
                changes.added.size(), changes.relinked.size(), physics.count());
  }
}
