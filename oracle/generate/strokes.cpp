#include "oracle/generate/strokes.h"

#include <lgs/brush.h>
#include <algorithm>
#include <array>
#include <vector>

namespace lgs::oracle {
namespace {

constexpr std::array<std::int64_t, 6> kSteps{1, 5, 37, 977, 8'192, 10'007};

class Painter {
 public:
  Painter(Cell cell, const StrokeHabits& habits, Random& random) : cell_(cell), habits_(habits), random_(random) {}

  std::vector<Call> stroke() {
    if (!habits_.can.regions && random_.chance(8)) return onSolidGround();
    constexpr std::array kDeeds{BrushEdit::Deed::carve, BrushEdit::Deed::fill, BrushEdit::Deed::replace};
    BrushEdit brush;
    brush.deed = kDeeds[random_.below(kDeeds.size())];
    const Block block = any();
    const bool isOfRegions = habits_.can.regions;
    if (!isOfRegions && random_.chance(30)) brush.staying = {any()};
    const int kind = habits_.tight && random_.chance(80) ? 2 : isOfRegions ? random_.between(1, 19) : random_.below(20);
    if (kind == 0) brush.deed = BrushEdit::Deed::carve;  // or many cells would be filled
    brush.block = brush.deed == BrushEdit::Deed::carve ? 0 : block;
    if (kind < 9) {
      if (kind == 0) brush.rings = {longest()};
      if (kind == 1) brush.rings = {star()};
      if (kind > 1) brush.rings = rings();
      return {Call::byBrush(std::move(brush))};
    }
    std::vector<Ring> parts = shape().rings;
    brush.isEvenOdd = isOfRegions || width_ < kLeastUnited || random_.chance(50);
    std::vector<Call> calls;
    if (!brush.isEvenOdd) {
      brush.rings = std::move(parts);
      return {Call::byBrush(std::move(brush))};
    }
    for (Ring& ring : parts) {
      brush.rings = {std::move(ring)};
      calls.push_back(Call::byBrush(brush));
    }
    return calls;
  }

 private:
  Block any() { return random_.pick(habits_.blocks); }
  std::int64_t between(std::int64_t least, std::int64_t most) { return random_.between(least, most); }
  std::vector<Ring> rings() {
    if (!habits_.corners.empty() && random_.chance(30)) return {passing()};
    return crossingRings(habits_.tight ? *habits_.tight : tightAt(place(), random_), random_);
  }

  /// Full cells are carved and filled again, or get another block: that leaves no seam (law 10).
  std::vector<Call> onSolidGround() {
    Call gone = Call::of(Call::Kind::clear), many = Call::of(Call::Kind::addMany);
    gone.cells = {{cell_.i - 1, cell_.j - 1}, {cell_.i + 1, cell_.j + 1}};
    const bool areHalved = random_.chance(60), isOneBlock = random_.chance(50);
    const Block block = any();
    constexpr std::int32_t kEnd = kUnitsPerCell;
    const std::int32_t left = random_.between(1, kEnd - 1), right = random_.between(1, kEnd - 1);
    const auto add = [&](Cell cell, LocalPolygon polygon) {
      many.comes.push_back({.cell = cell, .shape = {std::move(polygon)}, .block = isOneBlock ? block : any()});
    };
    for (std::int32_t k = 0; k < 9; ++k) {
      const Cell cell{gone.cells.min.i + k % 3, gone.cells.min.j + k / 3};
      if (areHalved) {
        add(cell, {{0, 0}, {kEnd, 0}, {kEnd, right}, {0, left}});
        add(cell, {{0, left}, {kEnd, right}, {kEnd, kEnd}, {0, kEnd}});
      } else {
        add(cell, {kUnitSquare.begin(), kUnitSquare.end()});
      }
    }
    const Point min = toWorld(gone.cells.min, {0, 0}), max = toWorld(gone.cells.max, {kEnd, kEnd});
    std::vector<Call> calls{std::move(gone), std::move(many)};
    for (int k = random_.between(1, 3); k > 0; --k) {
      BrushEdit brush{.deed = BrushEdit::Deed::carve, .rings = rings()};
      for (Ring& ring : brush.rings)
        for (Point& p : ring) p = {std::clamp(p.x, min.x, max.x), std::clamp(p.y, min.y, max.y)};
      if (isOneBlock) calls.push_back(Call::byBrush(brush));
      brush.deed = isOneBlock ? BrushEdit::Deed::fill : BrushEdit::Deed::replace;
      brush.block = isOneBlock ? block : any();
      calls.push_back(Call::byBrush(std::move(brush)));
    }
    return calls;
  }

  Point near(Point p, std::int64_t reach) { return {p.x + between(-reach, reach), p.y + between(-reach, reach)}; }

