// Bytes that claim to be a saved world, or a chunk of one. The checksum is made right, so that what follows it is read. Then the bytes are
// refused, or are a world like any other: its outline is the naive reference's, it can be saved and loaded again,
// edited and emptied.
#include "fuzz/target.h"
#include "oracle/check/observed.h"
#include "oracle/check/window.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/dump.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <set>

namespace lgs::fuzz {
namespace snapshot_target {
namespace {

using namespace std::string_view_literals;

constexpr std::array kWords{// Numbers as a snapshot has them.
                            "\0"sv, "\1"sv, "\2"sv, "\3"sv, "\4"sv, "\x81\x10"sv, "\x80\x10"sv, "\xff\x7f"sv,
                            "\x80\x80\4"sv, "\x80\x80\2"sv, "\x80\0"sv, "\xff\xff\xff\xff\x0f"sv,
                            "\xff\xff\xff\xff\xff\xff\xff\xff\x7f"sv,
                            // The beginnings of files.
                            "lgssnap\1"sv, "lgschnk\1"sv};

constexpr std::size_t kHead = 8, kTail = 4;   // letters and version; checksum
constexpr std::uint64_t kManyPolygons = 200;  // the reference takes its time

using oracle::saved;
using Snapshot = std::vector<std::byte>;

/// CRC-32, bit by bit.
std::uint32_t checksumOf(std::span<const std::byte> bytes) {
  std::uint32_t sum = 0xffff'ffff;
  for (const std::byte byte : bytes) {
    sum ^= std::to_integer<std::uint32_t>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (0xedb8'8320U & (0U - (sum & 1U)));
  }
  return ~sum;
}

Snapshot sealed(Bytes input) {
  Snapshot bytes(input.size());
  std::transform(input.begin(), input.end(), bytes.begin(), [](std::uint8_t byte) { return std::byte{byte}; });
  if (bytes.size() < kHead + kTail) return bytes;
  const std::uint32_t sum = checksumOf(std::span(bytes).first(bytes.size() - kTail));
  for (unsigned k = 0; k < kTail; ++k) bytes[bytes.size() - kTail + k] = static_cast<std::byte>(sum >> 8 * k & 0xffU);
  return bytes;
}

/// So many cells more on each side, but none outside of `all`.
CellRect grown(const CellRect& cells, std::int32_t by, const CellRect& all) {
  return {{std::max(all.min.i, cells.min.i - by), std::max(all.min.j, cells.min.j - by)},
          {std::min(all.max.i, cells.max.i + by), std::min(all.max.j, cells.max.j + by)}};
}

/// All cells of a world; or some, about one of its polygons, if it has many.
CellRect judgedCells(const World& world, const CellRect& all) {
  if (world.stats().polygons <= kManyPolygons) return all;
  Cell last{};
  world.forEachPolygon([&](Cell cell, const PlacedPolygon&) { last = cell; });
  return grown({last, last}, 3, all);
}

/// The polygons of some cells. The relation preserves all that differs, or nothing.
oracle::Scene sceneOf(const World& world, const CellRect& cells, bool preserves) {
  oracle::Scene scene;
  std::set<Block> blocks;
  const auto add = [&](Cell cell, const PlacedPolygon& p) {
    scene.polygons.push_back({cell, p.block, {p.vertices.begin(), p.vertices.end()}});
    if (!preserves || !blocks.insert(p.block).second) return;
    for (const Block other : blocks)
      if (other != p.block) scene.preserve.add(other, p.block);
  };
  world.forEachPolygon(cells, add);
  return scene;
}

/// What is wrong with the outline, in words.
std::string differenceByLaws(const World& world, bool preserves) {
  const auto all = world.bounds();
  if (!all) return "";
  const CellRect cells = judgedCells(world, *all);
  const oracle::Scene scene = sceneOf(world, grown(cells, 1, *all), preserves);  // see oracle/check/window.h
  if (scene.polygons.size() > kManyPolygons) return "";
  oracle::Outline expected = oracle::NaiveReference()(scene).outline, actual;
  std::erase_if(expected, [&](const oracle::OutlineSegment& s) { return !contains(cells, oracle::cellOf(s)); });
  for (const SegmentId id : world.segments(cells)) actual.push_back(oracle::outlineSegment(*world.segment(id)));
  std::ranges::sort(actual);
  return expected == actual ? "" : oracle::describe(oracle::compare(expected, actual));
}

std::optional<Finding> checkWorld(World world, bool preserves, std::size_t size) {
  const Stats stats = world.stats();
  if (stats.bytes > 4'000'000 + 2'000 * size) return Finding{fmt::format("{} bytes for {}\n", stats.bytes, size)};
  const Snapshot again = saved(world);
  const auto twin = World::load(again, world.preserveRelation());
  if (!twin) return Finding{"what was saved again can not be loaded: " + message(twin.error()) + "\n"};
  if (saved(*twin) != again) return Finding{"saved, loaded and saved again it is other bytes\n"};
  if (!samePolygons(world, *twin)) return Finding{"saved and loaded again it has other polygons\n"};
  if (const std::string difference = differenceByLaws(world, preserves); !difference.empty())
    return Finding{difference};
  if (!world.clear(world.bounds().value_or(CellRect{}))) return Finding{"it can not be emptied\n"};
  const std::size_t removed = world.commit().removed.size();
  if (removed != stats.segments || !world.segments().empty()) return Finding{"emptied it still has segments\n"};
  return std::nullopt;
}

/// The same bytes as a chunk (World::reload()): it is refused, or stands in a world that can be saved.
std::optional<Finding> checkChunk(const Snapshot& bytes) {
  World world;
  const auto cell = world.reload(bytes);
  if (!cell && (cell.error().offset > bytes.size() || message(cell.error()).empty()))
    return Finding{"a chunk is refused at a byte that is not there, or without a word\n"};
  if (!cell) return std::nullopt;
  world.commit();
  auto finding = checkWorld(world, false, bytes.size());
  if (finding) return finding;
  Snapshot again;
  const CellRect cells{*cell, {std::min(cell->i + 31, kMaxCell), std::min(cell->j + 31, kMaxCell)}};
  const auto gone = world.unload(cells, [&](Cell, auto chunk) { again.assign(chunk.begin(), chunk.end()); });
  if (!gone || *gone != 1) return Finding{"a chunk that came can not leave\n"};
  if (!World().reload(again)) return Finding{"a chunk that came and left does not come again\n"};
  return std::nullopt;
}

std::optional<Finding> check(Bytes input, oracle::CheckStats& stats) {
  const Snapshot bytes = sealed(input);
  if (auto finding = checkChunk(bytes)) return finding;
  for (const bool preserves : {false, true}) {
    PreserveRelation relation;
    if (preserves) relation = [](Block a, Block b) { return a != b; };
    auto world = World::load(bytes, std::move(relation));
    ++stats.edits;
    if (world) {
      if (auto finding = checkWorld(std::move(*world), preserves, bytes.size())) return finding;
    } else if (world.error().offset > bytes.size() || message(world.error()).empty()) {
      return Finding{"it is refused at a byte that is not there, or without a word\n"};
    }
  }
  return std::nullopt;
}

oracle::Trace traceOf(Bytes) { return {}; }

std::string whyEmpty(Bytes) { return "a saved world has no edits; `lgs replay` takes it as it is"; }

constexpr Target kTarget{"snapshot", "saved worlds, as bytes", check, traceOf, nullptr, kWords, whyEmpty};

}  // namespace
}  // namespace snapshot_target

const Target kSnapshot = snapshot_target::kTarget;

}  // namespace lgs::fuzz
