#include "fuzz/questions.h"

#include "fuzz/units.h"
#include "oracle/check/questions.h"
#include "oracle/trace/trace.h"

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
using oracle::segmentsOf;

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
  for (const oracle::Call& edit : parsed.trace.calls)
    if (edit.kind == oracle::Call::Kind::add &&
        !again.add(edit.polygon().cell, edit.polygon().vertices, edit.polygon().block))
      return "writeTrace() writes an edit that is refused";
  if (!samePolygons(world, again)) return "writeTrace() writes other polygons";
  return writeSvg(world).starts_with("<svg") ? "" : "writeSvg() writes no picture";
}

}  // namespace

std::string wrongAnswers(const World& world, Random& random) {
  const std::vector<Segment> segments = segmentsOf(world);
  const std::vector<double> radii{0, 1.0 / kCell, 0.25, 1, 3, 40};
  for (int k = 0; k < 4; ++k) {
    const Point p = oracle::somePoint(world, random);
    Point q = oracle::somePoint(world, random);
    if (random.chance(20)) q.x = p.x;
    if (random.chance(20)) q.y = p.y;
    if (std::string wrong = oracle::wrongSpot(world, p); !wrong.empty()) return wrong;
    if (std::string wrong = oracle::wrongNearest(world, segments, p, random.pick(radii)); !wrong.empty()) return wrong;
    const bool isNear = std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)) <= kMaxRay * kCell;
    if (!isNear && world.rayCast(p, q)) return "a ray that is too long is not refused";
    if (!isNear) continue;
    if (std::string wrong = oracle::wrongRay(world, segments, p, q); !wrong.empty()) return wrong;
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
