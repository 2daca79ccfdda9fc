#include "oracle/generate/strokes.h"

#include <lgs/brush.h>
#include <array>
#include <vector>

namespace lgs::oracle {
namespace {

class Painter {
 public:
  Painter(Cell cell, Random& random) : cell_(cell), random_(random) {}

  std::vector<Call> stroke(Block block) {
    constexpr std::array kDeeds{BrushEdit::Deed::carve, BrushEdit::Deed::fill, BrushEdit::Deed::replace};
    std::vector<Call> calls;
    BrushEdit brush;
    brush.deed = kDeeds[random_.below(kDeeds.size())];
    brush.block = brush.deed == BrushEdit::Deed::carve ? 0 : block;
    if (random_.chance(40)) {
      brush.rings = crossing();
      return {Call::byBrush(brush)};
    }
    for (Ring& ring : shape().rings) {
      brush.rings = {std::move(ring)};
      calls.push_back(Call::byBrush(brush));
    }
    return calls;
  }

 private:
  std::int64_t between(std::int64_t least, std::int64_t most) { return random_.between(least, most); }
  Point near(Point p, std::int64_t reach) { return {p.x + between(-reach, reach), p.y + between(-reach, reach)}; }

  /// A place in a cell: on its rim, on a coarse lattice, or anywhere.
  Point place() {
    const std::int64_t step = kUnitsPerCell >> (random_.chance(70) ? random_.below(4) : 16);
    const Point corner = toWorld(cell_, {0, 0});
    const std::int64_t steps = kUnitsPerCell / step;
    return {corner.x + step * between(0, steps), corner.y + step * between(0, steps)};
  }

  Region shape() {
    const Point at = place();
    const std::int64_t size = (2 * kUnitsPerCell) >> random_.below(random_.chance(80) ? 6 : 17);
    switch (random_.below(3)) {
      case 0:
        return circle(at, size, 8 + 8 * random_.below(4));
      case 1:
        return rectangle(at, random_.chance(50) ? Point{1, 0} : near({0, 0}, 100), size, between(1, size));
      default: {
        const std::array line{at, near(at, size), near(at, 2 * size)};
        return thickLine(line, between(1, size), 8);
      }
    }
  }

  /// Rings on a lattice of few points: they cross, touch and overlap.
  std::vector<Ring> crossing() {
    constexpr std::array<std::int64_t, 6> kSteps{1, 5, 37, 977, 8'192, 10'007};
    const std::int64_t step = kSteps[random_.below(kSteps.size())];
    const Point at = place();
    std::vector<Ring> rings(1 + random_.below(2U));
    for (Ring& ring : rings)
      for (std::int64_t k = between(3, 7); k > 0; --k)
        ring.push_back({at.x + step * between(-12, 12), at.y + step * between(-12, 12)});
    return rings;
  }

  Cell cell_;
  Random& random_;
};

}  // namespace

std::vector<Call> strokeAt(Cell cell, Block block, Random& random) { return Painter(cell, random).stroke(block); }

}  // namespace lgs::oracle
