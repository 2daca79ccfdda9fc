#include "oracle/calls/draw.h"

#include "oracle/calls/shapes.h"

#include <lgs/world.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace lgs::oracle {

using Kind = Call::Kind;

namespace {

constexpr std::int32_t kUnit = kUnitsPerCell;
constexpr std::uint32_t kNoShape = 4'711;  // where the call itself makes shapes, other ids may become known

// Some cells further, and no further than there are numbers.
std::int32_t plus(std::int32_t index, int step) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(std::int64_t{index} + step, INT32_MIN, INT32_MAX));
}

// Draws a call. Compilers differ in the order in which they evaluate arguments: so a call of a function has at most one
// that is drawn.
class Drawer {
 public:
  Drawer(Random& choices, const Habits& habits) : choices_(choices), habits_(habits) {}

  Call call(Kind kind) {
    Call call;
    call.kind = kind;
    const Cell here = cell();
    call.cells = {here, here};
    if (kind == Kind::fill || kind == Kind::clear) call.cells.max = {plus(here.i, below(3)), plus(here.j, below(3))};
    if (kind == Kind::leave) {  // with all of its chunk, or not
      const int left = below(96), down = below(96), right = below(96), up = below(96);
      call.cells = {{plus(here.i, -left), plus(here.j, -down)}, {plus(here.i, right), plus(here.j, up)}};
    }
    if (choices_.chance(3)) call.cells.max.i = plus(call.cells.max.i, -3);  // mostly an empty rectangle
    if (isHostile()) call.cells.max = endOfCells();
    switch (kind) {
      case Kind::shape:
      case Kind::addShape:
      case Kind::replace:
      case Kind::fill:
        call.comes = {coming(here, shape())};
        break;
      case Kind::add:
      case Kind::setBlock:
        call.comes = {coming(here, {polygon()})};
        break;
      case Kind::addMany:
        for (int k = below(5); k > 0; --k) {
          const Cell there = cell();
          call.comes.push_back(coming(there, shape()));
        }
        break;
      case Kind::exchange:
        for (LocalPolygon& p : shape())
          if (!choices_.chance(20)) call.comes.push_back(coming(here, {std::move(p)}));
        break;
      case Kind::group:
        for (int k = 1 + below(4); k > 0; --k) call.group.push_back(this->call(edit()));
        call.keeps = static_cast<Call::Keeps>(below(3));
        break;
      default:
        break;
    }
    for (Coming& c : call.comes)
      if (isByShape(kind) && choices_.chance(10)) c.id = kind == Kind::addMany ? kNoShape : 1 + choices_.below(100U);
    for (Coming& c : call.comes)
      if (isByShape(kind) && isHostile()) c.id = endOfNumbers() | 0x7000'0000;
    if (kind == Kind::remove || kind == Kind::setBlock) call.goes = {named(here)};
    if (kind == Kind::removeMany || kind == Kind::exchange) call.goes = several(kind, here);
    constexpr std::array kNotations{Notation::lattice, Notation::list, Notation::floats, Notation::doubles};
    call.notation = kNotations[choices_.below(kNotations.size())];
    call.offset = choices_.below(choices_.chance(habits_.badPercent) ? kOffsets : kSpoiltOffset);
    const auto isHuge = [](const LocalPolygon& p) { return p.size() > kMaxVerticesPerCell; };
    if (habits_.hostilePercent > 0 && call.comes.size() == 1 && std::ranges::any_of(call.comes[0].shape, isHuge)) {
      call.notation = choices_.chance(50) ? Notation::floats : Notation::doubles;  // two things are wrong with it
      call.offset = kSpoiltOffset + choices_.below(2U);
    }
    call.room = choices_.below(4U);
    call.nth = choices_.below(16U);
    if (kind == Kind::rollBack && habits_.weights[static_cast<std::size_t>(Kind::redo)] > 0)
      call.keeps = choices_.chance(60) ? Call::Keeps::always : Call::Keeps::never;
    if (kind == Kind::commit) call.nth = 0;
    return tidied(std::move(call));
  }

