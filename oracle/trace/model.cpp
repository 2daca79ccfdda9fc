#include "oracle/trace/model.h"

#include "oracle/reference/blame.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>
#include <utility>

namespace lgs::oracle {
namespace {

using Kind = Call::Kind;

std::string cellInWords(Cell cell) {
  return cell == Error::kNoCell ? "no cell" : fmt::format("({}, {})", cell.i, cell.j);
}

std::vector<Cell> cellsOf(const CellRect& rect) {
  std::vector<Cell> cells;
  if (isEmpty(rect)) return cells;  // it may have any number of rows
  for (std::int32_t j = rect.min.j; j <= rect.max.j; ++j)
    for (std::int32_t i = rect.min.i; i <= rect.max.i; ++i) cells.push_back({i, j});
  return cells;
}

std::optional<Verdict> outOfRange(const CellRect& cells) {
  for (const Cell corner : {cells.min, cells.max})
    if (!inRange(corner)) return Verdict{false, ErrorCode::cellOutOfRange, corner};
  return std::nullopt;
}

// By rows.
bool comesBefore(Cell a, Cell b) { return std::pair(a.j, a.i) < std::pair(b.j, b.i); }

CellRect cellsOfChunk(Cell chunk) { return {{32 * chunk.i, 32 * chunk.j}, {32 * chunk.i + 31, 32 * chunk.j + 31}}; }

// Whether a chunk lies in a rectangle as a whole. Cells that there are not need not.
bool isWithin(const CellRect& cells, Cell chunk) {
  const auto fits = [](std::int64_t k, std::int32_t min, std::int32_t max) {
    return min <= std::max<std::int64_t>(32 * k, -kMaxCell) && std::min<std::int64_t>(32 * k + 31, kMaxCell) <= max;
  };
  return fits(chunk.i, cells.min.i, cells.max.i) && fits(chunk.j, cells.min.j, cells.max.j);
}

// The polygon of the error is one that comes, and overlaps another one that comes or the one that stands there.
std::string wrongOverlap(const Error& error, const Call& call, const World& world) {
  if (call.kind == Kind::addMany && error.index2 >= 0) return "";  // with another entry's, which has no handle
  Shape comes;
  for (const Coming& coming : call.comes) comes.insert(comes.end(), coming.shape.begin(), coming.shape.end());
  if (call.kind == Kind::addMany) comes = call.comes[static_cast<std::size_t>(error.index)].shape;
  const auto known = [&](std::int32_t k) { return k >= 0 && static_cast<std::size_t>(k) < comes.size(); };
  if (!known(error.polygon)) return "does not say which polygon";
  const LocalPolygon& polygon = comes[static_cast<std::size_t>(error.polygon)];
  if (known(error.polygon2))
    return overlap(polygon, comes[static_cast<std::size_t>(error.polygon2)]) ? "" : "names what does not overlap";
  const auto other = world.polygon(error.other);
  if (!other || world.cellOf(error.other) != error.cell) return "names a polygon that is not in the cell";
  if (other->block != error.otherBlock) return "names another block than that of the polygon";
  return overlap(polygon, {other->vertices.begin(), other->vertices.end()}) ? "" : "names what does not overlap";
}

// What the refusal of a call that brings one polygon says of that.
std::string wrongPart(const Call& call, const Error& error) {
  if (error.code == ErrorCode::capacity || error.code == ErrorCode::unloaded)
    return error.vertex == -1 ? "" : "names a vertex, which is not to blame";
  const bool isOfOne = call.kind == Kind::add || call.kind == Kind::addShape || call.kind == Kind::shape ||
                       call.kind == Kind::replace || call.kind == Kind::fill;
  const bool isSpoilt = isReal(call.notation) && call.offset >= kSpoiltOffset;
  if (!isOfOne || isSpoilt || call.comes[0].id != 0 || call.comes[0].shape.size() != 1) return "";
  return wrongBlame(error, call.comes[0].shape[0]);
}

}  // namespace

bool isTooLarge(const CellRect& r) {
  const auto chunks = [](std::int32_t min, std::int32_t max) { return (std::int64_t{max} >> 5) - (min >> 5) + 1; };
  return chunks(r.min.i, r.max.i) * chunks(r.min.j, r.max.j) > 2 * static_cast<std::int64_t>(kMaxChunks);
}

PreserveRelation relationOf(const PreservePairs& pairs) {
  if (pairs.empty()) return {};
  return [pairs](Block a, Block b) { return pairs(a, b); };
}

std::optional<ErrorCode> faultOf(const Call& call, const Shape& shape) {
  const bool isSpoilt = isReal(call.notation) && call.offset >= kSpoiltOffset && shape.size() == 1;
  if (!isSpoilt || shape[0].size() < 3) return oracle::faultOf(std::span(shape));
  if (shape[0].size() > kMaxVerticesPerCell) return ErrorCode::capacity;
  return call.offset == kOffsets - 1 ? ErrorCode::outsideCell : ErrorCode::notFinite;
}

// --- What a call names

Call Model::resolved(const Call& call) const {
  using enum Named::How;
  if (call.goes.empty()) return call;
  Call out = call;
  out.goes.clear();
  const auto put = [&](PolygonHandle at, std::string of) {
    out.goes.push_back({.how = handle, .handle = at, .name = std::move(of)});
  };
  const auto putPlaced = [&](const Standing::Placed& p) { put(p.handle, p.name); };
  for (const Named& named : call.goes) {
    if (named.how == standing || named.how == all) {
      const auto& there = now_.standing.in(named.cell);
      if (named.how == all)
        std::ranges::for_each(there, putPlaced);
      else
        there.empty() ? put({}, "") : putPlaced(there[named.nth % there.size()]);
    } else if (named.how == given || named.how == beside) {
      Given one = now_.given.empty() ? Given{} : now_.given[named.nth % now_.given.size()];
      if (named.how == beside) one.handle.serial += 1 + named.nth % Caller::kFar;
      if (named.how == beside || one.handle || !isAlive(one.name)) one.name.clear();  // its handle says what it is now
      put(one.handle, one.name);
    } else if (named.how == Named::How::name && isAlive(named.name)) {
      put(now_.standing.handleOf(named.name), named.name);
    } else {
      out.goes.push_back(named);
    }
    if (out.goes.empty()) continue;
    Named& last = out.goes.back();
    const std::string* const known = last.handle ? now_.standing.nameOf(last.handle) : nullptr;
    if (known != nullptr) last.name = *known;
  }
  return out;
}

// --- What must come of it

std::optional<Cell> Model::firstAway(const CellRect& cells) const {
  std::optional<Cell> first;
  for (const auto& entry : now_.away) {
    const CellRect all = cellsOfChunk(entry.first);
    const CellRect here{{std::max(all.min.i, cells.min.i), std::max(all.min.j, cells.min.j)},
                        {std::min(all.max.i, cells.max.i), std::min(all.max.j, cells.max.j)}};
    if (!isEmpty(here) && (!first || comesBefore(here.min, *first))) first = here.min;
  }
  return first;
}

// By rows.
std::vector<Cell> Model::chunksWithin(const CellRect& cells, bool areLoaded) const {
  std::vector<Cell> within;
  for (const Cell chunk : now_.chunks)
    if (isWithin(cells, chunk) && now_.away.contains(chunk) != areLoaded) within.push_back(chunk);
  std::ranges::sort(within, comesBefore);
  return within;
}

Verdict Model::judgeResolved(const Call& call) const {
  std::set<std::string> going, coming;
  for (const Named& named : call.goes) {
    if (named.how == Named::How::name) return {.accepted = false, .isOfName = true};
    going.insert(named.name);
  }
  if (call.kind != Kind::setBlock)
    for (const Coming& c : call.comes)
      for (const std::string& name : c.names) {
        const bool isFree = !isAlive(name) || going.contains(name) ||
                            (call.kind == Kind::replace && now_.standing.cellOf(name) == c.cell);
        if (!isFree || !coming.insert(name).second) return {.accepted = false, .isOfName = true};
      }
  if (call.kind == Kind::add) {
    const Coming& c = call.comes[0];
    if (!inRange(c.cell)) return {false, ErrorCode::cellOutOfRange, c.cell};
    if (const auto fault = faultOf(call, c.shape)) return {false, fault, c.cell};
  }
  if (call.kind == Kind::shape || isByShape(call.kind)) {
    for (const Coming& c : call.comes)
      if (const auto fault = faultOf(call, c.shape); fault && c.id == 0) return {false, fault};
  }
  return judgeParts(call);
}

Verdict Model::addingTo(const Standing& standing, Cell cell, const Coming& coming) const {
  if (!inRange(cell)) return {false, ErrorCode::cellOutOfRange, cell};
  if (coming.id != 0 && coming.shape.empty()) return {false, ErrorCode::unknownShape, cell};
  if (!isLoaded(cell)) return {false, ErrorCode::unloaded, cell};
  if (now_.chunks.size() >= kMaxChunks && !now_.chunks.contains(chunkOf(cell)))
    return {false, ErrorCode::capacity, cell};
  const auto refusal = standing.refusalIn(cell, coming.shape);
  return refusal ? Verdict{false, refusal, cell} : Verdict{};
}

// A polygon that is not there may be in a chunk that is not in memory.
Verdict Model::goesWrong(const Named& named) const {
  for (const auto& [chunk, content] : now_.away)
    for (const auto& [cell, there] : content)
      if (named.handle && std::ranges::find(there, named.handle, &Standing::Placed::handle) != there.end())
        return {false, ErrorCode::unloaded, cell};
  Verdict stale{false, ErrorCode::staleHandle};
  // Which handles are those of a chunk that is not in memory, but of no polygon there, nobody says.
  if (!isWhole() && named.handle) stale.code.reset();
  return stale;
}

// What comes one after the other is tried on a copy.
Verdict Model::judgeParts(const Call& call) const {
  switch (call.kind) {
    case Kind::add:
    case Kind::addShape:
      return addingTo(now_.standing, call.comes[0].cell, call.comes[0]);
    case Kind::replace:
      return addingTo(Standing(), call.comes[0].cell, call.comes[0]);
    case Kind::fill: {
      if (isEmpty(call.cells)) return {};
      if (const auto verdict = outOfRange(call.cells)) return *verdict;
      const Coming& coming = call.comes[0];
      if (coming.id != 0 && coming.shape.empty()) return {false, ErrorCode::unknownShape, call.cells.min};
      if (!isLoaded(call.cells.min)) return {false, ErrorCode::unloaded, call.cells.min};
      if (isTooLarge(call.cells)) return {false, ErrorCode::capacity, call.cells.min};
      for (const Cell cell : cellsOf(call.cells))
        if (auto verdict = addingTo(now_.standing, cell, coming); !verdict.accepted) return verdict;
      return {};
    }
    case Kind::clear:
    case Kind::leave:
    case Kind::unload:
    case Kind::reloadEmpty: {
      if (isEmpty(call.cells)) return {};
      if (const auto verdict = outOfRange(call.cells)) return *verdict;
      if (call.kind == Kind::leave && hasMarks()) return {false, ErrorCode::uncommitted};
      if (call.kind == Kind::leave) return {.code = ErrorCode::uncommitted, .isOpen = true};  // if edits are pending
      const auto away = call.kind == Kind::clear ? firstAway(call.cells) : std::nullopt;
      return away ? Verdict{false, ErrorCode::unloaded, *away} : Verdict{};
    }
    case Kind::remove:
    case Kind::setBlock:
      return call.goes[0].name.empty() ? goesWrong(call.goes[0]) : Verdict{};
    case Kind::addMany: {
      std::set<Cell> cells;
      for (const Coming& coming : call.comes) cells.insert(coming.cell);
      Standing tried = now_.standing.part(cells);
      std::size_t count = 0;
      for (std::size_t k = 0; k < call.comes.size(); ++k) {
        const Coming& coming = call.comes[k];
        auto verdict = addingTo(tried, coming.cell, coming);
        verdict.index = static_cast<int>(k);
        if (!verdict.accepted) return verdict;
        for (const LocalPolygon& polygon : coming.shape)
          tried.add(fmt::format("#new{}", ++count), {coming.cell, coming.block, polygon});
      }
      return {};
    }
    case Kind::removeMany: {
      std::set<std::string> gone;
      for (std::size_t k = 0; k < call.goes.size(); ++k) {
        const Named& named = call.goes[k];
        if (!named.name.empty() && gone.insert(named.name).second) continue;
        Verdict verdict = named.name.empty() ? goesWrong(named) : Verdict{false, ErrorCode::staleHandle};
        verdict.index = static_cast<int>(k);
        return verdict;
      }
      return {};
    }
    case Kind::exchange: {
      const Cell cell = call.cells.min;
      if (!inRange(cell)) return {false, ErrorCode::cellOutOfRange, cell};
      if (!isLoaded(cell)) return {false, ErrorCode::unloaded, cell};
      Standing tried = now_.standing.part({cell});
      std::vector<Verdict> verdicts;
      for (std::size_t k = 0; k < call.goes.size() && verdicts.empty(); ++k) {
        if (tried.isAlive(call.goes[k].name))
          tried.remove(call.goes[k].name);
        else
          verdicts.push_back({false, ErrorCode::staleHandle, cell, static_cast<int>(k)});
      }
      Shape comes;
      for (const Coming& coming : call.comes) comes.push_back(coming.shape[0]);
      const auto fault = comes.empty() ? std::nullopt : oracle::faultOf(std::span<const LocalPolygon>(comes));
      if (fault) verdicts.push_back({false, fault, cell});
      const bool areSimple = !fault || fault == ErrorCode::overlap;
      const auto refusal = areSimple ? tried.refusalIn(cell, comes) : std::nullopt;
      if (refusal) verdicts.push_back({false, refusal, cell});
      if (verdicts.size() > 1) return {false, std::nullopt, cell};
      return verdicts.empty() ? Verdict{} : verdicts[0];
    }
    case Kind::goForward:
      if (!hasAhead() || timeline_.redo() == Redo::sure) return {};
      return {.accepted = false, .code = ErrorCode::unknownMark, .isOpen = timeline_.redo() == Redo::maybe};
    case Kind::follow:  // if edits are pending
      return hasMarks() ? Verdict{false, ErrorCode::uncommitted}
                        : Verdict{.code = ErrorCode::uncommitted, .isOpen = true};
    case Kind::load: {
      const auto away = firstAway({{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}});
      return away ? Verdict{false, ErrorCode::unloaded, *away} : Verdict{};
    }
    case Kind::brush:  // whether a cell is full can not be known beforehand, nor which cells it reaches
      if (isOutOfReach(call.brush)) return {false, ErrorCode::outOfReach};
      return {.code = firstAway(cellsUnder(call.brush)) ? ErrorCode::unloaded : ErrorCode::capacity, .isOpen = true};
    default:
      return {};
  }
}

// --- What it does

void Model::add(const std::string& name, ScenePolygon polygon, PolygonHandle handle) {
  now_.chunks.insert(chunkOf(polygon.cell));
  now_.given.push_back({name, handle});
  now_.standing.add(name, std::move(polygon), handle);
}

void Model::place(Cell cell, const Coming& coming, std::span<const PolygonHandle> handles) {
  for (std::size_t k = 0; k < coming.shape.size(); ++k)
    add(k < coming.names.size() ? coming.names[k] : freshName(), {cell, coming.block, coming.shape[k]},
        handles.empty() ? PolygonHandle{} : handles[k]);
}

void Model::clear(const CellRect& cells) {
  std::vector<Cell> gone;
  for (const auto& entry : now_.standing.cells())
    if (contains(cells, entry.first)) gone.push_back(entry.first);
  for (const Cell cell : gone) now_.standing.take(cell);
}

void Model::takeAway(Cell chunk) {
  Content& content = now_.away[chunk];
  std::vector<Cell> filled;
  for (const auto& entry : now_.standing.cells())
    if (chunkOf(entry.first) == chunk) filled.push_back(entry.first);
  for (const Cell cell : filled) content[cell] = now_.standing.take(cell);
}

void Model::bringBack(const Content& content) {
  for (const auto& [cell, there] : content)
    for (const auto& [name, block, vertices, handle] : there)  // a name may be that of what is there since
      now_.standing.add(isAlive(name) ? freshName() : name, {cell, block, vertices}, handle);
}

void Model::unload(const CellRect& cells) {
  for (const Cell chunk : chunksWithin(cells, true)) {
    takeAway(chunk);
    shelf_[chunk].push_back(now_.away.at(chunk));
    owed_.erase(chunk);
  }
}

// Being in memory is no edit: what there is becomes what there was, and what is away stays away. A chunk that is away,
// and was not there yet, was there at all times, and held nothing.
void Model::goTo(State state) {
  const std::set<Cell> away = chunksAway();
  now_ = std::move(state);
  for (const auto& entry : std::exchange(now_.away, {})) bringBack(entry.second);
  for (const Cell chunk : away) {
    takeAway(chunk);
    owed_.insert(chunk);
    if (!now_.chunks.insert(chunk).second) continue;
    timeline_.forEach([&](State& other) { other.chunks.insert(chunk); });
  }
  now_.alone.clear();
  for (const Cell chunk : away)
    if (!isBesideLoaded(chunk)) now_.alone.insert(chunk);
}

std::set<Cell> Model::chunksAway() const {
  std::set<Cell> chunks;
  for (const auto& entry : now_.away) chunks.insert(entry.first);
  return chunks;
}

// What a chunk held is given up, at all times.
void Model::empty(Cell chunk) {
  now_.away.erase(chunk);
  timeline_.forEach([&](State& state) {
    std::vector<Cell> filled;
    for (const auto& entry : state.standing.cells())
      if (chunkOf(entry.first) == chunk) filled.push_back(entry.first);
    for (const Cell cell : filled) state.standing.take(cell);
    if (const auto away = state.away.find(chunk); away != state.away.end()) away->second.clear();
  });
}

std::vector<Cell> Model::comingBack(const CellRect& cells) const {
  std::vector<Cell> back;
  for (const auto& entry : shelf_) {
    const bool isGone = !now_.chunks.contains(entry.first);
    if (contains(cells, cellsOfChunk(entry.first).min) && (isGone || now_.away.contains(entry.first)))
      back.push_back(entry.first);
  }
  return back;
}

// A chunk that was forgotten comes back with new handles.
void Model::reload(Cell chunk, const World* world) {
  const bool isNew = now_.chunks.insert(chunk).second;
  Content content = isNew ? shelf_.at(chunk).back() : now_.away.at(chunk);
  now_.away.erase(chunk);
  if (isNew) timeline_.happened(Redo::no);
  for (auto& [cell, there] : content) {
    const auto now = world != nullptr && isNew ? world->polygons(cell) : std::vector<PlacedPolygon>();
    for (std::size_t k = 0; k < there.size() && isNew; ++k)
      there[k].handle = k < now.size() ? now[k].handle : PolygonHandle{};
  }
  bringBack(content);
}

// A loaded one has a chunk of its own, however empty that is.
bool Model::isBesideLoaded(Cell chunk, const std::set<Cell>& gone) const {
  return std::ranges::any_of(cellsOf({{chunk.i - 1, chunk.j - 1}, {chunk.i + 1, chunk.j + 1}}), [&](Cell beside) {
    return now_.chunks.contains(beside) && !now_.away.contains(beside) && !gone.contains(beside);
  });
}

// The chunks that forget() takes: those loaded that hold nothing; then those not in memory that no loaded one is beside,
// nor was at the last commit.
std::vector<Cell> Model::leaving(const CellRect& cells) const {
  if (isEmpty(cells)) return {};
  std::set<Cell> filled;
  for (const auto& entry : now_.standing.cells()) filled.insert(chunkOf(entry.first));
  std::vector<Cell> gone = chunksWithin(cells, true);
  std::erase_if(gone, [&](Cell chunk) { return filled.contains(chunk); });
  const std::set<Cell> loaded(gone.begin(), gone.end());
  for (const Cell chunk : chunksWithin(cells, false))
    if (!isBesideLoaded(chunk, loaded) && now_.alone.contains(chunk)) gone.push_back(chunk);
  return gone;
}

std::size_t Model::mayStay(const CellRect& cells) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(leaving(cells), [&](Cell chunk) { return stays(chunk, nullptr); }));
}

