#include "editor.h"

#include <utility>
#include <vector>

namespace platform {

const oracle::Habits Editor::kHabits = [] {
  oracle::Habits habits{.width = 10, .height = 10, .blocks = 6};
  habits.weights[static_cast<std::size_t>(oracle::Call::Kind::commit)] = 0;
  return habits;
}();

Editor::Editor(Hash& hash, std::uint64_t seed, lgs::World world, oracle::Habits habits, lgs::Cell origin)
    : hash_(hash), choices_(seed), habits_(std::move(habits)), caller_(std::move(world), origin), origin_(origin) {}

void Editor::edit() { put(hash_, caller_.make(drawCall(choices_, habits_))); }

void Editor::commit() {
  const lgs::Changes& changes = caller_.world.commit();
  put(hash_, oracle::copyOf(changes));
  std::vector<lgs::Segment> added(changes.added.size());
  putResult(hash_, caller_.world.segments(changes.added, added));
  putAll(hash_, added);
  hash_.number(caller_.world.maxSegmentId());
  hash_.step();
}

void Editor::readAll() {
  std::vector<lgs::SegmentId> ids = caller_.world.segments();
  for (const lgs::SegmentId id : ids) put(hash_, *caller_.world.segment(id));
  for (const lgs::Collinear collinear : {lgs::Collinear::keep, lgs::Collinear::merge}) {
    for (const lgs::Loop& loop : caller_.world.loops(collinear)) {
      putAll(hash_, loop.vertices);
      putAll(hash_, loop.segments);
    }
  }
  putAll(hash_, caller_.world.segments(
                    lgs::CellRect{origin_, {origin_.i + habits_.width / 2, origin_.j + habits_.height / 2}}));
  caller_.world.forEachPolygon([&](lgs::Cell at, const lgs::PlacedPolygon& polygon) {
    put(hash_, at);
    put(hash_, polygon.handle);
    hash_.number(polygon.block);
    for (const lgs::LocalPoint v : polygon.vertices) put(hash_, lgs::Point{v.x, v.y});
  });
  if (const auto bounds = caller_.world.bounds()) {
    put(hash_, bounds->min);
    put(hash_, bounds->max);
  }
  const lgs::Stats stats = caller_.world.stats();  // its bytes depend on the machine
  for (const std::uint64_t count :
       {stats.polygons, stats.cells, stats.segments, stats.shapes, stats.contents, stats.chunks})
    hash_.number(count);
  ids.push_back({caller_.world.maxSegmentId() + 1});
  std::vector<lgs::DoubleSegment> inCells(ids.size());
  putResult(hash_, caller_.world.segments(ids, lgs::Point{12'345, -6'789}, inCells));
  for (const lgs::DoubleSegment& s : inCells) put(hash_, s.end);
  hash_.step();
}

}  // namespace platform
