#include "oracle/views/beyond_check.h"

#include "oracle/reference/touching.h"
#include "oracle/views/island_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace lgs::oracle {
namespace {

Cell chunkOf(Cell cell) { return {cell.i & ~31, cell.j & ~31}; }

/// Unites the sets of polygons that `isOne` is true of, and returns the number of that set; -1, if there is none.
template <class IsOne>
std::ptrdiff_t unite(std::vector<std::size_t>& set, const IsOne& isOne) {
  std::set<std::size_t> numbers;
  for (std::size_t k = 0; k < set.size(); ++k)
    if (isOne(k)) numbers.insert(set[k]);
  if (numbers.empty()) return -1;
  for (std::size_t& number : set)
    if (numbers.contains(number)) number = *numbers.begin();
  return static_cast<std::ptrdiff_t>(*numbers.begin());
}

bool isLarger(const IslandFacts& a, const IslandFacts& b) {
  if (a.outer.doubleArea != b.outer.doubleArea) return a.outer.doubleArea > b.outer.doubleArea;
  return std::tie(a.outer.west, a.outer.id) < std::tie(b.outer.west, b.outer.id);
}

}  // namespace

std::string BeyondCheck::begin(const World& part, const WholeGround& whole, const Islands& islands) {
  before_ = {};
  return read(part, whole, islands, before_);
}

std::string BeyondCheck::update(const World& part, const WholeGround& whole, const Islands& islands, bool isTold) {
  Moment now;
  if (std::string wrong = read(part, whole, islands, now); !wrong.empty()) return wrong;
  std::set<Cell> gone = before_.empty;  // forgotten, maybe: until ground comes there nobody is told
  gone.insert(before_.away.begin(), before_.away.end());
  now.forgotten = whole.forgotten;
  for (const ScenePolygon& p : now.polygons) {
    gone.erase(chunkOf(p.cell));
    now.forgotten.erase(chunkOf(p.cell));
  }
  now.empty.insert(gone.begin(), gone.end());
  std::string wrong = isTold ? compare(islands, now, {}) : "";
  const std::vector<Cell> open = mayCount(now);
  constexpr std::size_t kAlone = 6;  // all choices of these; the others count together
  for (std::size_t choice = 1; !wrong.empty() && choice < std::size_t{2} << std::min(open.size(), kAlone); ++choice) {
    std::set<Cell> counting;
    for (std::size_t k = 0; k < open.size(); ++k)
      if ((choice >> std::min(k, kAlone) & 1) != 0) counting.insert(open[k]);
    if (compare(islands, now, counting).empty()) wrong.clear();
  }
  before_ = std::move(now);
  return wrong;
}

bool BeyondCheck::stands(const ScenePolygon& p, const Moment& now) {
  return std::ranges::any_of(now.polygons,
                             [&](const ScenePolygon& q) { return p.cell == q.cell && p.vertices == q.vertices; });
}

/// Whether it was in an unloaded chunk, and was not there when that came back: no view has seen it.
bool BeyondCheck::isLost(const ScenePolygon& p, const Moment& now) const {
  const Cell chunk = chunkOf(p.cell);
  return before_.away.contains(chunk) && !now.away.contains(chunk) && !stands(p, now);
}

/// Of the chunks that may count as beyond or not, those that have ground near.
std::vector<Cell> BeyondCheck::mayCount(const Moment& now) const {
  std::set<Cell> open = before_.empty;
  open.insert(now.empty.begin(), now.empty.end());
  for (const ScenePolygon& p : before_.polygons)
    if (isLost(p, now)) open.insert(chunkOf(p.cell));
  std::set<Cell> near;
  for (const Moment* moment : {&before_, &now})
    for (const ScenePolygon& p : moment->polygons)
      for (const std::int32_t j : {-1, 0, 1})
        for (const std::int32_t i : {-1, 0, 1}) near.insert(chunkOf({p.cell.i + i, p.cell.j + j}));
  std::vector<Cell> out;
  std::ranges::set_intersection(open, near, std::back_inserter(out));
  return out;
}

