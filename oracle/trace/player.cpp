#include "oracle/trace/player.h"

#include "oracle/trace/call_text.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {

using Kind = Call::Kind;

Player::Player(PreservePairs preserve) : caller_(World(relationOf(preserve))), preserve_(std::move(preserve)) {}

Judged Player::judge(const Call& call) const {
  Judged judged{caller_.resolved(model_.resolved(call)), {}};
  judged.verdict = model_.judgeResolved(judged.call);
  return judged;
}

Player::Done Player::apply(const Call& call) {
  if (call.kind == Kind::group) return makeGroup(call);
  if (call.kind == Kind::foresee) return foresee(call);
  if (call.kind != Kind::repeat) return make(judge(call));
  for (std::uint32_t k = 0; k < call.nth; ++k)
    for (const Call& part : call.group)
      if (auto done = apply(part); !done && done.error().isWrong) return done;
  return {};
}

Player::Done Player::make(const Judged& judged) {
  brushed_ = {};
  Done done;
  if (judged.verdict.isOfName)
    done = tl::unexpected(TraceError{0, badName(judged.call), {}});
  else
    done = judged.call.kind == Kind::brush ? brush(judged) : makeCall(judged);
  if (!done) done.error().line = judged.call.line;
  return done;
}

const Changes& Player::commit(std::uint32_t executor) {
  Call call;
  call.nth = executor;
  static_cast<void>(makeCall({std::move(call), {}}));
  return *caller_.changes;
}

// What is undone has not been.
Player::Done Player::makeGroup(const Call& call) {
  const Model::State before = model_.state();
  const Redo redo = model_.redo();
  const Moment moment = now_;
  Done done;
  const bool isKept = caller_.makeGroup(call, [&](const Call& part) {
    if (!done && done.error().isWrong) return false;
    done = apply(part);
    return done.has_value();
  });
  if (!done && done.error().isWrong) return done;
  if (!isKept) {
    model_.restore(before, redo);
    now_ = moment;
    hasLeft_ = true;
  }
  return {};
}

// What would be has not been; but it commits.
Player::Done Player::foresee(const Call& call) {
  commit();
  const Model::State before = model_.state();
  const Redo redo = model_.redo();
  const Moment moment = now_;
  const std::set<Cell> edited = edited_;
  Done done;
  Outcome outcome;
  caller_.foresee(call, outcome, [&](const Call& part) {
    if (done || !done.error().isWrong) done = apply(part);
  });
  if (!done && done.error().isWrong) return done;
  model_.restore(before, redo);
  now_ = moment;
  edited_ = edited;
  moments_.happened(Redo::maybe);
  hasLeft_ = true;
  if (outcome.changes != ChangeLists()) return wrong("a commit of nothing changes something");
  foreseen_ = std::move(outcome);
  return {};
}

// Those that go elsewhere in time or memory leave no trace.
void Player::keepMoment(const Call& call) {
  const std::set<Cell> away = model_.chunksAway();
  now_.away = away;
  now_.chunks = model_.state().chunks;
  if (call.kind == Kind::mark) moments_.mark(now_);
  if (call.kind == Kind::rollBack && moments_.hasMarks())
    now_ = moments_.back(call.nth, call.keeps != Call::Keeps::never);
  if (call.kind == Kind::redo && moments_.hasAhead()) now_ = moments_.forward(call.nth);
  if (call.kind == Kind::rollBack || call.kind == Kind::redo) {
    hasTravelled_ = true;
    turn(away);
  }
  if (call.kind == Kind::forget && moments_.hasMarks()) moments_.forget(call.nth);
  if (call.kind == Kind::load) moments_.clear();
  hasLeft_ = hasLeft_ || call.kind == Kind::rollBack || call.kind == Kind::load || call.kind == Kind::copy;
}