  Kind kind() {
    int ticket = below(std::accumulate(habits_.weights.begin(), habits_.weights.end(), 0));
    std::size_t k = 0;
    for (; ticket >= habits_.weights[k]; ++k) ticket -= habits_.weights[k];
    return static_cast<Kind>(k);
  }

 private:
  int below(int n) { return choices_.below(n); }

  // An edit, which is no group.
  Kind edit() {
    constexpr std::array kEdits{Kind::add,      Kind::addShape,   Kind::addMany, Kind::remove,
                                Kind::shape,    Kind::removeMany, Kind::replace, Kind::exchange,
                                Kind::setBlock, Kind::fill,       Kind::clear};
    return kEdits[choices_.below(kEdits.size())];
  }

  bool isHostile() { return habits_.hostilePercent > 0 && choices_.chance(habits_.hostilePercent); }

  std::uint32_t endOfNumbers() {
    constexpr std::array<std::uint32_t, 6> kEnds{0xffff'ffff, 0, 1, 0x7fff'ffff, 0x8000'0000, 0xffff'fffe};
    return kEnds[choices_.below(kEnds.size())];
  }

  std::int32_t endOfWorld() {
    constexpr std::array kEnds{kMaxCell,  -kMaxCell, kMaxCell + 1, -kMaxCell - 1, INT32_MIN,
                               INT32_MAX, 0,         INT32_MIN + 1};
    return kEnds[choices_.below(kEnds.size())];
  }

  Cell endOfCells() {
    const std::int32_t i = endOfWorld(), j = endOfWorld();
    return {i, j};
  }

  Cell cell() {
    if (isHostile()) return endOfCells();
    const int i = below(habits_.width), j = below(habits_.height);
    if (choices_.chance(1)) return {kMaxCell - i, kMaxCell};  // a chunk of its own, or out of range
    return {i, j};
  }

  /// With more vertices than a cell may have, or one at the end of all numbers.
  LocalPolygon hostilePolygon(LocalPolygon polygon) {
    if (choices_.chance(30)) return LocalPolygon(kMaxVerticesPerCell + choices_.below(2U), polygon[0]);
    constexpr std::array kEnds{INT32_MIN, INT32_MAX, INT32_MIN + 1, kUnit + 1, -1};
    LocalPoint& p = polygon[choices_.below(polygon.size())];
    (choices_.chance(50) ? p.x : p.y) = kEnds[choices_.below(kEnds.size())];
    return polygon;
  }

  LocalPolygon polygon() {
    LocalPolygon drawn = drawPolygon(choices_);
    if (isHostile()) return hostilePolygon(std::move(drawn));
    return choices_.chance(habits_.badPercent) ? spoilt(choices_, std::move(drawn)) : drawn;
  }

  Shape shape() {
    if (choices_.chance(25)) return {polygon()};
    Shape shape = degenerateShapes()[choices_.below(degenerateShapes().size())].polygons;
    const int symmetry = below(8);
    for (LocalPolygon& p : shape) p = turned(p, symmetry);
    if (!choices_.chance(habits_.badPercent)) return shape;
    if (choices_.chance(30)) return choices_.chance(30) ? Shape() : Shape{shape[0], shape[0]};
    LocalPolygon& any = shape[choices_.below(shape.size())];
    any = spoilt(choices_, any);
    return shape;
  }

  Coming coming(Cell cell, Shape shape) {
    const Block block = isHostile() ? endOfNumbers() : choices_.below(habits_.blocks);
    return {.cell = cell, .shape = std::move(shape), .block = block};
  }

