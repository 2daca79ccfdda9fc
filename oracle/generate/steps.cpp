#include "oracle/generate/steps.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace lgs::oracle {
namespace {

constexpr std::size_t kLongest = 300;  // edits of one call: enough to fill a cell

// What a name decides here, in bits of chanceOf(); all 0 is the plain way. The lowest three are doorOf()'s, the upper
// half is the player's.
bool wantsTogether(std::uint64_t chance) { return bitsOf(chance, 3, 2) != 0; }
bool wantsClear(std::uint64_t chance) { return bitsOf(chance, 3, 1) != 0; }
bool wantsFillFirst(std::uint64_t chance) { return bitsOf(chance, 5, 1) != 0; }
std::size_t mostInShape(std::uint64_t chance) {
  constexpr std::array<std::size_t, 4> kMost{3, kLongest, kLongest, kLongest};
  return kMost[bitsOf(chance, 6, 2)];
}
std::int32_t wider(std::uint64_t chance, unsigned side) {
  constexpr std::array<std::int32_t, 4> kCells{0, 0, 1, 40};
  return kCells[bitsOf(chance, 8 + 2 * side, 2)];
}
bool wantsWear(std::uint64_t chance) { return bitsOf(chance, 16, 6) == 63; }
unsigned howWorn(std::uint64_t chance) { return 250 + bitsOf(chance, 22, 4); }
bool wantsReplace(std::uint64_t chance) { return bitsOf(chance, 26, 1) != 0; }
bool wantsSetBlock(std::uint64_t chance) { return bitsOf(chance, 27, 1) != 0; }

void include(CellRect& box, Cell cell) {
  box.min = {std::min(box.min.i, cell.i), std::min(box.min.j, cell.j)};
  box.max = {std::max(box.max.i, cell.i), std::max(box.max.j, cell.j)};
}

std::uint64_t areaOf(const CellRect& box) {
  const auto length = [](std::int32_t min, std::int32_t max) {
    return static_cast<std::uint64_t>(std::int64_t{max} - min + 1);
  };
  return length(box.min.i, box.max.i) * length(box.min.j, box.max.j);
}

bool isByShape(Door door) {
  return door == Door::shape || door == Door::handles || door == Door::several || door == Door::fill ||
         door == Door::replace;
}

std::vector<LocalPolygon> shapeOf(const Step& step) {
  std::vector<LocalPolygon> shape;
  for (const Edit& edit : step.edits.first(step.inCell)) shape.push_back(edit.polygon.vertices);
  return shape;
}

}  // namespace

std::optional<Step> Steps::next() {
  if (at_ == edits_.size()) return std::nullopt;
  switch (edits_[at_].kind) {
    case Edit::Kind::add:
      return addition();
    case Edit::Kind::remove:
      return removal();
    case Edit::Kind::brush: {
      Step step = take(1, Door::brush);
      step.verdict = model_.judge(step.edits.front());
      return step;
    }
    case Edit::Kind::commit:
      break;
  }
  return take(1, Door{});
}

void Steps::brushed(std::span<const Edit> edits) {
  for (const Edit& edit : edits) make(edit);
}

void Steps::make(const Edit& edit) {
  edited_.insert(edit.kind == Edit::Kind::add ? edit.polygon.cell : model_.cellOf(edit.name));
  model_.apply(edit);
}

Step Steps::take(std::size_t count, Door door) {
  Step step;
  step.door = door;
  step.edits = edits_.subspan(at_, count);
  step.chance = chanceOf(step.edits.front().name);
  at_ += count;
  step.end = at_;
  return step;
}

Step Steps::addition() {
  const Edit& edit = edits_[at_];
  const std::uint64_t chance = chanceOf(edit.name);
  if (at_ >= oneByOne_ && wantsTogether(chance)) {
    const bool fillFirst = wantsFillFirst(chance);
    for (const Door door : {fillFirst ? Door::fill : Door::several, fillFirst ? Door::several : Door::fill})
      if (auto step = together(door)) return *step;
  }
  Step step = take(1, orReplace(doorOf(edit)));
  step.cells = {edit.polygon.cell, edit.polygon.cell};
  step.verdict = model_.judge(edit);
  if (step.verdict.accepted) {
    wear(step);
    make(edit);
  } else if (step.verdict.code) {
    step.verdict = judgeTrial(step);
  }
  return step;
}

