// What leaves the ground as a body, and what an edit would do: on a copy of the world. An island that is taken has all
// polygons that hang together, and comes back as it was; what was foreseen is what happens, and leaves no trace.
#include "oracle/check/laws/list.h"
#include "oracle/check/observed.h"
#include "oracle/reference/vector.h"
#include "oracle/views/touching.h"

#include <lgs/islands.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lgs::oracle {
namespace {

// Where its last polygon was there is another one: it is not put there, nor is a part of it.
std::string wrongRefusal(World world, const Body& body) {
  const BodyPolygon& last = body.polygons.back();
  const Cell cell{last.cell.i + body.origin.i, last.cell.j + body.origin.j};
  if (!world.add(cell, std::span<const LocalPoint>(last.vertices), last.block)) return "what was taken is still there";
  const World before = world;
  const auto placed = put(world, body, body.origin);
  // A cell that is full already says so first.
  const bool isRefused =
      !placed && (placed.error().code == ErrorCode::overlap || placed.error().code == ErrorCode::capacity);
  if (!isRefused || placed.error().index + 1 != std::ssize(body.polygons))
    return "a body is put where something is in the way of its last polygon, or another one is blamed";
  std::string left = differenceOf(before, world);
  return left.empty() ? "" : "a body that does not fit leaves " + left;
}

// Summed up about the centroid that is told, where nothing cancels: the area, how far that is off, and the moment.
bool isMassOf(const Body& body) {
  using Real = std::array<double, 2>;
  double area = 0, offX = 0, offY = 0, moment = 0, size = 1;
  for (const BodyPolygon& p : body.polygons) {
    const auto at = [&](std::size_t k) {
      const LocalPoint v = p.vertices[k % p.vertices.size()];
      return Real{p.cell.i + double{1} * v.x / kUnitsPerCell - body.mass.centroid.x,
                  p.cell.j + double{1} * v.y / kUnitsPerCell - body.mass.centroid.y};
    };
    for (std::size_t k = 0; k < p.vertices.size(); ++k) {
      const auto [ax, ay] = at(k);
      const auto [bx, by] = at(k + 1);
      const double turn = ax * by - ay * bx;
      area += turn / 2;
      offX += (ax + bx) * turn / 6;
      offY += (ay + by) * turn / 6;
      moment += (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) * turn / 12;
      size = std::max({size, std::abs(ax), std::abs(ay)});
    }
  }
  constexpr double kNear = 1e-7;
  const double most = kNear * size * std::max(area, 1e-9);
  return std::abs(area - body.mass.area) <= kNear * area && std::abs(offX) <= most && std::abs(offY) <= most &&
         std::abs(moment - body.mass.secondMoment) <= kNear * size * moment + 1e-12;
}

bool haveCommonEdge(const ScenePolygon& one, const ScenePolygon& other) {
  const auto edge = [](const ScenePolygon& p, std::size_t k) {
    return std::pair(toWorld(p.cell, p.vertices[k]), toWorld(p.cell, p.vertices[(k + 1) % p.vertices.size()]));
  };
  for (std::size_t k = 0; k < one.vertices.size(); ++k) {
    for (std::size_t l = 0; l < other.vertices.size(); ++l) {
      const auto [a, b] = edge(one, k);
      const auto [v, u] = edge(other, l);  // the other way around
      if (cross(b - a, u - a) != 0 || cross(b - a, v - a) != 0) continue;
      if (std::max(std::min(a, b), std::min(u, v)) < std::min(std::max(a, b), std::max(u, v))) return true;
    }
  }
  return false;
}

// An island that is taken apart is as many bodies as hang together by edges, with the same polygons in all.
std::string wrongParts(World world, const std::vector<ScenePolygon>& polygons, PolygonHandle one) {
  std::vector<std::size_t> set(polygons.size());
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    set[k] = k;
    for (std::size_t l = 0; l < k; ++l)
      if (set[l] != set[k] && haveCommonEdge(polygons[k], polygons[l])) std::ranges::replace(set, set[k], set[l]);
  }
  std::ranges::sort(set);
  const auto count = static_cast<std::size_t>(std::unique(set.begin(), set.end()) - set.begin());
  const Islands islands(world);
  const auto bodies = takeApart(world, islands, islands.of(world, one));
  if (!bodies || bodies->size() != count) return "an island comes apart in other bodies than those that edges hold";
  std::vector<ScenePolygon> taken;
  for (const Body& body : *bodies) {
    if (!isMassOf(body)) return "a body that came apart has another mass than its polygons";
    for (const BodyPolygon& p : body.polygons)
      taken.push_back({{p.cell.i + body.origin.i, p.cell.j + body.origin.j}, p.block, p.vertices});
  }
  return std::ranges::is_permutation(taken, polygons) ? "" : "an island that comes apart has other polygons then";
}

