#include "oracle/check/reads.h"

#include "oracle/calls/random.h"
#include "oracle/trace/dump.h"

#include <fmt/format.h>
#include <algorithm>
#include <tuple>

namespace lgs::oracle {
namespace {

std::string inWords(const CellRect& r) {
  return fmt::format("({}, {}) to ({}, {})", r.min.i, r.min.j, r.max.i, r.max.j);
}

bool isPlaced(const PlacedPolygon& polygon, const Standing::Placed& as) {
  return polygon.block == as.block && std::ranges::equal(polygon.vertices, as.vertices);
}

// All cells, none, one cell with segments, some that hold others, and a rectangle that reaches into empty chunks.
std::vector<CellRect> someRects(std::span<const Segment> segments) {
  constexpr CellRect kAll{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};
  constexpr CellRect kNone{{1, 0}, {0, 5}};
  std::vector<CellRect> rects{kAll, kNone};
  std::vector<Cell> cells;
  for (const Segment& s : segments)
    if (s.id) cells.push_back(s.cell);
  if (cells.empty()) return rects;
  Random random(cells.size() + segments.size());
  for (int k = 0; k < 3; ++k) {
    const Cell a = random.pick(cells);
    const Cell b = k == 0 ? a : random.pick(cells);
    rects.push_back({{std::min(a.i, b.i), std::min(a.j, b.j)}, {std::max(a.i, b.i), std::max(a.j, b.j)}});
  }
  rects.push_back({{cells[0].i - 40, cells[0].j}, {cells[0].i, cells[0].j + 40}});  // other chunks, and none
  return rects;
}

std::optional<WrongRead> readRect(const World& world, std::span<const Segment> segments, const CellRect& rect) {
  std::vector<SegmentId> expected;
  for (const Segment& s : segments)
    if (s.id && contains(rect, s.cell)) expected.push_back(s.id);
  std::vector<SegmentId> actual = world.segments(rect);
  std::sort(actual.begin(), actual.end());
  if (actual == expected) return std::nullopt;
  WrongRead wrong{fmt::format("{} segments in cells {}, but there should be {}, or others", actual.size(),
                              inWords(rect), expected.size())};
  std::vector<SegmentId> differing;
  std::set_symmetric_difference(actual.begin(), actual.end(), expected.begin(), expected.end(),
                                std::back_inserter(differing));
  for (const SegmentId id : differing)
    if (const auto s = world.segment(id)) wrong.about.push_back(outlineSegment(*s));
  return wrong;
}

// Many at once, as they are and in cells from an origin, in both kinds of reals: as one by one.
template <class Real>
bool isRead(const RealPoint<Real>& actual, Point p, Point origin) {
  const auto part = [](std::int64_t units) { return static_cast<Real>(static_cast<double>(units) / kUnitsPerCell); };
  return actual.x == part(p.x - origin.x) && actual.y == part(p.y - origin.y);
}

template <class Real>
bool areRead(const World& world, const std::vector<SegmentId>& ids, const std::vector<Segment>& expected) {
  const Point origin = expected.empty() ? Point{} : expected.back().end;
  std::vector<RealSegment<Real>> many(ids.size());
  return world.segments(ids, origin, many) && std::ranges::equal(many, expected, [&](const auto& a, const Segment& s) {
           return std::tie(a.id, a.predecessor, a.successor, a.block, a.polygon, a.cell) ==
                      std::tie(s.id, s.predecessor, s.successor, s.block, s.polygon, s.cell) &&
                  isRead(a.start, s.start, origin) && isRead(a.end, s.end, origin) &&
                  (!s.predecessor || isRead(a.ghost1, s.ghost1, origin)) &&
                  (!s.successor || isRead(a.ghost2, s.ghost2, origin));
         });
}

bool isSame(const Segment& a, const Segment& b) {
  return std::tie(a.id, a.start, a.end, a.predecessor, a.successor, a.block, a.polygon, a.cell) ==
             std::tie(b.id, b.start, b.end, b.predecessor, b.successor, b.block, b.polygon, b.cell) &&
         (!a.predecessor || a.ghost1 == b.ghost1) && (!a.successor || a.ghost2 == b.ghost2);
}

std::optional<WrongRead> readMany(const World& world) {
  const std::vector<SegmentId> ids = world.segments();
  std::vector<Segment> each, many(ids.size());
  for (const SegmentId id : ids) each.push_back(*world.segment(id));
  if (!world.segments(ids, many) || !std::ranges::equal(many, each, isSame) || !areRead<float>(world, ids, each) ||
      !areRead<double>(world, ids, each))
    return WrongRead{"many segments are read otherwise than one by one"};
  return std::nullopt;
}

std::optional<CellRect> leastRect(const Standing& standing) {
  std::optional<CellRect> rect;
  for (const auto& [cell, placed] : standing.cells()) {
    CellRect& r = rect ? *rect : rect.emplace(CellRect{cell, cell});
    r.min = {std::min(r.min.i, cell.i), std::min(r.min.j, cell.j)};
    r.max = {std::max(r.max.i, cell.i), std::max(r.max.j, cell.j)};
  }
  return rect;
}

// The least box of each shape, by its polygons.
std::optional<WrongRead> readShapes(const World& world) {
  const auto count = static_cast<std::uint32_t>(world.stats().shapes);
  for (std::uint32_t id = 1; id <= count; ++id) {
    const auto polygons = world.polygonsOf({id});
    const auto box = world.boundingBox({id});
    if (!polygons || !box) return WrongRead{fmt::format("shape {} of {} is unknown", id, count)};
    LocalBox least{(*polygons)[0][0], (*polygons)[0][0]};
    for (const auto& polygon : *polygons) {
      for (const LocalPoint p : polygon) {
        least.min = {std::min(least.min.x, p.x), std::min(least.min.y, p.y)};
        least.max = {std::max(least.max.x, p.x), std::max(least.max.y, p.y)};
      }
    }
    if (*box != least) return WrongRead{fmt::format("shape {} has another box", id)};
  }
  if (world.boundingBox({count + 1}) || world.polygonsOf({0})) return WrongRead{"a shape that was never made is known"};
  return std::nullopt;
}

}  // namespace

std::optional<WrongRead> readCell(const World& world, const Standing& standing, Cell cell) {
  const auto wrong = [&](const std::string& text) {
    return WrongRead{fmt::format("cell ({}, {}) {}", cell.i, cell.j, text)};
  };
  const std::vector<PlacedPolygon> there = world.polygons(cell);
  const std::vector<Standing::Placed>& expected = standing.in(cell);
  if (there.size() != expected.size())
    return wrong(fmt::format("has {} polygons, but should have {}", there.size(), expected.size()));
  std::vector<PlacedPolygon> again(3);
  world.polygons(cell, again);
  if (again.size() != there.size()) return wrong("reads otherwise into a list that was not empty");
  for (const Standing::Placed& placed : expected) {
    const PolygonHandle handle = placed.handle;
    const auto isIt = [&](const PlacedPolygon& p) { return p.handle == handle && isPlaced(p, placed); };
    if (std::none_of(there.begin(), there.end(), isIt) || std::none_of(again.begin(), again.end(), isIt))
      return wrong(fmt::format("does not hold '{}' as it was placed", placed.name));
    const auto polygon = world.polygon(handle);
    const auto where = world.cellOf(handle);
    if (!polygon || !isIt(*polygon) || !where || *where != cell)
      return wrong(fmt::format("holds '{}', which its handle does not find", placed.name));
  }
  return std::nullopt;
}

std::optional<WrongRead> readPolygons(const Player& player) {
  const Standing& model = player.standing();
  for (const auto& entry : model.cells())
    if (auto wrong = readCell(player.world(), model, entry.first)) return wrong;
  for (const auto& entry : player.model().state().away)
    for (const auto& [cell, there] : entry.second)
      for (const Standing::Placed& placed : there) {
        const auto none = player.world().polygon(placed.handle);
        if (none || none.error().code != ErrorCode::unloaded || none.error().cell != cell)
          return WrongRead{fmt::format("'{}' is not in memory, and its handle does not say so", placed.name)};
      }
  const Stats stats = player.world().stats();
  const auto differs = [](const char* of, std::uint64_t actual, std::uint64_t expected) {
    return WrongRead{fmt::format("stats() counts {} {}, but there should be {}", actual, of, expected)};
  };
  if (stats.polygons != model.polygons()) return differs("polygons", stats.polygons, model.polygons());
  if (stats.cells != model.cells().size()) return differs("cells", stats.cells, model.cells().size());
  const std::size_t chunks = player.model().chunks();
  if (stats.chunks != chunks) return differs("chunks", stats.chunks, chunks);
  if (stats.shapes != player.shapes()) return differs("shapes", stats.shapes, player.shapes());
  if (player.world().bounds() != leastRect(model))
    return WrongRead{"bounds() is not the least rectangle of all polygons"};
  return readShapes(player.world());
}

std::optional<WrongRead> readSegments(const World& world, std::span<const Segment> segments, bool isAway) {
  const auto most = static_cast<std::uint32_t>(segments.size() - 1);
  if (isAway ? world.maxSegmentId() < most : world.maxSegmentId() != most)
    return WrongRead{fmt::format("the highest id is said to be {}, but {} was", world.maxSegmentId(), most)};
  std::uint64_t alive = 0;
  for (std::uint32_t id = 0; id <= most + 2; ++id) {
    if (id <= most && segments[id].id) {
      ++alive;  // the mirror has read it
      continue;
    }
    const auto none = world.segment({id});
    if (!none && none.error().code == ErrorCode::unloaded && isAway) continue;
    if (none || none.error().code != ErrorCode::unknownSegment || none.error().segment != SegmentId{id})
      return WrongRead{fmt::format("id {} names no segment, but can be read", id)};
  }
  if (world.segment({UINT32_MAX})) return WrongRead{"an id that was never used can be read"};
  if (const std::uint64_t counted = world.stats().segments; counted != alive)
    return WrongRead{fmt::format("stats() counts {} segments, but there should be {}", counted, alive)};
  for (const CellRect& rect : someRects(segments))
    if (auto wrong = readRect(world, segments, rect)) return wrong;
  return readMany(world);
}

}  // namespace lgs::oracle
