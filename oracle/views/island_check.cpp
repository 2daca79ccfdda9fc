#include "oracle/views/island_check.h"

#include "oracle/reference/touching.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace lgs::oracle {
namespace {

Wide doubleAreaOf(const ScenePolygon& p) {
  Wide sum = 0;
  for (std::size_t k = 0; k < p.vertices.size(); ++k) {
    const LocalPoint a = p.vertices[k], b = p.vertices[(k + 1) % p.vertices.size()];
    sum += Wide{a.x - b.x} * (a.y + b.y);
  }
  return sum;
}

/// Whether an edge is a part of one of the polygon's, in the same direction.
bool owns(const ScenePolygon& p, const Edge& edge) {
  const auto side = [](Point a, Point b, Point c) {
    return Wide{b.x - a.x} * (c.y - a.y) - Wide{b.y - a.y} * (c.x - a.x);
  };
  const auto along = [](Point a, Point b, Point c) {
    return Wide{b.x - a.x} * (c.x - a.x) + Wide{b.y - a.y} * (c.y - a.y);
  };
  for (std::size_t k = 0; k < p.vertices.size(); ++k) {
    const Point a = toWorld(p.cell, p.vertices[k]), b = toWorld(p.cell, p.vertices[(k + 1) % p.vertices.size()]);
    const auto [start, end] = edge;
    if (side(a, b, start) != 0 || side(a, b, end) != 0) continue;
    if (along(a, b, start) >= 0 && along(a, b, end) <= along(a, b, b) && along(a, b, start) < along(a, b, end))
      return true;
  }
  return false;
}

std::string at(const ScenePolygon& p) { return fmt::format("the polygon in cell ({}, {})", p.cell.i, p.cell.j); }

}  // namespace

std::optional<std::string> IslandCheck::begin(const World& world, const Islands& islands) {
  if (auto wrong = loops_.begin(world, islands.loops())) return wrong;
  before_.clear();
  const std::string wrong = read(world, islands, before_);
  if (wrong.empty()) return std::nullopt;
  return wrong;
}

std::optional<std::string> IslandCheck::update(const World& world, const Islands& islands) {
  if (auto wrong = loops_.update(world, islands.loops())) return wrong;
  ById now;
  if (std::string wrong = read(world, islands, now); !wrong.empty()) return wrong;
  const std::vector<Kin> kin = kinOf(now);
  if (std::string wrong = checkIds(kin, now); !wrong.empty()) return wrong;
  if (std::string wrong = checkLists(islands, kin, now); !wrong.empty()) return wrong;
  before_ = std::move(now);
  return std::nullopt;
}

/// The islands as the view has them, if each is one set of polygons, with one outer loop and all its anchors.
std::string IslandCheck::read(const World& world, const Islands& islands, ById& out) const {
  std::vector<PolygonHandle> handles;
  world.forEachPolygon([&](Cell, const PlacedPolygon& p) { handles.push_back(p.handle); });
  const Scene scene = bareScene(world);
  const std::vector<std::size_t> set = setsOf(scene.polygons);
  std::map<std::size_t, IslandId> idOf;
  std::map<IslandId, std::uint64_t> anchors;
  std::map<IslandId, Wide> area;  // of all polygons, then without what the loops run around
  for (std::size_t k = 0; k < set.size(); ++k) {
    const ScenePolygon& p = scene.polygons[k];
    const IslandId id = islands.of(world, handles[k]);
    if (!islands.island(id)) return at(p) + " is of no island";
    if (idOf.try_emplace(set[k], id).first->second != id) return at(p) + " is of another island than what it touches";
    out[id].polygons.polygons.push_back(p);
    area[id] += doubleAreaOf(p);
    if (isAnchor_ && isAnchor_(p.block, p.cell)) ++anchors[id];
  }
  if (idOf.size() != out.size()) return "two islands have one id";
  std::set<LoopId> outers;
  for (const WalkedLoop& loop : walkedLoops(scene)) {
    const auto owner =
        std::ranges::find_if(scene.polygons, [&](const ScenePolygon& p) { return owns(p, loop.edges().front()); });
    const IslandId id = idOf.at(set[static_cast<std::size_t>(owner - scene.polygons.begin())]);
    area[id] -= loop.doubleArea;
    if (loop.doubleArea < 0) continue;
    Known& known = out[id];
    if (known.facts.id) return fmt::format("island {} has two outer loops", id.value);
    known.facts = *islands.island(id);
    const LoopFacts& f = known.facts.outer;
    if (f.west != loop.west || f.max != loop.max) return fmt::format("island {} has another outer loop", id.value);
    if (islands.of(f.id) != id) return fmt::format("the loop of island {} is of another one", id.value);
    if (!outers.insert(f.id).second) return "two islands have one loop";
  }
  for (const auto& [id, known] : out) {
    const std::string name = fmt::format("island {}, with {}, ", id.value, at(known.polygons.polygons.front()));
    if (known.facts.id != id) return name + "has another id";
    if (area[id] != 0) return name + "has another area than its loops";
    if (known.facts.anchors != anchors[id])
      return fmt::format("{}has {} anchors, not {}", name, anchors[id], known.facts.anchors);
  }
  if (islands.all().size() != out.size())
    return fmt::format("there are {} islands, not {}", out.size(), islands.all().size());
  return {};
}

