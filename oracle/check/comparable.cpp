#include "oracle/check/comparable.h"

#include "oracle/reference/vector.h"

#include <algorithm>
#include <map>
#include <vector>

namespace lgs::oracle {
namespace {

constexpr std::size_t kNoSegment = static_cast<std::size_t>(-1);

// Joins what is collinear.
class Joining {
 public:
  explicit Joining(const Outline& outline) : outline_(outline), next_(outline.size(), kNoSegment) {
    for (std::size_t k = 0; k < outline_.size(); ++k) {
      at_[outline_[k].start].leaving.push_back(k);
      at_[outline_[k].end].arriving.push_back(k);
    }
    std::vector<bool> isLater(outline_.size());
    for (std::size_t k = 0; k < outline_.size(); ++k) {
      next_[k] = nextOf(k);
      if (next_[k] != kNoSegment) isLater[next_[k]] = true;
    }
    for (std::size_t k = 0; k < outline_.size(); ++k)
      if (!isLater[k]) join(k);
  }

  Outline joined() {
    Outline result;
    for (const Chain& chain : chains_) {
      OutlineSegment s = outline_[chain.first];
      const OutlineSegment& last = outline_[chain.last];
      s.end = last.end;
      s.ghost1 = farEnd(s.ghost1, s.start, &Chain::first);
      s.ghost2 = farEnd(last.ghost2, last.end, &Chain::last);
      result.push_back(s);
    }
    return result;
  }

 private:
  struct Vertex {
    std::vector<std::size_t> arriving, leaving;
  };
  struct Chain {
    std::size_t first, last;
  };

  Vector directionOf(std::size_t k) const { return direction(outline_[k].end - outline_[k].start); }

  // The segment that is joined to the end of this one.
  std::size_t nextOf(std::size_t k) const {
    if (outline_[k].start == outline_[k].end) return kNoSegment;  // an engine may put out anything
    const Vertex& there = at_.at(outline_[k].end);
    const Vector along = directionOf(k), back{-along.x, -along.y};
    std::size_t next = kNoSegment, same = 0;
    for (const std::size_t other : there.leaving) {
      const Vector d = directionOf(other);
      if (d != along && d != back) return kNoSegment;
      if (d == along) next = ++same == 1 ? other : kNoSegment;
    }
    std::size_t before = 0;
    for (const std::size_t other : there.arriving) {
      const Vector d = directionOf(other);
      if (d != along && d != back) return kNoSegment;
      if (d == along) ++before;
    }
    return before == 1 && next != kNoSegment && outline_[next].block == outline_[k].block ? next : kNoSegment;
  }

  void join(std::size_t first) {
    std::size_t last = first;
    chainOf_[first] = chains_.size();
    while (next_[last] != kNoSegment) {
      last = next_[last];
      chainOf_[last] = chains_.size();
    }
    chains_.push_back({first, last});
  }

  // Where the chain of the segment between a ghost and a vertex begins, or ends.
  std::optional<Point> farEnd(const std::optional<Point>& ghost, Point vertex, std::size_t Chain::*which) const {
    if (!ghost) return ghost;
    const bool begins = which == &Chain::first;
    const auto found = at_.find(vertex);
    for (const std::size_t k : begins ? found->second.arriving : found->second.leaving) {
      const OutlineSegment& s = outline_[k];
      if ((begins ? s.start : s.end) != *ghost) continue;
      const OutlineSegment& far = outline_[chains_[chainOf_.at(k)].*which];
      return begins ? far.start : far.end;
    }
    return ghost;
  }

  const Outline& outline_;
  std::map<Point, Vertex> at_;
  std::vector<std::size_t> next_;
  std::vector<Chain> chains_;
  std::map<std::size_t, std::size_t> chainOf_;
};

}  // namespace

Outline comparable(Outline outline, const Capabilities& can) {
  for (OutlineSegment& s : outline) {
    if (!can.blocks) s.block = 0;
    if (!can.ghosts) s.ghost1 = s.ghost2 = std::nullopt;
  }
  if (can.merged) outline = Joining(outline).joined();
  std::sort(outline.begin(), outline.end());
  return outline;
}

}  // namespace lgs::oracle
