// Strokes of brushes on a ground of 3×3 cells, by the laws of `lgs check`; none of them is refused. How far strokes are
// from the exact result (law 8) CGAL measures there: here it would take most of the time.
//
//   header  byte 0      the ground: empty, solid, or two blocks with a slanted seam in each cell
//   record  byte 0      bits 0-3: the deed, or another ring of the stroke before
//           byte 1      bits 0, 1: the block; 2-4: the step of the lattice; 5, 6: how many vertices, 3 to 6
//           bytes 2, 3  the middle, in sixteenths of a cell
//           bytes 4-15  the vertices, x and y: so many steps from the middle
#include "fuzz/check_edits.h"
#include "fuzz/units.h"

#include <fmt/format.h>
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

std::optional<Finding> checkTrace(const Trace& trace, oracle::CheckStats& stats) {
  const std::uint64_t refused = stats.refused;
  if (auto finding = checkEdits(trace, {.cgal = false}, stats)) return finding;
  // Fewer polygons than these stand in a cell, and all strokes are in range.
  if (stats.refused != refused) return Finding{"a stroke is refused\n"};
  return std::nullopt;
}

constexpr Target kTarget{"brush", "strokes of brushes on a small world", check<traceOf, checkTrace>, traceOf,
                         checkTrace};

}  // namespace
}  // namespace brush_target

const Target kBrush = brush_target::kTarget;

}  // namespace lgs::fuzz