std::vector<IslandCheck::Kin> IslandCheck::kinOf(const ById& now) const {
  std::vector<ScenePolygon> polygons;
  std::vector<std::pair<bool, IslandId>> owner;  // whether it is of now, and the island
  for (const bool isNow : {false, true}) {
    for (const auto& [id, known] : isNow ? now : before_) {
      for (const ScenePolygon& p : known.polygons.polygons) {
        polygons.push_back(p);
        owner.emplace_back(isNow, id);
      }
    }
  }
  const std::vector<std::size_t> set = setsOf(polygons);
  std::map<std::size_t, std::pair<std::set<IslandId>, std::set<IslandId>>> sets;
  for (std::size_t k = 0; k < set.size(); ++k)
    (owner[k].first ? sets[set[k]].second : sets[set[k]].first).insert(owner[k].second);
  std::vector<Kin> kin;
  for (const auto& [index, both] : sets) {
    Kin one{{both.first.begin(), both.first.end()}, {both.second.begin(), both.second.end()}};
    const auto largestFirst = [](const ById& byId) {
      return [&byId](IslandId a, IslandId b) {
        const LoopFacts &m = byId.at(a).facts.outer, &n = byId.at(b).facts.outer;
        return m.doubleArea != n.doubleArea ? m.doubleArea > n.doubleArea
                                            : std::tie(m.west, m.id) < std::tie(n.west, n.id);
      };
    };
    std::ranges::sort(one.olds, largestFirst(before_));
    std::ranges::sort(one.news, largestFirst(now));
    kin.push_back(std::move(one));
  }
  return kin;
}

std::string IslandCheck::checkIds(const std::vector<Kin>& kin, const ById& now) const {
  for (const Kin& k : kin) {
    for (const IslandId id : k.news) {
      std::optional<IslandId> expected;
      if (id == k.news.front()) {
        if (!k.olds.empty()) expected = k.olds.front();
      } else {
        for (const IslandId old : k.olds)
          if (before_.at(old).facts.outer.id == now.at(id).facts.outer.id && old != k.news.front()) expected = old;
      }
      if (expected && *expected != id) return fmt::format("island {} should have the id {}", id.value, expected->value);
      if (!expected && before_.contains(id)) return fmt::format("island {} should have a new id", id.value);
    }
  }
  return {};
}

std::string wrongLists(IslandChanges expected, const IslandChanges& changes) {
  for (auto* ids : {&expected.added, &expected.removed, &expected.changed}) std::ranges::sort(*ids);
  for (auto* pairs : {&expected.cutOff, &expected.joined}) std::ranges::sort(*pairs);
  std::ranges::sort(expected.before, {}, &IslandFacts::id);
  const auto words = [](const auto& list) {
    std::string text;
    for (const auto& entry : list) {
      if constexpr (std::is_same_v<decltype(entry), const IslandId&>) text += fmt::format(" {}", entry.value);
      if constexpr (std::is_same_v<decltype(entry), const IslandPair&>)
        text += fmt::format(" {}/{}", entry.from.value, entry.into.value);
    }
    return text.empty() ? " none" : text;
  };
  const auto differs = [&](const char* what, const auto& is, const auto& must) {
    return fmt::format("another list of islands that {}:{}, and not{}", what, words(is), words(must));
  };
  if (changes.added != expected.added) return differs("came", changes.added, expected.added);
  if (changes.removed != expected.removed) return differs("went", changes.removed, expected.removed);
  if (changes.changed != expected.changed) return differs("changed", changes.changed, expected.changed);
  if (changes.cutOff != expected.cutOff) return differs("were cut off", changes.cutOff, expected.cutOff);
  if (changes.joined != expected.joined) return differs("joined", changes.joined, expected.joined);
  if (changes.before != expected.before) return "the islands were something else before";
  return {};
}

std::string IslandCheck::checkLists(const Islands& islands, const std::vector<Kin>& kin, const ById& now) const {
  IslandChanges expected;
  for (const Kin& k : kin) {
    for (const IslandId id : k.news) {
      const auto old = before_.find(id);
      if (k.olds.empty()) {
        expected.added.push_back(id);
      } else if (old == before_.end()) {
        expected.cutOff.push_back({k.news.front(), id});
      } else {
        const IslandFacts &was = old->second.facts, &is = now.at(id).facts;
        const std::vector<LoopId>& loops = islands.loops().changes().changed;
        if (was.anchors == is.anchors && was.outer.id == is.outer.id && std::ranges::count(loops, is.outer.id) == 0)
          continue;
        expected.changed.push_back(id);
        expected.before.push_back(was);
      }
    }
    for (const IslandId id : k.olds) {
      if (std::ranges::count(k.news, id) > 0) continue;
      expected.before.push_back(before_.at(id).facts);
      if (k.news.empty())
        expected.removed.push_back(id);
      else
        expected.joined.push_back({id, k.news.front()});
    }
  }
  return wrongLists(std::move(expected), islands.changes());
}

}  // namespace lgs::oracle