// An undo may have changed nothing: the engine knows.
bool Model::stays(Cell chunk, const World* world) const {
  if (!now_.away.contains(chunk) || !owed_.contains(chunk)) return false;
  const Cell corner = cellsOfChunk(chunk).min;
  return world == nullptr || world->firstUnloaded({corner, corner});
}

void Model::apply(const Call& call, const Outcome* outcome, const World* world) {
  std::span<const PolygonHandle> handles;
  if (outcome != nullptr) handles = outcome->handles;
  const auto next = [&](Cell cell, const Coming& coming) {
    place(cell, coming, handles);
    if (!handles.empty()) handles = handles.subspan(coming.shape.size());
  };
  // What changes nothing may count as an edit, or not.
  const bool mayBeNone = !isEdit(call.kind) || call.kind == Kind::shape || call.kind == Kind::setBlock ||
                         (call.comes.empty() && call.goes.empty()) || (call.kind == Kind::fill && isEmpty(call.cells));
  if (!movesInTime(call.kind) && !isOfMemory(call.kind)) timeline_.happened(mayBeNone ? Redo::maybe : Redo::no);
  switch (call.kind) {
    case Kind::setBlock:
      return recolour(call.goes[0].name, call.comes[0].block);
    case Kind::clear:
      return clear(call.cells);
    case Kind::fill:
      for (const Cell cell : cellsOf(call.cells)) next(cell, call.comes[0]);
      return;
    case Kind::shape:
    case Kind::copy:
    case Kind::brush:
    case Kind::group:
    case Kind::repeat:
    case Kind::follow:
      return;
    case Kind::commit:
      now_.alone.clear();
      for (const auto& entry : now_.away)
        if (!isBesideLoaded(entry.first)) now_.alone.insert(entry.first);
      return;
    case Kind::leave:
      for (const Cell chunk : leaving(call.cells)) {
        if (stays(chunk, world)) continue;
        now_.chunks.erase(chunk);
        now_.away.erase(chunk);
      }
      return;
    case Kind::unload:
      return unload(call.cells);
    case Kind::reload:
      for (const Cell chunk : comingBack(call.cells)) reload(chunk, world);
      return;
    case Kind::reloadEmpty:
      for (const Cell chunk : chunksWithin(call.cells, false)) empty(chunk);
      return;
    case Kind::mark:
      return timeline_.mark(now_);
    case Kind::goBack:
      if (hasMarks()) goTo(timeline_.back(call.nth, call.keeps != Call::Keeps::never));
      return;
    case Kind::goForward:
      if (hasAhead()) goTo(timeline_.forward(call.nth));
      return;
    case Kind::forget:
      if (hasMarks()) timeline_.forget(call.nth);
      return;
    case Kind::load:
      return timeline_.clear();
    case Kind::replace:
      clear({call.comes[0].cell, call.comes[0].cell});
      break;
    default:
      break;
  }
  for (const Named& named : call.goes) now_.standing.remove(named.name);
  for (const Coming& coming : call.comes) next(call.kind == Kind::exchange ? call.cells.min : coming.cell, coming);
}

