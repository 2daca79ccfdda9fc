// Law 2 without the grid: radialMatch() links directed edges as the law says, also where many coincide, and loopsOf() has
// the cycles of mutual links. What has no direction, leads nowhere or is too long is refused.
#include "oracle/calls/random.h"
#include "oracle/check/laws/list.h"
#include "oracle/reference/canonical.h"
#include "oracle/reference/vector.h"

#include <lgs/radial_match.h>
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lgs::oracle {
namespace {

using Links = std::vector<EdgeLinks>;
using Cycles = std::vector<std::vector<std::uint32_t>>;

struct AnyEdges {
  std::vector<Point> points;
  std::vector<DirectedEdge> edges;
};

constexpr std::uint32_t kOnSide = 4;

// Between the points of a small square, so that many share an end, point alike or coincide.
AnyEdges edgesOnASquare(Random& random) {
  constexpr std::array<std::int64_t, 3> kSteps{1, kUnitsPerCell, kMaxEdgeLength / (kOnSide - 1)};
  const std::int64_t step = kSteps[random.below(kSteps.size())];
  AnyEdges any;
  for (std::uint32_t k = 0; k < kOnSide * kOnSide; ++k) any.points.push_back({k % kOnSide * step, k / kOnSide * step});
  for (int k = random.below(40); k > 0; --k) {
    const std::uint32_t from = random.below(kOnSide * kOnSide), to = random.below(kOnSide * kOnSide);
    if (from != to) any.edges.push_back({from, to});
  }
  return any;
}

// Of the candidates that point alike the last one comes before an edge, and the first one after it.
std::uint32_t linkOf(const AnyEdges& any, std::uint32_t edge, const Outline& linked, bool isBefore) {
  const auto ghost = isBefore ? linked[edge].ghost1 : linked[edge].ghost2;
  const std::uint32_t at = isBefore ? any.edges[edge].from : any.edges[edge].to;
  std::uint32_t found = kNoEdge;
  for (std::uint32_t k = 0; ghost && k < any.edges.size(); ++k) {
    const auto [near, far] =
        isBefore ? std::pair(any.edges[k].to, any.edges[k].from) : std::pair(any.edges[k].from, any.edges[k].to);
    if (near != at || (!isBefore && found != kNoEdge)) continue;
    if (direction(any.points[far] - any.points[at]) == direction(*ghost - any.points[at])) found = k;
  }
  return found;
}

Links linksOf(const AnyEdges& any) {
  Outline segments;
  for (const auto& [from, to] : any.edges) segments.push_back({any.points[from], any.points[to], 0, {}, {}});
  const Outline linked = oracle::linked(std::move(segments));
  Links links;
  for (std::uint32_t e = 0; e < any.edges.size(); ++e)
    links.push_back({linkOf(any, e, linked, true), linkOf(any, e, linked, false)});
  return links;
}

// Whoever comes back along mutual links is in a loop, which its least edge tells.
Cycles slowCycles(const Links& links) {
  Cycles loops;
  for (std::uint32_t first = 0; first < links.size(); ++first) {
    std::vector<std::uint32_t> loop;
    std::uint32_t at = first;
    do {
      loop.push_back(at);
      const std::uint32_t next = links[at].successor;
      at = next != kNoEdge && links[next].predecessor == at ? next : kNoEdge;
    } while (at != kNoEdge && at > first);
    if (at == first) loops.push_back(std::move(loop));
  }
  return loops;
}

// One edge becomes one that must be refused; or as long as it may be, which must not.
std::string wrongRefusalOfEdges(AnyEdges any, Random& random) {
  const std::size_t bad = random.below(any.edges.size());
  DirectedEdge& edge = any.edges[bad];
  const auto end = static_cast<std::uint32_t>(any.points.size());
  const Point from = any.points[edge.from];
  const int kind = random.below(6);
  const bool isGood = kind == 0;
  edge.to = kind == 1 ? edge.from : end;
  if (kind != 1 && kind != 2) {
    const std::int64_t reach = kind == 3 ? kMaxCoordinate + 1 : kMaxEdgeLength + (isGood ? 0 : 1);
    const Point moved = kind == 5 ? Point{from.x, from.y - reach} : Point{from.x + reach, from.y};
    any.points.push_back(moved);
  }
  if (kind != 1 && random.chance(50)) std::swap(edge.from, edge.to);
  const auto links = radialMatch(any.points, any.edges);
  if (isGood) return links ? "" : "radialMatch() refuses an edge as long as it may be";
  return !links && links.error().code == ErrorCode::outOfReach && links.error().index == static_cast<int>(bad)
             ? ""
             : "radialMatch() does not refuse a bad edge, or blames another one";
}

// The edges of an outline lie in loops, and these are the engine's.
std::string wrongOutline(const World& world, const Outline& outline) {
  AnyEdges any;
  std::map<Point, std::uint32_t> numbers;
  const auto numberOf = [&](Point p) {
    const auto [at, isNew] = numbers.try_emplace(p, static_cast<std::uint32_t>(any.points.size()));
    if (isNew) any.points.push_back(p);
    return at->second;
  };
  for (const OutlineSegment& s : outline) {
    const std::uint32_t from = numberOf(s.start);
    any.edges.push_back({from, numberOf(s.end)});
  }
  const auto links = radialMatch(any.points, any.edges);
  if (!links) return "radialMatch() refuses the edges of an outline";
  Loops own, loops;
  for (const auto& loop : loopsOf(*links)) {
    own.emplace_back();
    for (const std::uint32_t e : loop) own.back().push_back(any.points[any.edges[e].from]);
  }
  for (Loop& loop : world.loops(Collinear::merge)) loops.push_back(std::move(loop.vertices));
  return canonical(std::move(own)) == canonical(std::move(loops)) ? "" : "radialMatch() links outlines to other loops";
}

class EdgesLaw : public Law {
 public:
  Found atEnd(Seen& seen) override {
    if (seen.trace.preserve.empty() && seen.model().isWhole())
      if (std::string wrong = wrongOutline(seen.world(), seen.shown()); !wrong.empty())
        return seen.mismatch(Mismatch::Kind::loops, std::move(wrong));
    constexpr int kTries = 12;
    Random random(seen.edits);
    for (int k = 0; k < kTries; ++k) {
      const AnyEdges any = edgesOnASquare(random);
      const Links expected = linksOf(any);
      const auto links = radialMatch(any.points, any.edges);
      std::string wrong;
      if (!links || *links != expected) wrong = "radialMatch() links edges otherwise than law 2";
      if (wrong.empty() && loopsOf(expected) != slowCycles(expected))
        wrong = "loopsOf() has other loops than the links";
      if (wrong.empty() && !any.edges.empty()) wrong = wrongRefusalOfEdges(any, random);
      if (!wrong.empty()) return seen.mismatch(Mismatch::Kind::loops, std::move(wrong));
    }
    return std::nullopt;
  }
};

}  // namespace

std::unique_ptr<Law> laws::edges() { return std::make_unique<EdgesLaw>(); }

}  // namespace lgs::oracle
