#include "oracle/generate/editor.h"

#include "oracle/calls/shapes.h"
#include "oracle/generate/forms.h"
#include "oracle/reference/vector.h"

#include <fmt/format.h>
#include <lgs/world.h>
#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

namespace lgs::oracle {

// A call has at most one random argument: compilers differ in the order in which they evaluate arguments.

Editor::Editor(Trace start, EditHabits habits, Random random)
    : trace_(std::move(start)), habits_(std::move(habits)), random_(random) {
  for (const Call& call : trace_.calls) model_.play(call);
  start_ = model_.standing();
  at_ = random_.pick(habits_.cells);
}

void Editor::operate() {
  constexpr std::int32_t kSteps[] = {kUnitsPerCell / 4, kUnitsPerCell / 4, kUnitsPerCell / 8, 1};
  step_ = std::max(kSteps[random_.below(4)], kUnitsPerCell / habits_.can.lattice);
  const Operation operation = pickOperation();
  const std::size_t first = trace_.calls.size();
  const Cell cell = pickCell();
  if (!model_.isLoaded(cell) && random_.chance(40)) bringBack(cell);
  look(cell);
  const bool goesOnThere = operation == &Editor::stroke || operation == &Editor::remove;
  if (brushed_.contains(cell) && !goesOnThere && random_.chance(20)) empty(cell);
  (this->*operation)(cell);
  // An operation may come to nothing; a commit of nothing is worth a try now and then.
  const bool isLast = !op_.empty() || first != trace_.calls.size();
  const bool pending = isLast || (!trace_.calls.empty() && trace_.calls.back().kind != Call::Kind::commit);
  if (random_.chance(pending ? habits_.commitPercent : 2)) op_.push_back(Call::commit());
  makeEdits();
}

// What stands from this cell on, as far as a rectangle reaches.
void Editor::look(Cell cell) {
  std::set<Cell> cells;
  for (std::int32_t k = 0; k < 9; ++k) cells.insert({cell.i + k % 3, cell.j + k / 3});
  near_ = model_.standing().part(cells);
}

void Editor::makeEdits() {
  if (habits_.forms) {
    makeInForms(op_, model_, random_, [this](Call call) { push(std::move(call)); });
  } else {
    for (Call& call : op_) make(std::move(call));
  }
  op_.clear();
  gone_.clear();
}

void Editor::run(std::size_t edits) {
  while (edits_ < edits) operate();
  for (; edits_ > edits; trace_.calls.pop_back()) {  // the last operation may have made more
    if (trace_.calls.back().kind != Call::Kind::commit) --edits_;
  }
  push(Call::commit());
}

Editor::Operation Editor::pickOperation() {
  const std::pair<int, Operation> weighted[] = {
      {habits_.place, &Editor::place},     {habits_.fill, &Editor::fill},       {habits_.lean, &Editor::lean},
      {habits_.scatter, &Editor::scatter}, {habits_.restore, &Editor::restore}, {habits_.remove, &Editor::remove},
      {habits_.clear, &Editor::clear},     {habits_.replace, &Editor::replace}, {habits_.refused, &Editor::tryRefused},
      {habits_.any, &Editor::any},         {habits_.stroke, &Editor::stroke},   {habits_.travel, &Editor::travel},
      {habits_.memory, &Editor::remember}, {habits_.carry, &Editor::carry},
  };
  int total = 0;
  for (const auto& entry : weighted) total += entry.first;
  int ticket = random_.below(total);
  for (const auto& [weight, operation] : weighted) {
    if (ticket < weight) return operation;
    ticket -= weight;
  }
  return &Editor::place;
}

// What is not in memory can not be edited: it is tried now and then.
Cell Editor::pickCell() {
  for (int attempt = 0; attempt < 3; ++attempt)
    if (const Cell cell = anyCell(); model_.isLoaded(cell)) return cell;
  return anyCell();
}

Cell Editor::anyCell() {
  if (!habits_.wander || random_.chance(3)) return at_ = random_.pick(habits_.cells);
  const Cell next{at_.i + random_.below(3) - 1, at_.j + random_.below(3) - 1};
  if (std::binary_search(habits_.cells.begin(), habits_.cells.end(), next)) at_ = next;
  return at_;
}

void Editor::place(Cell cell) {
  const std::vector<LocalPolygon>& shape = random_.pick(habits_.shapes);
  const int symmetry = habits_.turnShapes ? random_.below(8) : 0;
  const bool all = random_.chance(70);
  const bool oneBlock = random_.chance(60);
  const Block block = random_.pick(habits_.blocks);
  for (const LocalPolygon& polygon : shape) {
    if (!all && random_.chance(50)) continue;
    addIfGood(cell, oneBlock ? block : random_.pick(habits_.blocks), turned(polygon, symmetry));
  }
}

// Clears the cells first, as a rule. If it does not, and polygons are in the way, the whole rectangle must be refused.
void Editor::fill(Cell cell) {
  const std::vector<LocalPolygon>& shape = random_.pick(habits_.shapes);
  const int symmetry = habits_.turnShapes ? random_.below(8) : 0;
  const Block block = random_.pick(habits_.blocks);
  const std::vector<Cell> cells = rectangleAt(cell);
  const bool isRefused = habits_.refused > 0 && random_.chance(20) && habits_.can.several;
  if (!isRefused)
    for (const Cell& at : cells) empty(at);
  for (const Cell& at : cells) {
    for (const LocalPolygon& polygon : shape) edit(Call::add(freshName(), {at, block, turned(polygon, symmetry)}));
  }
}

void Editor::lean(Cell cell) {
  if (near_.in(cell).empty() || !habits_.can.slants || !habits_.can.several) return place(cell);
  const LocalPolygon polygon = random_.pick(near_.in(cell)).vertices;
  const std::size_t k = random_.below(polygon.size());
  const LocalPoint a = polygon[k];
  const LocalPoint b = polygon[(k + 1) % polygon.size()];
  // The edge's lattice points are a + n·(b-a)/pieces; mostly take quarters of it, if there are.
  std::int32_t pieces = std::gcd(b.x - a.x, b.y - a.y);
  if (pieces % 4 == 0 && random_.chance(80)) pieces = 4;
  const auto pointAt = [&](std::int32_t n) {
    return LocalPoint{a.x + (b.x - a.x) / pieces * n, a.y + (b.y - a.y) / pieces * n};
  };
  const Block block = random_.pick(habits_.blocks);
  constexpr int kAttempts = 8;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::int32_t from = 0;
    std::int32_t to = pieces;
    if (random_.chance(50)) {
      from = random_.below(pieces);
      to = from + 1 + random_.below(pieces - from);
    }
    if (addIfGood(cell, block, {pointAt(to), pointAt(from), randomPoint()})) return;
  }
}

