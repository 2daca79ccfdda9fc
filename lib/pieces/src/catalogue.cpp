#include "catalogue.h"

#include "geometry/sort.h"

#include <algorithm>
#include <utility>

namespace lgs::pieces {
namespace {

std::uint64_t hashOf(const Key& key) {
  std::uint64_t hash = 0;
  const auto mix = [&hash](std::uint64_t value) {
    hash = (hash ^ value) * 0x9e37'79b9'7f4a'7c15U;
    hash ^= hash >> 32;
  };
  for (const Ring& ring : key) {
    mix(ring.size());
    for (const LocalPoint p : ring) mix(static_cast<std::uint64_t>(p.x) << 32 | static_cast<std::uint64_t>(p.y));
  }
  return hash;
}

}  // namespace

Ring canonicalRing(std::span<const LocalPoint> vertices) {
  Ring ring(vertices.begin(), vertices.end());
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

Key keyOf(std::span<const PlacedPolygon> polygons) {
  Key key;
  key.reserve(polygons.size());
  for (const PlacedPolygon& polygon : polygons) key.push_back(canonicalRing(polygon.vertices));
  detail::sort(key);
  return key;
}

Catalogue::Catalogue(std::size_t maxVertices) : maxVertices_(maxVertices) {
  entries_.push_back({{}, 0, std::make_shared<const Content>(Key(), maxVertices), 1});
}

ContentId Catalogue::use(Key key) {
  if (key.empty()) return kEmpty;
  const std::uint64_t hash = hashOf(key);
  for (auto [it, end] = index_.equal_range(hash); it != end; ++it) {
    Entry& entry = entries_[it->second];
    if (entry.key != key) continue;
    ++entry.users;
    return it->second;
  }
  ++workedOut_;
  if (free_.empty()) {
    free_.push_back(static_cast<ContentId>(entries_.size()));
    entries_.emplace_back();
  }
  const ContentId id = free_.back();
  free_.pop_back();
  auto content = std::make_shared<const Content>(key, maxVertices_);
  entries_[id] = {std::move(key), hash, std::move(content), 1};
  index_.emplace(hash, id);
  return id;
}

void Catalogue::release(ContentId id) {
  if (id == kEmpty || --entries_[id].users != 0) return;
  for (auto [it, end] = index_.equal_range(entries_[id].hash); it != end; ++it) {
    if (it->second != id) continue;
    index_.erase(it);
    break;
  }
  entries_[id] = {};
  free_.push_back(id);
}

}  // namespace lgs::pieces
