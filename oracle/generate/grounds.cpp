// Strokes on ground that is made for them.
#include "oracle/calls/shapes.h"
#include "oracle/generate/strokes.h"
#include "oracle/reference/validity.h"

#include <lgs/brush.h>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace lgs::oracle {

BrushEdit::Deed anyDeed(Random& random) {
  constexpr std::array kDeeds{BrushEdit::Deed::carve, BrushEdit::Deed::fill, BrushEdit::Deed::replace};
  return kDeeds[random.below(kDeeds.size())];
}

namespace {

// Columns of boxes and triangles, some with nothing between them: they have edges and parts of edges in common, or
// touch with a corner, or a vertex on an edge.
Shape patchwork(Random& random) {
  constexpr std::int32_t kEighth = kUnitsPerCell / 8;
  const auto eighths = [&](int most) {
    std::vector<std::int32_t> all{0, 8};
    for (int k = random.below(most); k > 0; --k) all.push_back(random.between(1, 7));
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  };
  Shape shape;
  const auto columns = eighths(4);
  for (std::size_t i = 1; i < columns.size(); ++i) {
    const auto rows = eighths(4);
    for (std::size_t j = 1; j < rows.size(); ++j) {
      const std::int32_t left = columns[i - 1], right = columns[i], floor = rows[j - 1], top = rows[j];
      const int kind = random.below(8);
      if (kind < 2) continue;
      LocalPolygon& box = shape.emplace_back(LocalPolygon{{left, floor}, {right, floor}, {right, top}, {left, top}});
      if (kind < 5) continue;
      const std::size_t side = random.below(std::size_t{4});  // a triangle on it, with its tip on the other one
      const LocalPoint a = box[side], b = box[(side + 1) % 4], c = box[(side + 2) % 4], d = box[(side + 3) % 4];
      const bool isFlat = side % 2 == 0;
      const auto [least, most] = isFlat ? std::minmax(c.x, d.x) : std::minmax(c.y, d.y);
      const std::int32_t along = random.between(least, most);
      box = {a, b, isFlat ? LocalPoint{along, c.y} : LocalPoint{c.x, along}};
    }
  }
  for (LocalPolygon& polygon : shape)
    for (LocalPoint& v : polygon) v = {v.x * kEighth, v.y * kEighth};
  return shape;
}

}  // namespace

std::vector<Call> acrossShapes(Cell cell, const std::vector<Block>& blocks, Random& random) {
  const auto any = [&] { return random.pick(blocks); };
  const auto between = [&](std::int64_t least, std::int64_t most) { return random.between(least, most); };
  Call gone = Call::of(Call::Kind::clear), many = Call::of(Call::Kind::addMany);
  gone.cells = {cell, cell};
  const std::int32_t size = random.chance(50) ? kUnitsPerCell : 8 << random.below(4);
  const auto anywhere = [&] {
    const std::int32_t last = kUnitsPerCell - size, kind = random.below(3);
    return kind == 0 ? 0 : kind == 1 ? last : random.below(last + 1);
  };
  const LocalPoint corner{anywhere(), anywhere()};
  const Block block = any();
  const bool isOneBlock = random.chance(70);
  const int symmetry = random.below(8);
  for (const LocalPolygon& polygon :
       random.chance(50) ? patchwork(random) : Shape(random.pick(degenerateShapes()).polygons)) {
    LocalPolygon moved = turned(polygon, symmetry);
    for (LocalPoint& v : moved)
      v = {corner.x + static_cast<std::int32_t>(std::int64_t{v.x} * size / kUnitsPerCell),
           corner.y + static_cast<std::int32_t>(std::int64_t{v.y} * size / kUnitsPerCell)};
    if (faultOf(moved)) continue;  // slivers vanish where all is small
    many.comes.push_back({.cell = cell, .shape = {std::move(moved)}, .block = isOneBlock ? block : any()});
  }
  std::vector<Call> calls{std::move(gone), std::move(many)};
  for (int k = random.between(1, 3); k > 0; --k) {
    BrushEdit brush{.deed = random.chance(60) ? BrushEdit::Deed::carve : anyDeed(random), .rings = {}};
    if (brush.deed != BrushEdit::Deed::carve) brush.block = any();
    // An edge of the hole passes some place of it.
    const std::int64_t radius = 1 + between(0, random.chance(50) ? size : 4 * size - 1);
    const Point rim = random.pick(circle({}, radius, 32).rings[0]), base = toWorld(cell, corner);
    const std::int64_t x = between(0, size), y = between(0, size);
    brush.rings = circle({base.x + x - rim.x, base.y + y - rim.y}, radius, random.chance(50) ? 8 : 32).rings;
    if (random.chance(30)) {  // a triangle or another polygon of some of its corners
      Ring some;
      const std::size_t step = 1 + random.below(brush.rings[0].size() / 3 + 1);
      for (std::size_t v = 0; v < brush.rings[0].size(); v += step) some.push_back(brush.rings[0][v]);
      brush.rings = {std::move(some)};
    }
    calls.push_back(Call::byBrush(std::move(brush)));
  }
  return calls;
}

std::vector<Call> acrossSlivers(Cell cell, const std::vector<Block>& blocks, Random& random) {
  constexpr std::array kWidths{8, 30, 300, 5'000};
  const std::int32_t width = kWidths[random.below(kWidths.size())], far = width / 8 + 1;
  const std::int32_t left = random.between(far, kUnitsPerCell - width - far);
  const std::int32_t floor = random.chance(50) ? 0 : random.between(1, kUnitsPerCell - 1);
  const bool isUpright = random.chance(50), isTurned = random.chance(50);
  const auto at = [&](std::int32_t along, std::int32_t across) {
    return isUpright ? LocalPoint{floor + across, left + along} : LocalPoint{left + along, floor + across};
  };
  std::vector<std::int32_t> tips(2 + random.below(14U)), feet(2 * tips.size());
  for (auto* const row : {&tips, &feet}) {
    for (std::int32_t& v : *row) v = random.between(0, width);
    std::ranges::sort(*row);
  }
  Call gone = Call::of(Call::Kind::clear), many = Call::of(Call::Kind::addMany);
  gone.cells = {cell, cell};
  for (std::size_t k = 0; k < tips.size(); ++k) {
    LocalPoint a = at(feet[2 * k], isTurned), b = at(feet[2 * k + 1], isTurned);
    if (isUpright != isTurned) std::swap(a, b);
    if (a != b)
      many.comes.push_back({.cell = cell, .shape = {{a, b, at(tips[k], !isTurned)}}, .block = random.pick(blocks)});
  }
  BrushEdit brush{.deed = anyDeed(random), .rings = {{}}};
  if (brush.deed != BrushEdit::Deed::carve) brush.block = random.pick(blocks);
  const std::int32_t begin = random.between(-far, width + far), end = begin + random.between(-3, 3);
  for (const LocalPoint v : {at(begin, random.between(-3, 0)), at(end, random.between(1, 4)),
                             at(begin + random.between(1, 2 * far), random.between(-4, 4))})
    brush.rings[0].push_back(toWorld(cell, v));
  return {std::move(gone), std::move(many), Call::byBrush(std::move(brush))};
}

}  // namespace lgs::oracle
