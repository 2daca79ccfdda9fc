#include "oracle/trace/row.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>
#include <string_view>

namespace lgs::oracle {
namespace {

using Kind = Call::Kind;

bool isRemove(const Edit& edit) { return edit.kind == Edit::Kind::remove; }

std::span<const Edit> removesOf(std::span<const Edit> edits) {
  return {edits.begin(), std::ranges::find_if_not(edits, isRemove)};
}

bool areNamesGood(std::span<const Edit> removes, std::span<const Edit> adds, const Model& model) {
  std::set<std::string_view> gone, come;
  for (const Edit& edit : removes)
    if (!model.isAlive(edit.name) || !gone.insert(edit.name).second) return false;
  return std::ranges::all_of(adds, [&](const Edit& edit) {
    const bool isFree = !model.isAlive(edit.name) || gone.contains(edit.name);
    return isFree && come.insert(edit.name).second;
  });
}

CellRect boxOf(const std::vector<Cell>& cells) {
  CellRect box{cells[0], cells[0]};
  for (const Cell cell : cells) {
    box.min = {std::min(box.min.i, cell.i), std::min(box.min.j, cell.j)};
    box.max = {std::max(box.max.i, cell.i), std::max(box.max.j, cell.j)};
  }
  return box;
}

// Makes a rectangle larger where that adds no polygons to it.
CellRect widened(CellRect cells, std::uint32_t number, const Model& model) {
  constexpr std::array<std::int32_t, 4> kCells{0, 0, 1, 40};
  for (unsigned side = 0; side < 4; ++side) {
    CellRect larger = cells;
    const std::int32_t by = kCells[bitsOf(number, 2 * side, 2)];
    if (side == 0) larger.min.i -= by;
    if (side == 1) larger.min.j -= by;
    if (side == 2) larger.max.i += by;
    if (side == 3) larger.max.j += by;
    if (inRange(larger.min) && inRange(larger.max) && model.polygonsIn(larger) == model.polygonsIn(cells))
      cells = larger;
  }
  return cells;
}

// The rectangle whose cells get the same polygons each, if these adds are that.
std::optional<CellRect> rectangleOf(std::span<const Edit> adds, const std::vector<Cell>& cells, std::size_t inCell) {
  if (adds.size() % inCell != 0) return std::nullopt;
  std::set<Cell> seen;
  for (std::size_t k = 0; k < adds.size(); ++k) {
    if (cells[k] != cells[k - k % inCell] || adds[k].polygon.vertices != adds[k % inCell].polygon.vertices)
      return std::nullopt;
    if (k % inCell == 0 && !seen.insert(cells[k]).second) return std::nullopt;
  }
  const CellRect box = boxOf(cells);
  const auto length = [](std::int32_t min, std::int32_t max) { return std::int64_t{max} - min + 1; };
  const auto area = static_cast<std::uint64_t>(length(box.min.i, box.max.i) * length(box.min.j, box.max.j));
  return area == seen.size() ? std::optional(box) : std::nullopt;
}

Notation notationOf(Door door, std::uint32_t number) {
  switch (door) {
    case Door::list:
      return Notation::list;
    case Door::floats:
      return Notation::floats;
    case Door::doubles:
      return Notation::doubles;
    case Door::points:
      return Notation::lattice;
    default:
      return static_cast<Notation>(bitsOf(number, 2, 2));
  }
}

// Makes the call of a row whose cells and names are known; false if its door can not make all of it.
bool makeCall(Row& row, const Model& model) {
  const auto removes = removesOf(row.edits), adds = row.edits.subspan(removes.size());
  Call& call = row.call;
  const Door door = row.way.door;
  const std::uint32_t number = row.way.number;
  const auto isHere = [&](Cell cell) { return cell == row.cells[0]; };
  const auto isOfBlock = [&](const Edit& edit) { return edit.polygon.block == adds.front().polygon.block; };
  const bool isOneCell = std::ranges::all_of(row.cells, isHere), isOneBlock = std::ranges::all_of(adds, isOfBlock);
  const bool addsOnly = removes.empty(), removesOnly = adds.empty();
  call.notation = notationOf(door, number);
  call.offset = bitsOf(number, 4, 2);
  for (const Edit& edit : removes) call.goes.push_back({Named::How::handle, {}, 0, model.handleOf(edit.name)});
  // As one shape, or one by one.
  const auto comeTogether = [&](std::size_t count) {
    call.comes = {{row.cells[0], {}, adds.front().polygon.block}};
    for (const Edit& edit : adds.first(count)) call.comes[0].shape.push_back(edit.polygon.vertices);
  };
  const auto comeEach = [&] {
    for (const Edit& edit : adds)
      call.comes.push_back({edit.polygon.cell, {edit.polygon.vertices}, edit.polygon.block});
  };
  switch (door) {
    case Door::points:
    case Door::list:
    case Door::floats:
    case Door::doubles:
      call.kind = Kind::add;
      comeEach();
      return addsOnly && adds.size() == 1;
    case Door::shape:
    case Door::handles:
    case Door::several:
      if (!addsOnly || !isOneCell || !isOneBlock) return false;
      call.kind = Kind::addShape;
      call.room = door == Door::handles   ? 1 + bitsOf(number, 0, 2) % 3
                  : door == Door::several ? bitsOf(number, 0, 2)
                                          : 0;
      comeTogether(adds.size());
      return true;
    case Door::replace:
      if (removesOnly || !isOneCell || !isOneBlock || removes.size() != model.in(row.cells[0]).size()) return false;
      call.kind = Kind::replace;
      call.room = bitsOf(number, 0, 2);
      call.goes.clear();
      comeTogether(adds.size());
      return true;
    case Door::many:
      call.kind = Kind::addMany;
      call.room = bitsOf(number, 0, 2);
      comeEach();
      return addsOnly;
    case Door::exchange:
      call.kind = Kind::exchange;
      call.room = bitsOf(number, 0, 2);
      call.notation = Notation::lattice;
      call.cells = {row.cells[0], row.cells[0]};
      comeEach();
      return isOneCell;
    case Door::fill: {
      if (!addsOnly || !isOneBlock) return false;
      const auto inCell = static_cast<std::size_t>(std::ranges::find_if_not(row.cells, isHere) - row.cells.begin());
      const auto cells = rectangleOf(adds, row.cells, inCell);
      if (!cells) return false;
      call.kind = Kind::fill;
      call.cells = *cells;
      comeTogether(inCell);
      return true;
    }
    case Door::remove:
      call.kind = Kind::remove;
      return removesOnly && removes.size() == 1;
    case Door::removeMany:
      call.kind = Kind::removeMany;
      return removesOnly;
    case Door::clear:
      if (!removesOnly || model.polygonsIn(boxOf(row.cells)) != removes.size()) return false;
      call.kind = Kind::clear;
      call.cells = widened(boxOf(row.cells), number, model);
      call.goes.clear();
      return true;
    case Door::setBlock: {
      if (removes.size() != 1 || adds.size() != 1 || !isOneCell) return false;
      call.kind = Kind::setBlock;
      call.comes = {{row.cells[0], {}, adds[0].polygon.block}};
      return model[removes[0].name].vertices == adds[0].polygon.vertices;
    }
    case Door::brush:
    case Door::commit:
      break;
  }
  return false;
}

// The edits as one call, if they are fit for that.
std::optional<Row> together(std::span<const Edit> edits, Way way, const CallModel& standing) {
  const Model& model = standing.standing();
  const auto removes = removesOf(edits), adds = edits.subspan(removes.size());
  if (std::ranges::any_of(adds, [](const Edit& edit) { return edit.kind != Edit::Kind::add; })) return std::nullopt;
  if (!areNamesGood(removes, adds, model)) return std::nullopt;
  Row row;
  row.edits = edits;
  row.way = way;
  for (const Edit& edit : edits) row.cells.push_back(isRemove(edit) ? model.cellOf(edit.name) : edit.polygon.cell);
  if (!makeCall(row, model)) return std::nullopt;
  std::vector<const Edit*> come;
  for (const Edit& edit : adds) come.push_back(&edit);
  const auto placeOf = [](const Edit* edit) { return std::pair(edit->polygon.cell.j, edit->polygon.cell.i); };
  if (way.door == Door::fill) std::ranges::stable_sort(come, {}, placeOf);  // as the call goes over its cells
  for (const Edit* edit : come) row.names.push_back(edit->name);
  row.verdict = standing.judge(row.call);
  return row;
}

}  // namespace

std::string inWords(const Row& row) {
  std::string text = fmt::format("{} of '{}'", describe(row.way.door), row.edits.front().name);
  if (row.edits.size() > 1) text += fmt::format(" to '{}'", row.edits.back().name);
  return text;
}

Row rowOf(const Edit& edit, const CallModel& standing) {
  const std::span<const Edit> alone{&edit, 1};
  Way plain = edit.way;
  plain.door = Edit::plainWay(edit.kind).door;
  if (edit.kind == Edit::Kind::add || isRemove(edit)) {
    if (auto row = together(alone, edit.way, standing)) return *row;
    if (auto row = together(alone, plain, standing)) return *row;
  }
  Row row;
  row.edits = alone;
  row.way = plain;
  row.verdict = standing.standing().judge(edit);
  return row;
}

std::optional<Row> Rows::next(const CallModel& standing) {
  if (at_ == edits_.size()) return std::nullopt;
  const std::size_t begin = at_;
  const Edit& first = edits_[begin];
  std::size_t end = begin + 1;
  if (begin >= oneByOne_)
    while (end < edits_.size() && edits_[end].way.joins && edits_[end].way.door == first.way.door) ++end;
  std::optional<Row> row;
  if (end - begin > 1) row = together(edits_.subspan(begin, end - begin), first.way, standing);
  if (!row || !row->verdict.accepted) oneByOne_ = std::max(oneByOne_, end);
  if (!row) row = rowOf(first, standing);
  row->end = begin + row->edits.size();
  row->isTrial = row->edits.size() > 1 && !row->verdict.accepted;
  if (!row->isTrial) at_ = row->end;
  return row;
}

}  // namespace lgs::oracle
