#include "oracle/suites/strokes.h"

#include "oracle/cgal/even_odd.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace lgs::oracle {
namespace {

constexpr const char* kNoArea = "case without area";
constexpr std::size_t kMostVertices = 4'000, kMostCrossings = 20'000;

// How coordinates become lattice points.
class Lattice {
 public:
  explicit Lattice(const SuiteCase& of) {
    const auto visit = [&](auto look) {
      for (const Operand& operand : of.operands)
        for (const SuitePart& part : operand)
          for (const auto& ring : part.rings)
            for (const auto& v : ring) look(v);
    };
    SuitePart::Vertex max{-kFar, -kFar};
    int fine = -kFinest;  // all coordinates times 2^fine are whole
    visit([&](const SuitePart::Vertex& v) {
      ++vertices;
      min_ = {std::min(min_.x, v.x), std::min(min_.y, v.y)};
      max = {std::max(max.x, v.x), std::max(max.y, v.y)};
      fine = std::max({fine, finenessOf(v.x), finenessOf(v.y)});
    });
    width_ = vertices == 0 ? 0 : std::max(max.x - min_.x, max.y - min_.y);
    if (!hasArea()) return;
    const int usual = 18 - std::ilogb(width_), most = 21 - std::ilogb(width_);  // 2^19 units are 8 cells
    power_ = std::clamp(fine, usual, most);
    // Where the least one times 2^power is no 62-bit integer the difference is rounded, too.
    const double largest = std::max({std::abs(min_.x), std::abs(min_.y), std::abs(max.x), std::abs(max.y)});
    isRounded = fine > power_ || (largest != 0 && std::ilogb(largest) + power_ > 61);
  }

  bool hasArea() const { return width_ > 0 && std::isfinite(width_); }

  Point pointOf(const SuitePart::Vertex& v) const { return {unitsOf(v.x, min_.x), unitsOf(v.y, min_.y)}; }

  std::size_t vertices = 0;
  bool isRounded = false;

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  static constexpr int kFinest = 1'100;

  static int finenessOf(double v) {
    if (v == 0) return -kFinest;
    int exponent = 0;
    const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(v, &exponent), 53));
    return 53 - exponent - std::countr_zero(static_cast<std::uint64_t>(digits));
  }

  std::int64_t unitsOf(double v, double min) const {
    if (isRounded) return std::llround(std::ldexp(v - min, power_));
    return std::llround(std::ldexp(v, power_)) - std::llround(std::ldexp(min, power_));
  }

  SuitePart::Vertex min_{kFar, kFar};
  double width_ = 0;
  int power_ = 0;
};

bool isInside(Filled rule, int winding) {
  switch (rule) {
    case Filled::nonZero:
      return winding != 0;
    case Filled::positive:
      return winding > 0;
    case Filled::negative:
      return winding < 0;
    default:
      return winding % 2 != 0;
  }
}

std::vector<RuledRings> onLattice(const Operand& operand, const Lattice& lattice) {
  std::vector<RuledRings> regions;
  for (const SuitePart& part : operand) {
    regions.push_back({Rings(), [rule = part.rule](int n) { return isInside(rule, n); }});
    RuledRings& region = regions.back();
    for (const auto& vertices : part.rings) {
      std::vector<Point> ring;
      for (const auto& v : vertices)
        if (const Point p = lattice.pointOf(v); ring.empty() || ring.back() != p) ring.push_back(p);
      if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
      if (ring.size() > 2) region.rings.push_back(std::move(ring));
    }
  }
  return regions;
}

double cross(Point a, Point b, Point c) {
  return static_cast<double>(b.x - a.x) * static_cast<double>(c.y - a.y) -
         static_cast<double>(b.y - a.y) * static_cast<double>(c.x - a.x);
}

// So many, about, or more than may be.
std::size_t crossings(const std::vector<std::vector<RuledRings>>& operands) {
  std::vector<std::pair<Point, Point>> edges;
  for (const auto& operand : operands)
    for (const RuledRings& region : operand)
      for (const auto& ring : region.rings)
        for (std::size_t k = 0; k < ring.size(); ++k) edges.emplace_back(ring[k], ring[(k + 1) % ring.size()]);
  std::size_t count = 0;
  for (std::size_t k = 0; k < edges.size() && count <= kMostCrossings; ++k) {
    for (std::size_t m = 0; m < k; ++m) {
      const auto& [a, b] = edges[k];
      const auto& [c, d] = edges[m];
      const bool meet = std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
                        cross(a, b, c) * cross(a, b, d) <= 0 && cross(c, d, a) * cross(c, d, b) <= 0;
      count += meet ? 1 : 0;
    }
  }
  return count;
}

Rings joined(const std::vector<RuledRings>& regions) {
  Rings all;
  for (const RuledRings& region : regions) all.insert(all.end(), region.rings.begin(), region.rings.end());
  return all;
}

Rings both(Rings a, const Rings& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

tl::expected<Strokes, std::string> strokesOf(const SuiteCase& of) {
  const Lattice lattice(of);
  if (!lattice.hasArea()) return tl::unexpected<std::string>(kNoArea);
  if (lattice.vertices > kMostVertices) return tl::unexpected<std::string>("case of more than 4,000 vertices");
  std::vector<std::vector<RuledRings>> operands;
  for (const Operand& operand : of.operands) operands.push_back(onLattice(operand, lattice));
  if (crossings(operands) > kMostCrossings) return tl::unexpected<std::string>("case of more than 20,000 crossings");

  Strokes strokes;
  strokes.isRounded = lattice.isRounded;
  const auto make = [&](BrushEdit::Deed deed, Rings rings) {
    if (rings.empty()) return;
    BrushEdit brush;
    brush.deed = deed;
    brush.block = deed == BrushEdit::Deed::carve ? 0 : 1;
    brush.rings = std::move(rings);
    strokes.trace.calls.push_back(Call::byBrush(std::move(brush)));
  };
  const auto commit = [&] { strokes.trace.calls.push_back(Call::commit()); };
  const auto inStrokes = [&](const std::vector<RuledRings>& operand) {
    auto parts = asEvenOdd(operand);
    strokes.isEvenOdd = strokes.isEvenOdd || !parts;
    return parts ? std::move(*parts) : std::vector<Rings>{joined(operand)};
  };
  const auto inOne = [&](const std::vector<RuledRings>& operand) {
    const auto parts = asEvenOdd(operand);
    strokes.isEvenOdd = strokes.isEvenOdd || !parts || parts->size() > 1;
    return joined(operand);
  };
  const auto whole = [&]() -> tl::expected<Strokes, std::string> {
    const auto isStroke = [](const Call& call) { return call.kind == Call::Kind::brush; };
    if (std::ranges::none_of(strokes.trace.calls, isStroke)) return tl::unexpected<std::string>(kNoArea);
    return std::move(strokes);
  };
  using enum BrushEdit::Deed;
  if (of.operation == Operation::exclude) {
    Rings all;
    for (const auto& operand : operands) all = both(std::move(all), inOne(operand));
    make(fill, std::move(all));
    commit();
    return whole();
  }
  const bool isOne = of.operation == Operation::intersect;
  Rings first;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    std::vector<Rings> parts = isOne ? std::vector<Rings>{inOne(operands[k])} : inStrokes(operands[k]);
    if (k == 0) first = parts.empty() ? Rings() : parts[0];
    for (Rings& rings : parts) {
      if (isOne && k > 0) rings = both(std::move(rings), first);
      make(k == 0 || of.operation == Operation::unite ? fill : carve, std::move(rings));
    }
    commit();
  }
  return whole();
}

}  // namespace lgs::oracle
