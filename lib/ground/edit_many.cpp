// Edits that take many at once. All are made or none: the ground rolls back if one is refused.
#include "ground/edit.h"
#include "ground/refusal.h"

#include <algorithm>

namespace lgs::detail {

/// Calls edit(k) for each k, and brings the ground back to where it was if one is refused.
template <class One>
Expected<void> Edit::allOrNone(std::size_t count, One&& edit) {
  if (count > kMaxEntries) return refuse({.code = ErrorCode::capacity});
  const Journal::Moment begin = ground_.journal.begin();
  Expected<void> done;
  for (std::size_t k = 0; k < count && done; ++k) done = edit(k);
  if (!done) ground_.takeBack(begin);
  ground_.letGo(begin);
  return done;
}

namespace {

/// The entry that placed a polygon, or -1 if it was there before them. The last serials of a cell are of the last
/// entries that placed something in it.
std::int32_t entryThatPlaced(const Ground& ground, std::span<const Placement> placed, PolygonHandle polygon) {
  const Cell cell = ground.grid.cellOf(polygon.cellRef);
  std::size_t before = ground.held(ground.grid.find(cell)).lastSerial();
  for (std::size_t k = placed.size(); k-- != 0;) {
    if (placed[k].cell != cell) continue;
    before -= ground.catalogue.shape(placed[k].shape).polygons.size();
    if (polygon.serial > before) return static_cast<std::int32_t>(k);
  }
  return -1;
}

/// The caller never got the handle of a polygon that the call placed and takes back: so the error names the entry that
/// placed it.
Error nameEntry(const Ground& ground, std::span<const Placement> placed, Error error) {
  if (!error.other) return error;
  error.index2 = entryThatPlaced(ground, placed, error.other);
  if (error.index2 >= 0) error.other = {};
  return error;
}

}  // namespace

/// The usual case of addMany(): each entry puts a shape of one polygon into a cell that has nothing. First all cells
/// get their words, which can be put back, and then what can not fail. False, and nothing is done, in any other case.
bool Edit::addSoles(std::span<const Placement> placements, std::span<PolygonHandle> handles) {
  if (ground_.journal.isOn()) return false;
  std::vector<std::uint32_t> made;
  const auto takes = [&](const Placement& p) {
    const InternedShape& interned = ground_.catalogue.shape(p.shape);
    CellAt at = ground_.grid.findLast(p.cell);
    if (!at && inRange(p.cell) && !ground_.grid.isFull() && ground_.grid.unloadedCount() == 0) {
      const std::size_t before = ground_.grid.count();
      at = ground_.grid.obtain(p.cell);
      if (ground_.grid.count() != before) made.push_back(at.chunk->index);
    }
    if (!at || !takesSole(at, interned)) return false;
    at.word() = wordOf(interned.content, at.word() + 1);
    return true;
  };
  std::size_t taken = 0;
  while (taken < placements.size() && takes(placements[taken])) ++taken;
  if (taken < placements.size()) {
    for (; taken != 0; --taken) {
      const CellAt at = ground_.grid.find(placements[taken - 1].cell);
      at.word() = (at.word() & kLowMask) - 1;
    }
    for (const std::uint32_t number : made) ground_.grid.forget(number);
    return false;
  }
  for (std::size_t k = 0; k < placements.size(); ++k) {
    const CellAt at = ground_.grid.obtain(placements[k].cell);
    ground_.completeSole(at, ground_.catalogue.shape(placements[k].shape), placements[k].block);
    if (k < handles.size()) handles[k] = {at.ref(), at.word() & kLowMask};
  }
  return true;
}

Expected<void> Edit::addMany(std::span<const Placement> placements, std::span<PolygonHandle> handles) {
  if (placements.size() <= kMaxEntries && addSoles(placements, handles)) return {};
  return allOrNone(placements.size(), [&](std::size_t k) -> Expected<void> {
    const auto& [cell, shape, block] = placements[k];
    const auto handle = add(cell, shape, block, {});
    if (!handle) {
      std::fill(handles.begin(), handles.end(), PolygonHandle{});
      return refuseAt(nameEntry(ground_, placements.first(k), handle.error()), &Error::index, k);
    }
    if (k < handles.size()) handles[k] = *handle;
    return {};
  });
}

Expected<void> Edit::removeMany(std::span<const PolygonHandle> polygons) {
  return allOrNone(polygons.size(), [&](std::size_t k) -> Expected<void> {
    auto done = remove(polygons[k]);
    if (done) return done;
    const auto twin = std::ranges::find(polygons.first(k), polygons[k]);
    if (twin != polygons.first(k).end()) done.error().index2 = static_cast<std::int32_t>(twin - polygons.begin());
    return refuseAt(done.error(), &Error::index, k);
  });
}

}  // namespace lgs::detail
