#include "oracle/check/observed.h"

#include "oracle/trace/call_text.h"

#include <fmt/format.h>
#include <map>
#include <tuple>

namespace lgs::oracle {
namespace {

auto fieldsOf(const Segment& s) {
  return std::tuple(s.id, s.start, s.end, s.predecessor, s.successor, s.predecessor ? s.ghost1 : Point{},
                    s.successor ? s.ghost2 : Point{}, s.block, s.polygon, s.cell);
}

struct Stands {
  Cell cell;
  Block block = 0;
  std::vector<LocalPoint> vertices;
  friend bool operator==(const Stands&, const Stands&) = default;
};

std::map<PolygonHandle, Stands> standingIn(const World& world) {
  std::map<PolygonHandle, Stands> all;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    all[p.handle] = {cell, p.block, {p.vertices.begin(), p.vertices.end()}};
  });
  return all;
}

}  // namespace

std::vector<std::byte> saved(const World& world) {
  std::vector<std::byte> bytes;
  const auto keep = [&](std::span<const std::byte> piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); };
  return world.save(keep) ? bytes : std::vector<std::byte>();
}

std::string differenceOf(const World& a, const World& b) {
  if (standingIn(a) != standingIn(b)) return "other polygons, or by other handles";
  if (!samePolygons(a, b)) return "samePolygons() does not say that they are the same";
  const auto ids = a.segments();
  if (ids != b.segments()) return "other segments";
  for (const SegmentId id : ids)
    if (fieldsOf(*a.segment(id)) != fieldsOf(*b.segment(id))) return fmt::format("another segment {}", id.value);
  if (a.maxSegmentId() != b.maxSegmentId()) return "another highest id";
  const auto counts = [](const Stats& s) { return std::tuple(s.polygons, s.cells, s.segments, s.shapes, s.chunks); };
  if (counts(a.stats()) != counts(b.stats())) return "stats() counts something else";
  return saved(a) == saved(b) ? "" : "saved, they are different bytes";
}

std::string wrongPast(const Player& player) {
  Caller twin{World(relationOf(player.preserve()))};
  for (const auto& told : player.past()) {
    if (told->outcome.refusal)
      twin.makeShapes(told->call);
    else if (twin.makeResolved(told->call) != told->outcome && !told->isOther)
      return "once more, without what was undone or refused, another answer: " + printCall(told->call);
  }
  const std::string difference = differenceOf(player.world(), twin.world);
  return difference.empty() ? "" : "a world in which nothing was undone or refused has " + difference;
}

}  // namespace lgs::oracle