bool Model::play(const Call& call) {
  if (call.kind == Kind::repeat) {
    for (std::uint32_t k = 0; k < call.nth; ++k)
      for (const Call& part : call.group) play(part);
    return true;
  }
  if (call.kind == Kind::group) {
    const State before = now_;
    const Redo redo = timeline_.redo();
    bool keeps = call.keeps != Call::Keeps::never;
    for (const Call& part : call.group) {
      if (play(part) || call.keeps != Call::Keeps::ifAll) continue;
      keeps = false;
      break;
    }
    if (!keeps) restore(before, redo);
    return true;
  }
  const Call made = resolved(call);
  const bool isAccepted = judgeResolved(made).accepted;
  if (isAccepted) apply(made);
  return isAccepted;
}

// --- What is wrong with an answer

std::string Model::wrongAnswer(const Call& call, const Verdict& verdict, const Outcome& outcome,
                               const World& world) const {
  if (verdict.accepted || (verdict.isOpen && !outcome.refusal)) {
    if (outcome.refusal && !verdict.isOpen) return "refused, but is good: " + message(*outcome.refusal);
    if (!outcome.refusal) {
      std::string wrong = wrongHandles(call, outcome);
      return wrong.empty() ? wrongChunks(call, outcome) : wrong;
    }
  }
  if (!outcome.refusal)
    return fmt::format("accepted, but must be refused{}",
                       verdict.code ? fmt::format(" as {}", name(*verdict.code)) : "");
  const Error& error = *outcome.refusal;
  if (!verdict.code) return "";
  if (error.code != *verdict.code)
    return fmt::format("refused as {} instead of {}", name(error.code), name(*verdict.code));
  if (error.cell != verdict.cell)
    return fmt::format("refused in cell {} instead of {}", cellInWords(error.cell), cellInWords(verdict.cell));
  if (message(error).empty()) return "refused without a word";
  if (std::string wrong = wrongPart(call, error); !wrong.empty()) return "the refusal " + wrong;
  if (error.index != verdict.index) return fmt::format("blames entry {} instead of {}", error.index, verdict.index);
  const auto isNamed = [&](const Named& named) { return named.handle == error.other; };
  if (error.code == ErrorCode::staleHandle && std::ranges::none_of(call.goes, isNamed))
    return "names no handle of the call";
  const bool isAmongPlaced = error.code == ErrorCode::overlap && error.hasCell();
  return isAmongPlaced ? wrongOverlap(error, call, world) : "";
}

