#include "oracle/trace/player.h"

#include "oracle/trace/detour.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

// Runs the jobs from the last to the first; with `apart` the even ones, then the odd ones.
Executor executorOf(bool apart) {
  return [apart](std::size_t count, const std::function<void(std::size_t)>& job) {
    for (std::size_t k = count; k-- > 0;)
      if (!apart || k % 2 == 0) job(k);
    for (std::size_t k = 0; k < count; ++k)
      if (apart && k % 2 != 0) job(k);
  };
}

}  // namespace

Player::Player(PreservePairs preserve, Loads loads)
    : caller_(World(relationOf(preserve))), preserve_(std::move(preserve)), loads_(loads) {}

tl::expected<void, TraceError> Player::apply(const Row& row) {
  brushed_ = {};
  auto done = row.isTrial ? Done() : detour(row);
  if (done) done = make(row);
  if (done) {
    pending_ = true;
  } else {
    done.error().line = row.edits.front().line;
  }
  return done;
}

// What nobody may notice: the world is saved and loaded, edited wrongly and brought back, or keeps a mark for a while. Or
// chunks leave memory and come back.
Player::Done Player::detour(const Row& row) {
  constexpr std::size_t kSmall = 200;  // polygons: it costs in proportion to the world
  const auto told = [](std::optional<std::string> complaint) -> Done {
    return complaint ? Done(wrong(std::move(*complaint))) : Done();
  };
  const Detour what = row.way.detour;
  const auto counted = [&](bool isMade) {
    detours_[static_cast<std::size_t>(what)] += isMade ? 1 : 0;
    return isMade;
  };
  const bool isSmall = standing().polygons() <= kSmall;
  if (what == Detour::saved && counted(loads_ == Loads::sometimes && !pending_ && isSmall)) {
    mark_.reset();  // it is not saved
    if (auto done = told(saveAndLoad(world())); !done) return done;
  }
  if (mark_ && !pending_) {  // it has seen a commit
    if (!world().forget(*mark_)) return wrong("a mark is forgotten too early");
    mark_.reset();
  }
  if (what == Detour::marked && counted(!mark_)) mark_ = world().checkpoint();
  const bool isSomewhere = !row.cells.empty() && inRange(row.cells[0]);
  if (what == Detour::undone && counted(isSomewhere)) return told(editAndGoBack(world(), row.cells[0], row.way.number));
  if (what == Detour::unloaded && counted(isSomewhere && pending_))  // a commit follows: chunks count as changed
    return told(unloadAndReload(world(), row.cells[0], row.way.number));
  const bool isEmpty = isSomewhere && row.verdict.accepted && standing().in(row.cells[0]).empty();
  return what == Detour::worn && counted(isEmpty) ? wear(row.cells[0], 250 + bitsOf(row.way.number, 0, 4)) : Done();
}

Player::Done Player::make(const Row& row) {
  const Edit& first = row.edits.front();
  if (first.kind == Edit::Kind::brush) return brush(first);
  if (row.cells.empty()) return tl::unexpected(TraceError{0, badName(first), {}});
  if (row.way.detour != Detour::grouped) return makeCall(row);
  ++detours_[static_cast<std::size_t>(Detour::grouped)];
  Transaction group = world().edit();
  auto done = makeCall(row);
  group.keep();  // if the edit is refused, there is nothing to undo
  return done;
}

Player::Done Player::makeCall(const Row& row) {
  Call call = row.call;
  const bool isRepainted =
      row.way.detour == Detour::repainted && row.verdict.accepted && call.kind != Call::Kind::setBlock;
  for (Coming& coming : call.comes) coming.block ^= isRepainted ? 1U : 0U;
  const Outcome outcome = caller_.makeResolved(call);
  if (std::string text = calls_.wrongAnswer(call, row.verdict, outcome, world()); !text.empty())
    return wrong(fmt::format("{}: {}", text, inWords(row)));
  if (auto done = checkShapes(call, outcome); !done) return done;
  if (outcome.refusal) return refused(*outcome.refusal);
  calls_.apply(row.call, outcome.handles, row.names);
  for (const std::string& name : row.names) {
    lost_.erase(name);
    const PolygonHandle handle = handleOf(name);
    const auto [cell, block, vertices] = standing()[name];
    if (isRepainted) {
      ++detours_[static_cast<std::size_t>(Detour::repainted)];
      if (const auto done = world().setBlock(handle, block); !done) return wrong(message(done.error()));
    }
    const auto placed = world().polygon(handle);
    if (!placed || placed->block != block || !std::ranges::equal(placed->vertices, vertices) ||
        world().cellOf(handle) != cell)
      return wrong(fmt::format("'{}' is accepted, but is not what its handle names: {}", name, inWords(row)));
  }
  return {};
}