  Named named(Cell cell) {
    using enum Named::How;
    if (isHostile()) {
      const std::uint32_t cellRef = endOfNumbers(), serial = endOfNumbers();
      return {handle, cell, 0, {cellRef, serial}, {}};
    }
    const int ticket = below(100);
    const Named::How how = ticket < 85 ? standing : ticket < 95 ? given : beside;
    return {.how = how, .cell = cell, .nth = choices_.below(how == standing ? 8U : 64U)};
  }

  // Of one cell for exchange(), as a rule.
  std::vector<Named> several(Kind kind, Cell here) {
    std::vector<Named> all;
    if (choices_.chance(60)) return {{.how = Named::How::all, .cell = here}};
    for (int k = below(4); k > 0; --k) all.push_back(named(kind == Kind::exchange ? here : cell()));
    return all;
  }

  Random& choices_;
  const Habits& habits_;
};

LocalPoint drawPoint(Random& choices, std::int32_t lines) {
  const std::int32_t x = choices.below(lines + 1), y = choices.below(lines + 1);
  return {x * (kUnit / lines), y * (kUnit / lines)};
}

}  // namespace

Habits withMarks(Habits habits) {
  for (const Kind kind : {Kind::mark, Kind::rollBack, Kind::forget}) habits.weights[static_cast<std::size_t>(kind)] = 6;
  return habits;
}

Habits withLoads(Habits habits) {
  for (const Kind kind : {Kind::leave, Kind::load}) habits.weights[static_cast<std::size_t>(kind)] = 2;
  return habits;
}

Call drawCall(Random& choices, const Habits& habits) {
  Drawer drawer(choices, habits);
  return drawer.call(drawer.kind());
}

LocalPolygon drawPolygon(Random& choices) {
  const int kind = choices.below(10);
  if (kind < 7) {
    const Shape& shape = degenerateShapes()[choices.below(degenerateShapes().size())].polygons;
    const LocalPolygon& polygon = choices.pick(shape);
    return turned(polygon, choices.below(8));
  }
  if (kind == 7) {  // a box on eighths
    const std::int32_t left = choices.below(8), floor = choices.below(8);
    const std::int32_t right = choices.between(left + 1, 8), top = choices.between(floor + 1, 8);
    constexpr std::int32_t k = kUnit / 8;
    return {{left * k, floor * k}, {right * k, floor * k}, {right * k, top * k}, {left * k, top * k}};
  }
  const std::int32_t lines = kind == 8 ? 8 : kUnit;
  LocalPolygon triangle;
  for (int k = 0; k < 3; ++k) triangle.push_back(drawPoint(choices, lines));
  const auto [a, b, c] = std::tuple(triangle[0], triangle[1], triangle[2]);
  const std::int64_t turn = std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
  if (turn < 0) std::swap(triangle[1], triangle[2]);
  return triangle;
}

LocalPolygon spoilt(Random& choices, LocalPolygon polygon) {
  const std::size_t n = polygon.size(), k = choices.below(n), m = choices.below(n);
  switch (choices.below(9)) {
    case 0:
      std::reverse(polygon.begin(), polygon.end());
      break;
    case 1:
      polygon.resize(choices.below(3U));
      break;
    case 2:  // out of the cell
      polygon[k].x = choices.chance(50) ? -1 : kUnit + 1;
      break;
    case 3:
      polygon.push_back(polygon[k]);
      break;
    case 4:
      std::swap(polygon[k], polygon[m]);
      break;
    case 5:
      polygon[k] = drawPoint(choices, 8);
      break;
    case 6: {  // a new corner in the middle of another edge
      const LocalPoint a = polygon[m], b = polygon[(m + 1) % n];
      polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(k), {(a.x + b.x) / 2, (a.y + b.y) / 2});
      break;
    }
    case 7:  // no area
      for (LocalPoint& p : polygon) p.y = p.x;
      break;
    default:  // there and back again
      for (std::size_t left = n; left-- > 0;) polygon.push_back(polygon[left]);
      break;
  }
  return polygon;
}

}  // namespace lgs::oracle
