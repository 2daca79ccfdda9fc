#include "oracle/generate/strokes.h"

#include "oracle/reference/vector.h"

#include <lgs/brush.h>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

namespace lgs::oracle {
namespace {

constexpr std::array<std::int64_t, 7> kSteps{1, 1, 5, 37, 977, 8'192, 10'007};

class Painter {
 public:
  Painter(Cell cell, const StrokeHabits& habits, Random& random) : cell_(cell), habits_(habits), random_(random) {}

  std::vector<Call> stroke() {
    if (!habits_.can.regions && random_.chance(habits_.tight ? 20 : 8)) return onSolidGround();
    if (!habits_.can.regions && random_.chance(12)) return beside();
    if (!habits_.can.regions && random_.chance(20)) return acrossShapes(cell_, habits_.blocks, random_);
    if (!habits_.can.regions && random_.chance(12)) return acrossSlivers(cell_, habits_.blocks, random_);
    BrushEdit brush{.deed = anyDeed(random_), .rings = {}};
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
      if (random_.chance(20))
        for (Ring& ring : brush.rings) std::ranges::reverse(ring);
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
    if (!habits_.last.empty() && random_.chance(40)) return random_.chance(60) ? std::vector<Ring>{passing()} : again();
    return crossingRings(habits_.tight ? *habits_.tight : tightAt(place(), random_), random_);
  }

  /// Full cells are carved and filled again, or get another block, some as a whole: that leaves no seam (law 10). Where
  /// they have several blocks, one may stay.
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
    const auto inside = [&] {
      std::vector<Ring> all = random_.chance(30) ? wholeCells(place()).rings : rings();
      for (Ring& ring : all)
        for (Point& p : ring) p = {std::clamp(p.x, min.x, max.x), std::clamp(p.y, min.y, max.y)};
      return all;
    };
    for (int k = random_.between(1, 3); k > 0; --k) {
      BrushEdit brush{.deed = BrushEdit::Deed::carve, .rings = inside()};
      if (isOneBlock) calls.push_back(Call::byBrush(brush));
      if (random_.chance(30)) brush.rings = inside();
      if (!isOneBlock && random_.chance(50)) brush.staying = {any()};
      brush.deed = isOneBlock ? BrushEdit::Deed::fill : anyDeed(random_);
      if (brush.deed != BrushEdit::Deed::carve) brush.block = isOneBlock ? block : any();
      calls.push_back(Call::byBrush(std::move(brush)));
    }
    return calls;
  }

  /// Two edges of a region pass a small triangle by a unit or so, all along one of its edges, and cross there. What the
  /// crossing is rounded to lies in the triangle, which the region does not meet: so that is bent (law 9).
  std::vector<Call> beside() {
    constexpr std::int32_t kMost = 40, kLast = kUnitsPerCell - kMost, kTries = 400;
    const auto low = [&] { return random_.chance(70) ? random_.between(0, kLast) : kLast; };
    const std::int32_t left = low(), floor = low();
    const auto point = [&] {
      const std::int32_t x = left + random_.between(0, kMost);
      return LocalPoint{x, floor + random_.between(0, kMost)};
    };
    const auto isLeft = [](Point a, Point b, Point p) { return cross(b - a, p - a) > 0; };
    const auto at = [&](LocalPoint v) { return toWorld(cell_, v); };
    Call gone = Call::of(Call::Kind::clear), many = Call::of(Call::Kind::addMany);
    gone.cells = {cell_, cell_};
    const auto add = [&](LocalPoint a, LocalPoint b, LocalPoint c) {
      if (isLeft(at(a), at(b), at(c))) many.comes.push_back({.cell = cell_, .shape = {{a, b, c}}, .block = any()});
    };
    LocalPoint u = point(), v = point(), w = point();
    if (!isLeft(at(u), at(v), at(w))) std::swap(u, v);
    add(u, v, w);
    if (random_.chance(40)) add(w, v, point());
    if (random_.chance(30)) add(v, u, point());
    const Point a = at(u), b = at(v), c = at(w);
    const Vector d = b - a;
    const bool isFlat = std::abs(d.x) > std::abs(d.y);
    const int step = (isFlat ? d.x < 0 : d.y > 0) ? 1 : -1;  // to the right of the edge
    const auto beyond = [&](std::int64_t sixteenths) {
      Point p{a.x + d.x * sixteenths / 16, a.y + d.y * sixteenths / 16};
      while (isLeft(a, b, p) || (d != Vector{} && cross(d, p - a) == 0)) (isFlat ? p.y : p.x) += step;
      return p;
    };
    const std::int64_t reach = random_.chance(70) ? 60 : 800;
    std::array<Point, 4> ends{};
    for (int k = 0; k < kTries; ++k) {
      for (const std::size_t end : {0U, 1U, 2U, 3U})
        ends[end] = beyond(end % 2 == 0 ? -between(1, reach) : 16 + between(1, reach));
      const auto crossing = crossingOf(ends);
      if (crossing && isLeft(a, b, *crossing) && isLeft(b, c, *crossing) && isLeft(c, a, *crossing)) break;
    }
    const bool isCarved = random_.chance(45);  // mostly with the triangle: then nothing may be left of it
    BrushEdit brush{.deed = isCarved ? BrushEdit::Deed::carve : BrushEdit::Deed::fill, .rings = {}};
    if (!isCarved) brush.block = any();
    brush.isEvenOdd = random_.chance(50);
    const std::int64_t far = between(1, 30) * (random_.chance(isCarved ? 40 : 80) ? 1 : -1);
    for (const std::size_t first : {0U, 2U})
      brush.rings.push_back({ends[first], ends[first + 1], near({a.x + d.y * far, a.y - d.x * far}, kMost)});
    return {std::move(gone), std::move(many), Call::byBrush(std::move(brush))};
  }

