#include "ground/catalogue.h"

#include "geometry/sort.h"
#include "ground/refusal.h"

#include <lgs/world.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace lgs::detail {
namespace {

std::uint64_t hashOf(std::uint64_t seed, PolygonView vertices) {
  std::uint64_t hash = seed ^ vertices.size();
  for (const LocalPoint v : vertices)
    hash = mix(hash, std::uint64_t{static_cast<std::uint32_t>(v.x)} << 32 | static_cast<std::uint32_t>(v.y));
  return hash;
}

std::uint64_t hashOf(std::uint64_t seed, std::span<const PolygonId> polygons,
                     std::span<const std::pair<Slot, Slot>> preserved) {
  std::uint64_t hash = seed ^ polygons.size();
  for (const PolygonId id : polygons) hash = mix(hash, id);
  for (const auto& [a, b] : preserved) hash = mix(hash, std::uint64_t{1} << 63 | std::uint64_t{a} << 16 | b);
  return hash;
}

/// For an index: a number among those with the same hash.
auto is(std::uint64_t id) {
  return [id](std::uint64_t number) { return number == id; };
}

/// Puts the value at a free number, or at the next one.
template <class T>
std::uint32_t store(std::vector<T>& table, std::vector<std::uint32_t>& free, T value) {
  if (free.empty()) {
    table.push_back(std::move(value));
    return static_cast<std::uint32_t>(table.size() - 1);
  }
  const std::uint32_t id = free.back();
  free.pop_back();
  table[id] = std::move(value);
  return id;
}

}  // namespace

Catalogue::Catalogue() {
  contents_.push_back(std::make_shared<const Content>(builder_.build({}, {}, {})));
  uses_.push_back({.users = kForever});
}

Expected<PolygonId> Catalogue::internPolygon(PolygonView vertices) {
  const auto isIt = [&](std::uint64_t id) { return std::ranges::equal(polygons_[id].vertices, vertices); };
  if (!vertices.empty() && isIt(lastPolygon_)) return lastPolygon_;
  const std::uint64_t hash = hashOf(seed_, vertices);
  if (const std::uint64_t found = polygonIndex_.find(hash, isIt); found != 0)
    return lastPolygon_ = static_cast<PolygonId>(found);
  if (const auto defect = findDefect(vertices))
    return refuse({.code = defect->code, .polygon = 0, .vertex = defect->vertex, .vertex2 = defect->vertex2});
  InternedPolygon polygon;
  polygon.vertices.assign(vertices.begin(), vertices.end());
  polygon.hash = hash;
  const PolygonId id = store(polygons_, freePolygons_, std::move(polygon));
  polygonIndex_.set(hash, id, is(id));
  ++unused_;
  return id;
}

Expected<ContentId> Catalogue::internContent(std::span<const PolygonId> polygons, std::span<const std::uint8_t> known,
                                             std::span<const std::pair<Slot, Slot>> preserved) {
  const std::uint64_t hash = hashOf(seed_, polygons, preserved);
  const std::uint64_t found = contentIndex_.find(hash, [&](std::uint64_t id) {
    return std::ranges::equal(contents_[id]->polygons, polygons) &&
           std::ranges::equal(contents_[id]->preserved, preserved);
  });
  if (found != 0) return static_cast<ContentId>(found);

  views_.clear();
  std::size_t vertexCount = 0;
  for (const PolygonId id : polygons) {
    views_.push_back(vertices(id));
    vertexCount += views_.back().size();
  }
  if (polygons.size() > kMaxPolygonsPerCell || vertexCount > kMaxVerticesPerCell)
    return refuse({.code = ErrorCode::capacity});
  if (freeContents_.empty() && contents_.size() > kMaxContent) return refuse({.code = ErrorCode::capacity});
  const auto isKnown = [&](std::size_t k) { return !known.empty() && known[k]; };
  for (std::size_t b = 0; b < views_.size(); ++b) {
    if (isKnown(b)) continue;
    for (std::size_t a = 0; a < views_.size(); ++a)
      if ((a < b || isKnown(a)) && interiorsMeet(views_[a], views_[b])) return refuse({.code = ErrorCode::overlap});
  }

  auto content = std::make_shared<Content>(builder_.build(polygons, views_, preserved));
  content->hash = hash;
  widestFan_ = std::max(widestFan_, content->widestFan);
  const Facts facts = content->facts;
  const ContentId id = store<std::shared_ptr<const Content>>(contents_, freeContents_, std::move(content));
  uses_.resize(contents_.size());
  uses_[id] = {.users = 0, .facts = facts};
  contentIndex_.set(hash, id, is(id));
  for (const PolygonId polygon : polygons) acquire(polygons_[polygon].users);
  if (polygons.size() == 1) polygons_[polygons[0]].sole = id;
  ++unused_;
  return id;
}

