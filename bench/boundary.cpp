#include "bench/boundary.h"

#include "oracle/reference/vector.h"
#include "oracle/reference/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace lgs::bench {
namespace {

// Unsigned, because partial sums may go beyond 64 bits. The sum is right modulo 2^64.
std::uint64_t twiceAreaLeftOf(Point a, Point b) {
  const auto u = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
  return u(a.x) * u(b.y) - u(a.y) * u(b.x);
}

// An edge on its directed line. Edges with equal directions and offsets are on the same line.
struct OnLine {
  std::int64_t dx, dy;  // the direction, as the shortest integer vector
  std::int64_t offset;  // the cross product of the direction with any point of the line
  std::int64_t from;    // where the edge starts, measured along the line
  Edge edge;
  auto key() const { return std::tuple(dx, dy, offset, from); }
};

OnLine onLine(const Edge& edge) {
  const oracle::Vector d = oracle::direction({edge.end.x - edge.start.x, edge.end.y - edge.start.y});
  const auto along = [&](Point p) { return d.x != 0 ? (d.x > 0 ? p.x : -p.x) : (d.y > 0 ? p.y : -p.y); };
  const std::int64_t offset = d.x * edge.start.y - d.y * edge.start.x;
  return {d.x, d.y, offset, along(edge.start), edge};
}

}  // namespace

void addRing(Ring ring, Winding winding, Edges& edges) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) return;
  std::uint64_t twiceArea = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) twiceArea += twiceAreaLeftOf(ring[k], ring[(k + 1) % ring.size()]);
  const bool isCounterClockwise = static_cast<std::int64_t>(twiceArea) > 0;
  if (winding != Winding::asItIs && isCounterClockwise != (winding == Winding::counterClockwise)) {
    std::reverse(ring.begin(), ring.end());
  }
  for (std::size_t k = 0; k < ring.size(); ++k) edges.push_back({ring[k], ring[(k + 1) % ring.size()]});
}

Boundary boundaryOf(const Edges& edges) {
  std::vector<OnLine> lines;
  lines.reserve(edges.size());
  std::uint64_t twiceArea = 0;
  for (const Edge& edge : edges) {
    lines.push_back(onLine(edge));
    twiceArea += twiceAreaLeftOf(edge.start, edge.end);
  }
  std::sort(lines.begin(), lines.end(), [](const OnLine& a, const OnLine& b) { return a.key() < b.key(); });
  Boundary boundary;
  boundary.twiceArea = static_cast<std::int64_t>(twiceArea);
  for (std::size_t k = 0; k < lines.size();) {
    Edge run = lines[k].edge;
    std::size_t next = k + 1;
    const auto goesOn = [&] {
      return next < lines.size() &&
             std::tie(lines[next].dx, lines[next].dy, lines[next].offset) ==
                 std::tie(lines[k].dx, lines[k].dy, lines[k].offset) &&
             lines[next].edge.start == run.end;
    };
    for (; goesOn(); ++next) run.end = lines[next].edge.end;
    boundary.straight.push_back(run);
    k = next;
  }
  std::sort(boundary.straight.begin(), boundary.straight.end());
  return boundary;
}

std::uint64_t Boundary::checksum() const {
  std::uint64_t sum = 0xcbf29ce484222325U;  // FNV-1a, but of whole words instead of bytes
  const auto mix = [&](std::int64_t v) { sum = (sum ^ static_cast<std::uint64_t>(v)) * 0x100000001b3U; };
  for (const Edge& e : straight) {
    for (const std::int64_t v : {e.start.x, e.start.y, e.end.x, e.end.y}) mix(v);
  }
  mix(twiceArea);
  return sum;
}

std::string difference(const Boundary& expected, const Boundary& actual) {
  if (expected == actual) return {};
  Edges missing;
  std::set_difference(expected.straight.begin(), expected.straight.end(), actual.straight.begin(),
                      actual.straight.end(), std::back_inserter(missing));
  Edges extra;
  std::set_difference(actual.straight.begin(), actual.straight.end(), expected.straight.begin(),
                      expected.straight.end(), std::back_inserter(extra));
  std::string text = fmt::format("{} straight edges missing, {} extra", missing.size(), extra.size());
  if (expected.twiceArea != actual.twiceArea) text += ", another area";
  if (!missing.empty()) text += "; missing: " + oracle::inWords(missing[0].start, missing[0].end);
  if (!extra.empty()) text += "; extra: " + oracle::inWords(extra[0].start, extra[0].end);
  return text;
}

}  // namespace lgs::bench
