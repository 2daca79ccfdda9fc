// Edits that take many at once. All are made or none: the ground goes back if one is refused.
#include "ground/edit.h"
#include "ground/refusal.h"

#include <algorithm>

namespace lgs::detail {

/// Brings the ground back to where it was when the group began, unless the group is kept.
class Edit::Group {
 public:
  explicit Group(Ground& ground) : ground_(ground), start_(ground.now()), wasNoting_(ground.isNoting()) {
    ground_.startNoting();
  }
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;
  ~Group() {
    if (!isKept_) ground_.goBack(start_);
    if (!wasNoting_) ground_.stopNoting();
  }
  void keep() { isKept_ = true; }

 private:
  Ground& ground_;
  Ground::Moment start_;
  bool wasNoting_, isKept_ = false;
};

namespace {

/// The entry that placed a polygon, or -1 if it was there before them. The last serials of a cell are of the last
/// entries that placed something in it.
std::int32_t entryThatPlaced(const Ground& ground, std::span<const Placement> placed, PolygonHandle polygon) {
  const Cell cell = ground.grid.cellOf(polygon.cellRef);
  std::size_t before = ground.lastSerial(ground.grid.find(cell));
  for (std::size_t k = placed.size(); k-- != 0;) {
    if (placed[k].cell != cell) continue;
    before -= ground.catalogue.shape(placed[k].shape)->polygons.size();
    if (polygon.serial > before) return static_cast<std::int32_t>(k);
  }
  return -1;
}

}  // namespace

Expected<void> Edit::addMany(std::span<const Placement> placements, std::span<PolygonHandle> handles) {
  if (placements.size() > kMaxEntries) return refuse({.code = ErrorCode::capacity});
  Group group(ground_);
  for (std::size_t k = 0; k < placements.size(); ++k) {
    const auto& [cell, shape, block] = placements[k];
    auto handle = add(cell, shape, block, {});
    if (!handle) {
      Error error = handle.error();
      if (error.other) {  // nobody keeps the handle of a polygon that this call placed and takes back
        error.index2 = entryThatPlaced(ground_, placements.first(k), error.other);
        if (error.index2 >= 0) error.other = {};
      }
      std::fill(handles.begin(), handles.end(), PolygonHandle{});
      return refuseAt(error, &Error::index, k);
    }
    if (k < handles.size()) handles[k] = *handle;
  }
  group.keep();
  return {};
}

Expected<void> Edit::removeMany(std::span<const PolygonHandle> polygons) {
  if (polygons.size() > kMaxEntries) return refuse({.code = ErrorCode::capacity});
  Group group(ground_);
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    auto done = remove(polygons[k]);
    if (done) continue;
    const auto twin = std::ranges::find(polygons.first(k), polygons[k]);
    if (twin != polygons.first(k).end()) done.error().index2 = static_cast<std::int32_t>(twin - polygons.begin());
    return refuseAt(done.error(), &Error::index, k);
  }
  group.keep();
  return {};
}

}  // namespace lgs::detail
