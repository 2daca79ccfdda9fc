#include "oracle/reference/canonical.h"

#include "oracle/reference/vector.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace lgs::oracle {
namespace {

// The index of the segment from start to end; the outline's size if there is none.
std::size_t find(const Outline& outline, Point start, Point end) {
  const auto found = std::partition_point(outline.begin(), outline.end(), [&](const OutlineSegment& s) {
    return std::pair(s.start, s.end) < std::pair(start, end);
  });
  const bool isThere = found != outline.end() && found->start == start && found->end == end;
  return isThere ? static_cast<std::size_t>(found - outline.begin()) : outline.size();
}

// The vertices that all loops together visit exactly once, sorted.
std::vector<Point> visitedOnce(const Loops& loops) {
  std::vector<Point> all;
  for (const auto& loop : loops) all.insert(all.end(), loop.begin(), loop.end());
  std::sort(all.begin(), all.end());
  std::vector<Point> once;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool again = (k > 0 && all[k - 1] == all[k]) || (k + 1 < all.size() && all[k + 1] == all[k]);
    if (!again) once.push_back(all[k]);
  }
  return once;
}

std::vector<Point> withoutStraightRuns(const std::vector<Point>& loop, const std::vector<Point>& mayGo) {
  std::vector<Point> kept;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Point previous = loop[(k + loop.size() - 1) % loop.size()];
    const Point next = loop[(k + 1) % loop.size()];
    const bool isStraight = direction(loop[k] - previous) == direction(next - loop[k]);
    if (!isStraight || !std::binary_search(mayGo.begin(), mayGo.end(), loop[k])) kept.push_back(loop[k]);
  }
  return kept;
}

// A loop may visit its least vertex more than once, so the least rotation is the least of several.
std::vector<Point> leastRotation(const std::vector<Point>& loop) {
  if (loop.empty()) return loop;
  const Point least = *std::min_element(loop.begin(), loop.end());
  std::vector<Point> best;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    if (loop[k] != least) continue;
    std::vector<Point> rotated = loop;
    std::rotate(rotated.begin(), rotated.begin() + static_cast<std::ptrdiff_t>(k), rotated.end());
    if (best.empty() || rotated < best) best = std::move(rotated);
  }
  return best;
}

}  // namespace

std::optional<Loops> followLinks(const Outline& outline) {
  std::vector<std::size_t> successor(outline.size());
  for (std::size_t k = 0; k < outline.size(); ++k) {
    if (!outline[k].ghost2) return std::nullopt;
    successor[k] = find(outline, outline[k].end, *outline[k].ghost2);
    // Mutual links make the successor a permutation: no segment has two predecessors. So every chain closes.
    if (successor[k] == outline.size() || outline[successor[k]].ghost1 != outline[k].start) return std::nullopt;
  }

  Loops loops;
  std::vector<bool> done(outline.size());
  for (std::size_t first = 0; first < outline.size(); ++first) {
    if (done[first]) continue;
    loops.emplace_back();
    for (std::size_t k = first; !done[k]; k = successor[k]) {
      done[k] = true;
      loops.back().push_back(outline[k].start);
    }
  }
  return loops;
}

Loops canonical(Loops loops) {
  const std::vector<Point> ofDegreeTwo = visitedOnce(loops);
  for (auto& loop : loops) loop = leastRotation(withoutStraightRuns(loop, ofDegreeTwo));
  std::sort(loops.begin(), loops.end());
  return loops;
}

}  // namespace lgs::oracle
