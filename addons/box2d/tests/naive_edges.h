// Rules 1 to 3 of <lgs/box2d/edges.h> in the slow and obvious way: whole chains, from their beginnings, without
// updates.
#pragma once

#include <fmt/format.h>
#include <lgs/box2d/edges.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <ostream>
#include <tuple>
#include <vector>

namespace lgs::box2d_test {

/// An edge without the numbers that depend on the edits.
struct PlainEdge {
  SegmentId first;
  SegmentId last;
  box2d::Chunk chunk;
  Point start;
  Point end;
  std::optional<Point> ghost1;
  std::optional<Point> ghost2;
  friend auto operator<=>(const PlainEdge&, const PlainEdge&) = default;
  friend void PrintTo(const PlainEdge& e, std::ostream* out) {
    const auto ghost = [](const std::optional<Point>& p) { return p ? fmt::format("({}, {})", p->x, p->y) : "none"; };
    *out << fmt::format("({}, {}) to ({}, {}), ghosts {} and {}, segments {} to {}, chunk ({}, {})", e.start.x,
                        e.start.y, e.end.x, e.end.y, ghost(e.ghost1), ghost(e.ghost2), e.first.value, e.last.value,
                        e.chunk.x, e.chunk.y);
  }
};

struct NaiveEdges {
  std::vector<PlainEdge> edges;  // sorted
  box2d::EdgeCounts counts;
};

class NaiveBuilder {
 public:
  NaiveBuilder(const World& world, const box2d::EdgeOptions& options) : options_(options) {
    for (const SegmentId id : world.segments()) segments_.emplace(id, *world.segment(id));
  }

  NaiveEdges build() {
    for (const auto& [id, segment] : segments_) {  // first the chains that have a beginning, then the rings
      if (!before(segment)) addChain(id, false);
    }
    for (const auto& [id, segment] : segments_) {
      if (!done_.contains(id)) addChain(id, true);
    }
    std::sort(result_.edges.begin(), result_.edges.end());
    result_.counts.edges = result_.edges.size();
    result_.counts.segments = segments_.size();
    return result_;
  }

 private:
  using Strip = std::vector<Segment>;

  const Segment* before(const Segment& s) const {
    const auto other = segments_.find(s.predecessor);  // none, too, if its chunk is unloaded
    return other != segments_.end() && other->second.successor == s.id ? &other->second : nullptr;
  }
  const Segment* after(const Segment& s) const {
    const auto other = segments_.find(s.successor);
    return other != segments_.end() && other->second.predecessor == s.id ? &other->second : nullptr;
  }

  static std::pair<std::int64_t, std::int64_t> direction(const Segment& s) {
    const std::int64_t x = s.end.x - s.start.x;
    const std::int64_t y = s.end.y - s.start.y;
    const std::int64_t divisor = std::gcd(x, y);
    return {x / divisor, y / divisor};
  }
  box2d::Chunk chunkOf(const Segment& s) const {
    const double side = options_.chunkCells;
    return {static_cast<std::int32_t>(std::floor(s.cell.i / side)),
            static_cast<std::int32_t>(std::floor(s.cell.j / side))};
  }
  bool isOneStrip(const Segment& a, const Segment& b) const {
    return options_.merge && direction(a) == direction(b) && chunkOf(a) == chunkOf(b) &&
           (!options_.material || options_.material(a.block) == options_.material(b.block));
  }
  bool isShort(Point from, Point to) const {
    return std::hypot(static_cast<long double>(to.x - from.x), static_cast<long double>(to.y - from.y)) <
           static_cast<long double>(options_.shortest);
  }
  bool isShort(const Strip& strip) const { return isShort(strip.front().start, strip.back().end); }

  void addChain(SegmentId from, bool ring) {
    std::vector<Segment> chain;
    for (const Segment* s = &segments_.at(from); s != nullptr && done_.emplace(s->id, true).second; s = after(*s)) {
      chain.push_back(*s);
    }
    if (ring) {  // begin where a strip begins
      for (std::size_t k = 0; k < chain.size() && isOneStrip(chain.back(), chain.front()); ++k) {
        std::rotate(chain.begin(), chain.begin() + 1, chain.end());
      }
    }
    std::vector<Strip> strips;
    for (const Segment& s : chain) {
      if (strips.empty() || !isOneStrip(strips.back().back(), s)) strips.emplace_back();
      strips.back().push_back(s);
    }
    if (ring) rotateRing(strips);
    std::vector<PlainEdge> edges;
    std::vector<Segment> pending;
    bool isWelded = false;  // whether the edge before `pending` is
    const auto endRow = [&] {
      const bool isLonger = isWelded && !pending.empty() && !isShort(edges.back().start, pending.back().end);
      if (isLonger) {
        edges.back().last = pending.back().id;
        edges.back().end = pending.back().end;
      }
      (isLonger ? result_.counts.welded : result_.counts.leftOut) += pending.size();
      pending.clear();
      isWelded = false;
    };
    for (const Strip& strip : strips) {
      if (!isShort(strip)) {
        endRow();
        addEdge(edges, strip);
        (strip.size() == 1 ? result_.counts.single : result_.counts.merged) += strip.size();
        continue;
      }
      pending.insert(pending.end(), strip.begin(), strip.end());
      if (isShort(pending)) continue;
      addEdge(edges, pending);
      result_.counts.welded += pending.size();
      pending.clear();
      isWelded = true;
    }
    endRow();
    link(edges, chain, ring);
    result_.edges.insert(result_.edges.end(), edges.begin(), edges.end());
  }

  // Begins the ring so that no row of short strips runs over its end. If all strips are short, the least one is first.
  void rotateRing(std::vector<Strip>& strips) const {
    const auto isLong = [&](const Strip& s) { return !isShort(s); };
    auto first = std::find_if(strips.begin(), strips.end(), isLong);
    if (first == strips.end()) {
      first = std::min_element(strips.begin(), strips.end(), [](const Strip& a, const Strip& b) {
        return std::tie(a.front().start, a.front().end) < std::tie(b.front().start, b.front().end);
      });
    }
    std::rotate(strips.begin(), first, strips.end());
  }

  void addEdge(std::vector<PlainEdge>& edges, const Strip& of) const {
    edges.push_back({of.front().id, of.back().id, chunkOf(of.front()), of.front().start, of.back().end, {}, {}});
  }

  static void link(std::vector<PlainEdge>& edges, const std::vector<Segment>& chain, bool ring) {
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
      edges[k].ghost2 = edges[k + 1].end;
      edges[k + 1].ghost1 = edges[k].start;
    }
    if (edges.empty()) return;
    if (ring) {
      if (edges.size() == 1) return;
      edges.front().ghost1 = edges.back().start;
      edges.back().ghost2 = edges.front().end;
      return;
    }
    if (chain.front().predecessor) edges.front().ghost1 = chain.front().ghost1;
    if (chain.back().successor) edges.back().ghost2 = chain.back().ghost2;
  }

  const box2d::EdgeOptions& options_;
  std::map<SegmentId, Segment> segments_;
  std::map<SegmentId, bool> done_;
  NaiveEdges result_;
};

}  // namespace lgs::box2d_test
