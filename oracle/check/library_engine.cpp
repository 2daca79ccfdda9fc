#include "oracle/check/library_engine.h"

#include "oracle/check/observed.h"
#include "oracle/check/questions.h"
#include "oracle/trace/call_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>
#include <functional>

namespace lgs::oracle {
namespace {

// Some polygons hold their islands, wherever they are.
bool isAnchor(Block block, Cell cell) { return block % 3 == 1 || (std::int64_t{cell.i} + cell.j) % 5 == 0; }

// Whether a refusal left all counts as they were. It may leave new shapes.
bool sameCounts(const Stats& a, const Stats& b) {
  return a.polygons == b.polygons && a.cells == b.cells && a.segments == b.segments && a.chunks == b.chunks;
}

std::optional<Complaint> reading(std::optional<WrongRead> wrong) {
  if (!wrong) return std::nullopt;
  return Complaint{Mismatch::Kind::reading, std::move(wrong->text), std::move(wrong->about)};
}

}  // namespace

void LibraryEngine::reset(const PreservePairs& preserve) {
  player_.emplace(preserve);
  views_.reset();
  if (followsViews_ && player_->world().followCells(true))
    views_.emplace(Followed{Islands(player_->world(), isAnchor), IslandCheck(isAnchor), Pieces(player_->world()),
                            PieceCheck(), GroundHashes(player_->world())});
  mirror_ = {};
  stale_.clear();
  refused_.clear();
  wasAway_ = false;
}

void LibraryEngine::add(const std::string& name, const ScenePolygon& polygon) {
  if (const auto done = player_->apply(Call::add(name, polygon)); !done) refused_.push_back({name, done.error().text});
}

void LibraryEngine::remove(const std::string& name) {
  if (const auto done = player_->apply(Call::remove(name)); !done) refused_.push_back({name, done.error().text});
}

Engine::Refusals LibraryEngine::commit() {
  changes_ = &player_->commit(std::exchange(executor_, 0));
  return std::exchange(refused_, {});
}

Outline LibraryEngine::outlineIn(const CellSet& cells) const {
  Outline outline;
  for (const Cell& cell : cells) {
    for (const SegmentId id : player_->world().segments(CellRect{cell, cell})) {
      if (const auto segment = player_->world().segment(id)) outline.push_back(outlineSegment(*segment));
    }
  }
  std::sort(outline.begin(), outline.end());
  return outline;
}

tl::expected<std::optional<Complaint>, TraceError> LibraryEngine::apply(const Call& call, const Judged& judged) {
  const bool isSingle = call.kind != Call::Kind::group && call.kind != Call::Kind::repeat;
  const Verdict& verdict = judged.verdict;
  std::vector<PolygonHandle> removed;
  for (const Named& named : judged.call.goes)
    if (isSingle && verdict.accepted && call.kind != Call::Kind::setBlock) removed.push_back(named.handle);
  const bool mayBeRefused = isSingle && (!verdict.accepted || verdict.isOpen);
  const Stats before = mayBeRefused ? player_->world().stats() : Stats();
  const bool isNowhere = (call.kind == Call::Kind::goBack && !model().hasMarks()) ||
                         (call.kind == Call::Kind::goForward && !model().hasAhead());
  const auto done = isSingle ? player_->make(judged) : player_->apply(call);
  if (!done && done.error().isWrong) return Complaint{Mismatch::Kind::verdict, done.error().text};
  if (done && isNowhere) return std::nullopt;
  if (done) return isEdit(call.kind) ? checkStale(removed) : afterTravel(call.kind);
  if (auto complaint = afterRefusal(judged.call, before)) return complaint;
  refused_.push_back({call.name(), done.error().text});
  return tl::unexpected(done.error());
}

// Handles that were stale may be valid again, or void.
std::optional<Complaint> LibraryEngine::afterTravel(Call::Kind kind) {
  const World& world = player_->world();
  stale_.clear();
  wasAway_ = wasAway_ || !model().isWhole();
  if (kind == Call::Kind::load) views_.reset();  // a world that was loaded follows nothing
  if (kind == Call::Kind::group || kind == Call::Kind::repeat) return reading(readPolygons(*player_));
  if (kind != Call::Kind::goBack && kind != Call::Kind::goForward) return std::nullopt;
  using After = Mirror::After;
  const auto after = player_->pending() ? After::goingBackToPending : After::goingBack;
  if (auto problem = mirror_.update(world, world.changesOfRollBack(), after))
    return Complaint{Mismatch::Kind::changes, std::move(*problem), mirror_.blamed()};
  if (auto complaint = reading(readPolygons(*player_))) return complaint;
  changes_ = &world.changesOfRollBack();
  if (player_->pending()) views_.reset();  // what follows from the outline of then is not that of the polygons
  return views_ ? checkViews() : std::nullopt;
}

std::optional<Complaint> LibraryEngine::afterRefusal(const Call& call, const Stats& before) const {
  std::set<Cell> cells{call.cells.min, call.cells.max};
  for (const Coming& coming : call.comes) cells.insert(coming.cell);
  for (const Named& named : call.goes)
    if (player_->isAlive(named.name)) cells.insert(player_->standing().cellOf(named.name));
  const bool isSame = std::ranges::none_of(
      cells, [&](Cell cell) { return readCell(player_->world(), player_->standing(), cell).has_value(); });
  const bool isSameAll = call.kind != Call::Kind::brush || !readPolygons(*player_);
  if (isSame && isSameAll && sameCounts(player_->world().stats(), before)) return std::nullopt;
  return Complaint{Mismatch::Kind::refusal, fmt::format("the refusal changed something: {}", printCall(call))};
}

std::optional<Complaint> LibraryEngine::checkStale(const std::vector<PolygonHandle>& handles) {
  World& world = player_->world();
  for (const PolygonHandle handle : handles) {
    const auto again = world.remove(handle);
    if (again || again.error().code != ErrorCode::staleHandle || again.error().other != handle ||
        world.polygon(handle) || world.cellOf(handle)) {
      return Complaint{Mismatch::Kind::verdict, "the handle of a removed polygon is not stale"};
    }
    stale_.push_back(handle);
  }
  return std::nullopt;
}

std::optional<Complaint> LibraryEngine::afterCommit(const CellSet& edited) {
  if (auto problem = mirror_.update(player_->world(), *changes_))
    return Complaint{Mismatch::Kind::changes, std::move(*problem), mirror_.blamed()};
  for (const Cell& cell : edited)
    if (auto complaint = reading(readCell(player_->world(), player_->standing(), cell))) return complaint;
  return views_ ? checkViews() : std::nullopt;
}

std::optional<Complaint> LibraryEngine::checkViews() {
  const World& world = player_->world();
  auto& [islands, islandCheck, pieces, pieceCheck, hashes] = *views_;
  if (!islands.update(world, *changes_)) return Complaint{Mismatch::Kind::views, "the views refuse what was committed"};
  hashes.update(world.cellChanges());
  auto wrong = islandCheck.update(world, islands);
  if (!wrong) wrong = pieceCheck.update(world, pieces, pieces.update(world.cellChanges()));
  if (!wrong) wrong = faultOf(hashes, world);
  if (!wrong) return std::nullopt;
  return Complaint{Mismatch::Kind::views, std::move(*wrong)};
}

std::optional<Complaint> LibraryEngine::readAll(const Outline& whole, std::size_t questions) {
  const World& world = player_->world();
  const auto isThere = [&](PolygonHandle handle) { return world.polygon(handle).has_value(); };
  if (std::ranges::any_of(stale_, isThere))
    return Complaint{Mismatch::Kind::reading, "the handle of a removed polygon names another one now"};
  if (auto complaint = reading(readPolygons(*player_))) return complaint;
  if (auto complaint = reading(readSegments(world, mirror_.segments(), wasAway_))) return complaint;
  if (auto complaint = reading(readLoops(world, mirror_.segments()))) return complaint;
  Random random(whole.size());
  std::string wrong = wrongAnswers(world, player_->scene(), whole, random, questions);
  if (wrong.empty()) wrong = wrongComparison(world);
  return wrong.empty() ? std::nullopt : std::optional(Complaint{Mismatch::Kind::reading, std::move(wrong)});
}

std::optional<Complaint> LibraryEngine::compareWithPast() const {
  if (!player_->hasLeft() || !player_->isOfOnePast()) return std::nullopt;
  std::string wrong = wrongPast(*player_);
  return wrong.empty() ? std::nullopt : std::optional(Complaint{Mismatch::Kind::past, std::move(wrong)});
}

Loops LibraryEngine::loops() const {
  Loops loops;
  for (Loop& loop : player_->world().loops(Collinear::merge)) loops.push_back(std::move(loop.vertices));
  return loops;
}

tl::expected<Outline, TraceError> LibraryEngine::outlineAtOnce(const Trace& trace) {
  Player fresh(trace.preserve);
  for (const Call& call : trace.calls)
    if (const auto done = fresh.apply(call); !done) return tl::unexpected(done.error());
  constexpr std::uint32_t kLastFirst = 2;  // threads would share the jobs of this executor: their order must not matter
  fresh.commit(kLastFirst);
  return outlineOf(fresh.world());
}

}  // namespace lgs::oracle
