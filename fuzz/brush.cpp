// Strokes of brushes on a ground of 3×3 cells: after each of them the outline is the naive reference's, what the stroke
// does not reach stays (law 9), and none is refused (law 11). To carve the first region out of solid ground, and to
// fill it again, leaves no seam (law 10). How far strokes are from the exact result (law 8) CGAL measures in
// `lgs check --brushes`: here it would take most of the time.
//
//   header  byte 0      the ground: empty, solid, or two blocks with a slanted seam in each cell
//   record  byte 0      bits 0-3: the deed, or another ring of the stroke before. From kAnyForm on: a stroke of any form
//                       (strokes.h), of which all other bytes are the seed. A trace has none of these. They are made
//                       after the others, on the same ground
//           byte 1      bits 0, 1: the block; 2-4: the step of the lattice; 5, 6: how many vertices, 3 to 6
//           bytes 2, 3  the middle, in sixteenths of a cell
//           bytes 4-15  the vertices, x and y: so many steps from the middle
#include "fuzz/check_edits.h"
#include "fuzz/strokes.h"
#include "fuzz/units.h"

#include <fmt/format.h>
#include <lgs/brush.h>
#include <algorithm>
#include <array>

namespace lgs::fuzz {
namespace brush_target {
namespace {

using oracle::BrushEdit;
using oracle::Call;
using oracle::Trace;

constexpr std::int64_t kCells = 3;
constexpr std::size_t kMaxStrokes = 60;
constexpr std::size_t kMaxOfAnyForm = 12;  // each is made several times over
constexpr std::uint8_t kAnyForm = 192;

std::vector<oracle::ScenePolygon> groundOf(unsigned kind) {
  std::vector<oracle::ScenePolygon> ground;
  if (kind == 0) return ground;
  constexpr std::int32_t kLow = U / 3, kHigh = U - 5;
  for (std::int32_t i = 0; i < kCells; ++i) {
    for (std::int32_t j = 0; j < kCells; ++j) {
      const Block block = kind == 1 ? 1 : 1 + static_cast<Block>(i + j) % 3;
      if (kind == 1) {
        ground.push_back({{i, j}, block, {kUnitSquare.begin(), kUnitSquare.end()}});
      } else {
        ground.push_back({{i, j}, block, {{0, 0}, {U, 0}, {U, kHigh}, {0, kLow}}});
        ground.push_back({{i, j}, block % 3 + 1, {{0, kLow}, {U, kHigh}, {U, U}, {0, U}}});
      }
    }
  }
  return ground;
}

std::vector<Point> ringOf(Bytes record) {
  constexpr std::array<std::int64_t, 8> kSteps{1, 1, 2, 5, 37, 512, 977, 1'024};
  const std::int64_t step = kSteps[record[1] >> 2 & 7U];
  const auto middle = [](std::uint8_t byte) { return std::int64_t{byte} % (16 * kCells + 1) * (U / 16); };
  const auto away = [&](std::uint8_t byte) { return step * (std::int64_t{byte} - 128); };
  std::vector<Point> ring(3 + (record[1] >> 5 & 3U));
  for (std::size_t k = 0; k < ring.size(); ++k)
    ring[k] = {middle(record[2]) + away(record[4 + 2 * k]), middle(record[3]) + away(record[5 + 2 * k])};
  return ring;
}

Trace traceOf(Bytes input) {
  Trace trace;
  std::vector<std::uint8_t> bytes(input.begin(), input.end());
  bytes.resize(std::max((bytes.size() + kRecord - 1) / kRecord, std::size_t{1}) * kRecord);
  for (auto& polygon : groundOf(bytes[0] % 3U))
    trace.calls.push_back(Call::add(fmt::format("p{}", trace.calls.size() + 1), std::move(polygon)));
  trace.calls.push_back(Call::commit());
  std::size_t strokes = 0;
  for (std::size_t at = kRecord; at < bytes.size(); at += kRecord) {
    const Bytes record = Bytes(bytes).subspan(at, kRecord);
    if (record[0] >= kAnyForm) continue;
    const unsigned deed = record[0] & 15U;
    const bool isNew = deed < 12 || strokes == 0;
    if (isNew && ++strokes > kMaxStrokes) break;
    if (isNew) {
      constexpr std::array kDeeds{BrushEdit::Deed::carve, BrushEdit::Deed::fill, BrushEdit::Deed::replace};
      BrushEdit brush;
      brush.deed = kDeeds[deed % 3];
      if (brush.deed != BrushEdit::Deed::carve) brush.block = 1 + (record[1] & 3U);
      trace.calls.push_back(Call::byBrush(std::move(brush)));
      trace.calls.push_back(Call::commit());
    }
    trace.calls[trace.calls.size() - 2].brush.rings.push_back(ringOf(record));
  }
  return trace;
}

World worldOf(unsigned kind) {
  World world;
  for (const auto& [cell, block, vertices] : groundOf(kind)) static_cast<void>(world.add(cell, vertices, block));
  world.commit();
  return world;
}

// Outlines with straight lines as one segment each.
std::vector<std::vector<Point>> outlinesOf(World& world) {
  world.commit();
  std::vector<std::vector<Point>> all;
  for (const Loop& loop : world.loops(Collinear::merge)) all.push_back(loop.vertices);
  return all;
}

// Law 10, for a region as far as it lies over solid ground.
bool leavesASeam(const BrushEdit& brush) {
  Region region{brush.rings, FillRule::evenOdd};
  for (Ring& ring : region.rings)
    for (Point& p : ring)
      p = {std::clamp<std::int64_t>(p.x, 0, kCells * U), std::clamp<std::int64_t>(p.y, 0, kCells * U)};
  World world = worldOf(1);
  const auto solid = outlinesOf(world);
  const bool isCarved = carve(world, region).has_value();
  world.commit();
  return !isCarved || !paint(world, region, 1, PaintMode::fill) || outlinesOf(world) != solid;
}

std::optional<Finding> checkTrace(const Trace& trace, oracle::CheckStats& stats) {
  const std::uint64_t refused = stats.refused;
  if (auto finding = checkEdits(trace, {.cgal = false}, stats)) return finding;
  // Fewer polygons than these stand in a cell, and all strokes are in range.
  if (stats.refused != refused) return Finding{"a stroke is refused\n"};
  const auto first = std::ranges::find(trace.calls, Call::Kind::brush, &Call::kind);
  if (first != trace.calls.end() && leavesASeam(first->brush))
    return Finding{"to carve the first region out of solid ground, and to fill it again, leaves a seam\n"};
  return std::nullopt;
}

std::optional<Finding> checkAll(Bytes input, oracle::CheckStats& stats) {
  if (auto finding = check<traceOf, checkTrace>(input, stats)) return finding;
  World world = worldOf(input.empty() ? 0 : input[0] % 3U);
  std::size_t strokes = 0;
  for (std::size_t at = kRecord; at < input.size() && strokes < kMaxOfAnyForm; at += kRecord) {
    const Bytes record = input.subspan(at, std::min(kRecord, input.size() - at));
    if (record[0] < kAnyForm) continue;
    oracle::Random random = seededBy(record);
    ++strokes;
    ++stats.edits;
    if (const std::string wrong = strokeAndGoBack(world, random, record[0] % 2 != 0); !wrong.empty())
      return Finding{fmt::format("stroke {} of any form: {}\n", strokes, wrong)};
  }
  return std::nullopt;
}

constexpr Target kTarget{"brush", "strokes of brushes on a small world", checkAll, traceOf, checkTrace};

}  // namespace
}  // namespace brush_target

const Target kBrush = brush_target::kTarget;

}  // namespace lgs::fuzz