// Chunks that came or went since have done it at the end of this past, and with a commit, unless edits were pending.
void Player::turn(const std::set<Cell>& away) {
  if (!hasStreamed_) return;
  if (now_.pending || !std::ranges::includes(now_.chunks, away)) isOfOnePast_ = false;
  const auto add = [&](Kind kind, const std::set<Cell>& chunks, const std::set<Cell>& others) {
    for (const Cell chunk : chunks) {
      if (others.contains(chunk)) continue;
      Call call = Call::of(kind);
      const Cell corner{32 * chunk.i, 32 * chunk.j};
      call.cells = {corner, {std::min(corner.i + 31, kMaxCell), std::min(corner.j + 31, kMaxCell)}};
      now_.past.push_back(std::make_shared<Told>(Told{std::move(call), {}, true}));
    }
  };
  add(Kind::unload, away, now_.away);
  add(Kind::reload, now_.away, away);
  if (!now_.pending) now_.past.push_back(std::make_shared<Told>(Told{Call::commit(), {}, true}));
}

// Of a call that is accepted, before the model makes it.
void Player::noteEdited(const Call& call, const Outcome& outcome) {
  for (const Body& body : outcome.bodies)
    for (const BodyPolygon& p : body.polygons) edited_.insert({body.origin.i + p.cell.i, body.origin.j + p.cell.j});
  if (call.kind == Kind::take) return;
  const bool isAnywhere = call.kind == Kind::fill || call.kind == Kind::exchange || call.kind == Kind::setBlock;
  for (const Coming& coming : call.comes)
    if (!isAnywhere && call.kind != Kind::shape) edited_.insert(coming.cell);
  for (const Named& named : call.goes) edited_.insert(standing().cellOf(named.name));
  if ((call.kind == Kind::fill && !isEmpty(call.cells)) || call.kind == Kind::exchange)
    for (std::int32_t j = call.cells.min.j; j <= call.cells.max.j; ++j)
      for (std::int32_t i = call.cells.min.i; i <= call.cells.max.i; ++i) edited_.insert({i, j});
  if (call.kind == Kind::clear)
    for (const auto& entry : standing().cells())
      if (contains(call.cells, entry.first)) edited_.insert(entry.first);
}

Player::Done Player::makeCall(const Judged& judged) {
  const auto& [call, verdict] = judged;
  auto told = std::make_shared<Told>();
  Outcome& outcome = told->outcome;
  outcome = caller_.makeResolved(call);
  if (std::string text = model_.wrongAnswer(call, verdict, outcome, world()); !text.empty())
    return wrong(fmt::format("{}: {}", text, printCall(call)));
  if (auto done = checkShapes(call, outcome); !done) return done;
  const bool isDone = !outcome.refusal;
  const auto refusal = outcome.refusal;
  const std::size_t chunks = model_.chunks();
  if (!movesInTime(call.kind)) {
    if (!isDone) model_.tried();
    if (!isDone || !isOfMemory(call.kind)) moments_.happened(Redo::maybe);
    hasLeft_ = hasLeft_ || !isDone;
  }
  if (call.kind == Kind::leave && isDone && model_.owing(call.cells, Model::Owed::maybe) != 0) isOfOnePast_ = false;
  if (call.kind == Kind::reloadEmpty && model_.hasMarks() && outcome.count != 0) isOfOnePast_ = false;
  hasStreamed_ = hasStreamed_ || isOfMemory(call.kind);
  if (isDone) {
    if (isEdit(call.kind)) noteEdited(call, outcome);
    model_.apply(call, &outcome, &world());
    if (call.kind == Kind::reload && model_.chunks() != chunks) {
      moments_.happened(Redo::maybe);
      if (hasTravelled_) isOfOnePast_ = false;  // the bytes may be of what was undone
    }
    for (const Coming& coming : call.comes)
      for (const std::string& name : coming.names) lost_.erase(name);
    keepMoment(call);
  }
  const bool isCommit = call.kind == Kind::commit || call.kind == Kind::load;
  if (isCommit || !movesInTime(call.kind)) {
    if (isCommit) now_.pending = false;
    if (!isCommit && isDone) now_.pending = true;
    told->call = call.kind == Kind::load ? Call() : call;
    if (call.kind == Kind::load) outcome.refusal.reset();
    if (call.kind == Kind::reload && model_.chunks() == chunks && outcome.chunks.size() > 1) {
      told->call.nth ^= 1U;  // once more, they come back in the other order
      std::ranges::reverse(outcome.chunks);
      hasLeft_ = true;
    }
    if (call.kind != Kind::leave || isDone) now_.past.push_back(std::move(told));
  }
  if (!isDone) return refused(*refusal);
  for (const Coming& coming : call.comes) {
    for (std::size_t k = 0; k < coming.names.size() && call.kind != Kind::setBlock; ++k) {
      const PolygonHandle handle = handleOf(coming.names[k]);
      const auto [cell, block, vertices] = standing()[coming.names[k]];
      const auto placed = world().polygon(handle);
      if (!placed || placed->block != block || !std::ranges::equal(placed->vertices, vertices) ||
          world().cellOf(handle) != cell)
        return wrong(
            fmt::format("'{}' is accepted, but is not what its handle names: {}", coming.names[k], printCall(call)));
    }
  }
  return {};
}

