#include "oracle/check/reads.h"
#include "oracle/trace/dump.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>

namespace lgs::oracle {
namespace {

// A chain as loops() must give it.
using Chain = std::pair<std::vector<Point>, std::vector<SegmentId>>;

// The chain of a segment, from its successor to its successor; empty if it does not close, or a link is not mutual.
std::vector<SegmentId> closedChain(std::span<const Segment> segments, SegmentId first) {
  std::vector<SegmentId> chain{first};
  for (;;) {
    const SegmentId here = chain.back();
    const SegmentId next = segments[here.value].successor;
    const bool isShown = next && next.value < segments.size() && segments[next.value].id;
    if (!isShown || segments[next.value].predecessor != here) return {};
    if (next == first) return chain;
    chain.push_back(next);
  }
}

// Turned so that the vertices are the least they can be.
Chain turned(std::span<const Segment> segments, const std::vector<SegmentId>& ids) {
  std::vector<Point> vertices;
  vertices.reserve(ids.size());
  for (const SegmentId id : ids) vertices.push_back(segments[id.value].start);
  const Point least = *std::min_element(vertices.begin(), vertices.end());
  std::optional<Chain> best;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (vertices[k] != least) continue;
    Chain chain{vertices, ids};
    const auto by = static_cast<std::ptrdiff_t>(k);
    std::rotate(chain.first.begin(), chain.first.begin() + by, chain.first.end());
    std::rotate(chain.second.begin(), chain.second.begin() + by, chain.second.end());
    if (!best || chain.first < best->first) best = std::move(chain);
  }
  return *best;
}

std::vector<Chain> chainsOf(std::span<const Segment> segments) {
  std::vector<Chain> chains;
  std::vector<bool> seen(segments.size());
  for (const Segment& s : segments) {
    if (!s.id || seen[s.id.value]) continue;
    const std::vector<SegmentId> ids = closedChain(segments, s.id);
    for (const SegmentId id : ids) seen[id.value] = true;
    if (!ids.empty()) chains.push_back(turned(segments, ids));
  }
  std::sort(chains.begin(), chains.end());
  return chains;
}

// Without the vertices where one segment arrives and one leaves, straight on.
std::vector<Point> merged(const Chain& chain, const std::map<Point, int>& leaving) {
  const std::vector<Point>& v = chain.first;
  std::vector<Point> corners;
  for (std::size_t k = 0; k < v.size(); ++k) {
    const Point before = v[(k + v.size() - 1) % v.size()], here = v[k], after = v[(k + 1) % v.size()];
    const Point in{here.x - before.x, here.y - before.y}, out{after.x - here.x, after.y - here.y};
    const bool straight = in.x * out.y == in.y * out.x && in.x * out.x + in.y * out.y > 0;
    if (!straight || leaving.at(here) > 1) corners.push_back(here);
  }
  const auto begin = std::min_element(corners.begin(), corners.end());
  std::vector<Point> best;
  for (auto at = begin; at != corners.end(); ++at) {
    if (*at != *begin) continue;
    std::vector<Point> candidate = corners;
    std::rotate(candidate.begin(), candidate.begin() + (at - corners.begin()), candidate.end());
    if (best.empty() || candidate < best) best = std::move(candidate);
  }
  return best;
}

Outline outlineOf(std::span<const Segment> segments, const std::vector<SegmentId>& ids) {
  Outline outline;
  for (const SegmentId id : ids)
    if (id.value < segments.size() && segments[id.value].id) outline.push_back(outlineSegment(segments[id.value]));
  return outline;
}

}  // namespace

std::optional<WrongRead> readLoops(const World& world, std::span<const Segment> segments, const Outline* whole) {
  const std::vector<Chain> expected = chainsOf(segments);
  const std::vector<Loop> kept = world.loops(Collinear::keep);
  const std::vector<Loop> joined = world.loops(Collinear::merge);
  if (kept.size() != expected.size() || joined.size() != expected.size()) {
    return WrongRead{fmt::format("{} loops, {} where collinear segments are merged; there should be {}", kept.size(),
                                 joined.size(), expected.size())};
  }
  std::map<Point, int> leaving;
  for (const Segment& s : segments)
    if (s.id && whole == nullptr) ++leaving[s.start];
  if (whole != nullptr)
    for (const OutlineSegment& s : *whole) ++leaving[s.start];
  std::vector<std::vector<Point>> corners;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    if (kept[k].vertices != expected[k].first || kept[k].segments != expected[k].second)
      return WrongRead{fmt::format("loop {} has other vertices, or other segments", k),
                       outlineOf(segments, expected[k].second)};
    corners.push_back(merged(expected[k], leaving));
  }
  std::sort(corners.begin(), corners.end());
  for (std::size_t k = 0; k < joined.size(); ++k) {
    if (joined[k].vertices != corners[k] || !joined[k].segments.empty())
      return WrongRead{fmt::format("loop {} has other vertices where collinear segments are merged", k)};
  }
  return std::nullopt;
}

}  // namespace lgs::oracle
