// Taking one polygon out of another: the first is cut along the second's edges until each part is inside or apart.
#include "subtract.h"

#include "rounding.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lgs::tiled {
namespace {

/// Edges and vertices looked at before a difference is given up: far beyond drawn shapes, a few milliseconds at most.
constexpr std::int64_t kBudget = 4'000'000;

/// A part that is nowhere wider than a few lattice units is not worth a word.
constexpr std::int64_t kSliver = 8 * std::int64_t{kUnitsPerCell};

class Subtraction {
 public:
  Subtraction(const Polygon& b, Obstacles obstacles, std::int64_t& budget)
      : b_(b), waiting_(obstacles.begin(), obstacles.end()), budget_(budget) {}

  /// Cuts along the edges from `edge` on; each is used once on the way to a part, so the depth is at most b's size.
  void run(const Polygon& a, std::size_t edge) {
    budget_ -= static_cast<std::int64_t>(a.size() * b_.size());
    if (budget_ < 0 || !isSimple(a)) return giveUp(a);
    switch (relation(a, b_)) {
      case Relation::apart:
        result_.parts.push_back(a);
        return;
      case Relation::inside:
        return;
      case Relation::overlap:
        break;
    }
    for (; edge < b_.size(); ++edge) {
      const Point from = b_[edge], to = nextVertex(b_, edge);
      if (!nearby(a, from, to)) continue;
      Halves halves = split(a, {from, to - from}, obstacles());
      if (halves.left.empty() || halves.right.empty()) continue;
      // Where one half is cut again, on the line that they share, the new vertex must not push it into the other.
      const std::size_t before = waiting_.size();
      for (std::vector<Polygon>* half : {&halves.left, &halves.right}) {
        for (Polygon& part : *half) waiting_.push_back(std::move(part));
      }
      while (waiting_.size() > before) {
        const Polygon part = std::move(waiting_.back());
        waiting_.pop_back();
        run(part, edge + 1);
      }
      return;
    }
    // No edge cuts it any more. Where it was cut before, rounding may have left it a unit too large to count as inside,
    // or to count as apart.
    if (nearlyInside(a, b_)) return;
    bool clear = true;
    std::vector<Polygon> loops = tidyLoops(bentAround(a, b_));
    for (const Polygon& loop : loops)
      clear &= doubleArea(loop) > 0 && isSimple(loop) && relation(loop, b_) == Relation::apart;
    if (!clear) return giveUp(a);
    for (Polygon& loop : loops) result_.parts.push_back(std::move(loop));
  }

  Difference take() { return std::move(result_); }

 private:
  std::vector<Polygon> obstacles() {
    std::vector<Polygon> all = waiting_;
    all.insert(all.end(), result_.parts.begin(), result_.parts.end());
    for (const Polygon& ring : all) budget_ -= static_cast<std::int64_t>(ring.size());
    return all;
  }

  void giveUp(const Polygon& a) { result_.lost |= doubleArea(a) > kSliver; }

  /// Whether the edge can run through the inside of a, judged by their boxes: others need not cut it.
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
  // Where rounding spoils a part hangs on the order of the cuts: b may begin at any of its vertices.
  Polygon turned = b;
  for (std::size_t k = 1; k < b.size() && difference.lost && budget >= 0; ++k) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    if (Difference other = differenceBy(turned); !other.lost) difference = std::move(other);
  }
  return difference;
}

}  // namespace lgs::tiled