std::string wrongBody(const World& world, const Scene& scene, std::size_t which) {
  World copy = world;
  const Islands islands(copy);
  const ScenePolygon& one = scene.polygons[which];
  const std::vector<std::size_t> sets = setsOf(scene.polygons);
  const auto there = copy.polygons(one.cell);
  const auto is = [&](const PlacedPolygon& p) {
    return p.block == one.block && std::ranges::equal(p.vertices, one.vertices);
  };
  const PolygonHandle handle = std::ranges::find_if(there, is)->handle;
  const IslandId island = islands.of(copy, handle);
  const auto body = take(copy, islands, island);
  if (!body) return "an island can not be taken: " + message(body.error());
  std::vector<ScenePolygon> taken, expected, left;
  for (const BodyPolygon& p : body->polygons)
    taken.push_back({{p.cell.i + body->origin.i, p.cell.j + body->origin.j}, p.block, p.vertices});
  for (std::size_t k = 0; k < sets.size(); ++k) (sets[k] == sets[which] ? expected : left).push_back(scene.polygons[k]);
  const auto areAlike = [](const auto& a, const auto& b) { return std::ranges::is_permutation(a, b); };
  if (!areAlike(taken, expected)) return "a body has other polygons than its island";
  if (!isMassOf(*body)) return "a body has another mass than its polygons";
  if (std::string wrong = wrongParts(world, expected, handle); !wrong.empty()) return wrong;
  std::vector<ScenePolygon> stay;
  copy.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    stay.push_back({cell, p.block, {p.vertices.begin(), p.vertices.end()}});
  });
  if (!areAlike(stay, left)) return "an island that was taken leaves something, or takes more along";
  copy.commit();
  if (std::string wrong = wrongRefusal(copy, *body); !wrong.empty()) return wrong;
  if (!put(copy, *body, body->origin)) return "a body does not fit where it was";
  return samePolygons(copy, world) ? "" : "a body that came back is another one";
}

std::string wrongForesight(const World& world, Cell cell) {
  World copy = world, other = world;
  const auto edit = [cell](World& in) { return in.clear(cell).has_value(); };
  Islands would(copy), does(other);
  const Foreseen foreseen = foresee(copy, would, edit);
  if (std::string wrong = differenceOf(world, copy); !wrong.empty()) return "foresee() leaves " + wrong;
  if (would.all().size() != does.all().size()) return "foresee() leaves other islands";
  edit(other);
  if (!does.update(other, other.commit())) return "a view refuses what was committed";
  const auto counts = [](const IslandChanges& c) {
    return std::array{c.added.size(), c.removed.size(), c.changed.size(), c.cutOff.size(), c.joined.size()};
  };
  return counts(foreseen.changes) == counts(does.changes()) ? "" : "foresee() foresees something else";
}

class BodiesLaw : public Law {
 public:
  Found nowAndThen(Seen& seen) override {
    if (!seen.options.views || !seen.model().isWhole() || seen.isPending()) return std::nullopt;
    const Scene scene = seen.scene();
    if (scene.polygons.empty()) return std::nullopt;
    const std::size_t which = scene.polygons.size() / 2;
    std::string wrong = wrongBody(seen.world(), scene, which);
    if (wrong.empty()) wrong = wrongForesight(seen.world(), scene.polygons[which].cell);
    return wrong.empty() ? std::nullopt : Found(seen.mismatch(Mismatch::Kind::views, std::move(wrong)));
  }
};

}  // namespace

std::unique_ptr<Law> laws::bodies() { return std::make_unique<BodiesLaw>(); }

}  // namespace lgs::oracle