Expected<ShapeId> Catalogue::internShape(std::span<const PolygonId> polygons) {
  if (polygons.empty()) return refuse({.code = ErrorCode::emptyShape});
  const auto isIt = [&](std::uint64_t id) { return std::ranges::equal(shapes_[id].polygons, polygons); };
  if (const std::uint64_t found = shapeIndex_.find(hashOf(seed_, polygons, {}), isIt); found != 0)
    return ShapeId{static_cast<std::uint32_t>(found)};

  const std::vector<PolygonId> given(polygons.begin(), polygons.end());
  std::vector<PolygonId> sorted = given;
  detail::sort(sorted);
  const auto content = internContent(sorted, {}, {});
  if (!content) return refuse(content.error().code == ErrorCode::overlap ? overlapAmong(given) : content.error());
  // The content is never forgotten from here on, and it uses the polygons: so the shape need not be their user too.
  if (uses_[*content].users == 0) --unused_;
  uses_[*content].users = kForever;
  putShape({*content, facts(*content), given.size() == 1, given});
  return ShapeId{static_cast<std::uint32_t>(shapeCount())};
}

InternedShape Catalogue::takeShape() {
  assert(shapeCount() != 0);
  shapeIndex_.erase(hashOf(seed_, shapes_.back().polygons, {}), is(shapeCount()));
  InternedShape shape = std::move(shapes_.back());
  shapes_.pop_back();
  return shape;
}

void Catalogue::putShape(InternedShape shape) {
  shapeIndex_.set(hashOf(seed_, shape.polygons, {}), shapes_.size(), is(shapes_.size()));
  shapes_.push_back(std::move(shape));
}

Error Catalogue::overlapAmong(std::span<const PolygonId> polygons) const {
  Error error{.code = ErrorCode::overlap};
  for (std::size_t k = 1; k < polygons.size(); ++k) {
    const auto earlier = polygons.first(k);
    const auto other = std::ranges::find_if(earlier, [&](PolygonId id) { return overlap(id, polygons[k]); });
    if (other == earlier.end()) continue;
    error.polygon = static_cast<std::int32_t>(k);
    error.polygon2 = static_cast<std::int32_t>(other - earlier.begin());
    break;
  }
  return error;
}

void Catalogue::collect() {
  // Looking through the catalogue is worth it once an eighth has no users: marks keep contents, and more would wait.
  // That share hardly passes a half, since contents without users still use their polygons.
  if (unused_ < 1024 || 8 * unused_ < contents_.size() + polygons_.size() - 1) return;
  for (ContentId id = 1; id < contents_.size(); ++id)
    if (uses_[id].users == 0 && contents_[id]) forgetContent(id);
  for (PolygonId id = 1; id < polygons_.size(); ++id)
    if (polygons_[id].users == 0 && !polygons_[id].vertices.empty()) forgetPolygon(id);
}

void Catalogue::forgetContent(ContentId id) {
  const auto content = std::exchange(contents_[id], nullptr);
  contentIndex_.erase(content->hash, is(id));
  for (const PolygonId polygon : content->polygons) drop(polygons_[polygon].users);
  if (content->polygons.size() == 1) polygons_[content->polygons[0]].sole = kEmptyContent;
  --unused_;
  freeContents_.push_back(id);
}

void Catalogue::forgetPolygon(PolygonId id) {
  polygonIndex_.erase(polygons_[id].hash, is(id));
  polygons_[id] = InternedPolygon{};
  --unused_;
  freePolygons_.push_back(id);
}

std::uint64_t Catalogue::bytes() const {
  std::uint64_t sum = polygonIndex_.bytes() + contentIndex_.bytes() + shapeIndex_.bytes();
  for (const InternedPolygon& p : polygons_) sum += heldBytes(p.vertices);
  for (const auto& content : contents_)
    if (content) sum += sizeof *content + content->listBytes;
  for (const InternedShape& s : shapes_) sum += heldBytes(s.polygons);
  return sum + builder_.bytes() + heldBytes(polygons_, contents_, views_, uses_, shapes_, freePolygons_, freeContents_);
}

}  // namespace lgs::detail