/// Each island of the view is one set of polygons that hang together, and what is beyond is another one.
std::string BeyondCheck::read(const World& part, const WholeGround& whole, const Islands& islands, Moment& out) const {
  out.polygons = whole.polygons;
  for (const ScenePolygon& p : out.polygons)
    if (const Cell chunk = chunkOf(p.cell); whole.away.contains(chunk)) out.away.insert(chunk);
  std::ranges::set_difference(whole.away, out.away, std::inserter(out.empty, out.empty.end()));
  const auto isAway = [&](std::size_t k) { return out.away.contains(chunkOf(out.polygons[k].cell)); };
  std::vector<std::size_t> set = setsOf(out.polygons);
  const std::ptrdiff_t beyond = unite(set, isAway);
  std::map<std::size_t, IslandId> idOf;
  std::map<IslandId, IslandFacts> expected;
  for (std::size_t k = 0; k < set.size(); ++k) {
    const ScenePolygon& p = out.polygons[k];
    const std::string name = fmt::format("the polygon in cell ({}, {}) ", p.cell.i, p.cell.j);
    const bool isBeyond = static_cast<std::ptrdiff_t>(set[k]) == beyond;
    IslandId id = kBeyond;
    if (!isAway(k)) {
      const auto held = part.polygons(p.cell);
      const auto same = std::ranges::find_if(
          held, [&](const PlacedPolygon& q) { return std::ranges::equal(q.vertices, p.vertices); });
      if (same == held.end()) return name + "is not in memory";
      id = islands.of(part, same->handle);
    }
    out.islandOf.push_back(id);
    if (isBeyond != (id == kBeyond)) return name + (isBeyond ? "reaches beyond, and is not there" : "is not beyond");
    if (isBeyond) continue;
    if (idOf.try_emplace(set[k], id).first->second != id) return name + "is of another island than what it touches";
    const bool isNew = !expected.contains(id);
    IslandFacts& facts = expected[id];
    for (const LocalPoint v : p.vertices) {
      const Point at = toWorld(p.cell, v);
      if (isNew && v == p.vertices.front()) facts.outer.min = facts.outer.max = facts.outer.west = at;
      facts.outer.west = std::min(facts.outer.west, at);
      facts.outer.min = {std::min(facts.outer.min.x, at.x), std::min(facts.outer.min.y, at.y)};
      facts.outer.max = {std::max(facts.outer.max.x, at.x), std::max(facts.outer.max.y, at.y)};
    }
    if (isAnchor_ && isAnchor_(p.block, p.cell)) ++facts.anchors;
  }
  if (idOf.size() != expected.size()) return "two islands have one id";
  for (const auto& [id, facts] : expected) {
    const auto is = islands.island(id);
    if (!is) return fmt::format("island {} is not there", id.value);
    if (is->outer.west != facts.outer.west || is->outer.min != facts.outer.min || is->outer.max != facts.outer.max)
      return fmt::format("island {} has another outer loop", id.value);
    if (is->anchors != facts.anchors)
      return fmt::format("island {} has {} anchors, not {}", id.value, facts.anchors, is->anchors);
    out.known[id] = *is;
  }
  if (islands.all().size() != out.known.size())
    return fmt::format("there are {} islands, not {}", out.known.size(), islands.all().size());
  return {};
}

