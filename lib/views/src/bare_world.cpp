#include "bare_world.h"

#include "beyond.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace lgs::detail {
namespace {

bool isAmong(std::span<const PlacedPolygon> polygons, const PlacedPolygon& like, bool withBlock) {
  return std::ranges::any_of(polygons, [&](const PlacedPolygon& p) {
    return (!withBlock || p.block == like.block) && std::ranges::equal(p.vertices, like.vertices);
  });
}

/// Whether there are polygons in memory in these cells.
bool hasGround(const World& world, const CellRect& cells) {
  bool has = false;
  world.forEachPolygon(cells, [&](Cell, const PlacedPolygon&) { has = true; });
  return has;
}

/// What the other world holds fits here, too. Only where polygons were placed and taken back 2^28 times in one cell
/// there may be no place left.
void expect(bool done) {
  assert(done);
  if (!done) std::abort();
}

}  // namespace

BareWorld::BareWorld(const World& world, AtEdge atEdge) : isOpen_(atEdge == AtEdge::open) {
  if (!isOpen_)
    for (const CellRect& chunk : unloadedChunks(world)) fillUnknown(chunk);
  world.forEachPolygon(
      [this](Cell cell, const PlacedPolygon& p) { expect(world_.add(cell, p.vertices, p.block).has_value()); });
  world_.commit();
  if (isOpen_) expect(world_.followCells(true).has_value());
}

// Whose edge is open is looked at for anchors, too, which are by block; else only vertices matter.
void BareWorld::become(Cell cell, std::span<const PlacedPolygon> polygons) {
  world_.polygons(cell, held_);
  gone_.clear();
  come_.clear();
  for (const PlacedPolygon& p : held_)
    if (!isAmong(polygons, p, isOpen_)) gone_.push_back(p.handle);
  for (const PlacedPolygon& p : polygons)
    if (!isAmong(held_, p, isOpen_)) come_.push_back({p.vertices, p.block});
  expect(world_.exchange(cell, gone_, come_).has_value());
}

void BareWorld::fillUnknown(const CellRect& chunk) {
  if (!unknown_.insert(chunk.min).second) return;
  const auto square = world_.shape(kUnitSquare);
  expect(square && world_.reloadEmpty(chunk) && world_.fill(chunk, *square, 0) && world_.unload(chunk, {}));
}

void BareWorld::know(const CellRect& chunk) {
  expect(world_.reloadEmpty(chunk).has_value());
  unknown_.erase(chunk.min);
}

/// Forgotten chunks are not reported. No loaded ground was beside them then, so it is in time to look for them
/// where some comes.
void BareWorld::dropForgotten(const World& world, Cell cell) {
  if (!isAtRimOfChunk(cell)) return;
  const CellRect around = cellsAround(cell);
  for (std::int32_t i = around.min.i; i <= around.max.i; ++i)
    for (std::int32_t j = around.min.j; j <= around.max.j; ++j)
      if (const Cell beside{i, j}; isUnloaded(world_, beside) && !isUnloaded(world, beside)) know(chunkWith(beside));
}

const Changes& BareWorld::follow(const World& world) {
  std::vector<CellRect> left, emptied;
  for (const CellChange& change : world.cellChanges()) {
    const CellRect chunk = chunkWith(change.cell);
    const bool isAway = isUnloaded(world, change.cell);
    if (change.now.empty() && (isOpen_ || !isAway) && (emptied.empty() || emptied.back().min != chunk.min))
      emptied.push_back(chunk);
    if (isOpen_) {
      become(change.cell, isAway ? std::span<const PlacedPolygon>() : change.now);
      continue;
    }
    if (isAway) {
      if (left.empty() || left.back().min != chunk.min) left.push_back(chunk);
      continue;
    }
    know(chunk);
    dropForgotten(world, change.cell);
    become(change.cell, change.now);
  }
  for (const CellRect& chunk : left) expect(world_.unload(chunk, {}).has_value());
  if (!isOpen_ && world.changesOfRollBack().after == world.version())  // it rolled back, and no commit followed
    for (const CellRect& chunk : unloadedChunks(world))
      if (!hasGround(world_, chunk)) fillUnknown(chunk);  // else it left since: the next commit says so
  const Changes& changes = world_.commit();
  for (const CellRect& chunk : emptied) expect(world_.forgetChunks(chunk).has_value());  // which hold nothing
  return changes;
}

}  // namespace lgs::detail