// New ones, as many as come; and those that are told are these.
std::string Model::wrongHandles(const Call& call, const Outcome& outcome) const {
  const std::vector<PolygonHandle>& handles = outcome.handles;
  if (std::ranges::any_of(handles, [&](PolygonHandle h) { return standing().nameOf(h) != nullptr; }))
    return "gives the handle of another polygon";
  std::vector<PolygonHandle> told = handles;
  if (call.kind == Kind::addMany) {
    told.clear();
    std::size_t first = 0;
    for (const Coming& coming : call.comes) {
      told.push_back(handles[first]);
      first += coming.shape.size();
    }
  }
  const bool isReturned = call.kind == Kind::add || call.kind == Kind::addShape || call.kind == Kind::replace;
  if (isReturned) told.insert(told.begin(), handles[0]);
  told.resize(outcome.told.size(), Caller::kUntouched);
  if (told != outcome.told) return "tells other handles than those of what it placed";
  std::size_t count = outcome.count;
  if (call.kind == Kind::fill) count = cellsOf(call.cells).size();
  if (call.kind == Kind::clear) count = isEmpty(call.cells) ? 0 : standing().polygonsIn(call.cells);
  if (call.kind == Kind::load) count = 0;
  return outcome.count == count ? "" : fmt::format("counts {} instead of {}", outcome.count, count);
}

