#include "oracle/views/loop_check.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace lgs::oracle {
namespace {

Wide wide(Int128 v) { return static_cast<Wide>(v.high) * (Wide{1} << 64) + static_cast<Wide>(v.low); }

std::string inWords(Point p) { return fmt::format("({}, {})", p.x, p.y); }

template <class T>
bool has(const std::vector<T>& list, const T& value) {
  return std::ranges::count(list, value) > 0;
}

}  // namespace

std::optional<std::string> LoopCheck::begin(const World& world, const Loops& loops) {
  before_.clear();
  const std::string wrong = read(world, loops, before_);
  if (wrong.empty()) return std::nullopt;
  return wrong;
}

std::optional<std::string> LoopCheck::update(const World& world, const Loops& loops) {
  ById now;
  if (const std::string wrong = read(world, loops, now); !wrong.empty()) return wrong;
  std::map<Edge, LoopId> loopBefore;
  for (const auto& [id, loop] : before_)
    for (const Edge& edge : loop.edges) loopBefore[edge] = id;
  Shares shares;
  for (const auto& [id, loop] : now)
    for (const Edge& edge : loop.edges)
      if (const auto old = loopBefore.find(edge); old != loopBefore.end()) ++shares[{old->second, id}];
  if (std::string wrong = checkIds(now, shares); !wrong.empty()) return wrong;
  if (std::string wrong = checkLists(loops.changes(), now, shares); !wrong.empty()) return wrong;
  before_ = std::move(now);
  return std::nullopt;
}

/// The loops as the view has them, if each is one that is found by walking, and none is missing.
std::string LoopCheck::read(const World& world, const Loops& loops, ById& out) const {
  const World& outline = loops.outline(world);
  std::map<Edge, LoopId> loopOf;
  for (const SegmentId id : outline.segments()) {
    const Segment s = *outline.segment(id);
    const LoopId loop = loops.of(id);
    if (!loops.loop(loop)) return fmt::format("the segment from {} is on no loop", inWords(s.start));
    loopOf[{s.start, s.end}] = loop;
    out[loop].links.push_back({{s.start, s.end}, id, s.successor});
  }
  const std::vector<WalkedLoop> walked = walkedLoops(bareScene(world));
  std::size_t edges = 0;
  for (const WalkedLoop& loop : walked) {
    const auto first = loopOf.find(loop.edges().front());
    if (first == loopOf.end()) return fmt::format("the segment from {} is missing", inWords(loop.vertices.front()));
    const LoopId id = first->second;
    const LoopFacts f = *loops.loop(id);
    Known& known = out[id];
    if (!known.edges.empty()) return fmt::format("loop {} stands for two loops", id.value);
    known.facts = f;
    known.edges = loop.edges();
    for (const Edge& edge : known.edges)
      if (loopOf[edge] != id) return fmt::format("the segment from {} is on another loop", inWords(edge.first));
    edges += known.edges.size();
    const std::string name = fmt::format("loop {}, through {}, ", id.value, inWords(loop.vertices.front()));
    if (f.id != id) return name + "has another id";
    if (wide(f.doubleArea) != loop.doubleArea)
      return fmt::format("{}has twice the area {}, not {}", name, inWords(loop.doubleArea),
                         inWords(wide(f.doubleArea)));
    if (f.segments != known.edges.size()) return fmt::format("{}has {} segments", name, known.edges.size());
    if (f.min != loop.min || f.max != loop.max) return name + "has another box";
    if (f.west != loop.west) return fmt::format("{}is westernmost at {}", name, inWords(loop.west));
    const auto start = outline.segment(f.first);
    if (!start || start->start != f.west || loops.of(f.first) != id) return name + "begins elsewhere";
    std::ranges::sort(known.edges);
    std::ranges::sort(known.links);
  }
  if (edges != loopOf.size()) return "there are segments that are on no loop";
  if (loops.all().size() != out.size())
    return fmt::format("there are {} loops, not {}", out.size(), loops.all().size());
  for (const LoopId id : loops.all())
    if (!out.contains(id)) return fmt::format("there is no loop {}", id.value);
  return {};
}

std::string LoopCheck::checkIds(const ById& now, const Shares& shares) const {
  // The loop of now that a loop of before hands its id to.
  std::map<LoopId, std::vector<LoopId>> handed;
  for (const auto& [old, known] : before_) {
    using Claim = std::tuple<std::int64_t, Point, Wide, SegmentId>;
    std::optional<std::pair<Claim, LoopId>> best;
    for (const auto& [pair, count] : shares) {
      if (pair.from != old || now.at(pair.into).facts.isHole() != known.facts.isHole()) continue;
      const LoopFacts& f = now.at(pair.into).facts;
      const std::pair claim{Claim{-static_cast<std::int64_t>(count), f.west, wide(f.doubleArea), f.first}, pair.into};
      if (!best || claim < *best) best = claim;
    }
    if (best) handed[best->second].push_back(old);
  }
  for (const auto& [id, known] : now) {
    std::vector<LoopId>& olds = handed[id];
    const auto order = [&](LoopId a, LoopId b) {
      const std::size_t m = before_.at(a).edges.size(), n = before_.at(b).edges.size();
      return m != n ? m > n : a < b;
    };
    std::ranges::sort(olds, order);
    if (olds.empty() && before_.contains(id))
      return fmt::format("loop {} has an id that it does not inherit", id.value);
    if (!olds.empty() && olds.front() != id)
      return fmt::format("loop {} should have inherited the id {}", id.value, olds.front().value);
  }
  return {};
}

std::string LoopCheck::checkLists(const LoopChanges& changes, const ById& now, const Shares& shares) const {
  LoopChanges expected;
  std::set<LoopId> cameFrom, wentInto;
  for (const auto& [pair, count] : shares) {
    if (!before_.contains(pair.into)) {
      expected.split.push_back(pair);
      cameFrom.insert(pair.into);
    }
    if (!now.contains(pair.from)) {
      expected.joined.push_back(pair);
      wentInto.insert(pair.from);
    }
  }
  for (const auto& [id, known] : now)
    if (!before_.contains(id) && !cameFrom.contains(id)) expected.added.push_back(id);
  for (const auto& [id, known] : before_) {
    const bool stays = now.contains(id), differs = stays && known.links != now.at(id).links;
    if (!stays && !wentInto.contains(id)) expected.removed.push_back(id);
    // A roll-back lists what has the same id and the same ends, if it was another polygon's in between.
    if (differs || (stays && has(changes.changed, id))) expected.changed.push_back(id);
    if (differs || !stays || has(changes.changed, id)) expected.before.push_back(known.facts);
  }
  if (changes.added != expected.added) return "another list of loops that came";
  if (changes.removed != expected.removed) return "another list of loops that went";
  if (changes.changed != expected.changed) return "another list of loops that changed";
  if (changes.split != expected.split) return "another list of loops that split";
  if (changes.joined != expected.joined) return "another list of loops that joined";
  if (changes.before != expected.before) return "the loops were something else before";
  return {};
}

}  // namespace lgs::oracle
