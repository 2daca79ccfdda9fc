// Whether a call must be accepted, and else why not.
#include "oracle/reference/validity.h"
#include "oracle/reference/vector.h"
#include "oracle/trace/model.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <lgs/brush.h>
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace lgs::oracle {

using Kind = Call::Kind;

namespace {

std::optional<Verdict> outOfRange(const CellRect& cells) {
  for (const Cell corner : {cells.min, cells.max})
    if (!inRange(corner)) return Verdict{false, ErrorCode::cellOutOfRange, corner};
  return std::nullopt;
}

// Whether a brush may leave more in a cell than that has room for. Each two edges cross once at most, and the parts
// between them are no more than the points where edges meet.
bool mayBeTooMuch(const BrushEdit& brush, const Standing& standing) {
  std::size_t edges = 0, there = 0;
  for (const std::vector<Point>& ring : brush.rings) edges += ring.size();
  const CellRect cells = cellsUnder(brush);
  for (const auto& [cell, placed] : standing.cells()) {
    if (!contains(cells, cell)) continue;
    std::size_t vertices = 0;
    for (const Standing::Placed& p : placed) vertices += p.vertices.size();
    there = std::max(there, vertices);
  }
  constexpr std::size_t kOfRim = 8;
  return edges * edges / 2 + edges * there + 3 * edges + there + kOfRim > kMaxPolygonsPerCell;
}

// Whether a region has more edges in one cell than it may, or in one with ground more crossings of its edges.
bool isTooMuch(const BrushEdit& brush, const Standing& standing) {
  const CellRect cells = cellsUnder(brush);
  if (cells.min != cells.max) return false;
  std::vector<std::pair<Point, Point>> edges;
  for (const std::vector<Point>& ring : brush.rings)
    for (std::size_t k = 0; k < ring.size(); ++k)
      if (const Point a = ring[k], b = ring[(k + 1) % ring.size()]; a != b) edges.emplace_back(a, b);
  if (edges.size() > kMaxRegionEdgesPerCell) return true;
  const auto parts = [](Point a, Point b, Point p, Point q) {
    const std::int64_t one = cross(b - a, p - a), other = cross(b - a, q - a);
    return (one < 0 && other > 0) || (one > 0 && other < 0);
  };
  std::size_t crossings = 0;
  for (const auto& [a, b] : edges)
    for (const auto& [c, d] : edges) crossings += parts(a, b, c, d) && parts(c, d, a, b) ? 1 : 0;  // each twice
  return crossings > 2 * kMaxCrossingsPerCell && !standing.in(cells.min).empty();
}

}  // namespace

bool isTooLarge(const CellRect& r) {
  const auto chunks = [](std::int32_t min, std::int32_t max) { return (std::int64_t{max} >> 5) - (min >> 5) + 1; };
  return chunks(r.min.i, r.max.i) * chunks(r.min.j, r.max.j) > 2 * static_cast<std::int64_t>(kMaxChunks);
}

std::optional<ErrorCode> faultOf(const Call& call, const Shape& shape) {
  const bool isSpoilt = isReal(call.notation) && call.offset >= kSpoiltOffset && shape.size() == 1;
  if (!isSpoilt || shape[0].size() < 3) return oracle::faultOf(std::span(shape));
  if (shape[0].size() > kMaxVerticesPerCell) return ErrorCode::capacity;
  return call.offset == kOffsets - 1 ? ErrorCode::outsideCell : ErrorCode::notFinite;
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
    case Kind::take:
      return judgeTake(call);
    case Kind::put:
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
    case Kind::redo:
      if (!hasAhead() || timeline_.redo() == Redo::sure) return {};
      return {.accepted = false, .code = ErrorCode::unknownMark, .isOpen = timeline_.redo() == Redo::maybe};
    case Kind::follow:
      if (hasMarks() || now_.pending == Pending::sure) return {false, ErrorCode::uncommitted};
      return now_.pending == Pending::no ? Verdict{} : Verdict{.code = ErrorCode::uncommitted, .isOpen = true};
    case Kind::load: {
      const auto away = firstAway({{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}});
      return away ? Verdict{false, ErrorCode::unloaded, *away} : Verdict{};
    }
    case Kind::brush:  // which cells it reaches is not known beforehand, nor whether a cell is full if much comes
      if (isOutOfReach(call.brush)) return {false, ErrorCode::outOfReach};
      if (firstAway(cellsUnder(call.brush))) return {.code = ErrorCode::unloaded, .isOpen = true};
      if (isTooMuch(call.brush, standing())) return {false, ErrorCode::capacity, cellsUnder(call.brush).min};
      if (mayBeTooMuch(call.brush, standing())) return {.code = ErrorCode::capacity, .isOpen = true};
      return {};
    default:
      return {};
  }
}

}  // namespace lgs::oracle
