// What an editor does with chunks that leave memory, and come back.
#include "oracle/generate/editor.h"

#include <lgs/world.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

// The chunks that a case can reach, and more.
CellRect chunksAround(Cell cell) {
  const auto inside = [](std::int32_t k) { return std::clamp(k, -kMaxCell, kMaxCell); };
  return {{inside((cell.i & ~31) - 64), inside((cell.j & ~31) - 64)},
          {inside((cell.i & ~31) + 95), inside((cell.j & ~31) + 95)}};
}

}  // namespace

void Editor::bringBack(Cell cell) {
  Call call = Call::of(Call::Kind::reload);
  call.cells.min = call.cells.max = Model::cellsOfChunk(Model::chunkOf(cell)).min;
  make(std::move(call));
}

// Of a world with unloaded chunks none is saved.
void Editor::allComesBack(Cell cell) {
  if (model_.isWhole()) return;
  Call call = Call::of(Call::Kind::reload);
  call.cells = chunksAround(cell);
  make(std::move(call));
}

// Chunks come or go, around a cell.
void Editor::turn(Call::Kind kind, Cell cell) {
  Call call = Call::of(kind);
  if (kind == Call::Kind::reload) cell = random_.pick(habits_.cells);
  const std::int32_t wide = 32 * random_.below(2), high = 32 * random_.below(2);
  const auto inside = [](std::int32_t k) { return std::clamp(k, -kMaxCell, kMaxCell); };
  call.cells = {{inside(cell.i & ~31), inside(cell.j & ~31)},
                {inside((cell.i & ~31) + 31 + wide), inside((cell.j & ~31) + 31 + high)}};
  if (random_.chance(20)) {
    call.cells = {{inside(call.cells.min.i - 64), inside(call.cells.min.j - 64)},
                  {inside(call.cells.max.i + 64), inside(call.cells.max.j + 64)}};
  }
  if (random_.chance(5)) ++call.cells.min.i;  // not all of them
  call.nth = random_.below(2U);
  make(tidied(std::move(call)));
}

// A row of squares across the border of two chunks, or two rows that touch there with a corner. One of the chunks leaves;
// the row is cut beside it, and the chunk may come back.
void Editor::cutAtTheEdge(Cell cell) {
  const bool isUpright = random_.chance(50), isBent = random_.chance(40), isBefore = random_.chance(50);
  const Cell corner = Model::cellsOfChunk(Model::chunkOf(cell)).min;
  const auto at = [&](std::int32_t along) {
    const std::int32_t across = isBent && along >= 0 ? 1 : 0;
    return isUpright ? Cell{cell.i + across, corner.j + along} : Cell{corner.i + along, cell.j + across};
  };
  const auto clearAt = [&](Cell there) {
    Call gone = Call::of(Call::Kind::clear);
    gone.cells = {there, there};
    make(std::move(gone));
  };
  const auto commits = [&] {
    if (random_.chance(80)) make(Call::commit());
  };
  for (std::int32_t k = -3; k < 3; ++k) {
    if (!inRange(at(k))) continue;
    clearAt(at(k));
    make(squareAt(at(k)));
  }
  make(Call::commit());
  Call leaves = Call::of(Call::Kind::unload);
  leaves.cells = Model::cellsOfChunk(Model::chunkOf(at(isBefore ? -1 : 0)));
  leaves.cells.max = {std::min(leaves.cells.max.i, kMaxCell), std::min(leaves.cells.max.j, kMaxCell)};
  make(leaves);
  commits();
  if (random_.chance(70)) {
    const Cell beside = at(isBefore ? random_.below(2) : -1 - random_.below(2));
    if (inRange(beside)) clearAt(beside);
    commits();
  }
  if (random_.chance(60)) return;
  leaves.kind = Call::Kind::reload;
  make(std::move(leaves));
  commits();
}