void Editor::scatter(Cell cell) {
  const Block block = random_.pick(habits_.blocks);
  addIfGood(cell, block, randomPolygon());
}

void Editor::restore(Cell cell) {
  for (const Standing::Placed& placed : start_.in(cell)) addIfGood(cell, placed.block, placed.vertices);
}

void Editor::remove(Cell cell) {
  if (brushed_.contains(cell)) {
    Call call = Call::of(Call::Kind::remove);
    call.goes = {{.cell = cell, .nth = random_.below(8U)}};
    return make(std::move(call));
  }
  if (!near_.in(cell).empty()) removeNamed(random_.pick(near_.in(cell)).name);
}

void Editor::clear(Cell cell) {
  if (random_.chance(50)) return empty(cell);
  for (const Cell& at : rectangleAt(cell)) empty(at);
}

void Editor::replace(Cell cell) {
  if (near_.in(cell).empty()) return;
  const Standing::Placed old = random_.pick(near_.in(cell));
  removeNamed(old.name);
  if (random_.chance(30)) op_.push_back(Call::commit());
  const Block block = random_.chance(70) ? old.block : random_.pick(habits_.blocks);
  addIfGood(cell, block, old.vertices);
}

// Half of what is spoilt takes the place of the polygon that it is made of: then nothing but its own fault is wrong
// with it, and an engine that knows only of overlaps accepts it.
void Editor::tryRefused(Cell cell) {
  if (near_.in(cell).empty()) return place(cell);
  const Standing::Placed pattern = random_.pick(near_.in(cell));
  LocalPolygon polygon = pattern.vertices;  // as it is: overlaps itself
  const int kind = random_.below(14);
  if (kind == 0) polygon = {kUnitSquare.begin(), kUnitSquare.end()};  // around what is there
  if (kind == 1) polygon = random_.pick(random_.pick(habits_.shapes));
  const bool isSpoilt = kind > 2;
  if (kind == 10) {  // an edge that folds back
    const std::size_t k = random_.below(polygon.size()), next = (k + 1) % polygon.size();
    const LocalPoint a = polygon[k], b = polygon[next];
    polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(next + 1), {(a.x + b.x) / 2, (a.y + b.y) / 2});
  } else if (kind == 11) {  // any ring at all
    polygon.clear();
    for (int k = 4 + random_.below(9); k > 0; --k) polygon.push_back(randomPoint());
  } else if (kind > 11) {  // one of many corners that is good but for one of these
    polygon = random_.chance(40) ? randomRange() : randomStar();
    const std::size_t k = random_.below(polygon.size());
    polygon[k] = random_.chance(50) ? randomPoint() : random_.pick(polygon);
  } else if (isSpoilt) {
    polygon = spoilt(random_, std::move(polygon));
  }
  const Block block = random_.pick(habits_.blocks);
  if (isSpoilt && random_.chance(50)) removeNamed(pattern.name);
  Call add = Call::add(freshName(), {cell, block, std::move(polygon)});
  if (isFit(add)) edit(std::move(add));
}

