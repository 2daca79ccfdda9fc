#include "oracle/trace/call_model.h"

#include "oracle/reference/blame.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace lgs::oracle {
namespace {

using Kind = Call::Kind;

std::string cellInWords(Cell cell) {
  return cell == Error::kNoCell ? "no cell" : fmt::format("({}, {})", cell.i, cell.j);
}

// A single polygon may be given in reals, and one of them may be none.
std::optional<ErrorCode> faultOf(const Call& call, const Shape& shape) {
  const bool isSpoilt = isReal(call.notation) && call.offset >= kSpoiltOffset && shape.size() == 1;
  if (!isSpoilt || shape[0].size() < 3) return oracle::faultOf(std::span(shape));
  if (shape[0].size() > kMaxVerticesPerCell) return ErrorCode::capacity;
  return call.offset == kOffsets - 1 ? ErrorCode::outsideCell : ErrorCode::notFinite;
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

// Whether a rectangle in range reaches far more chunks of 32×32 cells than a world has room for. Random calls make none
// that is near that.
bool isTooLarge(const CellRect& r) {
  const auto chunks = [](std::int32_t min, std::int32_t max) { return (std::int64_t{max} >> 5) - (min >> 5) + 1; };
  return chunks(r.min.i, r.max.i) * chunks(r.min.j, r.max.j) > 2 * static_cast<std::int64_t>(kMaxChunks);
}

void remove(Model& standing, PolygonHandle handle) {
  standing.apply(Edit::remove(std::string(*standing.nameOf(handle))));
}

void place(Model& standing, Cell cell, const Coming& coming, std::span<const PolygonHandle> handles,
           std::span<const std::string> names) {
  for (std::size_t k = 0; k < coming.shape.size(); ++k) {
    const auto [cellRef, serial] = handles[k];
    standing.apply(Edit::add(names.empty() ? fmt::format("{}:{}", cellRef, serial) : names[k],
                             {cell, coming.block, coming.shape[k]}),
                   handles[k]);
  }
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
  if (error.code == ErrorCode::capacity) return error.vertex == -1 ? "" : "names a vertex, which is not to blame";
  const bool isOfOne = call.kind == Kind::add || call.kind == Kind::addShape || call.kind == Kind::shape ||
                       call.kind == Kind::replace || call.kind == Kind::fill;
  const bool isSpoilt = isReal(call.notation) && call.offset >= kSpoiltOffset;
  if (!isOfOne || isSpoilt || call.comes[0].id != 0 || call.comes[0].shape.size() != 1) return "";
  return wrongBlame(error, call.comes[0].shape[0]);
}

}  // namespace

PreserveRelation relationOf(const PreservePairs& pairs) {
  if (pairs.empty()) return {};
  return [pairs](Block a, Block b) { return pairs(a, b); };
}

Verdict CallModel::judge(const Call& call) const {
  if (call.kind == Kind::add) {
    const Coming& coming = call.comes[0];
    if (!inRange(coming.cell)) return {false, ErrorCode::cellOutOfRange, coming.cell};
    if (const auto fault = faultOf(call, coming.shape)) return {false, fault, coming.cell};
  }
  if (call.kind == Kind::shape || isByShape(call.kind)) {
    for (const Coming& coming : call.comes)
      if (const auto fault = faultOf(call, coming.shape); fault && coming.id == 0) return {false, fault};
  }
  return judgeParts(call);
}

// What comes one after the other is tried on a copy.
Verdict CallModel::judgeParts(const Call& call) const {
  const auto addingTo = [](const Model& standing, Cell cell, const Coming& coming) -> Verdict {
    if (!inRange(cell)) return {false, ErrorCode::cellOutOfRange, cell};
    if (coming.id != 0 && coming.shape.empty()) return {false, ErrorCode::unknownShape, cell};
    const auto refusal = standing.refusalIn(cell, coming.shape);
    return refusal ? Verdict{false, refusal, cell} : Verdict{};
  };
  switch (call.kind) {
    case Kind::add:
    case Kind::addShape:
      return addingTo(standing_, call.comes[0].cell, call.comes[0]);
    case Kind::replace:
      return addingTo(Model(), call.comes[0].cell, call.comes[0]);
    case Kind::fill: {
      const auto& [min, max] = call.cells;
      if (min.i > max.i || min.j > max.j) return {};
      if (const auto verdict = outOfRange(call.cells)) return *verdict;
      if (isTooLarge(call.cells)) {
        const bool isUnknown = call.comes[0].id != 0 && call.comes[0].shape.empty();
        return {false, isUnknown ? ErrorCode::unknownShape : ErrorCode::capacity, call.cells.min};
      }
      for (const Cell cell : cellsOf(call.cells))
        if (auto verdict = addingTo(standing_, cell, call.comes[0]); !verdict.accepted) return verdict;
      return {};
    }
    case Kind::clear:
    case Kind::leave: {
      const auto& [min, max] = call.cells;
      if (min.i > max.i || min.j > max.j) return {};
      if (const auto verdict = outOfRange(call.cells)) return *verdict;
      return call.kind == Kind::leave && !marks_.empty() ? Verdict{false, ErrorCode::uncommitted} : Verdict{};
    }
    case Kind::remove:
    case Kind::setBlock:
      return isAlive(call.goes[0].handle) ? Verdict{} : Verdict{false, ErrorCode::staleHandle};
    case Kind::addMany: {
      std::set<Cell> cells;
      for (const Coming& coming : call.comes) cells.insert(coming.cell);
      Model tried = standing_.part(cells);
      for (std::size_t k = 0; k < call.comes.size(); ++k) {
        const Coming& coming = call.comes[k];
        auto verdict = addingTo(tried, coming.cell, coming);
        verdict.index = static_cast<int>(k);
        if (!verdict.accepted) return verdict;
        const auto number = static_cast<std::uint32_t>(k << 8);  // handles that are not given out: of no cell
        std::vector<PolygonHandle> handles;
        for (std::size_t m = 0; m < coming.shape.size(); ++m)
          handles.push_back({0, number + static_cast<std::uint32_t>(m)});
        place(tried, coming.cell, coming, handles, {});
      }
      return {};
    }
    case Kind::removeMany: {
      std::set<PolygonHandle> gone;
      for (std::size_t k = 0; k < call.goes.size(); ++k)
        if (!isAlive(call.goes[k].handle) || !gone.insert(call.goes[k].handle).second)
          return {false, ErrorCode::staleHandle, Error::kNoCell, static_cast<int>(k)};
      return {};
    }
    case Kind::exchange: {
      const Cell cell = call.cells.min;
      if (!inRange(cell)) return {false, ErrorCode::cellOutOfRange, cell};
      Model tried = standing_.part({cell});
      std::vector<Verdict> verdicts;
      for (std::size_t k = 0; k < call.goes.size() && verdicts.empty(); ++k) {
        const PolygonHandle handle = call.goes[k].handle;
        if (tried.nameOf(handle) != nullptr)
          remove(tried, handle);
        else
          verdicts.push_back({false, ErrorCode::staleHandle, cell, static_cast<int>(k)});
      }
      Shape comes;
      for (const Coming& coming : call.comes) comes.push_back(coming.shape[0]);
      const auto fault = comes.empty() ? std::nullopt : oracle::faultOf(std::span<const LocalPolygon>(comes));
      const auto refusal = fault ? std::nullopt : tried.refusalIn(cell, comes);
      if (fault || refusal) verdicts.push_back({false, fault ? fault : refusal, cell});
      if (verdicts.size() > 1) return {false, std::nullopt, cell};
      return verdicts.empty() ? Verdict{} : verdicts[0];
    }
    default:
      return {};
  }
}

void CallModel::clear(const CellRect& cells) {
  std::vector<std::string> gone;
  for (const auto& [cell, placed] : standing_.cells())
    for (const Model::Placed& p : placed)
      if (contains(cells, cell)) gone.push_back(p.name);
  for (const std::string& name : gone) standing_.apply(Edit::remove(name));
}

void CallModel::apply(const Call& call, std::span<const PolygonHandle> handles, std::span<const std::string> names) {
  const auto next = [&](Cell cell, const Coming& coming) {
    place(standing_, cell, coming, handles, names);
    handles = handles.subspan(coming.shape.size());
    if (!names.empty()) names = names.subspan(coming.shape.size());
  };
  switch (call.kind) {
    case Kind::setBlock: {
      const PolygonHandle handle = call.goes[0].handle;
      const std::string name = *standing_.nameOf(handle);
      ScenePolygon polygon = standing_[name];
      polygon.block = call.comes[0].block;
      standing_.apply(Edit::remove(name));
      return standing_.apply(Edit::add(names.empty() ? name : names[0], std::move(polygon)), handle);
    }
    case Kind::clear:
      return clear(call.cells);
    case Kind::fill:
      for (const Cell cell : cellsOf(call.cells)) next(cell, call.comes[0]);
      return;
    case Kind::shape:
    case Kind::leave:
      return;
    case Kind::mark:
      marks_.push_back(standing_);
      return;
    case Kind::goBack:
      if (marks_.empty()) return;
      standing_ = marks_[call.nth % marks_.size()];
      marks_.resize(call.nth % marks_.size() + 1);
      return;
    case Kind::forget:
      if (!marks_.empty()) marks_.erase(marks_.begin() + static_cast<std::ptrdiff_t>(call.nth % marks_.size()));
      return;
    case Kind::load:
      marks_.clear();
      return;
    case Kind::replace:
      clear({call.comes[0].cell, call.comes[0].cell});
      break;
    default:
      break;
  }
  for (const Named& named : call.goes) remove(standing_, named.handle);
  for (const Coming& coming : call.comes) next(call.kind == Kind::exchange ? call.cells.min : coming.cell, coming);
}

std::string CallModel::wrongAnswer(const Call& call, Verdict verdict, const Outcome& outcome,
                                   const World& world) const {
  if (call.kind == Kind::leave && verdict.accepted && !isEmpty(call.cells) && !world.save({}))  // edits are pending
    verdict = {false, ErrorCode::uncommitted};
  if (verdict.accepted)
    return outcome.refusal ? "refused, but is good: " + message(*outcome.refusal) : wrongHandles(call, outcome);
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
std::string CallModel::wrongHandles(const Call& call, const Outcome& outcome) const {
  const std::vector<PolygonHandle>& handles = outcome.handles;
  if (std::ranges::any_of(handles, [&](PolygonHandle h) { return isAlive(h); }))
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
  if (call.kind == Kind::leave) return "";  // nobody says which chunks there are
  std::size_t count = 0;
  const auto& [min, max] = call.cells;
  const bool isNone = min.i > max.i || min.j > max.j;
  if (call.kind == Kind::fill && !isNone) count = cellsOf(call.cells).size();
  if (call.kind == Kind::clear && !isNone) count = standing_.polygonsIn(call.cells);
  return outcome.count == count ? "" : fmt::format("counts {} instead of {}", outcome.count, count);
}

}  // namespace lgs::oracle
