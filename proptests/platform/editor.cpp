#include "editor.h"

#include <array>
#include <span>

namespace platform {

lgs::Cell Editor::cell() {
  if (random_.oneIn(400)) return {lgs::kMaxCell + random_.between(0, 1), -lgs::kMaxCell};
  const std::int32_t i = random_.between(0, kSide - 1), j = random_.between(0, kSide - 1);
  return {origin_.i + i, origin_.j + j};
}

lgs::CellRect Editor::cells(std::int32_t most) {
  const lgs::Cell min = cell();
  const std::int32_t width = random_.between(0, most), height = random_.between(0, most);
  return {min, {min.i + width - 1, min.j + height - 1}};
}

lgs::ShapeId Editor::shape() {
  if (shapes_.empty() || random_.oneIn(200)) return {random_.below(1000)};
  return random_.of(shapes_);
}

lgs::PolygonHandle Editor::handle() {
  if (handles_.empty() || random_.oneIn(100)) return lgs::PolygonHandle::unpack(random_.bits() >> 20);
  return random_.of(handles_);
}

void Editor::keep(const lgs::Expected<lgs::PolygonHandle>& added) {
  if (!putResult(hash_, added)) return;
  put(hash_, *added);
  if (handles_.size() < kKept) {
    handles_.push_back(*added);
  } else {
    handles_[random_.below(kKept)] = *added;
  }
}

void Editor::makeShape() {
  lgs::Expected<lgs::ShapeId> made{lgs::ShapeId{}};
  switch (random_.below(4)) {
    case 0:
      made = world_.shape(randomPolygon(random_));
      break;
    case 1:
      made = world_.shape(inReals<float>(random_, randomPolygon(random_)));
      break;
    case 2:
      made = world_.shape(inReals<double>(random_, randomPolygon(random_)));
      break;
    default:
      made = world_.shape(randomShape(random_));
  }
  if (!putResult(hash_, made)) return;
  put(hash_, *made);
  const auto box = world_.boundingBox(*made);
  for (const lgs::LocalPoint corner : {box->min, box->max}) put(hash_, lgs::Point{corner.x, corner.y});
  shapes_.push_back(*made);
}

void Editor::addPoints() {
  const Polygon polygon = randomPolygon(random_);
  const lgs::Cell at = cell();
  keep(world_.add(at, polygon, block()));
}

void Editor::addReals() {
  const Polygon polygon = randomPolygon(random_);
  const lgs::Cell at = cell();
  if (random_.oneIn(2)) {
    const auto floats = inReals<float>(random_, polygon);
    keep(world_.add(at, floats, block()));
  } else {
    const auto doubles = inReals<double>(random_, polygon);
    keep(world_.add(at, doubles, block()));
  }
}

void Editor::addShape() {
  const lgs::ShapeId what = shape();
  const lgs::Cell at = cell();
  if (random_.oneIn(2)) return keep(world_.add(at, what, block()));
  std::array<lgs::PolygonHandle, 3> handles;
  keep(world_.add(at, what, block(), handles));
  for (const lgs::PolygonHandle h : handles) put(hash_, h);
}

void Editor::addMany() {
  std::vector<lgs::Placement> placements;
  for (std::uint32_t k = random_.below(6); k > 0; --k) {
    const lgs::Cell at = cell();
    const lgs::ShapeId what = shape();
    placements.push_back({at, what, block()});
  }
  std::vector<lgs::PolygonHandle> handles(placements.size());
  const bool isDone = putResult(hash_, world_.addMany(placements, handles));
  putAll(hash_, handles);
  if (!isDone) return;
  for (const lgs::PolygonHandle h : handles) keep(h);
}

void Editor::replace() {
  const lgs::ShapeId what = shape();
  const lgs::Cell at = cell();
  std::array<lgs::PolygonHandle, 2> handles;
  keep(world_.replace(at, what, block(), handles));
  for (const lgs::PolygonHandle h : handles) put(hash_, h);
}

void Editor::remove() { putResult(hash_, world_.remove(handle())); }

void Editor::removeMany() {
  std::vector<lgs::PolygonHandle> polygons;
  for (std::uint32_t k = random_.below(4); k > 0; --k) polygons.push_back(handle());
  putResult(hash_, world_.removeMany(polygons));
}

void Editor::group() {
  lgs::Transaction edits = world_.edit();
  addPoints();
  remove();
  addShape();
  if (random_.oneIn(2)) edits.keep();
}

void Editor::edit() {
  const std::uint32_t kind = random_.below(100);
  if (kind < 4) return makeShape();
  if (kind < 25) return addPoints();
  if (kind < 35) return addReals();
  if (kind < 55) return addShape();
  if (kind < 59) return addMany();
  if (kind < 64) return replace();
  if (kind < 80) return remove();
  if (kind < 84) return removeMany();
  if (kind < 88) return group();
  if (kind < 93) {
    const lgs::PolygonHandle polygon = handle();
    putResult(hash_, world_.setBlock(polygon, block()));
    return;
  }
  const lgs::ShapeId what = shape();
  if (kind < 96) {
    const lgs::CellRect where = cells(4);
    const auto filled = world_.fill(where, what, block());
    if (putResult(hash_, filled)) hash_.number(*filled);
    return;
  }
  const auto cleared = kind < 98 ? world_.clear(cells(4)) : world_.clear(cell());
  if (putResult(hash_, cleared)) hash_.number(*cleared);
}

void Editor::commit() {
  const lgs::Changes& changes = world_.commit();
  put(hash_, changes);
  std::vector<lgs::Segment> added(changes.added.size());
  putResult(hash_, world_.segments(changes.added, added));
  putAll(hash_, added);
  hash_.number(world_.maxSegmentId());
  hash_.step();
}

void Editor::readAll() {
  std::vector<lgs::SegmentId> ids = world_.segments();
  for (const lgs::SegmentId id : ids) put(hash_, *world_.segment(id));
  for (const lgs::Collinear collinear : {lgs::Collinear::keep, lgs::Collinear::merge}) {
    for (const lgs::Loop& loop : world_.loops(collinear)) {
      putAll(hash_, loop.vertices);
      putAll(hash_, loop.segments);
    }
  }
  putAll(hash_, world_.segments(lgs::CellRect{origin_, {origin_.i + kSide / 2, origin_.j + kSide / 2}}));
  world_.forEachPolygon([&](lgs::Cell at, const lgs::PlacedPolygon& polygon) {
    put(hash_, at);
    put(hash_, polygon.handle);
    hash_.number(polygon.block);
    for (const lgs::LocalPoint v : polygon.vertices) put(hash_, lgs::Point{v.x, v.y});
  });
  if (const auto bounds = world_.bounds()) {
    put(hash_, bounds->min);
    put(hash_, bounds->max);
  }
  const lgs::Stats stats = world_.stats();  // its bytes depend on the machine
  for (const std::uint64_t count :
       {stats.polygons, stats.cells, stats.segments, stats.shapes, stats.contents, stats.chunks})
    hash_.number(count);
  ids.push_back({world_.maxSegmentId() + 1});
  std::vector<lgs::DoubleSegment> inCells(ids.size());
  putResult(hash_, world_.segments(ids, lgs::Point{12'345, -6'789}, inCells));
  for (const lgs::DoubleSegment& s : inCells) put(hash_, s.end);
  hash_.step();
}

}  // namespace platform