void Editor::remember(Cell cell) {
  using enum Call::Kind;
  const auto commits = [&] {
    if (random_.chance(60)) make(Call::commit());
  };
  const auto forgetMarks = [&] {  // while there are some nothing is forgotten
    while (model_.hasMarks() && random_.chance(95)) make(Call::of(forget));
  };
  const auto edit = [&] {
    Call gone = Call::of(clear);
    gone.cells = {cell, cell};
    make(random_.chance(50) ? std::move(gone) : squareAt(cell));
  };
  const auto rollBackToLast = [&] {
    Call back = Call::of(rollBack);
    back.nth = static_cast<std::uint32_t>(model_.marks()) - 1;
    make(std::move(back));
  };
  switch (random_.below(16)) {
    case 0:
    case 1:
      return turn(unload, cell);
    case 2:
    case 3:
      return turn(reload, cell);
    case 4:
    case 5: {  // given up: it comes back empty, is edited, leaves and comes back again
      const bool isMarked = random_.chance(40);
      if (isMarked) make(Call::of(mark));
      if (random_.chance(40)) edit();
      if (random_.chance(60)) turn(unload, cell);
      if (random_.chance(30)) make(Call::commit());
      turn(reloadEmpty, cell);
      if (random_.chance(40)) {
        if (!isMarked) make(Call::of(mark));
        rollBackToLast();
      }
      if (random_.chance(60)) make(squareAt(cell));
      commits();
      if (random_.chance(60)) return;
      turn(unload, cell);
      commits();
      return turn(reload, cell);
    }
    case 6: {  // an empty chunk goes, and another one gets its number
      forgetMarks();
      Call gone = Call::of(clear);
      gone.cells = Model::cellsOfChunk(Model::chunkOf(cell));
      gone.cells = {{std::max(gone.cells.min.i, -kMaxCell), std::max(gone.cells.min.j, -kMaxCell)},
                    {std::min(gone.cells.max.i, kMaxCell), std::min(gone.cells.max.j, kMaxCell)}};
      if (random_.chance(50)) make(std::move(gone));
      commits();
      turn(leave, cell);
      if (random_.chance(40)) {
        allComesBack(cell);
        make(Call::of(load));
      }
      return random_.chance(60) ? make(squareAt(cell)) : void();
    }
    case 7: {  // all of it sleeps, and some of it wakes
      forgetMarks();
      Call all = Call::of(unload);
      all.cells = chunksAround(cell);
      make(all);
      make(Call::commit());
      if (random_.chance(80)) turn(reload, cell);
      return random_.chance(50) ? turn(reload, cell) : void();
    }
    case 8:
    case 9: {  // so much comes and goes that a cell needs a list
      Call call = Call::of(repeat), gone = Call::of(clear);
      gone.cells = {cell, cell};
      call.nth = 250U + random_.below(16U);
      call.group = {squareAt(cell), gone};
      if (near_.in(cell).empty()) make(std::move(call));
      return;
    }
    case 10: {  // a cell of many polygons leaves, and comes back
      constexpr std::int32_t kSide = kUnitsPerCell / 4;
      Call many = Call::of(addShape);
      many.comes = {{.cell = cell, .block = random_.pick(habits_.blocks)}};
      for (std::int32_t k = 0; k < 16; ++k) {
        const std::int32_t x = k % 4 * kSide, y = k / 4 * kSide;
        many.comes[0].shape.push_back({{x, y}, {x + kSide, y}, {x + kSide, y + kSide}, {x, y + kSide}});
      }
      if (near_.in(cell).empty()) make(std::move(many));
      turn(unload, cell);
      commits();
      return turn(reload, cell);
    }
    case 11: {  // ground around a chunk that leaves
      const CellRect chunk = Model::cellsOfChunk(Model::chunkOf(cell));
      const auto [left, floor] = Cell{chunk.min.i - 1, chunk.min.j - 1};
      const auto [right, top] = Cell{chunk.max.i + 1, chunk.max.j + 1};
      if (!random_.chance(30) || !inRange(Cell{left, floor}) || !inRange(Cell{right, top})) return turn(unload, cell);
      for (const CellRect& side :
           {CellRect{{left, floor}, {right, floor}}, CellRect{{left, top}, {right, top}},
            CellRect{{left, floor + 1}, {left, top - 1}}, CellRect{{right, floor + 1}, {right, top - 1}}}) {
        Call gone = Call::of(clear), come = squareAt(side.min);
        gone.cells = come.cells = side;
        come.kind = fill;
        make(std::move(gone));
        make(tidied(std::move(come)));
      }
      if (random_.chance(60)) make(squareAt({left + 1, random_.between(floor + 1, top - 1)}));
      make(Call::commit());
      Call leaves = Call::of(unload);
      leaves.cells = chunk;
      make(std::move(leaves));
      return commits();
    }
    case 12: {  // what was undone leaves memory with its chunk, and comes back
      const Cell corner = Model::cellsOfChunk(Model::chunkOf(cell)).min;
      const std::int32_t i = random_.between(0, 31), j = random_.between(0, 31);
      const Cell inside{corner.i + i, corner.j + j};
      if (!inRange(inside)) return turn(unload, cell);
      if (random_.chance(50)) make(squareAt(inside));
      make(Call::of(mark));
      Call gone = Call::of(clear);
      gone.cells = {inside, inside};
      make(near_.in(inside).empty() && random_.chance(50) ? squareAt(inside) : std::move(gone));
      if (random_.chance(50)) edit();
      commits();
      Call back = Call::of(rollBack);
      back.nth = static_cast<std::uint32_t>(model_.marks()) - 1;
      back.keeps = Call::Keeps::always;
      make(std::move(back));
      turn(unload, inside);
      if (random_.chance(30)) commits();
      if (random_.chance(30)) turn(reload, inside);
      make(Call::of(redo));
      commits();
      return random_.chance(70) ? allComesBack(cell) : void();
    }
    case 13:
      return cutAtTheEdge(cell);
    default:                     // leaves a place, and what was unloaded there
      if (random_.chance(40)) {  // of which the bytes do not say what was undone since
        make(Call::of(mark));
        edit();
        turn(unload, cell);
        rollBackToLast();
      }
      forgetMarks();
      turn(unload, cell);
      make(Call::commit());
      turn(leave, cell);
      return random_.chance(50) ? turn(reload, cell) : void();
  }
}

}  // namespace lgs::oracle