Step Steps::removal() {
  const Edit& edit = edits_[at_];
  const Verdict verdict = model_.judge(edit);
  if (verdict.accepted) {
    if (auto step = setBlock()) return *step;
    if (auto step = replacement()) return *step;
  }
  CellRect cells;
  const bool clears = verdict.accepted && wantsClear(chanceOf(edit.name));
  const std::size_t count = clears ? emptying(cells) : 0;
  Step step = take(std::max<std::size_t>(count, 1), count > 0 ? Door::clear : Door::remove);
  step.verdict = verdict;
  if (!verdict.accepted) return step;
  for (const Edit& gone : step.edits) make(gone);
  step.cells = cells;
  if (count > 0) widen(step.cells, step.chance);
  return step;
}

// What an empty cell gets may as well replace what is there.
Door Steps::orReplace(Door door) const {
  const Edit& edit = edits_[at_];
  const bool isPossible = isByShape(door) && door != Door::fill && model_.in(edit.polygon.cell).empty();
  return isPossible && wantsReplace(chanceOf(edit.name)) ? Door::replace : door;
}

// Takes a remove, and an add of the same polygon.
std::optional<Step> Steps::setBlock() {
  const Edit& old = edits_[at_];
  if (!wantsSetBlock(chanceOf(old.name)) || at_ + 1 == edits_.size()) return std::nullopt;
  const Edit& next = edits_[at_ + 1];
  if (next.kind != Edit::Kind::add || next.polygon.cell != model_.cellOf(old.name)) return std::nullopt;
  if (next.name != old.name && model_.isAlive(next.name)) return std::nullopt;
  const auto& there = model_.in(next.polygon.cell);
  const auto placed = std::ranges::find(there, old.name, &Model::Placed::name);
  if (placed->vertices != next.polygon.vertices) return std::nullopt;
  return taken(2, Door::setBlock);
}

// Takes the removes of all that a cell holds, and the adds of one block to it.
std::optional<Step> Steps::replacement() {
  if (!wantsReplace(chanceOf(edits_[at_].name))) return std::nullopt;
  const Cell cell = model_.cellOf(edits_[at_].name);
  const std::span<const Edit> all = edits_.subspan(at_, std::min(kLongest, edits_.size() - at_));
  std::set<std::string_view> gone, names;
  for (const Edit& edit : all) {
    if (edit.kind != Edit::Kind::remove || !model_.isAlive(edit.name) || model_.cellOf(edit.name) != cell) break;
    if (!gone.insert(edit.name).second) break;
  }
  if (gone.size() != model_.in(cell).size()) return std::nullopt;
  std::vector<LocalPolygon> shape;
  for (const Edit& edit : all.subspan(gone.size())) {
    const bool goesOn = edit.kind == Edit::Kind::add && edit.polygon.cell == cell &&
                        edit.polygon.block == all[gone.size()].polygon.block &&
                        (gone.contains(edit.name) || !model_.isAlive(edit.name)) && names.insert(edit.name).second;
    if (!goesOn) break;
    shape.push_back(edit.polygon.vertices);
  }
  if (shape.empty() || faultOf(shape)) return std::nullopt;
  Step step = taken(gone.size() + shape.size(), Door::replace);
  step.inCell = shape.size();
  return step;
}

// Takes the next edits, all of them good, and makes them in the model.
Step Steps::taken(std::size_t count, Door door) {
  Step step = take(count, door);
  for (const Edit& edit : step.edits) make(edit);
  return step;
}

// Takes as many of the next adds as one call can make; it may have to be refused. Nothing if only one add fits.
std::optional<Step> Steps::together(Door door) {
  const Edit& first = edits_[at_];
  CellRect cells{first.polygon.cell, first.polygon.cell};
  std::size_t inCell = inOneCell();
  std::size_t count = inCell;
  if (door == Door::fill) {
    count = inRectangle(inCell, cells);
    if (count == inCell) return std::nullopt;
  } else {
    count = inCell = std::min(inCell, mostInShape(chanceOf(first.name)));
    if (count < 2) return std::nullopt;
  }
  Step step = take(count, orReplace(door));
  step.cells = cells;
  step.inCell = inCell;
  wear(step);
  if (makes(step)) return step;
  step.worn = 0;
  step.isTrial = true;
  step.verdict = judgeTrial(step);
  at_ -= count;
  oneByOne_ = step.end;
  return step;
}

// How many adds from the next one on are to its cell, and of its block.
std::size_t Steps::inOneCell() const {
  const ScenePolygon& first = edits_[at_].polygon;
  std::set<std::string_view> names;
  std::size_t count = 0;
  for (const Edit& edit : edits_.subspan(at_, std::min(kLongest, edits_.size() - at_))) {
    const bool goesOn = edit.kind == Edit::Kind::add && edit.polygon.cell == first.cell &&
                        edit.polygon.block == first.block && !model_.isAlive(edit.name) &&
                        names.insert(edit.name).second;
    if (!goesOn) break;
    ++count;
  }
  return std::max<std::size_t>(count, 1);
}

