#include "fuzz/questions.h"

#include "fuzz/units.h"
#include "oracle/trace/trace.h"
#include "oracle/views/recompute.h"

#include <fmt/format.h>
#include <lgs/debug.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

namespace lgs::fuzz {
namespace {

using oracle::Random;
using oracle::Wide;

struct Vector {
  Wide x, y;
};
Vector operator-(Point a, Point b) { return {Wide{a.x} - b.x, Wide{a.y} - b.y}; }
Wide cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
Wide dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }

/// A fraction whose denominator is positive. Products of two of them fit: what is compared is near the point asked for.
struct Ratio {
  Wide over, under;
  double real() const { return static_cast<double>(over) / static_cast<double>(under); }
};
bool operator<(const Ratio& a, const Ratio& b) { return a.over * b.under < b.over * a.under; }

std::string inWords(Point p) { return fmt::format("({}, {})", p.x, p.y); }

auto nameOf(const Segment& s) { return std::tuple(s.start, s.end, s.block); }

std::vector<Segment> segmentsOf(const World& world) {
  std::vector<Segment> all;
  for (const SegmentId id : world.segments()) all.push_back(*world.segment(id));
  return all;
}

/// The winding number, or nothing on the outline.
std::optional<int> winding(std::span<const LocalPoint> polygon, Cell cell, Point p) {
  int turns = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector a = toWorld(cell, polygon[k]) - p, b = toWorld(cell, polygon[(k + 1) % polygon.size()]) - p;
    const Wide side = cross(a, b);
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
  world.forEachPolygon(look);
  return spot;
}

std::string wrongSpot(const World& world, Point p) {
  const Spot actual = world.at(p), expected = slowSpot(world, p);
  const auto fields = [](const Spot& s) { return std::tuple(s.where, s.polygon, s.block, s.cell); };
  return fields(actual) == fields(expected) ? "" : fmt::format("at{} is not what lies there", inWords(p));
}

/// The square of the distance.
Ratio distance(const Segment& s, Point p) {
  const Vector along = s.end - s.start, to = p - s.start;
  const Wide part = dot(to, along), whole = dot(along, along);
  if (part <= 0) return {dot(to, to), 1};
  if (part >= whole) return {dot(p - s.end, p - s.end), 1};
  return {cross(to, along) * cross(to, along), whole};
}

std::string wrongNearest(const World& world, const std::vector<Segment>& segments, Point p, double radius) {
  const auto actual = world.nearest(p, radius);
  if (!actual) return "nearest() is refused: " + message(actual.error());
  const std::int64_t reach = std::llround(radius * static_cast<double>(kCell));
  const Segment* nearest = nullptr;
  Ratio least{Wide{reach} * reach, 1};
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
  const std::string where = fmt::format("nearest({}, {})", inWords(p), radius);
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

std::string wrongRay(const World& world, const std::vector<Segment>& segments, Point from, Point to) {
  const auto actual = world.rayCast(from, to);
  if (!actual) return "rayCast() is refused: " + message(actual.error());
  const Segment* first = nullptr;
  Ratio least{1, 1};
  const Vector ray = to - from;
  for (const Segment& s : segments) {
    const Vector along = s.end - s.start, start = s.start - from;
    const Wide turn = -cross(ray, along);
    if (turn <= 0) continue;  // from behind, or along it
    const Ratio here{-cross(start, along), turn};
    const Wide part = -cross(start, ray);
    if (here.over < 0 || here.over > turn || part < 0 || part > turn) continue;
    if (first && (least < here || (!(here < least) && nameOf(*first) <= nameOf(s)))) continue;
    first = &s;
    least = here;
  }
  const std::string where = fmt::format("rayCast({}, {})", inWords(from), inWords(to));
  if (!first || !actual->segment) return first || actual->segment ? where + " meets a segment too many, or none" : "";
  const auto found = world.segment(actual->segment);
  if (!found || nameOf(*found) != nameOf(*first)) return where + " meets another segment";
  const DoublePoint normal = first->normal();
  const bool isNormal = actual->normal.x == normal.x && actual->normal.y == normal.y;
  return isNormal && std::abs(actual->fraction - least.real()) <= 1e-12 ? "" : where + " meets it elsewhere";
}

template <class Real>
std::string wrongReals(const World& world, const std::vector<Segment>& segments) {
  std::vector<SegmentId> ids;
  for (const Segment& s : segments) ids.push_back(s.id);
  std::vector<RealSegment<Real>> reals(ids.size());
  if (ids.empty()) return "";
  const Point origin = segments.front().start;
  if (!world.segments(ids, origin, reals)) return "segments() in reals is refused";
  const auto is = [&](RealPoint<Real> real, Point p) {
    const auto of = [](std::int64_t units) { return static_cast<Real>(static_cast<double>(units) / kCell); };
    return real.x == of(p.x - origin.x) && real.y == of(p.y - origin.y);
  };
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Segment& s = segments[k];
    const RealSegment<Real>& r = reals[k];
    const bool isSame = std::tie(r.id, r.predecessor, r.successor, r.block, r.polygon, r.cell) ==
                        std::tie(s.id, s.predecessor, s.successor, s.block, s.polygon, s.cell);
    if (!isSame || !is(r.start, s.start) || !is(r.end, s.end) || (s.predecessor && !is(r.ghost1, s.ghost1)) ||
        (s.successor && !is(r.ghost2, s.ghost2)))
      return fmt::format("segment {} is another one in reals", s.id.value);
  }
  ids.back() = SegmentId{0xffff'fff0};
  const auto none = world.segments(ids, origin, reals);
  const bool isTold = !none && none.error().code == ErrorCode::unknownSegment &&
                      none.error().index == static_cast<std::int32_t>(ids.size()) - 1;
  return isTold ? "" : "an unknown segment among many is not told";
}

/// The least box of each shape; its polygons are not empty.
std::string wrongShapes(const World& world) {
  const auto count = static_cast<std::uint32_t>(world.stats().shapes);
  for (std::uint32_t id = 1; id <= count; ++id) {
    const auto polygons = world.polygonsOf({id});
    const auto box = world.boundingBox({id});
    if (!polygons || !box) return fmt::format("shape {} of {} is unknown", id, count);
    LocalBox least{(*polygons)[0][0], (*polygons)[0][0]};
    for (const auto& polygon : *polygons) {
      for (const LocalPoint p : polygon) {
        least.min = {std::min(least.min.x, p.x), std::min(least.min.y, p.y)};
        least.max = {std::max(least.max.x, p.x), std::max(least.max.y, p.y)};
      }
    }
    if (*box != least) return fmt::format("shape {} has another box", id);
  }
  return world.boundingBox({count + 1}) || world.polygonsOf({0}) ? "a shape that was never made is known" : "";
}

/// What is written as a trace is read as the same polygons.
std::string wrongTrace(const World& world) {
  const oracle::ParsedTrace parsed = oracle::parseTrace(writeTrace(world));
  if (parsed.error) return "writeTrace() writes what is no trace";
  World again(world.preserveRelation());
  for (const oracle::Edit& edit : parsed.trace.edits)
    if (edit.kind == oracle::Edit::Kind::add &&
        !again.add(edit.polygon.cell, edit.polygon.vertices, edit.polygon.block))
      return "writeTrace() writes an edit that is refused";
  if (!samePolygons(world, again)) return "writeTrace() writes other polygons";
  return writeSvg(world).starts_with("<svg") ? "" : "writeSvg() writes no picture";
}

}  // namespace

Point somePoint(const World& world, Random& random) {
  const auto inTheWorld = [](std::int64_t x, std::int64_t y) {
    return Point{std::clamp(x, -kMaxCoordinate, kMaxCoordinate), std::clamp(y, -kMaxCoordinate, kMaxCoordinate)};
  };
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

std::string wrongAnswers(const World& world, Random& random) {
  const std::vector<Segment> segments = segmentsOf(world);
  const std::vector<double> radii{0, 1.0 / kCell, 0.25, 1, 3, 40};
  for (int k = 0; k < 4; ++k) {
    const Point p = somePoint(world, random);
    Point q = somePoint(world, random);
    if (random.chance(20)) q.x = p.x;
    if (random.chance(20)) q.y = p.y;
    if (std::string wrong = wrongSpot(world, p); !wrong.empty()) return wrong;
    if (std::string wrong = wrongNearest(world, segments, p, random.pick(radii)); !wrong.empty()) return wrong;
    const bool isNear = std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)) <= kMaxRay * kCell;
    if (!isNear && world.rayCast(p, q)) return "a ray that is too long is not refused";
    if (!isNear) continue;
    if (std::string wrong = wrongRay(world, segments, p, q); !wrong.empty()) return wrong;
  }
  const Point beyond{kMaxCoordinate + 1, 0};
  const bool isRefused = !world.nearest(beyond, 1) && !world.nearest({}, kMaxRadius + 1.0) && !world.nearest({}, -1) &&
                         !world.rayCast({}, beyond) && world.at(beyond).where == Spot::Where::outside;
  return isRefused ? "" : "what is out of reach is answered";
}

std::string wrongReads(const World& world) {
  const std::vector<Segment> segments = segmentsOf(world);
  std::optional<CellRect> bounds;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon&) {
    CellRect& r = bounds ? *bounds : bounds.emplace(CellRect{cell, cell});
    r.min = {std::min(r.min.i, cell.i), std::min(r.min.j, cell.j)};
    r.max = {std::max(r.max.i, cell.i), std::max(r.max.j, cell.j)};
  });
  if (world.bounds() != bounds) return "bounds() is not the least rectangle of all polygons";
  if (std::string wrong = wrongReals<double>(world, segments); !wrong.empty()) return wrong;
  if (std::string wrong = wrongReals<float>(world, segments); !wrong.empty()) return wrong;
  if (std::string wrong = wrongShapes(world); !wrong.empty()) return wrong;
  return wrongTrace(world);
}

}  // namespace lgs::fuzz
