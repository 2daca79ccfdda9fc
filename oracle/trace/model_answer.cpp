// What is wrong with the answer to a call.
#include "oracle/reference/blame.h"
#include "oracle/trace/model.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>
#include <tuple>

namespace lgs::oracle {

using Kind = Call::Kind;

namespace {

std::string cellInWords(Cell cell) {
  return cell == Error::kNoCell ? "no cell" : fmt::format("({}, {})", cell.i, cell.j);
}

// The polygons that an error counts: of addMany() and put() those of the entry to blame, or of the first shape that can not be made.
Shape countedBy(const Error& error, const Call& call) {
  Shape all;
  if (call.kind != Kind::addMany && call.kind != Kind::put)
    for (const Coming& coming : call.comes) all.insert(all.end(), coming.shape.begin(), coming.shape.end());
  else if (error.index >= 0)
    all = call.comes[static_cast<std::size_t>(error.index)].shape;
  else if (const auto bad = std::ranges::find_if(
               call.comes, [&](const Coming& c) { return c.id == 0 && faultOf(call, c.shape).has_value(); });
           bad != call.comes.end())
    all = bad->shape;
  return all;
}

// It names the first polygon of those that come that overlaps one before it, and of those the one that came first.
std::string wrongOverlap(const Error& error, const Call& call, const World& world) {
  if (call.kind == Kind::addMany && error.index2 >= 0) return "";  // with another entry's, which has no handle
  const Shape comes = countedBy(error, call);
  std::vector<PlacedPolygon> there = world.polygons(error.cell);
  std::erase_if(there, [&](const PlacedPolygon& p) {
    return std::ranges::any_of(call.goes, [&](const Named& named) { return named.handle == p.handle; });
  });
  std::ranges::sort(there, {}, [](const PlacedPolygon& p) { return p.handle.serial; });
  const auto blames = [&](std::size_t polygon, std::int32_t polygon2, PolygonHandle other, Block block) {
    return std::tuple(error.polygon, error.polygon2, error.other, error.otherBlock) ==
                   std::tuple(static_cast<std::int32_t>(polygon), polygon2, other, block)
               ? ""
               : "names another overlap than that of the first polygon, with the oldest one";
  };
  for (std::size_t k = 0; k < comes.size(); ++k) {
    for (const PlacedPolygon& p : there)
      if (overlap(comes[k], {p.vertices.begin(), p.vertices.end()})) return blames(k, -1, p.handle, p.block);
    for (std::size_t l = 0; l < k; ++l)
      if (overlap(comes[k], comes[l])) return blames(k, static_cast<std::int32_t>(l), {}, 0);
  }
  return "names an overlap, and there is none";
}

// What the refusal of a call that brings polygons says of these.
std::string wrongPart(const Call& call, const Error& error) {
  if (error.code == ErrorCode::capacity || error.code == ErrorCode::unloaded)
    return error.vertex == -1 ? "" : "names a vertex, which is not to blame";
  if (call.kind == Kind::brush && error.code == ErrorCode::outOfReach)
    return std::pair(error.polygon, error.vertex) == vertexInNoCell(call.brush) ? "" : "blames another vertex";
  const bool brings = call.kind == Kind::add || call.kind == Kind::shape || call.kind == Kind::exchange ||
                      (isByShape(call.kind) && !(call.comes.size() == 1 && call.comes[0].id != 0));
  const bool isSpoilt = isReal(call.notation) && call.offset >= kSpoiltOffset;
  if (!brings || isSpoilt || error.code == ErrorCode::staleHandle) return "";
  const Shape counted = countedBy(error, call);
  return counted.empty() ? "" : wrongBlame(error, counted);
}

}  // namespace

std::string Model::wrongAnswer(const Call& call, const Verdict& verdict, const Outcome& outcome,
                               const World& world) const {
  if (verdict.accepted || (verdict.isOpen && !outcome.refusal)) {
    if (outcome.refusal && !verdict.isOpen) return "refused, but is good: " + message(*outcome.refusal);
    if (!outcome.refusal) {
      std::string wrong = wrongHandles(call, outcome);
      if (wrong.empty()) wrong = wrongBodies(call, outcome);
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
  if (error.code == ErrorCode::staleHandle && call.kind != Kind::take && std::ranges::none_of(call.goes, isNamed))
    return "names no handle of the call";
  return error.code == ErrorCode::overlap ? wrongOverlap(error, call, world) : "";
}

// New ones that name nothing yet, as many as come, none twice while no chunk was forgotten; and those that are told are
// these.
std::string Model::wrongHandles(const Call& call, const Outcome& outcome) const {
  const std::vector<PolygonHandle>& handles = outcome.handles;
  if (std::ranges::any_of(handles, [&](PolygonHandle h) { return standing().nameOf(h) != nullptr; }))
    return "gives the handle of another polygon";
  constexpr std::ptrdiff_t kRecent = 1'024;
  const auto recent = now_.given.end() - std::min(kRecent, std::ssize(now_.given));
  if (!hasForgotten_ && std::any_of(recent, now_.given.end(), [&](const Given& given) {
        return given.handle && std::ranges::find(handles, given.handle) != handles.end();
      }))
    return "gives a handle again";
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
  if (call.kind != Kind::leave) return "";
  const std::size_t stay = owing(call.cells, Owed::sure);
  return counts(leaving(call.cells).size() - stay, owing(call.cells, Owed::maybe) - stay);
}

}  // namespace lgs::oracle