// How many adds from the next one on put the same polygons into each cell of a rectangle, which is written to `cells`.
std::size_t Steps::inRectangle(std::size_t inCell, CellRect& cells) const {
  const std::span<const Edit> all = edits_.subspan(at_, std::min(kLongest, edits_.size() - at_));
  std::set<std::string_view> names;
  std::set<Cell> seen;
  CellRect box = cells;
  std::size_t best = inCell;
  for (std::size_t begin = 0; begin + inCell <= all.size(); begin += inCell) {
    const Cell cell = all[begin].polygon.cell;
    for (std::size_t k = 0; k < inCell; ++k) {
      const Edit& edit = all[begin + k];
      const ScenePolygon& like = all[k].polygon;
      const bool goesOn = edit.kind == Edit::Kind::add && edit.polygon.cell == cell &&
                          edit.polygon.block == like.block && edit.polygon.vertices == like.vertices &&
                          !model_.isAlive(edit.name) && names.insert(edit.name).second;
      if (!goesOn) return best;
    }
    if (!seen.insert(cell).second) return best;
    include(box, cell);
    if (areaOf(box) != seen.size()) continue;
    best = begin + inCell;
    cells = box;
  }
  return best;
}

// How many removes from the next one on leave nothing in a rectangle, which is written to `cells`; 0 if none do.
std::size_t Steps::emptying(CellRect& cells) const {
  CellRect box{model_.cellOf(edits_[at_].name), model_.cellOf(edits_[at_].name)};
  std::set<std::string_view> names;
  std::size_t best = 0;
  for (const Edit& edit : edits_.subspan(at_, std::min(kLongest, edits_.size() - at_))) {
    const bool goesOn = edit.kind == Edit::Kind::remove && model_.isAlive(edit.name) && names.insert(edit.name).second;
    if (!goesOn) break;
    include(box, model_.cellOf(edit.name));
    if (model_.polygonsIn(box) != names.size()) continue;
    best = names.size();
    cells = box;
  }
  return best;
}

// Makes all edits of a step in the model, or none if one of them must be refused. Returns whether it made them.
bool Steps::makes(const Step& step) {
  for (std::size_t k = 0; k < step.edits.size(); ++k) {
    if (model_.judge(step.edits[k]).accepted) {
      model_.apply(step.edits[k]);
      continue;
    }
    for (const Edit& edit : step.edits.first(k)) model_.apply(Edit::remove(edit.name));
    return false;
  }
  for (const Edit& edit : step.edits) edited_.insert(edit.polygon.cell);
  return true;
}

// Why a call must be refused, and which cell the refusal must name. A shape is judged first, and names no cell.
Verdict Steps::judgeTrial(const Step& step) const {
  const std::vector<LocalPolygon> shape = shapeOf(step);
  if (!isByShape(step.door)) return model_.judge(step.edits.front());
  if (const auto fault = faultOf(shape)) return {false, fault, Error::kNoCell};
  for (const Cell corner : {step.cells.min, step.cells.max})
    if (!inRange(corner)) return {false, ErrorCode::cellOutOfRange, corner};
  for (std::int32_t j = step.cells.min.j; j <= step.cells.max.j; ++j) {
    for (std::int32_t i = step.cells.min.i; i <= step.cells.max.i; ++i) {
      if (const auto refusal = model_.refusalIn({i, j}, shape)) return {false, refusal, {i, j}};
    }
  }
  return {};
}

// Now and then more polygons come and go in an empty cell than a compact cell can count.
void Steps::wear(Step& step) const {
  const Cell cell = step.edits.front().polygon.cell;
  if (wantsWear(step.chance) && inRange(cell) && model_.in(cell).empty()) step.worn = howWorn(step.chance);
}

// Makes a rectangle larger where that adds no polygons to it.
void Steps::widen(CellRect& cells, std::uint64_t chance) const {
  for (unsigned side = 0; side < 4; ++side) {
    CellRect larger = cells;
    const std::int32_t by = wider(chance, side);
    if (side == 0) larger.min.i -= by;
    if (side == 1) larger.min.j -= by;
    if (side == 2) larger.max.i += by;
    if (side == 3) larger.max.j += by;
    if (inRange(larger.min) && inRange(larger.max) && model_.polygonsIn(larger) == 0) cells = larger;
  }
}

}  // namespace lgs::oracle
