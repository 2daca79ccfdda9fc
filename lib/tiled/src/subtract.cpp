// The first polygon is cut along the edges of the second until each part is inside the second or apart from it.
#include "subtract.h"

#include "rounding.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lgs::tiled {
namespace {

/// How many edges and vertices may be looked at before a difference is given up. Drawn shapes need far fewer. It takes
/// some milliseconds at most.
constexpr std::int64_t kBudget = 4'000'000;

/// Twice an area. A smaller part is given up without a word: across a cell it would be 4 lattice units wide.
constexpr std::int64_t kSliver = 8 * std::int64_t{kUnitsPerCell};

class Subtraction {
 public:
  Subtraction(const Polygon& b, Obstacles obstacles, std::int64_t& budget)
      : b_(b), waiting_(obstacles.begin(), obstacles.end()), budget_(budget) {}

  /// Takes b out of a, cutting along the edges of b from `edge` on. On the way to a part each edge cuts at most once,
  /// so the depth is at most b's size.
  void run(const Polygon& a, std::size_t edge) {
    budget_ -= static_cast<std::int64_t>(a.size() * b_.size());
    if (budget_ < 0 || !isSimple(a)) return giveUp(a);
    const Relation now = relation(a, b_);
    if (now == Relation::apart) result_.parts.push_back(a);
    if (now != Relation::overlap) return;
    for (; edge < b_.size(); ++edge) {
      if (cutAlong(edge, a)) return;
    }
    settle(a);
  }

  Difference take() { return std::move(result_); }

 private:
  /// Cuts a along an edge and goes on with the pieces. False if the edge leaves a whole.
  bool cutAlong(std::size_t edge, const Polygon& a) {
    const Point from = b_[edge], to = nextVertex(b_, edge);
    if (!nearby(a, from, to)) return false;
    const Halves halves = split(a, {from, to - from}, obstacles());
    if (halves.left.empty() || halves.right.empty()) return false;
    // All pieces wait together. If one is cut again, on a line that it shares with others, the new vertex must not push
    // it into them.
    const std::size_t before = waiting_.size();
    waiting_.insert(waiting_.end(), halves.left.begin(), halves.left.end());
    waiting_.insert(waiting_.end(), halves.right.begin(), halves.right.end());
    while (waiting_.size() > before) {
      const Polygon part = std::move(waiting_.back());
      waiting_.pop_back();
      run(part, edge + 1);
    }
    return true;
  }

  /// No edge cuts a any more, but it overlaps b. Where it was cut before, rounding may have left it a unit too large to
  /// count as inside, or to count as apart.
  void settle(const Polygon& a) {
    if (nearlyInside(a, b_)) return;
    std::vector<Polygon> loops = tidyLoops(bentAround(a, b_));
    const bool clear = std::all_of(loops.begin(), loops.end(), [&](const Polygon& loop) {
      return doubleArea(loop) > 0 && isSimple(loop) && relation(loop, b_) == Relation::apart;
    });
    if (!clear) return giveUp(a);
    for (Polygon& loop : loops) result_.parts.push_back(std::move(loop));
  }

  std::vector<Polygon> obstacles() {
    std::vector<Polygon> all = waiting_;
    all.insert(all.end(), result_.parts.begin(), result_.parts.end());
    for (const Polygon& ring : all) budget_ -= static_cast<std::int64_t>(ring.size());
    return all;
  }

  void giveUp(const Polygon& a) { result_.lost |= doubleArea(a) > kSliver; }

  /// Whether the edge can run through the interior of a, judged by their boxes. Other edges need not cut it.
  static bool nearby(const Polygon& a, Point from, Point to) {
    return interiorsMeet(boundingBox(std::array{from, to}), boundingBox(a));
  }

  const Polygon& b_;
  std::vector<Polygon> waiting_;  // obstacles, and parts still to be worked on
  Difference result_;
  std::int64_t& budget_;
};

}  // namespace

Difference subtract(const Polygon& a, const Polygon& b, Obstacles obstacles) {
  std::int64_t budget = kBudget;
  const auto differenceBy = [&](const Polygon& ring) {
    Subtraction subtraction(ring, obstacles, budget);
    subtraction.run(a, 0);
    return subtraction.take();
  };
  Difference difference = differenceBy(b);
  // Whether rounding spoils a part depends on the order of the cuts, so b is tried again from each of its vertices.
  Polygon turned = b;
  for (std::size_t k = 1; k < b.size() && difference.lost && budget >= 0; ++k) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    if (Difference other = differenceBy(turned); !other.lost) difference = std::move(other);
  }
  return difference;
}

}  // namespace lgs::tiled
