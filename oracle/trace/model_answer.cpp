// What is wrong with the answer to a call.
#include "oracle/reference/blame.h"
#include "oracle/trace/model.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace lgs::oracle {

using Kind = Call::Kind;

namespace {

std::string cellInWords(Cell cell) {
  return cell == Error::kNoCell ? "no cell" : fmt::format("({}, {})", cell.i, cell.j);
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
  if (call.kind == Kind::brush && error.code == ErrorCode::outOfReach)
    return std::pair(error.polygon, error.vertex) == vertexInNoCell(call.brush) ? "" : "blames another vertex";
  const bool isOfOne = call.kind == Kind::add || call.kind == Kind::addShape || call.kind == Kind::shape ||
                       call.kind == Kind::replace || call.kind == Kind::fill;
  const bool isSpoilt = isReal(call.notation) && call.offset >= kSpoiltOffset;
  if (!isOfOne || isSpoilt || call.comes[0].id != 0 || call.comes[0].shape.size() != 1) return "";
  return wrongBlame(error, call.comes[0].shape[0]);
}

}  // namespace

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
  if (call.kind == Kind::brush && verdict.isOpen) {  // one of many cells
    const bool isUnder = contains(cellsUnder(call.brush), error.cell);
    return isUnder && isLoaded(error.cell) == (error.code != ErrorCode::unloaded) ? "" : "blames another cell";
  }
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
  std::uint64_t count = outcome.count;
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

}  // namespace lgs::oracle
