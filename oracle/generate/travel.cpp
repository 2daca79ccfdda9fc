// What an editor does that is no plain edit: any call at all, strokes, moves in time and in memory.
#include "oracle/generate/editor.h"
#include "oracle/trace/plain_edits.h"

#include <lgs/world.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

Call squareAt(Cell cell) {
  Call call = Call::of(Call::Kind::addShape);
  call.comes = {{.cell = cell, .shape = {{kUnitSquare.begin(), kUnitSquare.end()}}, .block = 1}};
  return call;
}

// The chunks that a case can reach, and more.
CellRect chunksAround(Cell cell) {
  const auto inside = [](std::int32_t k) { return std::clamp(k, -kMaxCell, kMaxCell); };
  return {{inside((cell.i & ~31) - 64), inside((cell.j & ~31) - 64)},
          {inside((cell.i & ~31) + 95), inside((cell.j & ~31) + 95)}};
}

}  // namespace

Call Editor::anyEdit(Cell cell) {
  Habits habits{.width = 3, .height = 3, .hostilePercent = habits_.hostilePercent};
  const auto notEdits = habits.weights.begin() + static_cast<std::ptrdiff_t>(Call::Kind::group);
  std::fill(notEdits, habits.weights.end(), 0);
  return tidied(movedBy(drawCall(random_, habits), cell));
}

void Editor::any(Cell cell) { make(anyEdit({cell.i - 1, cell.j - 1})); }

void Editor::stroke(Cell cell) {
  for (Call& call : strokeAt(cell, habits_.strokes, random_)) {
    const CellRect cells = call.kind == Call::Kind::brush ? cellsUnder(call.brush) : call.cells;
    for (const Cell at : habits_.cells)
      if (contains(cells, at)) brushed_.insert(at);
    make(std::move(call));
  }
}

void Editor::bringBack(Cell cell) {
  Call call = Call::of(Call::Kind::reload);
  call.cells.min = call.cells.max = Model::cellsOfChunk(Model::chunkOf(cell)).min;
  make(std::move(call));
}

void Editor::travel(Cell cell) {
  using enum Call::Kind;
  const Cell from{cell.i - 1, cell.j - 1};
  const auto time = [&](Call::Kind kind, std::uint32_t nth = 0, bool keeps = false) {
    Call call = Call::of(kind);
    call.nth = nth;
    call.keeps = keeps ? Call::Keeps::always : Call::Keeps::never;
    make(tidied(std::move(call)));
  };
  const auto someEdits = [&](int most) {
    for (int k = 1 + random_.below(most); k > 0; --k) make(anyEdit(from));
  };
  const std::uint32_t nth = random_.below(8U);
  const bool keeps = random_.chance(60);
  constexpr std::size_t kManyMarks = 6;
  if (model_.marks() > kManyMarks) time(forget, nth);
  switch (random_.below(12)) {
    case 0:
    case 1:
      return model_.hasMarks() && random_.chance(40) ? time(rollBack, nth, keeps) : time(mark);
    case 2:
      return time(redo, nth);
    case 3:
      return time(forget, nth);
    case 4:
      return random_.chance(30) ? time(follow, random_.below(2U)) : time(copy);
    case 5:
      if (random_.chance(60)) allComesBack(cell);
      return time(load);
    case 6:
    case 7: {  // a group
      Call call = Call::of(group);
      call.keeps = static_cast<Call::Keeps>(random_.below(3));
      for (int k = 1 + random_.below(4); k > 0; --k) call.group.push_back(anyEdit(from));
      return make(std::move(call));
    }
    case 8:  // wrong edits, and back at once
    case 9:
      time(mark);
      someEdits(3);
      if (random_.chance(60)) time(commit);
      if (random_.chance(20)) time(mark);
      time(rollBack, static_cast<std::uint32_t>(model_.marks()) - 1, keeps);
      if (keeps && random_.chance(50)) time(redo, nth);
      return random_.chance(70) ? time(forget, nth) : void();
    default:  // undo and redo, step by step
      for (int k = 2 + random_.below(2); k > 0; --k) {
        time(mark);
        someEdits(2);
        if (random_.chance(70)) time(commit);
      }
      time(rollBack, random_.chance(50) ? nth : static_cast<std::uint32_t>(model_.marks()) - 1, true);
      if (random_.chance(60)) {  // what is ahead stays, or goes
        const bool goesOn = random_.chance(50);
        time(rollBack, random_.below(8U), goesOn);
      }
      if (random_.chance(30)) someEdits(1);
      for (int k = habits_.memory > 0 ? random_.below(3) : 0; k > 0; --k) {
        const int which = random_.below(3);
        turn(which == 0 ? reload : unload, cell);
        if (which == 2) turn(reloadEmpty, cell);
      }
      if (random_.chance(30)) time(commit);
      time(redo, random_.below(2U));
      if (habits_.memory > 0 && random_.chance(40)) turn(reloadEmpty, cell);
      if (random_.chance(40)) make(squareAt(cell));
      return random_.chance(50) ? time(commit) : void();
  }
}

// An island leaves the ground, and comes back as it lay or otherwise; or something is in its way. Or what edits would do
// is foreseen.
void Editor::carry(Cell cell) {
  using enum Call::Kind;
  const auto islandAt = [&](Cell at) {
    Call call = Call::of(take);
    call.goes = {{.cell = at, .nth = random_.below(4U)}};
    call.nth = random_.chance(50) ? 0 : random_.below(4U);
    return call;
  };
  if (random_.chance(90)) make(Call::commit());
  if (random_.chance(35)) {
    Call would = Call::of(foresee);
    for (int k = 1 + random_.below(3); k > 0; --k)
      would.group.push_back(random_.chance(30) ? islandAt(cell) : anyEdit({cell.i - 1, cell.j - 1}));
    return make(std::move(would));
  }
  const bool isMarked = random_.chance(25);
  if (isMarked) make(Call::of(mark));
  make(islandAt(cell));
  if (random_.chance(20)) make(islandAt(pickCell()));
  if (random_.chance(50)) make(Call::commit());
  if (isMarked && random_.chance(50)) {
    Call back = Call::of(rollBack);
    back.nth = static_cast<std::uint32_t>(model_.marks()) - 1;
    back.keeps = random_.chance(50) ? Call::Keeps::always : Call::Keeps::never;
    make(std::move(back));
    if (random_.chance(50)) make(Call::of(redo));
  }
  if (random_.chance(25)) make(squareAt(cell));
  Call comes = Call::of(put);
  const auto bodies = static_cast<std::uint32_t>(model_.state().bodies.size());
  comes.nth = bodies > 0 && random_.chance(70) ? bodies - 1 : random_.below(16U);
  if (random_.chance(45)) {
    comes.lies.symmetry = random_.below(8U);
    comes.lies.by.i = random_.below(5) - 2;
    comes.lies.by.j = random_.below(5) - 2;
  }
  make(std::move(comes));
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
  switch (random_.below(14)) {
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