// Which chunks went, or came.
std::string Model::wrongChunks(const Call& call, const Outcome& outcome) const {
  const auto counts = [&](std::size_t expected, std::size_t fewer = 0) {
    return expected - fewer <= outcome.count && outcome.count <= expected
               ? ""
               : fmt::format("counts {} chunks instead of {}", outcome.count, expected);
  };
  std::set<Cell> expected;
  if (call.kind == Kind::unload) {
    const auto chunks = isEmpty(call.cells) ? std::vector<Cell>() : chunksWithin(call.cells, true);
    for (const Cell chunk : chunks) expected.insert(cellsOfChunk(chunk).min);
    if (expected != std::set(outcome.chunks.begin(), outcome.chunks.end())) return "hands out other chunks";
    return counts(outcome.chunks.size());
  }
  if (call.kind == Kind::reload) {
    for (const Cell chunk : comingBack(call.cells)) expected.insert(cellsOfChunk(chunk).min);
    return expected == std::set(outcome.chunks.begin(), outcome.chunks.end()) ? "" : "other chunks come back";
  }
  if (call.kind == Kind::reloadEmpty) return counts(isEmpty(call.cells) ? 0 : chunksWithin(call.cells, false).size());
  return call.kind == Kind::leave ? counts(leaving(call.cells).size(), mayStay(call.cells)) : "";
}

Scene Model::scene(PreservePairs preserve) const {
  Scene scene{standing().polygonsOfAll(), std::move(preserve)};
  for (const auto& [chunk, content] : now_.away)
    for (const auto& [cell, there] : content)
      for (const Standing::Placed& p : there) scene.polygons.push_back({cell, p.block, p.vertices});
  return scene;
}

Trace withoutRefused(const Trace& trace) {
  Model model;
  Trace accepted{trace.preserve, {}};
  for (const Call& call : trace.calls)
    if (call.kind == Kind::brush ? model.judge(call).accepted : model.play(call)) accepted.calls.push_back(call);
  return accepted;
}

}  // namespace lgs::oracle