  /// A place in a cell: on its rim, on a coarse lattice, or anywhere.
  Point place() {
    const std::int64_t step = kUnitsPerCell >> (random_.chance(70) ? random_.below(4) : 16);
    const Point corner = toWorld(cell_, {0, 0});
    const std::int64_t steps = kUnitsPerCell / step;
    return {corner.x + step * between(0, steps), corner.y + step * between(0, steps)};
  }

  Region shape() {
    const Point at = place();
    if (random_.chance(25)) return wholeCells(at);
    const std::int64_t size = (2 * kUnitsPerCell) >> random_.below(random_.chance(80) ? 6 : 17);
    const std::int64_t width = width_ = between(1, size);
    switch (random_.below(3)) {
      case 0:
        width_ = size;
        return circle(at, size, 8 + 8 * random_.below(4));
      case 1:
        return rectangle(at, random_.chance(50) ? Point{1, 0} : near({0, 0}, 100), size, width);
      default: {
        const std::array line{at, near(at, size), near(at, 2 * size)};
        return thickLine(line, width, 8);
      }
    }
  }

  /// Some cells and halves of cells wide and high: it covers cells, some of them in a row.
  Region wholeCells(Point at) {
    const std::int64_t width = between(1, 8) * kUnitsPerCell / 2, height = between(1, 6) * kUnitsPerCell / 2;
    width_ = kUnitsPerCell;
    return {.rings = {{at, {at.x + width, at.y}, {at.x + width, at.y + height}, {at.x, at.y + height}}}};
  }

  /// Around a point, with many corners.
  Ring star() {
    const Point at = place();
    Ring ring = circle(at, kUnitsPerCell >> random_.below(4), 16 + 8 * random_.below(4)).rings[0];
    for (Point& p : ring) {
      const std::int64_t eighths = between(1, 8);
      p = {at.x + (p.x - at.x) / 8 * eighths, at.y + (p.y - at.y) / 8 * eighths};
    }
    return ring;
  }

  /// A triangle with an edge that passes a corner by less than a unit or two.
  Ring passing() {
    const Point corner = random_.pick(habits_.corners);
    const Point step{between(-2'000, 2'000), between(-2'000, 2'000)};
    const std::int64_t to = between(1, 30), from = -between(1, 30);
    const auto along = [&](std::int64_t n) { return near({corner.x + n * step.x, corner.y + n * step.y}, 1); };
    const Point a = along(to), b = along(from);
    return {a, b, near(corner, kUnitsPerCell / 2)};
  }

  /// As wide or high as a region may be, or a unit more, which must be refused.
  Ring longest() {
    const Point at = place();
    const std::int64_t length = kMaxRegionCells * kUnitsPerCell + between(0, 1), width = between(1, kUnitsPerCell);
    const bool lies = random_.chance(50);
    const Point far{at.x + (lies ? length : width), at.y + (lies ? width : length)};
    return {at, {far.x, at.y}, far, {at.x, far.y}};
  }

  static constexpr std::int64_t kLeastUnited = 256;  // units: a smaller one that is rounded may touch itself

  Cell cell_;
  const StrokeHabits& habits_;
  Random& random_;
  std::int64_t width_ = 0;  // of the last shape
};

// Vertices move to the next ones that an engine can have; a slanted edge becomes two that are not.
Ring fit(const Ring& ring, const Capabilities& can) {
  const std::int64_t step = kUnitsPerCell / can.lattice;
  const std::int64_t least = -std::int64_t{can.cells} * kUnitsPerCell, most = kUnitsPerCell - least;
  const auto moved = [&](std::int64_t v) { return std::clamp(v, least, most) / step * step; };
  Ring fitting;
  for (const Point p : ring) {
    const Point next{moved(p.x), moved(p.y)};
    if (!can.slants && !fitting.empty()) fitting.push_back({next.x, fitting.back().y});
    fitting.push_back(next);
  }
  if (!can.slants) fitting.push_back({fitting.front().x, fitting.back().y});
  return fitting;
}

}  // namespace

std::vector<Ring> crossingRings(const Tight& lattice, Random& random) {
  const auto& [at, step] = lattice;
  std::vector<Ring> rings(1 + random.below(2U));
  for (Ring& ring : rings) {
    for (std::int64_t k = random.between(3, 7); k > 0; --k) {
      const std::int64_t x = random.between(-12, 12), y = random.between(-12, 12);
      ring.push_back({at.x + step * x, at.y + step * y});
    }
  }
  return rings;
}

Tight tightAt(Point centre, Random& random) { return {centre, kSteps[random.below(kSteps.size())]}; }

std::vector<Call> strokeAt(Cell cell, StrokeHabits& habits, Random& random) {
  std::vector<Call> calls = Painter(cell, habits, random).stroke();
  if (habits.can.regions)
    for (Call& call : calls)
      for (Ring& ring : call.brush.rings) ring = fit(ring, habits.can);
  habits.corners.clear();
  for (const std::vector<Point>& ring : calls.back().brush.rings)
    habits.corners.insert(habits.corners.end(), ring.begin(), ring.end());
  return calls;
}

}  // namespace lgs::oracle