// The cells of a rectangle, nine at most, as far as they are the editor's.
std::vector<Cell> Editor::rectangleAt(Cell cell) {
  const std::int32_t width = 1 + random_.below(3);
  const std::int32_t height = 1 + random_.below(3);
  std::vector<Cell> cells;
  for (std::int32_t j = 0; j < height; ++j) {
    for (std::int32_t i = 0; i < width; ++i) {
      const Cell at{cell.i + i, cell.j + j};
      if (std::binary_search(habits_.cells.begin(), habits_.cells.end(), at)) cells.push_back(at);
    }
  }
  return cells;
}

void Editor::empty(Cell cell) {
  if (model_.isLoaded(cell) && brushed_.erase(cell) != 0) {
    Call call = Call::of(Call::Kind::clear);
    call.cells = {cell, cell};
    make(std::move(call));
    while (!near_.in(cell).empty()) near_.remove(std::string(near_.in(cell).back().name));
  }
  while (!near_.in(cell).empty()) removeNamed(near_.in(cell).back().name);
}

// Whether the engine can have it. An engine of one polygon a cell may be asked for a second one that it must refuse.
bool Editor::isFit(const Call& add) const {
  if (!whyNot(add.polygon(), habits_.can).empty()) return false;
  const Coming& coming = add.comes[0];
  return habits_.can.several || near_.in(coming.cell).empty() || faultOf(coming.shape) ||
         near_.refusalIn(coming.cell, coming.shape);
}

bool Editor::isAlive(const std::string& name) const {
  return near_.isAlive(name) || (model_.isAlive(name) && !gone_.contains(name));
}

bool Editor::addIfGood(Cell cell, Block block, LocalPolygon vertices) {
  if (faultOf(vertices) || near_.refusalIn(cell, {&vertices, 1})) return false;
  Call add = Call::add(freshName(), {cell, block, std::move(vertices)});
  if (!isFit(add)) return false;
  edit(std::move(add));
  return true;
}

void Editor::removeNamed(std::string name) {
  lastRemoved_ = name.starts_with('#') ? "" : name;
  edit(Call::remove(std::move(name)));
}

