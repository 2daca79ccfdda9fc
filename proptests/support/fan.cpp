#include "proptests/support/fan.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <tuple>

namespace lgs::test {

using oracle::Vector;

namespace {

/// Whether turning counter-clockwise from `from`, `a` is met before `b`. By angles in (0, 2π): what points like `from`
/// is met last.
bool isMetBefore(Vector from, Vector a, Vector b) {
  const auto half = [&](Vector v) {  // 0: less than half a turn, 1: half a turn or more, 2: a whole turn
    if (cross(from, v) > 0) return 0;
    return cross(from, v) == 0 && dot(from, v) > 0 ? 2 : 1;
  };
  if (half(a) != half(b)) return half(a) < half(b);
  return cross(a, b) > 0;
}

}  // namespace

bool pointAlike(const HalfEdge& a, const HalfEdge& b) {
  return cross(a.towards, b.towards) == 0 && dot(a.towards, b.towards) > 0;
}

std::optional<HalfEdge> metFirst(const HalfEdges& around, const HalfEdge& from) {
  std::optional<HalfEdge> first;
  for (const HalfEdge& edge : around) {
    if (edge.isOutgoing == from.isOutgoing || pointAlike(edge, from)) continue;
    // What is met first when turning clockwise is met last when turning counter-clockwise.
    const bool isFirst = !first || (from.isOutgoing ? isMetBefore(from.towards, first->towards, edge.towards)
                                                    : isMetBefore(from.towards, edge.towards, first->towards));
    if (isFirst) first = edge;
  }
  return first;
}

void showValue(const Fan& fan, std::ostream& out) {
  for (const HalfEdge& edge : fan.edges)
    out << fmt::format("{} ({}, {})\n", edge.isOutgoing ? "to" : "from", edge.towards.x, edge.towards.y);
}

rc::Gen<Fan> Fan::arbitrary() {
  // Small vectors often point alike or against each other, and lie close to those of a large cell.
  const auto number =
      rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-4, 5), rc::gen::inRange<std::int64_t>(-65'536, 65'537));
  using Drawn = std::tuple<std::int64_t, std::int64_t, bool>;
  const auto edges = rc::gen::container<std::vector<Drawn>>(rc::gen::tuple(number, number, rc::gen::arbitrary<bool>()));
  return rc::gen::map(
      rc::gen::pair(rc::gen::scale(0.16, edges), rc::gen::arbitrary<unsigned>()), [](const auto& drawn) {
        Fan fan;
        for (const auto& [x, y, isOutgoing] : drawn.first) {
          const HalfEdge edge{{x, y}, isOutgoing};
          const auto isSame = [&](const HalfEdge& e) { return e.isOutgoing == edge.isOutgoing && pointAlike(e, edge); };
          if ((x != 0 || y != 0) && std::ranges::none_of(fan.edges, isSame)) fan.edges.push_back(edge);
        }
        std::stable_sort(fan.edges.begin(), fan.edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
          const oracle::Vector west{-1, 0};
          return isMetBefore(west, a.towards, b.towards);
        });
        if (!fan.edges.empty()) {
          const auto start = static_cast<std::ptrdiff_t>(drawn.second % fan.edges.size());
          std::rotate(fan.edges.begin(), fan.edges.begin() + start, fan.edges.end());
        }
        return fan;
      });
}

}  // namespace lgs::test
