#include "follower_of_cells.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace lgs::test {
namespace {

PolygonFields fieldsOf(const PlacedPolygon& p) { return {p.handle, p.block, {p.vertices.begin(), p.vertices.end()}}; }

std::vector<PolygonFields> fieldsOf(std::span<const PlacedPolygon> polygons) {
  std::vector<PolygonFields> out;
  for (const PlacedPolygon& p : polygons) out.push_back(fieldsOf(p));
  return out;
}

std::vector<PolygonFields> in(const Cells& cells, Cell cell) {
  const auto found = cells.find(cell);
  return found == cells.end() ? std::vector<PolygonFields>() : found->second;
}

constexpr Cell kCorner{30, -2};  // of four chunks

Cell someCell(Chance& chance) { return {kCorner.i + chance.below(4), kCorner.j + chance.below(4)}; }

oracle::PreservePairs somePairs(bool preserves) {
  oracle::PreservePairs pairs;
  if (!preserves) return pairs;
  pairs.add(1, 2);
  pairs.add(2, 2);
  return pairs;
}

/// Single edits, good and bad.
Call someEdit(Chance& chance) {
  oracle::Choices choices([&chance] { return static_cast<std::uint64_t>(chance.below(1 << 30)); });
  oracle::Habits habits;
  for (const auto kind : {Call::Kind::group, Call::Kind::commit, Call::Kind::copy})
    habits.weights[static_cast<std::size_t>(kind)] = 0;
  return drawCall(choices, habits);
}

/// The cells that an edit may change.
std::vector<Cell> reached(const World& world, const Call& edit) {
  std::vector<Cell> cells{edit.cells.min};
  for (const oracle::Coming& coming : edit.comes) cells.push_back(coming.cell);
  for (const oracle::Named& named : edit.goes)
    if (const auto cell = world.cellOf(named.handle)) cells.push_back(*cell);
  world.forEachPolygon([&](Cell cell, const PlacedPolygon&) { cells.push_back(cell); });  // what clear() may reach
  if (edit.kind == Call::Kind::fill && inRange(edit.cells.min) && inRange(edit.cells.max))
    for (const Cell& cell : cellsOf(edit.cells)) cells.push_back(cell);
  return cells;
}

}  // namespace

Cells cellsIn(const World& world) {
  Cells cells;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) { cells[cell].push_back(fieldsOf(p)); });
  return cells;
}

/// By the trapezoids below the edges: another way than the view's.
std::map<Block, std::int64_t> recomputedAreas(const World& world) {
  std::map<Block, std::int64_t> areas;
  world.forEachPolygon([&](Cell, const PlacedPolygon& p) {
    for (std::size_t k = 0; k < p.vertices.size(); ++k) {
      const LocalPoint a = p.vertices[k], b = p.vertices[(k + 1) % p.vertices.size()];
      areas[p.block] += std::int64_t{a.x - b.x} * (a.y + b.y);
    }
  });
  return areas;
}

FollowerOfCells::FollowerOfCells(bool preserves)
    : preserve_(somePairs(preserves)), caller_(World(oracle::relationOf(preserve_)), kCorner), view_(world_) {
  EXPECT_TRUE(world_.followCells(true));
}

void FollowerOfCells::move(Chance& chance) {
  const int what = chance.below(100);
  if (what < 46) return edit(chance);
  if (what < 54) return editMany(chance);
  if (what < 60) return group(chance);
  if (what < 75) return commit();
  if (what < 83) return mark();
  if (what < 92) return goBack(chance);
  if (what < 95) return forget(chance);
  if (what < 98) return world_ = World(world_), void();  // nothing of the original is shared
  load();
}

/// Makes a call that may change these cells, and writes down those that it has changed.
template <class Call>
void FollowerOfCells::logged(const std::vector<Cell>& cells, Call&& call) {
  Cells before;
  for (const Cell cell : cells) before[cell] = polygonsIn(world_, cell);
  call();
  ++edits_;
  for (const auto& [cell, polygons] : before)
    if (polygonsIn(world_, cell) != polygons) log_.push_back({edits_, cell});
}

void FollowerOfCells::edit(Chance& chance) {
  const Call edit = caller_.resolved(someEdit(chance));
  logged(reached(world_, edit), [&] { caller_.makeResolved(edit); });
}

void FollowerOfCells::editMany(Chance& chance) {
  std::vector<Placement> placements;
  std::vector<PolygonHandle> removed;
  std::vector<Cell> cells;
  for (int k = 0; k < 3; ++k) {
    cells.push_back(someCell(chance));
    placements.push_back({cells.back(), {1}, static_cast<Block>(1 + chance.below(3))});
    for (const PlacedPolygon& p : world_.polygons(cells.back())) removed.push_back(p.handle);
  }
  const bool adds = chance.chance(50);
  // A cell that comes twice is refused, and so all are.
  logged(cells, [&] { static_cast<void>(adds ? world_.addMany(placements) : world_.removeMany(removed)); });
}

