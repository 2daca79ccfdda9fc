// Taking one polygon out of another: the first is cut along the second's edges until each part is inside or apart.
#include "geometry.h"

#include <algorithm>
#include <utility>

namespace lgs::tiled {
namespace {

/// Edge pairs looked at before a difference is given up: far beyond drawn shapes, a few milliseconds at most.
constexpr std::int64_t kBudget = 4'000'000;

/// A part that is nowhere wider than a few lattice units is not worth a word.
constexpr std::int64_t kSliver = 8 * std::int64_t{kUnitsPerCell};

class Subtraction {
 public:
  explicit Subtraction(const Polygon& b) : b_(b) {}

  /// Cuts along the edges from `edge` on; each is used once on the way to a part, so the depth is at most b's size.
  void run(const Polygon& a, std::size_t edge) {
    budget_ -= static_cast<std::int64_t>(a.size() * b_.size());
    if (budget_ < 0 || !isSimple(a)) return giveUp(a);
    switch (relation(a, b_)) {
      case Relation::apart: result_.parts.push_back(a); return;
      case Relation::inside: return;
      case Relation::overlap: break;
    }
    for (; edge < b_.size(); ++edge) {
      const Point from = b_[edge], to = b_[(edge + 1) % b_.size()];
      if (!nearby(a, from, to)) continue;
      const Halves halves = split(a, {from, {to.x - from.x, to.y - from.y}});
      if (halves.left.empty() || halves.right.empty()) continue;
      for (const Polygon& part : halves.right) run(part, edge + 1);
      for (const Polygon& part : halves.left) run(part, edge + 1);
      return;
    }
    giveUp(a);
  }

  Difference take() { return std::move(result_); }

 private:
  void giveUp(const Polygon& a) { result_.lost |= doubleArea(a) > kSliver; }

  /// Whether the edge can run through the inside of a, judged by their boxes: others need not cut it.
  static bool nearby(const Polygon& a, Point from, Point to) {
    const Box box = boxOf(a);
    return std::min(from.x, to.x) < box.max.x && std::max(from.x, to.x) > box.min.x &&
           std::min(from.y, to.y) < box.max.y && std::max(from.y, to.y) > box.min.y;
  }

  const Polygon& b_;
  Difference result_;
  std::int64_t budget_ = kBudget;
};

}  // namespace

Difference subtract(const Polygon& a, const Polygon& b) {
  Subtraction subtraction(b);
  subtraction.run(a, 0);
  return subtraction.take();
}

}  // namespace lgs::tiled