// A shape always gets the same id, and no two shapes get one.
Player::Done Player::checkShapes(const Call& call, const Outcome& outcome) {
  if (!isByShape(call.kind) && call.kind != Kind::shape) return {};
  for (const Coming& coming : call.comes) {
    if (coming.id != 0) continue;
    if (faultOf(call, coming.shape)) return {};  // the call has gone no further
    const bool isLast = &coming == &call.comes.back();
    const auto id =
        isLast ? outcome.shape : world().shape(std::span<const std::vector<LocalPoint>>(coming.shape)).value();
    const auto [made, isNew] = now_.shapes.emplace(coming.shape, id);
    const auto isSame = [&](const auto& entry) { return entry.second == id; };
    if (made->second != id || (isNew && std::ranges::count_if(now_.shapes, isSame) != 1))
      return wrong("shape() gives a shape another id, or two shapes one");
  }
  return {};
}

std::string Player::badName(const Call& call) const {
  for (const Named& named : call.goes) {
    if (named.how != Named::How::name) continue;
    const auto lost = lost_.find(named.name);
    const std::string why = lost == lost_.end() ? "" : "; a brush has changed it, and a changed polygon has no name";
    const std::string where = why.empty() || lost->second == 0 ? "" : fmt::format(" (line {})", lost->second);
    return fmt::format("there is no polygon named '{}' to remove{}{}", named.name, why, where);
  }
  std::string name;
  for (const Coming& coming : call.comes)
    for (const std::string& each : coming.names)
      if (name.empty() || isAlive(each)) name = each;
  return fmt::format("the name '{}' is in use; remove that polygon first, or choose another", name);
}

// Names the polygon that is overlapped: a reader of the trace knows names, and not the engine's handles.
tl::unexpected<TraceError> Player::refused(const Error& error) const {
  TraceError refusal{0, {}, error};
  const std::string* const other = standing().nameOf(error.other);
  const bool isNamed = other != nullptr && !other->starts_with('#');
  Error ofOne = error;
  ofOne.polygon = -1;
  refusal.text = error.code == ErrorCode::overlap && isNamed
                     ? fmt::format("cell ({}, {}): its interior overlaps '{}'", error.cell.i, error.cell.j, *other)
                     : message(ofOne);
  return tl::unexpected(std::move(refusal));
}

Player::Done Player::brush(const Judged& judged) {
  const auto& [call, verdict] = judged;
  auto told = std::make_shared<Told>(Told{call, caller_.makeResolved(call)});
  if (std::string text = model_.wrongAnswer(call, verdict, told->outcome, world()); !text.empty())
    return wrong(fmt::format("{}: {}", text, printCall(call)));
  now_.past.push_back(told);
  model_.tried();
  moments_.happened(Redo::maybe);
  if (!told->outcome.refusal) {
    now_.pending = true;
    return readBack(call, told->outcome.brushed);
  }
  const Error& error = *told->outcome.refusal;
  auto refusal = refused(error);
  if (error.code == ErrorCode::outOfReach && error.polygon >= 0)
    refusal.value().text = fmt::format("ring {}, vertex {}: {}", error.polygon, error.vertex, refusal.value().text);
  return refusal;
}

