#include "questions.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace lgs::oracle {
namespace {

constexpr std::int64_t kCell = kUnitsPerCell;

__extension__ using Exact = __int128;

/// From one point to another.
struct Arrow {
  Exact x, y;
};
Arrow arrow(Point from, Point to) { return {Exact{to.x} - from.x, Exact{to.y} - from.y}; }
Exact cross(Arrow a, Arrow b) { return a.x * b.y - a.y * b.x; }
Exact dot(Arrow a, Arrow b) { return a.x * b.x + a.y * b.y; }

/// A fraction whose denominator is positive. Products of two of them fit: what is compared is near the point asked for.
struct Ratio {
  Exact over, under;
  double real() const { return static_cast<double>(over) / static_cast<double>(under); }
};
bool operator<(const Ratio& a, const Ratio& b) { return a.over * b.under < b.over * a.under; }

std::string told(Point p) { return fmt::format("({}, {})", p.x, p.y); }

auto nameOf(const Segment& s) { return std::tuple(s.start, s.end, s.block); }

/// The winding number, or nothing on the outline.
std::optional<int> winding(std::span<const LocalPoint> polygon, Cell cell, Point p) {
  int turns = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Arrow a = arrow(p, toWorld(cell, polygon[k])), b = arrow(p, toWorld(cell, polygon[(k + 1) % polygon.size()]));
    const Exact side = cross(a, b);
    if (side == 0 && dot(a, b) <= 0) return std::nullopt;
    if (a.y <= 0 && b.y > 0 && side > 0) ++turns;
    if (a.y > 0 && b.y <= 0 && side < 0) --turns;
  }
  return turns;
}

Spot slowSpot(const World& world, Point p) {
  Spot spot;
  spot.cell = cellAt(p);
  const auto look = [&](Cell cell, const PlacedPolygon& polygon) {
    const auto turns = winding(polygon.vertices, cell, p);
    if (turns == 0) return;
    const Spot here{turns ? Spot::Where::inside : Spot::Where::edge, polygon.handle, polygon.block, cell};
    const auto order = [](const Spot& s) {
      return std::tuple(s.where != Spot::Where::inside, s.cell.j, s.cell.i, s.polygon);
    };
    if (spot.where == Spot::Where::outside || order(here) < order(spot)) spot = here;
  };
  const Cell at = spot.cell;  // a polygon reaches no further than the rim of its cell
  world.forEachPolygon({{at.i - 1, at.j - 1}, {at.i + 1, at.j + 1}}, look);
  return spot;
}

Point inTheWorld(std::int64_t x, std::int64_t y) {
  return {std::clamp(x, -kMaxCoordinate, kMaxCoordinate), std::clamp(y, -kMaxCoordinate, kMaxCoordinate)};
}

/// Whether a question had to look where nothing is in memory.
bool isRightlyUnseen(const World& world, const Error& error) {
  return error.code == ErrorCode::unloaded && inRange(error.cell) &&
         world.firstUnloaded({error.cell, error.cell}) == error.cell;
}

/// The square of the distance.
Ratio distance(const Segment& s, Point p) {
  const Arrow along = arrow(s.start, s.end), to = arrow(s.start, p);
  const Exact part = dot(to, along), whole = dot(along, along);
  if (part <= 0) return {dot(to, to), 1};
  if (part >= whole) return {dot(arrow(s.end, p), arrow(s.end, p)), 1};
  return {cross(to, along) * cross(to, along), whole};
}

}  // namespace

std::vector<Segment> segmentsOf(const World& world) {
  std::vector<Segment> all;
  for (const SegmentId id : world.segments()) all.push_back(*world.segment(id));
  return all;
}

Point somePoint(const World& world, Random& random) {
  const auto ids = world.segments();
  if (ids.empty() || random.chance(20)) {
    const Point origin = toWorld(world.bounds().value_or(CellRect{}).min, {});
    const std::int64_t x = random.below(6 * kCell) - kCell, y = random.below(6 * kCell) - kCell;
    return inTheWorld(origin.x + x, origin.y + y);
  }
  const Segment s = *world.segment(random.pick(ids));
  const Point p = random.chance(50) ? s.start : Point{(s.start.x + s.end.x) / 2, (s.start.y + s.end.y) / 2};
  const std::int64_t spread = random.chance(30) ? 0 : random.chance(50) ? 1 : kCell;
  const std::int64_t x = random.below(2 * spread + 1) - spread, y = random.below(2 * spread + 1) - spread;
  return inTheWorld(p.x + x, p.y + y);
}

std::string wrongSpot(const World& world, Point p) {
  const Spot actual = world.at(p), expected = slowSpot(world, p);
  const auto fields = [](const Spot& s) { return std::tuple(s.where, s.polygon, s.block, s.cell); };
  return fields(actual) == fields(expected) ? "" : fmt::format("at{} is not what lies there", told(p));
}

