#include <lgs/hashes.h>

#include "beyond.h"

#include <algorithm>

namespace lgs {
namespace {

constexpr int kChunkBits = 5;
static_assert(GroundHashes::kChunkSide == 1 << kChunkBits);
/// The chunk of the origin, on both axes: in base 4 all its 14 digits are 1.
constexpr std::int32_t kOrigin = 0x555'5555;
static_assert(kOrigin - (kMaxCell >> kChunkBits) >= 0 &&
              (kOrigin + (kMaxCell >> kChunkBits)) >> 2 * GroundHashes::kTopLevel == 0);

/// fmix64 (header).
constexpr std::uint64_t mix(std::uint64_t h) {
  h = (h ^ h >> 33) * 0xff51'afd7'ed55'8ccd;
  h = (h ^ h >> 33) * 0xc4ce'b9fe'1a85'ec53;
  return h ^ h >> 33;
}

constexpr std::uint64_t word(std::int32_t high, std::int32_t low) {
  return std::uint64_t{static_cast<std::uint32_t>(high)} << 32 | static_cast<std::uint32_t>(low);
}

std::uint64_t hashOf(Cell cell, const PlacedPolygon& polygon) {
  const auto& vertices = polygon.vertices;
  std::uint64_t h = mix(word(cell.i, cell.j));
  h = mix(h ^ (std::uint64_t{polygon.block} << 32 | vertices.size()));
  const auto least = std::ranges::min_element(vertices);
  const auto takeOver = [&h](LocalPoint v) { h = mix(h ^ word(v.x, v.y)); };
  std::for_each(least, vertices.end(), takeOver);
  std::for_each(vertices.begin(), least, takeOver);
  return h;
}

/// Which part of a square of this level a chunk is in.
constexpr std::size_t partWith(std::uint32_t x, std::uint32_t y, int level) {
  const int shift = 2 * (level - 1);
  return (y >> shift & 3) * 4 + (x >> shift & 3);
}

}  // namespace

GroundHashes::Place GroundHashes::placeOf(Cell cell, int level) {
  const auto chunk = [&](std::int32_t index) {
    return static_cast<std::uint32_t>((index >> kChunkBits) + kOrigin) >> 2 * level << 2 * level;
  };
  return {chunk(cell.i), chunk(cell.j), level};
}

GroundHashes::Place GroundHashes::Place::part(std::size_t k) const {
  const int shift = 2 * (level - 1);
  return {x + (static_cast<std::uint32_t>(k & 3) << shift), y + (static_cast<std::uint32_t>(k >> 2) << shift),
          level - 1};
}

HashedSquare GroundHashes::Place::withHash(std::uint64_t hash) const {
  const std::int64_t i = (std::int64_t{x} - kOrigin) * kChunkSide, j = (std::int64_t{y} - kOrigin) * kChunkSide;
  const std::int64_t side = std::int64_t{kChunkSide} << 2 * level;
  return {level,
          {{detail::inWorld(i), detail::inWorld(j)}, {detail::inWorld(i + side - 1), detail::inWorld(j + side - 1)}},
          hash};
}

GroundHashes::GroundHashes(const World& world) noexcept : version_(world.version()), nodes_(2) {
  world.forEachPolygon([this](Cell cell, const PlacedPolygon& polygon) { add(cell, polygon, true); });
}

void GroundHashes::update(std::span<const CellChange> changes) noexcept {
  for (const CellChange& change : changes) {
    for (const PlacedPolygon& polygon : change.before) add(change.cell, polygon, false);
    for (const PlacedPolygon& polygon : change.now) add(change.cell, polygon, true);
  }
}

bool GroundHashes::update(const World& world, const Changes& changes) noexcept {
  if (!world.followsCells() || changes.before != world.versionBeforeCellChanges()) return false;
  if (changes.before != version_ || changes.after != world.version()) return false;
  update(world.cellChanges());
  version_ = changes.after;
  return true;
}

void GroundHashes::set(Cell chunk, std::uint64_t hash) noexcept {
  const Cell cell{detail::inWorld(chunk.i), detail::inWorld(chunk.j)};
  const Place at = placeOf(cell, 0);
  std::uint32_t node = kWorld;
  for (int level = kTopLevel; level > 1; --level) node = nodes_[node].below[partWith(at.x, at.y, level)];
  add(cell, hash - nodes_[node].hash[partWith(at.x, at.y, 1)]);
}

void GroundHashes::add(Cell cell, const PlacedPolygon& polygon, bool comes) {
  add(cell, comes ? hashOf(cell, polygon) : 0 - hashOf(cell, polygon));
}

void GroundHashes::add(Cell cell, std::uint64_t hash) {
  hash_ += hash;
  addTo(kWorld, kTopLevel, placeOf(cell, 0), hash);
}

/// Whether the node is empty then, so that it is not in the tree any more.
bool GroundHashes::addTo(std::uint32_t node, int level, const Place& chunk, std::uint64_t hash) {
  const std::size_t part = partWith(chunk.x, chunk.y, level);
  nodes_[node].hash[part] += hash;
  if (level > 1) {
    if (nodes_[node].below[part] == kNothing) {
      const std::uint32_t made = newNode();
      nodes_[node].below[part] = made;
    }
    if (addTo(nodes_[node].below[part], level - 1, chunk, hash)) nodes_[node].below[part] = kNothing;
  }
  const auto isZero = [](auto number) { return number == 0; };
  if (node == kWorld || nodes_[node].hash[part] != 0) return false;
  if (!std::ranges::all_of(nodes_[node].hash, isZero) || !std::ranges::all_of(nodes_[node].below, isZero)) return false;
  free_.push_back(node);
  return true;
}

/// It is empty.
std::uint32_t GroundHashes::newNode() {
  if (free_.empty()) {
    nodes_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t node = free_.back();
  free_.pop_back();
  return node;
}

std::uint64_t GroundHashes::hash() const noexcept { return hash_; }

std::vector<HashedSquare> GroundHashes::hashes(const CellRect& cells, int level) const noexcept {
  std::vector<HashedSquare> found;
  const Cell min{std::max(cells.min.i, -kMaxCell), std::max(cells.min.j, -kMaxCell)};
  const Cell max{std::min(cells.max.i, kMaxCell), std::min(cells.max.j, kMaxCell)};
  if (level < 0 || level > kTopLevel || isEmpty({min, max})) return found;
  collect(kWorld, hash_, {0, 0, kTopLevel}, {placeOf(min, 0), placeOf(max, 0)}, level, found);
  return found;
}

/// Of a square and its node, the squares of a level that have a chunk from one corner to the other.
void GroundHashes::collect(std::uint32_t node, std::uint64_t hash, const Place& at, const std::array<Place, 2>& corners,
                           int level, std::vector<HashedSquare>& out) const {
  const std::uint32_t side = 1U << 2 * at.level;
  if (at.x > corners[1].x || at.y > corners[1].y || at.x + side <= corners[0].x || at.y + side <= corners[0].y) return;
  if (at.level == level) {
    if (hash != 0) out.push_back(at.withHash(hash));
    return;
  }
  if (node == kNothing) return;  // hashes below another one may have the sum 0
  for (std::size_t k = 0; k < 16; ++k)
    collect(nodes_[node].below[k], nodes_[node].hash[k], at.part(k), corners, level, out);
}

HashedSquare GroundHashes::whole() const noexcept {
  if (hash_ == 0) return square({0, 0}, 0);
  Place at{0, 0, kTopLevel};
  for (std::uint32_t node = kWorld; at.level > 0;) {
    const auto& parts = nodes_[node].hash;
    const auto only = std::ranges::find(parts, hash_);
    if (only == parts.end()) break;
    const auto k = static_cast<std::size_t>(only - parts.begin());
    node = nodes_[node].below[k];
    at = at.part(k);
  }
  return at.withHash(hash_);
}

HashedSquare GroundHashes::square(Cell cell, int level) noexcept {
  return placeOf({detail::inWorld(cell.i), detail::inWorld(cell.j)}, std::clamp(level, 0, kTopLevel)).withHash(0);
}

std::vector<CellRect> differences(const GroundHashes& a, const GroundHashes& b) noexcept {
  std::vector<CellRect> found;
  if (a.hash_ != b.hash_)
    GroundHashes::collect(a, GroundHashes::kWorld, b, GroundHashes::kWorld, {0, 0, GroundHashes::kTopLevel}, found);
  return found;
}

/// What differs in a square, by its two nodes.
void GroundHashes::collect(const GroundHashes& a, std::uint32_t nodeOfA, const GroundHashes& b, std::uint32_t nodeOfB,
                           const Place& at, std::vector<CellRect>& out) {
  const Node& ofA = a.nodes_[nodeOfA];
  const Node& ofB = b.nodes_[nodeOfB];
  for (std::size_t k = 0; k < 16; ++k) {
    if (ofA.hash[k] == ofB.hash[k]) continue;
    if (at.level == 1)
      out.push_back(at.part(k).withHash(0).cells);
    else
      collect(a, ofA.below[k], b, ofB.below[k], at.part(k), out);
  }
}

std::uint64_t groundHash(const World& world, const CellRect& cells) noexcept {
  std::uint64_t hash = 0;
  world.forEachPolygon(cells, [&](Cell cell, const PlacedPolygon& polygon) { hash += hashOf(cell, polygon); });
  return hash;
}

std::uint64_t GroundHashes::bytes() const noexcept {
  return nodes_.capacity() * sizeof(Node) + free_.capacity() * sizeof(std::uint32_t);
}

}  // namespace lgs