void FollowerOfCells::group(Chance& chance) {
  const std::size_t before = log_.size();
  bool stays = chance.chance(40);
  {
    Transaction group = world_.edit();
    for (int k = chance.below(4); k > 0; --k) edit(chance);
    if (log_.size() > before && chance.chance(10)) {  // a commit keeps what was edited before it
      commit();
      stays = true;
    }
    if (stays) group.keep();
  }
  if (!stays) log_.resize(before);
}

void FollowerOfCells::commit() {
  world_.commit();
  expectTold(std::span(log_).subspan(committed_), cellsIn(world_));
  committed_ = log_.size();
  const Mark here = world_.checkpoint();
  EXPECT_TRUE(world_.rollBack(here));
  EXPECT_TRUE(world_.cellChanges().empty()) << "of a roll-back over nothing";
  EXPECT_TRUE(world_.forget(here));
  std::map<Block, std::int64_t> areas;
  for (const auto& [block, area] : view_.areas()) {
    EXPECT_TRUE(0 <= area.halfUnits && area.halfUnits < examples::Area::kCell);
    areas[block] = area.cells * examples::Area::kCell + area.halfUnits;
  }
  EXPECT_EQ(areas, recomputedAreas(world_));
}

/// Edits may be pending.
void FollowerOfCells::mark() { marks_.push_back({world_.checkpoint(), told_, committed_, log_.size()}); }

void FollowerOfCells::goBack(Chance& chance) {
  if (marks_.empty()) return;
  const std::size_t k = chance.below(marks_.size());
  const Marked& to = marks_[k];
  const auto edited = std::span(log_).first(committed_).subspan(to.committed);
  const Mark end = world_.checkpoint();
  const Cells told = told_;
  ASSERT_TRUE(world_.rollBack(to.mark, Undone::keep));
  expectTold(edited, to.told);
  ASSERT_TRUE(world_.rollForward(end));
  expectTold(edited, told);
  ASSERT_TRUE(world_.rollBack(to.mark));
  expectTold(edited, to.told);
  committed_ = to.committed;
  log_.resize(to.edits);
  marks_.resize(k + 1);
}

void FollowerOfCells::forget(Chance& chance) {
  if (marks_.empty()) return;
  const std::size_t k = chance.below(marks_.size());
  EXPECT_TRUE(world_.forget(marks_[k].mark));
  marks_.erase(marks_.begin() + static_cast<std::ptrdiff_t>(k));
}

/// A loaded world follows nothing yet. Its view begins anew.
void FollowerOfCells::load() {
  commit();
  auto loaded = World::load(saved(world_), oracle::relationOf(preserve_));
  ASSERT_TRUE(loaded);
  world_ = std::move(*loaded);
  marks_.clear();
  EXPECT_TRUE(world_.cellChanges().empty());
  EXPECT_TRUE(world_.followCells(true));
  EXPECT_TRUE(world_.cellChanges().empty());
  view_ = examples::AreaByBlock(world_);
}

/// The changes name exactly these cells, each once, in the order in which they were first edited. They say what the
/// follower knew, and what stands there now. What they do not name is as it was.
void FollowerOfCells::expectTold(std::span<const Edited> edited, const Cells& now) {
  std::map<Cell, std::size_t> first;
  for (const Edited& e : edited) first.emplace(e.cell, e.edit);
  Cells after = told_;
  std::size_t edit = 0;
  std::set<Cell> named;
  for (const CellChange& change : world_.cellChanges()) {
    const Cell cell = change.cell;
    EXPECT_TRUE(named.insert(cell).second) << "a cell that is named twice: " << cell.i << ' ' << cell.j;
    ASSERT_TRUE(first.contains(cell)) << "a cell that was not edited: " << cell.i << ' ' << cell.j;
    EXPECT_GE(first[cell], edit) << "a cell that was edited earlier: " << cell.i << ' ' << cell.j;
    edit = first[cell];
    EXPECT_EQ(fieldsOf(change.before), in(told_, cell)) << "before, in cell " << cell.i << ' ' << cell.j;
    EXPECT_EQ(fieldsOf(change.now), in(now, cell)) << "now, in cell " << cell.i << ' ' << cell.j;
    after[cell] = fieldsOf(change.now);
    if (change.now.empty()) after.erase(cell);
  }
  EXPECT_EQ(named.size(), first.size()) << "cells that were edited are not named";
  EXPECT_EQ(after, now);
  view_.update(world_.cellChanges());
  told_ = now;
}

}  // namespace lgs::test
