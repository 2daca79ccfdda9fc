#include "fuzz/same.h"

#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/dump.h"

#include <algorithm>
#include <tuple>

namespace lgs::fuzz {
namespace {

constexpr std::uint64_t kManyPolygons = 200;

/// By what the lists of changes tell: they do not tell the ids of links, as one may go to another segment with the same
/// end.
bool isAlike(const Segment& a, const Segment& b) {
  const auto fields = [](const Segment& s) {
    return std::tuple(s.id, s.start, s.end, bool{s.predecessor}, bool{s.successor}, s.predecessor ? s.ghost1 : Point{},
                      s.successor ? s.ghost2 : Point{}, s.block, s.polygon, s.cell);
  };
  return fields(a) == fields(b);
}

}  // namespace

World builtAnew(const World& world) {
  World twin(world.preserveRelation());
  world.forEachPolygon(
      [&](Cell cell, const PlacedPolygon& p) { static_cast<void>(twin.add(cell, p.vertices, p.block)); });
  return twin;
}

std::string differenceByLaws(const World& world) {
  if (world.stats().polygons > kManyPolygons) return "";
  oracle::Scene scene;
  std::map<Block, bool> blocks;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    scene.polygons.push_back({cell, p.block, {p.vertices.begin(), p.vertices.end()}});
    blocks[p.block] = true;
  });
  const PreserveRelation& preserves = world.preserveRelation();
  for (auto a = blocks.begin(); preserves && a != blocks.end(); ++a)
    for (auto b = a; b != blocks.end(); ++b)
      if (preserves(a->first, b->first)) scene.preserve.add(a->first, b->first);
  const oracle::Outline expected = oracle::naiveOutline(scene), actual = oracle::outlineOf(world);
  return expected == actual ? "" : "the outline is not that of the laws\n" + describe(compare(expected, actual));
}

Follower::Follower(const World& world) {
  for (const SegmentId id : world.segments()) segments_[id] = *world.segment(id);
}

std::string Follower::follow(const World& world, const Changes& changes) {
  for (const SegmentId id : changes.removed)
    if (segments_.erase(id) == 0) return "a segment was removed that was not there";
  for (const SegmentId id : changes.added) {
    const auto s = world.segment(id);
    if (!s || !segments_.emplace(id, *s).second) return "a segment was added that is not there, or was there";
  }
  for (const SegmentId id : changes.relinked) {
    const auto s = world.segment(id);
    if (!s || !segments_.contains(id)) return "a segment was relinked that is not there";
    segments_[id] = *s;
  }
  const auto isRight = [&](const auto& entry) {
    const auto now = world.segment(entry.first);
    return now && isAlike(entry.second, *now);
  };
  const bool isAll = world.segments().size() == segments_.size() && std::ranges::all_of(segments_, isRight);
  return isAll ? "" : "the lists do not lead to the segments that there are";
}

}  // namespace lgs::fuzz