std::vector<BeyondCheck::Kin> BeyondCheck::kinOf(const Moment& now, const std::set<Cell>& counting) const {
  std::set<Cell> away;
  std::ranges::set_difference(before_.away, now.forgotten, std::inserter(away, away.end()));
  away.insert(now.away.begin(), now.away.end());
  away.insert(counting.begin(), counting.end());
  std::vector<ScenePolygon> all;
  std::vector<IslandId> islandOf;
  for (std::size_t k = 0; k < before_.polygons.size(); ++k) {
    if (counting.contains(chunkOf(before_.polygons[k].cell)) && isLost(before_.polygons[k], now)) continue;
    all.push_back(before_.polygons[k]);
    islandOf.push_back(before_.islandOf[k]);
  }
  const std::size_t olds = all.size();
  all.insert(all.end(), now.polygons.begin(), now.polygons.end());
  islandOf.insert(islandOf.end(), now.islandOf.begin(), now.islandOf.end());
  // What was taken away and touched the square of a chunk that nobody sees.
  const auto isBeside = [&](const ScenePolygon& p) {
    if (stands(p, now)) return false;
    for (const std::int32_t j : {-1, 0, 1}) {
      for (const std::int32_t i : {-1, 0, 1}) {
        const ScenePolygon square{{p.cell.i + i, p.cell.j + j}, 0, {kUnitSquare.begin(), kUnitSquare.end()}};
        if (away.contains(chunkOf(square.cell)) && haveCommonPoint(p, square)) return true;
      }
    }
    return false;
  };
  std::vector<std::size_t> set = setsOf(all);
  const std::ptrdiff_t beyond =
      unite(set, [&](std::size_t k) { return away.contains(chunkOf(all[k].cell)) || (k < olds && isBeside(all[k])); });
  std::map<std::size_t, Kin> sets;
  for (std::size_t k = 0; k < set.size(); ++k) {
    const IslandId id = islandOf[k];
    Kin& kin = sets[set[k]];
    kin.isBeyond = static_cast<std::ptrdiff_t>(set[k]) == beyond;
    if (id != kBeyond) (k < olds ? kin.olds : kin.news).insert(id);
  }
  std::vector<Kin> out;
  for (auto& [number, kin] : sets) out.push_back(std::move(kin));
  return out;
}

std::string BeyondCheck::compare(const Islands& islands, const Moment& now, const std::set<Cell>& counting) const {
  IslandChanges expected;
  for (const Kin& kin : kinOf(now, counting)) {
    const auto largest = [](const std::set<IslandId>& ids, const Moment& moment) {
      return *std::ranges::min_element(
          ids, [&](IslandId a, IslandId b) { return isLarger(moment.known.at(a), moment.known.at(b)); });
    };
    const bool hasFront = !kin.isBeyond && !kin.news.empty();
    const IslandId front = kin.isBeyond ? kBeyond : hasFront ? largest(kin.news, now) : IslandId{};
    const IslandId heirOf = !kin.isBeyond && !kin.olds.empty() ? largest(kin.olds, before_) : IslandId{};
    for (const IslandId id : kin.news) {
      const IslandFacts& is = now.known.at(id);
      IslandId old;
      if (id == front)
        old = heirOf;
      else
        for (const IslandId other : kin.olds)
          if (before_.known.at(other).outer.id == is.outer.id && (!hasFront || other != heirOf)) old = other;
      if (old && old != id) return fmt::format("island {} should have the id {}", id.value, old.value);
      if (!old && before_.known.contains(id)) return fmt::format("island {} should have a new id", id.value);
      if (!old && kin.olds.empty() && !kin.isBeyond) {
        expected.added.push_back(id);
      } else if (!old) {
        expected.cutOff.push_back({front, id});
      } else {
        const IslandFacts& was = before_.known.at(id);
        if (was.anchors == is.anchors && was.outer.id == is.outer.id &&
            std::ranges::count(islands.loops().changes().changed, is.outer.id) == 0)
          continue;
        expected.changed.push_back(id);
        expected.before.push_back(was);
      }
    }
    for (const IslandId id : kin.olds) {
      if (kin.news.contains(id)) continue;
      expected.before.push_back(before_.known.at(id));
      if (front)
        expected.joined.push_back({id, front});
      else
        expected.removed.push_back(id);
    }
  }
  return wrongLists(std::move(expected), islands.changes());
}

}  // namespace lgs::oracle