std::string wrongNearest(const World& world, std::span<const Segment> segments, Point p, double radius) {
  const auto actual = world.nearest(p, radius);
  if (!actual) return isRightlyUnseen(world, actual.error()) ? "" : "nearest() is refused: " + message(actual.error());
  const std::int64_t reach = std::llround(radius * static_cast<double>(kCell));
  const Segment* nearest = nullptr;
  Ratio least{Exact{reach} * reach, 1};
  for (const Segment& s : segments) {
    const auto isFar = [&](std::int64_t a, std::int64_t b, std::int64_t at) {
      return std::min(a, b) > at + reach || std::max(a, b) < at - reach;
    };
    if (isFar(s.start.x, s.end.x, p.x) || isFar(s.start.y, s.end.y, p.y)) continue;
    const Ratio here = distance(s, p);
    if (least < here || (nearest && !(here < least) && nameOf(*nearest) <= nameOf(s))) continue;
    nearest = &s;
    least = here;
  }
  const std::string where = fmt::format("nearest({}, {})", told(p), radius);
  if (!nearest || !actual->segment)
    return nearest || actual->segment ? where + " finds a segment too many, or none" : "";
  const auto found = world.segment(actual->segment);
  if (!found || nameOf(*found) != nameOf(*nearest)) return where + " finds another segment";
  const double expected = std::sqrt(least.real()) / static_cast<double>(kCell);
  const auto away = [](double at, std::int64_t from) {
    return at - static_cast<double>(from) / static_cast<double>(kCell);
  };
  const double told = std::hypot(away(actual->point.x, p.x), away(actual->point.y, p.y));
  const bool isRight = std::abs(actual->distance - expected) <= 1e-12 * std::max(1.0, expected);
  return isRight && std::abs(told - expected) <= 1e-6 ? "" : where + " finds it at another distance";
}

std::string wrongRay(const World& world, std::span<const Segment> segments, Point from, Point to) {
  const auto actual = world.rayCast(from, to);
  if (!actual) return isRightlyUnseen(world, actual.error()) ? "" : "rayCast() is refused: " + message(actual.error());
  const Segment* first = nullptr;
  Ratio least{1, 1};
  const Arrow ray = arrow(from, to);
  for (const Segment& s : segments) {
    const Arrow along = arrow(s.start, s.end), start = arrow(from, s.start);
    const Exact turn = -cross(ray, along);
    if (turn <= 0) continue;  // from behind, or along it
    const Ratio here{-cross(start, along), turn};
    const Exact part = -cross(start, ray);
    if (here.over < 0 || here.over > turn || part < 0 || part > turn) continue;
    if (first && (least < here || (!(here < least) && nameOf(*first) <= nameOf(s)))) continue;
    first = &s;
    least = here;
  }
  const std::string where = fmt::format("rayCast({}, {})", told(from), told(to));
  if (!first || !actual->segment) return first || actual->segment ? where + " meets a segment too many, or none" : "";
  const auto found = world.segment(actual->segment);
  if (!found || nameOf(*found) != nameOf(*first)) return where + " meets another segment";
  const DoublePoint normal = first->normal();
  const bool isNormal = actual->normal.x == normal.x && actual->normal.y == normal.y;
  return isNormal && std::abs(actual->fraction - least.real()) <= 1e-12 ? "" : where + " meets it elsewhere";
}

namespace {

// Where nothing is in memory: handles of other chunks are not known here.
std::string wrongSpotBeside(const World& world, const Scene& scene, Point p) {
  const Spot actual = world.at(p);
  if (actual.where == Spot::Where::unloaded)
    return world.firstUnloaded({actual.cell, actual.cell}) == actual.cell ? ""
                                                                          : "at() says unloaded of what is in memory";
  auto expected = Spot::Where::outside;
  for (const ScenePolygon& polygon : scene.polygons) {
    const auto turns = winding(polygon.vertices, polygon.cell, p);
    if (turns == 0) continue;
    if (!turns && expected != Spot::Where::inside) expected = Spot::Where::edge;
    if (turns) expected = Spot::Where::inside;
    if (turns && actual.block != polygon.block) return fmt::format("at{} is of another block", told(p));
  }
  return actual.where == expected ? "" : fmt::format("at{} is not what lies there", told(p));
}

Point pointNear(const Outline& whole, Random& random) {
  const OutlineSegment& s = random.pick(whole);
  const Point p = random.chance(50) ? s.start : Point{(s.start.x + s.end.x) / 2, (s.start.y + s.end.y) / 2};
  const std::int64_t spread = random.chance(30) ? 0 : random.chance(50) ? 1 : kCell;
  const std::int64_t x = random.below(2 * spread + 1) - spread, y = random.below(2 * spread + 1) - spread;
  return inTheWorld(p.x + x, p.y + y);
}

}  // namespace

std::string wrongAnswers(const World& world, const Scene& scene, const Outline& whole, Random& random,
                         std::size_t count) {
  if (whole.empty()) return "";
  std::vector<Segment> segments;
  for (const OutlineSegment& s : whole) {
    Segment& segment = segments.emplace_back();
    segment.start = s.start;
    segment.end = s.end;
    segment.block = s.block;
  }
  const bool isWhole = !world.firstUnloaded({{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}});
  for (; count > 0; --count) {
    const Point p = pointNear(whole, random), q = pointNear(whole, random);
    std::string wrong = isWhole ? wrongSpot(world, p) : wrongSpotBeside(world, scene, p);
    if (wrong.empty()) wrong = wrongNearest(world, segments, p, random.below(5) / 2.0);
    const auto isFar = [](std::int64_t a, std::int64_t b) { return std::abs(a - b) > 1'000 * kCell; };
    if (wrong.empty() && !isFar(p.x, q.x) && !isFar(p.y, q.y)) wrong = wrongRay(world, segments, p, q);
    if (!wrong.empty()) return wrong;
  }
  return "";
}

// It is another world as soon as one of its polygons has another block.
std::string wrongComparison(const World& world, World other) {
  if (!samePolygons(world, other) || !samePolygons(other, world))
    return "samePolygons() does not know the same polygons again";
  PolygonHandle any;
  Block block = 0;
  other.forEachPolygon([&](Cell, const PlacedPolygon& p) {
    any = p.handle;
    block = p.block;
  });
  if (!any || !other.setBlock(any, block + 1)) return "";
  return samePolygons(world, other) ? "samePolygons() does not see another block" : "";
}

}  // namespace lgs::oracle
