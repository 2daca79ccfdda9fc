#include "oracle/check/library_engine.h"

#include "oracle/trace/row.h"

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
  // Views can not follow into a world that was loaded: that follows nothing.
  player_.emplace(preserve, followsViews_ ? Loads::never : Loads::sometimes);
  views_.reset();
  if (followsViews_ && player_->world().followCells(true))
    views_.emplace(Followed{Islands(player_->world(), isAnchor), IslandCheck(isAnchor), Pieces(player_->world()),
                            PieceCheck(), GroundHashes(player_->world())});
  mirror_ = {};
  stale_.clear();
  refused_.clear();
}

void LibraryEngine::add(const std::string& name, const ScenePolygon& polygon) {
  if (const auto done = player_->apply(Edit::add(name, polygon)); !done) refused_.push_back({name, done.error().text});
}

void LibraryEngine::remove(const std::string& name) {
  if (const auto done = player_->apply(Edit::remove(name)); !done) refused_.push_back({name, done.error().text});
}

Engine::Refusals LibraryEngine::commit() {
  changes_ = &player_->commit();
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

tl::expected<std::optional<Complaint>, TraceError> LibraryEngine::apply(const Row& row) {
  std::vector<PolygonHandle> removed;
  for (const Edit& edit : row.edits) {
    const bool isRemoval = row.verdict.accepted && edit.kind == Edit::Kind::remove;
    if (isRemoval && row.way.door != Door::setBlock) removed.push_back(player_->handleOf(edit.name));
  }
  const Stats before = row.verdict.accepted ? Stats() : player_->world().stats();
  const auto done = player_->apply(row);
  if (!done && done.error().isWrong) return Complaint{Mismatch::Kind::verdict, done.error().text};
  if (done) return checkStale(removed);
  if (auto complaint = afterRefusal(row, before)) return complaint;
  if (row.isTrial) return std::nullopt;
  refused_.push_back({row.edits.front().name, done.error().text});
  return tl::unexpected(done.error());
}

tl::expected<Brushed, TraceError> LibraryEngine::brush(const Edit& edit) {
  if (const auto done = player_->apply(edit); !done) return tl::unexpected(done.error());
  return player_->brushed();
}

std::optional<Complaint> LibraryEngine::afterRefusedBrush() const {
  auto wrong = readPolygons(*player_);
  if (!wrong) return std::nullopt;
  return Complaint{Mismatch::Kind::refusal, "the refusal of a brush changed something: " + wrong->text};
}

std::optional<Complaint> LibraryEngine::afterRefusal(const Row& row, const Stats& before) const {
  const bool isSame = std::ranges::none_of(
      row.cells, [&](Cell cell) { return readCell(player_->world(), player_->standing(), cell).has_value(); });
  if (isSame && sameCounts(player_->world().stats(), before)) return std::nullopt;
  return Complaint{Mismatch::Kind::refusal, fmt::format("the refusal changed something: {}", inWords(row))};
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

std::optional<Complaint> LibraryEngine::readAll() const {
  const World& world = player_->world();
  const auto isThere = [&](PolygonHandle handle) { return world.polygon(handle).has_value(); };
  if (std::ranges::any_of(stale_, isThere))
    return Complaint{Mismatch::Kind::reading, "the handle of a removed polygon names another one now"};
  if (auto complaint = reading(readPolygons(*player_))) return complaint;
  if (auto complaint = reading(readSegments(world, mirror_.segments()))) return complaint;
  return reading(readLoops(world, mirror_.segments()));
}

Loops LibraryEngine::loops() const {
  Loops loops;
  for (Loop& loop : player_->world().loops(Collinear::merge)) loops.push_back(std::move(loop.vertices));
  return loops;
}

tl::expected<Outline, TraceError> LibraryEngine::outlineAtOnce(const Trace& trace) {
  Player fresh(trace.preserve);
  Rows rows(trace);
  while (const auto row = rows.next(fresh.calls()))
    if (const auto done = fresh.apply(*row); !done) return tl::unexpected(done.error());
  // Threads would share the jobs of this executor. It runs the last one first: their order must not matter either.
  fresh.world().commit([](std::size_t jobs, const std::function<void(std::size_t)>& run) {
    while (jobs-- > 0) run(jobs);
  });
  return outlineOf(fresh.world());
}

}  // namespace lgs::oracle
