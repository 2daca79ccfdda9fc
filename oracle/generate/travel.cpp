// What an editor does that is no plain edit: any call at all, strokes, moves in time, bodies. Memory is in streaming.cpp.
#include "oracle/generate/editor.h"
#include "oracle/trace/plain_edits.h"

#include <lgs/world.h>
#include <algorithm>

namespace lgs::oracle {

Call Editor::squareAt(Cell cell) {
  Call call = Call::of(Call::Kind::addShape);
  call.comes = {{.cell = cell, .shape = {{kUnitSquare.begin(), kUnitSquare.end()}}, .block = 1}};
  return call;
}

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

}  // namespace lgs::oracle