const Changes& Player::commit() {
  pending_ = false;
  switch (bitsOf(std::exchange(executor_, 0), 0, 2)) {
    case 0:
      return world().commit();
    case 1:
      return world().commit(Executor());
    case 2:
      return world().commit(executorOf(false));
    default:
      return world().commit(executorOf(true));
  }
}

// A shape always gets the same id, and no two shapes get one id.
Player::Done Player::checkShapes(const Call& call, const Outcome& outcome) {
  if (!isByShape(call.kind)) return {};
  for (const Coming& coming : call.comes) {
    if (faultOf(std::span(coming.shape))) return {};  // the call has gone no further
    const bool isLast = &coming == &call.comes.back();
    const auto id =
        isLast ? outcome.shape : world().shape(std::span<const std::vector<LocalPoint>>(coming.shape)).value();
    const auto [made, isNew] = shapes_.emplace(coming.shape, id);
    if (made->second != id || shapeIds_.insert(id).second != isNew)
      return wrong("shape() gives a shape another id, or two shapes one");
  }
  return {};
}

Player::Done Player::wear(Cell cell, unsigned times) {
  Call square;
  square.kind = Call::Kind::addShape;
  square.comes = {{cell, {{kUnitSquare.begin(), kUnitSquare.end()}}, 0}};
  const Outcome first = caller_.makeResolved(square);
  if (first.refusal || !world().remove(first.handles[0])) return wrong("a square can not come and go");
  for (; times > 1; --times) {
    const auto again = world().add(cell, first.shape, times);
    if (!again || !world().remove(*again)) return wrong("a square can not come and go");
  }
  return checkShapes(square, first);
}

std::string Player::badName(const Edit& edit) const {
  if (edit.kind == Edit::Kind::add)
    return fmt::format("the name '{}' is in use; remove that polygon first, or choose another", edit.name);
  const auto lost = lost_.find(edit.name);
  const std::string why = lost == lost_.end() ? "" : "; a brush has changed it, and a changed polygon has no name";
  const std::string where = why.empty() || lost->second == 0 ? "" : fmt::format(" (line {})", lost->second);
  return fmt::format("there is no polygon named '{}' to remove{}{}", edit.name, why, where);
}

// Names the polygon that is overlapped: a reader of the trace knows names, and not the engine's handles.
tl::unexpected<TraceError> Player::refused(const Error& error) const {
  TraceError refusal{0, {}, error};
  const std::string* const other = standing().nameOf(error.other);
  Error ofOne = error;
  ofOne.polygon = -1;
  refusal.text = error.code == ErrorCode::overlap && other != nullptr
                     ? fmt::format("cell ({}, {}): its interior overlaps '{}'", error.cell.i, error.cell.j, *other)
                     : message(ofOne);
  return tl::unexpected(std::move(refusal));
}

tl::expected<void, TraceError> play(const Trace& trace, Player& player, const CommitCallback& afterCommit) {
  const auto commit = [&] {
    const Changes& changes = player.commit();
    return !afterCommit || afterCommit(player, changes);
  };
  Rows rows(trace);
  while (const auto row = rows.next(player.calls())) {
    if (row->isCommit()) {
      player.useExecutor(row->way.number);
      if (!commit()) return {};
    } else if (auto done = player.apply(*row); !done && (!row->isTrial || done.error().isWrong)) {
      return done;
    }
  }
  if (player.pending()) commit();
  return {};
}

}  // namespace lgs::oracle