  /// The lattice point next to where two short edges cross.
  static std::optional<Point> crossingOf(const std::array<Point, 4>& ends) {
    const Vector r = ends[1] - ends[0], s = ends[3] - ends[2];
    std::int64_t divisor = cross(r, s), part = cross(ends[2] - ends[0], s);
    if (divisor < 0) divisor = -divisor, part = -part;
    if (part < 0 || part > divisor || divisor == 0) return std::nullopt;
    const auto rounded = [&](std::int64_t length) {
      const std::int64_t doubled = 2 * length * part + divisor, whole = doubled / (2 * divisor);
      return whole - (doubled < whole * 2 * divisor ? 1 : 0);
    };
    return Point{ends[0].x + rounded(r.x), ends[0].y + rounded(r.y)};
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

  /// A triangle with an edge that passes a corner by less than a unit or two; or runs so along a line between cells, and
  /// past some of them, where its rounded ends lie on the line.
  Ring passing() {
    Point corner = random_.pick(random_.pick(habits_.last));
    const bool isAlongLine = random_.chance(40);
    const std::int64_t most = isAlongLine ? 12'000 : 2'000;
    Point step{between(-most, most), between(-most, most)};
    if (isAlongLine) {
      const Point origin = toWorld(cell_, {0, 0});
      const bool lies = random_.chance(50);
      (lies ? corner.y : corner.x) = lies ? origin.y : origin.x;
      (lies ? step.y : step.x) = 0;
    }
    const std::int64_t to = between(1, 30), from = -between(1, 30);
    const auto along = [&](std::int64_t n) { return near({corner.x + n * step.x, corner.y + n * step.y}, 1); };
    const Point a = along(to), b = along(from);
    return {a, b, near(corner, kUnitsPerCell / 2)};
  }

  /// The last rings, and one of them with a corner less than a unit or two beside an edge, or what lies between that edge
  /// and the corner. So edges that run side by side become one chain, which is an edge of the ground already.
  std::vector<Ring> again() {
    std::vector<Ring> all = habits_.last;
    Ring ring = random_.pick(all);
    const auto k = static_cast<std::size_t>(random_.below(static_cast<int>(ring.size())));
    const Point a = ring[k], b = ring[(k + 1) % ring.size()];
    const std::int64_t part = between(1, 15);
    const Point beside = near({a.x + (b.x - a.x) * part / 16, a.y + (b.y - a.y) * part / 16}, 1);
    if (random_.chance(50)) {
      ring = {a, beside, b};
    } else {
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k) + 1, beside);
    }
    all.push_back(std::move(ring));
    return all;
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
  const auto place = [&lattice, &random] {
    const std::int64_t x = random.between(-12, 12), y = random.between(-12, 12);
    return Point{lattice.centre.x + lattice.step * x, lattice.centre.y + lattice.step * y};
  };
  std::vector<Ring> rings(1 + random.below(2U));
  for (Ring& ring : rings) {
    for (std::int64_t k = random.between(3, 7); k > 0; --k) ring.push_back(place());
    if (random.chance(15)) ring.insert(ring.begin() + 1, {place(), ring.front()});  // there and back
  }
  return rings;
}

Tight tightAt(Point centre, Random& random) { return {centre, kSteps[random.below(kSteps.size())]}; }

std::vector<Call> strokeAt(Cell cell, StrokeHabits& habits, Random& random) {
  std::vector<Call> calls = Painter(cell, habits, random).stroke();
  if (habits.can.regions)
    for (Call& call : calls)
      for (Ring& ring : call.brush.rings) ring = fit(ring, habits.can);
  habits.last = calls.back().brush.rings;
  return calls;
}

}  // namespace lgs::oracle
