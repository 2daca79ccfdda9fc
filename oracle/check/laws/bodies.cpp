// What leaves the ground as a body, and what an edit would do: on a copy of the world. An island that is taken has all
// polygons that hang together, and comes back as it was; what was foreseen is what happens, and leaves no trace.
#include "oracle/check/laws/list.h"
#include "oracle/check/observed.h"
#include "oracle/views/touching.h"

#include <lgs/islands.h>
#include <algorithm>
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

std::string wrongBody(const World& world, const Scene& scene, std::size_t which) {
  World copy = world;
  const Islands islands(copy);
  const ScenePolygon& one = scene.polygons[which];
  const std::vector<std::size_t> sets = setsOf(scene.polygons);
  const auto there = copy.polygons(one.cell);
  const auto is = [&](const PlacedPolygon& p) {
    return p.block == one.block && std::ranges::equal(p.vertices, one.vertices);
  };
  const IslandId island = islands.of(copy, std::ranges::find_if(there, is)->handle);
  const auto body = take(copy, islands, island);
  if (!body) return "an island can not be taken: " + message(body.error());
  std::vector<ScenePolygon> taken, expected, left;
  for (const BodyPolygon& p : body->polygons)
    taken.push_back({{p.cell.i + body->origin.i, p.cell.j + body->origin.j}, p.block, p.vertices});
  for (std::size_t k = 0; k < sets.size(); ++k) (sets[k] == sets[which] ? expected : left).push_back(scene.polygons[k]);
  const auto areAlike = [](const auto& a, const auto& b) { return std::ranges::is_permutation(a, b); };
  if (!areAlike(taken, expected)) return "a body has other polygons than its island";
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
