#include "follower_of_cells.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <set>

namespace lgs::test {
namespace {

std::vector<PolygonFields> allOf(std::span<const PlacedPolygon> polygons) {
  std::vector<PolygonFields> out;
  for (const PlacedPolygon& p : polygons) out.push_back(fieldsOf(p));
  return out;
}

std::vector<PolygonFields> in(const Cells& cells, Cell cell) {
  const auto found = cells.find(cell);
  return found == cells.end() ? std::vector<PolygonFields>() : found->second;
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

FollowerOfCells::FollowerOfCells(const Setting& setting) : caller_(setting.start()), view_(world_) {
  EXPECT_TRUE(world_.followCells(true));
}

void FollowerOfCells::make(const Call& call) {
  const std::size_t k = marks_.empty() ? 0 : call.nth % marks_.size();
  switch (call.kind) {
    case Call::Kind::commit:
      return commit();
    case Call::Kind::mark:  // edits may be pending
      return marks_.push_back({world_.mark(), told_, committed_, log_.size(), caller_.given.size()});
    case Call::Kind::rollBack:
      return marks_.empty() ? void() : rollBack(k);
    case Call::Kind::forget:
      if (marks_.empty()) return;
      EXPECT_TRUE(world_.forget(marks_[k].mark));
      marks_.erase(marks_.begin() + static_cast<std::ptrdiff_t>(k));
      return;
    case Call::Kind::load:
      return load();
    case Call::Kind::group:
      return group(call);
    default:
      static_cast<void>(edit(call));
  }
}

/// Makes a call, and writes down the cells that it has changed. Whether it is accepted.
bool FollowerOfCells::edit(const Call& call) {
  const Call edit = caller_.resolved(call);
  Cells before;
  for (const Cell cell : reached(world_, edit)) before[cell] = polygonsIn(world_, cell);
  const bool isAccepted = !caller_.makeResolved(edit).refusal;
  ++edits_;
  for (const auto& [cell, polygons] : before)
    if (polygonsIn(world_, cell) != polygons) log_.push_back({edits_, cell});
  return isAccepted;
}

/// A commit in a group keeps what was edited before it.
void FollowerOfCells::group(const Call& call) {
  const std::size_t before = log_.size();
  std::size_t parts = 0;
  bool isCommitted = false;
  const bool isKept = caller_.makeGroup(call, [&](const Call& part) {
    const bool isAccepted = edit(part);
    if (++parts == call.group.size() && call.nth % 8 == 0 && log_.size() > before) {
      commit();
      isCommitted = true;
    }
    return isAccepted;
  });
  if (!isKept && !isCommitted) log_.resize(before);
}

void FollowerOfCells::commit() {
  world_.commit();
  expectTold(std::span(log_).subspan(committed_), cellsIn(world_));
  committed_ = log_.size();
  const Mark here = world_.mark();
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

void FollowerOfCells::rollBack(std::size_t k) {
  const Marked& to = marks_[k];
  const auto edited = std::span(log_).first(committed_).subspan(to.committed);
  const Mark end = world_.mark();
  const Cells told = told_;
  ASSERT_TRUE(world_.rollBack(to.mark, Undone::keep));
  expectTold(edited, to.told);
  ASSERT_TRUE(world_.redo(end));
  expectTold(edited, told);
  ASSERT_TRUE(world_.rollBack(to.mark));
  expectTold(edited, to.told);
  committed_ = to.committed;
  log_.resize(to.edits);
  caller_.given.resize(to.given);
  marks_.resize(k + 1);
}

/// A loaded world follows nothing yet. Its view begins anew.
void FollowerOfCells::load() {
  commit();
  auto loaded = must(World::load(saved(world_), world_.preserveRelation()));
  world_ = std::move(loaded);
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
    EXPECT_EQ(allOf(change.before), in(told_, cell)) << "before, in cell " << cell.i << ' ' << cell.j;
    EXPECT_EQ(allOf(change.now), in(now, cell)) << "now, in cell " << cell.i << ' ' << cell.j;
    after[cell] = allOf(change.now);
    if (change.now.empty()) after.erase(cell);
  }
  EXPECT_EQ(named.size(), first.size()) << "cells that were edited are not named";
  EXPECT_EQ(after, now);
  view_.update(world_.cellChanges());
  told_ = now;
}

}  // namespace lgs::test
