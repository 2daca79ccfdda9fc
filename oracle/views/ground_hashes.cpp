#include "oracle/views/ground_hashes.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace lgs::oracle {
namespace {

using Words = std::vector<std::uint64_t>;

/// fmix64 of MurmurHash3, step by step.
std::uint64_t finalised(std::uint64_t k) {
  k ^= k >> 33U;
  k *= 18'397'679'294'719'823'053U;
  k ^= k >> 33U;
  k *= 14'181'476'777'654'086'739U;
  k ^= k >> 33U;
  return k;
}

/// Two numbers of 32 bits, of which a negative one is counted from 2^32 back.
std::uint64_t paired(std::int64_t high, std::int64_t low) {
  constexpr std::int64_t k32 = std::int64_t{1} << 32;
  return static_cast<std::uint64_t>((high + k32) % k32) * k32 + static_cast<std::uint64_t>((low + k32) % k32);
}

std::uint64_t hashOf(Cell cell, Block block, std::vector<LocalPoint> vertices) {
  std::rotate(vertices.begin(), std::min_element(vertices.begin(), vertices.end()), vertices.end());
  Words words{paired(cell.i, cell.j), paired(block, static_cast<std::int64_t>(vertices.size()))};
  for (const LocalPoint v : vertices) words.push_back(paired(v.x, v.y));
  std::uint64_t h = 0;
  for (const std::uint64_t word : words) h = finalised(h ^ word);
  return h;
}

std::int64_t power4(int exponent) { return std::int64_t{1} << 2 * exponent; }

/// Where a square of a level begins that has this column or row.
std::int64_t begin(std::int64_t index, int level) {
  const std::int64_t side = 32 * power4(level), before = 32 * (power4(level) - 1) / 3;
  const std::int64_t from = index + before;
  return (from >= 0 ? from / side : -((side - 1 - from) / side)) * side - before;
}

/// Squares are sorted as those of the level above are, and so on; of equals by rows.
std::vector<std::int64_t> keyOf(Cell cell, int level) {
  std::vector<std::int64_t> key;
  for (int above = GroundHashes::kTopLevel; above >= level; --above) {
    key.push_back(begin(cell.j, above));
    key.push_back(begin(cell.i, above));
  }
  return key;
}

std::int32_t cut(std::int64_t index) {
  return static_cast<std::int32_t>(std::min<std::int64_t>(std::max<std::int64_t>(index, -kMaxCell), kMaxCell));
}

}  // namespace

std::vector<HashedSquare> groundHashes(const World& world, int level) {
  std::map<std::pair<std::int64_t, std::int64_t>, HashedSquare> squares;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& polygon) {
    const std::int64_t i = begin(cell.i, level), j = begin(cell.j, level), side = 32 * power4(level);
    HashedSquare& square = squares[{j, i}];
    square.level = level;
    square.cells = {{cut(i), cut(j)}, {cut(i + side - 1), cut(j + side - 1)}};
    square.hash += hashOf(cell, polygon.block, {polygon.vertices.begin(), polygon.vertices.end()});
  });
  std::vector<HashedSquare> found;
  for (const auto& [place, square] : squares)
    if (square.hash != 0) found.push_back(square);
  if (found.size() > 1)
    std::ranges::sort(found, {}, [&](const HashedSquare& square) { return keyOf(square.cells.max, level); });
  return found;
}

std::optional<std::string> faultOf(const GroundHashes& hashes, const World& world) {
  const std::vector<HashedSquare> chunks = groundHashes(world, 0);
  std::uint64_t sum = 0;
  for (const HashedSquare& chunk : chunks) sum += chunk.hash;
  if (hashes.hash() != sum) return fmt::format("the hash of the world is {:x}, expected {:x}", hashes.hash(), sum);
  const std::vector<HashedSquare> found = hashes.hashes({{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}});
  const auto [wrong, right] = std::ranges::mismatch(found, chunks);
  if (wrong == found.end() && right == chunks.end()) {
    if (chunks.empty()) return {};
    const HashedSquare& one = chunks[chunks.size() / 2];
    const bool isThat = std::ranges::equal(hashes.hashes(one.cells), std::span(&one, 1));
    if (!isThat) return "of the cells of a chunk there are other hashes";
    int level = 0;
    while (groundHashes(world, level).size() > 1) ++level;
    if (hashes.whole() != groundHashes(world, level)[0]) return "the least square with all ground is another one";
    return {};
  }
  const Cell at = (right == chunks.end() ? *wrong : *right).cells.min;
  return fmt::format("the hash of the chunk from cell ({}, {}) on is not that of its polygons", at.i, at.j);
}

std::optional<std::string> faultOfRounds(GroundHashes hashes) {
  constexpr CellRect kAll{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};
  constexpr int kRounds = 8;  // what grew by a chunk each time would not fit into what there is
  const std::vector<HashedSquare> chunks = hashes.hashes(kAll);
  const std::uint64_t all = hashes.hash();
  std::uint64_t first = 0;
  for (int round = 0; round < kRounds; ++round) {
    for (const HashedSquare& chunk : chunks) hashes.set(chunk.cells.min, 0);
    if (hashes.hash() != 0 || !hashes.hashes(kAll).empty()) return "chunks without ground have hashes";
    if (hashes.whole() != GroundHashes::square({0, 0}, 0)) return "without ground the least square is another one";
    for (const HashedSquare& chunk : chunks) hashes.set(chunk.cells.max, chunk.hash);
    if (round == 0) first = hashes.bytes();
  }
  if (hashes.hash() != all || hashes.hashes(kAll) != chunks)
    return "chunks that are set as they were have other hashes";
  return hashes.bytes() > first ? std::optional("hashes of chunks that come and go take more and more memory")
                                : std::nullopt;
}

}  // namespace lgs::oracle