void Editor::edit(Call edit) {
  if (edit.kind == Call::Kind::remove) {
    near_.remove(edit.name());
    gone_.insert(edit.name());
  } else {
    const ScenePolygon polygon = edit.polygon();
    const bool isGood =
        !isAlive(edit.name()) && !faultOf(polygon.vertices) && !near_.refusalIn(polygon.cell, {&polygon.vertices, 1});
    if (isGood) near_.add(edit.name(), polygon);
  }
  op_.push_back(std::move(edit));
}

void Editor::make(Call call) {
  call = withoutFreshNames(std::move(call), model_);
  model_.play(call);
  push(std::move(call));
}

void Editor::push(Call call) {
  if (call.kind != Call::Kind::commit) ++edits_;
  trace_.calls.push_back(std::move(call));
}

std::string Editor::freshName() {
  if (!lastRemoved_.empty() && !isAlive(lastRemoved_) && random_.chance(20)) return lastRemoved_;
  std::string name;
  do name = fmt::format("p{}", ++names_);
  while (isAlive(name));
  return name;
}

LocalPoint Editor::randomPoint() {
  const std::int32_t lines = kUnitsPerCell / step_ + 1;
  return {random_.below(lines) * step_, random_.below(lines) * step_};
}

LocalPolygon Editor::randomBox() {
  const LocalPoint a = randomPoint(), b = randomPoint();
  const auto [left, right] = std::minmax(a.x, b.x);
  const auto [floor, top] = std::minmax(a.y, b.y);
  return {{left, floor}, {right, floor}, {right, top}, {left, top}};
}

// On the floor, with a top of many corners.
LocalPolygon Editor::randomRange() {
  LocalPolygon polygon{{0, 0}, {kUnitsPerCell, 0}};
  std::set<std::int32_t, std::greater<>> across;
  for (int k = 8 + random_.below(50); k > 0; --k) across.insert(randomPoint().x);
  for (const std::int32_t x : across)
    if (const std::int32_t y = randomPoint().y; y > 0) polygon.push_back({x, y});
  return turned(polygon, random_.below(8));
}

// Around the middle, with many corners: edges begin and end in all directions.
LocalPolygon Editor::randomStar() {
  const std::int32_t step = kUnitsPerCell / habits_.can.lattice, lines = habits_.can.lattice + 1;
  LocalPolygon polygon;
  for (int k = 18 + random_.below(30); k > 0; --k) {
    const std::int32_t x = random_.below(lines) * step;
    polygon.push_back({x, random_.below(lines) * step});
  }
  const auto fromMiddle = [](LocalPoint p) { return Vector{p.x - kUnitsPerCell / 2, p.y - kUnitsPerCell / 2}; };
  std::ranges::sort(polygon, [&](LocalPoint a, LocalPoint b) {
    const Vector u = fromMiddle(a), v = fromMiddle(b);
    const auto isLower = [](Vector w) { return w.y < 0 || (w.y == 0 && w.x < 0); };
    return isLower(u) != isLower(v) ? isLower(v) : cross(u, v) > 0 || (cross(u, v) == 0 && dot(u, u) < dot(v, v));
  });
  return polygon;
}

LocalPolygon Editor::randomPolygon() {
  if (!habits_.can.slants) return randomBox();
  if (random_.chance(15))
    if (LocalPolygon many = random_.chance(60) ? randomRange() : randomStar(); !faultOf(many)) return many;
  LocalPolygon polygon{randomPoint(), randomPoint(), randomPoint()};
  if (faultOf(polygon) == ErrorCode::clockwise) std::swap(polygon[0], polygon[1]);
  for (int more = random_.below(8); more > 0; --more) {
    LocalPolygon larger = polygon;
    const auto at = static_cast<std::ptrdiff_t>(random_.below(larger.size()));
    larger.insert(larger.begin() + at, randomPoint());
    if (!faultOf(larger)) polygon = std::move(larger);
  }
  return polygon;
}

}  // namespace lgs::oracle