// A polygon that has kept its handle, its block and its vertices has kept its name. What else there is gets a new one:
// no trace can name it, since # begins a comment. The result must tell of just these.
Player::Done Player::readBack(const Call& call, const BrushResult& result) {
  std::set<PolygonHandle> old(result.removed.begin(), result.removed.end()),
      made(result.added.begin(), result.added.end());
  for (const BrushChange& change : result.changed) {
    if (change.now.empty()) return wrong("the brush tells of a polygon that it became nothing");
    old.insert(change.old);
    made.insert(change.now.begin(), change.now.end());
  }
  if (old.size() != result.removed.size() + result.changed.size())
    return wrong("the brush tells twice what it did to a polygon");
  const CellRect cells = cellsUnder(call.brush);
  std::map<PolygonHandle, std::string> oldNames, newNames;  // a polygon that got another block has kept its handle
  std::map<PolygonHandle, ScenePolygon> there;
  world().forEachPolygon(cells, [&](Cell cell, const PlacedPolygon& p) {
    there[p.handle] = {cell, p.block, {p.vertices.begin(), p.vertices.end()}};
  });
  std::vector<std::pair<std::string, Block>> recoloured;
  for (const auto& [cell, placed] : standing().cells()) {
    if (!contains(cells, cell)) continue;
    for (const auto& [name, block, vertices, handle] : placed) {
      const auto now = there.find(handle);
      const bool isKept = now != there.end() && now->second == ScenePolygon{cell, block, vertices};
      if (isKept == old.contains(handle))
        return wrong(fmt::format("the brush does not tell what it did to '{}'", name));
      const bool isBent = std::ranges::find(result.rounded, handle) != result.rounded.end();
      if (isKept && isBent) return wrong(fmt::format("the brush says that it bent '{}', which is as it was", name));
      if (isBent) brushed_.rounded.push_back(name);
      oldNames[handle] = name;
      if (isKept) {
        there.erase(now);
      } else {
        brushed_.removed[name] = {cell, block, vertices};
      }
    }
  }
  for (const auto& entry : brushed_.removed) {
    edited_.insert(entry.second.cell);
    lost_[entry.first] = call.line;
    brushed_.edits.push_back(Call::remove(entry.first));
    model_.remove(entry.first);
  }
  for (auto& [handle, polygon] : there) {
    if (made.erase(handle) == 0) return wrong("the brush does not tell of a polygon that it made");
    const Call& part = brushed_.edits.emplace_back(Call::add(model_.freshName(), std::move(polygon)));
    if (!model_.judge(part).accepted) return wrong("a brush makes what must be refused: " + printCall(part));
    edited_.insert(part.comes[0].cell);
    model_.add(part.name(), part.polygon(), handle);
    newNames[handle] = part.name();
  }
  for (const BrushChange& change : result.changed)
    for (const PolygonHandle now : change.now) brushed_.became.emplace_back(oldNames[change.old], newNames[now]);
  return made.empty() ? Done() : wrong("the brush tells of a polygon that it did not make");
}

tl::expected<void, TraceError> play(const Trace& trace, Player& player, const CommitCallback& afterCommit) {
  const auto commit = [&](std::uint32_t executor) {
    const Changes& changes = player.commit(executor);
    return !afterCommit || afterCommit(player, changes);
  };
  for (const Call& call : trace.calls) {
    if (call.kind == Kind::commit || commitsFirst(call.kind))
      if (!commit(call.nth)) return {};
    if (call.kind == Kind::commit) continue;
    if (auto done = player.apply(call); !done && (!trace.mayRefuse || done.error().isWrong)) return done;
  }
  if (player.pending()) commit(0);
  return {};
}

}  // namespace lgs::oracle
