#include "apply.h"

#include "geometry/ring.h"

#include <algorithm>

namespace lgs::brush {
namespace {

class Brush {
 public:
  Brush(World& world, const Stroke& stroke, BrushResult& result) : world_(world), stroke_(stroke), result_(result) {}

  Expected<void> whole(const CellRect& cells) {
    if (stroke_.deed == Deed::carve) {
      world_.forEachPolygon(cells, [&](Cell, const PlacedPolygon& p) { result_.went.push_back(p.handle); });
      if (const auto done = world_.clear(cells); !done) return tl::unexpected(done.error());
      return {};
    }
    for (std::int32_t j = cells.min.j; j <= cells.max.j; ++j)
      for (std::int32_t i = cells.min.i; i <= cells.max.i; ++i)
        if (const auto done = paintWhole({i, j}); !done) return done;
    return {};
  }

  /// What goes and what comes is one change of the cell.
  Expected<void> cut(Cell cell, const Pieces& region) {
    read(cell);
    const CellEdit edit = editOf(old_, region, stroke_);
    removed_.clear();
    for (const std::size_t k : edit.gone) removed_.push_back(handles_[k]);
    local_.clear();
    for (const NewPart& p : edit.placed)
      for (const Point v : p.ring) local_.push_back({static_cast<std::int32_t>(v.x), static_cast<std::int32_t>(v.y)});
    added_.clear();
    std::size_t first = 0;
    for (const NewPart& p : edit.placed) {
      added_.push_back({std::span(local_).subspan(first, p.ring.size()), p.block});
      first += p.ring.size();
    }
    placedHandles_.resize(added_.size());
    if (const auto done = world_.exchange(cell, removed_, added_, placedHandles_); !done) return done;
    tell(edit);
    return {};
  }

 private:
  void read(Cell cell) {
    world_.polygons(cell, placed_);
    old_.clear();
    handles_.clear();
    for (const PlacedPolygon& p : placed_) {
      CellPolygon& copy = old_.emplace_back();
      copy.block = p.block;
      copy.ring.reserve(p.vertices.size());
      for (const LocalPoint v : p.vertices) copy.ring.push_back({v.x, v.y});
      handles_.push_back(p.handle);
    }
  }

  void tell(const CellEdit& edit) {
    std::vector<BrushChange> changes;
    for (const PolygonHandle old : removed_) changes.push_back({old, {}});
    for (std::size_t n = 0; n < edit.placed.size(); ++n) {
      const std::vector<std::size_t>& from = edit.placed[n].from;
      if (from.empty()) result_.came.push_back(placedHandles_[n]);
      for (const std::size_t k : from) {
        const auto place = std::lower_bound(edit.gone.begin(), edit.gone.end(), k) - edit.gone.begin();
        changes[static_cast<std::size_t>(place)].now.push_back(placedHandles_[n]);
      }
    }
    for (const std::size_t k : edit.bent) result_.bent.push_back(handles_[k]);
    for (BrushChange& change : changes) {
      if (change.now.empty()) {
        result_.went.push_back(change.old);
      } else {
        result_.changed.push_back(std::move(change));
      }
    }
  }

  /// A polygon that fills its cell keeps its handle, whatever is painted over it.
  Expected<void> paintWhole(Cell cell) {
    constexpr std::int64_t kDoubleArea = std::int64_t{2} * kUnitsPerCell * kUnitsPerCell;
    if (!world_.isEmpty(cell)) {
      world_.polygons(cell, placed_);
      if (placed_.size() == 1 && detail::doubleArea(placed_[0].vertices) == kDoubleArea) return recolour(placed_[0]);
      if (stroke_.deed == Deed::fill) return cut(cell, wholeCell());
      for (const PlacedPolygon& p : placed_) result_.went.push_back(p.handle);
      if (const auto done = world_.clear(cell); !done) return tl::unexpected(done.error());
    }
    const auto handle = world_.add(cell, kUnitSquare, stroke_.block);
    if (!handle) return tl::unexpected(handle.error());
    result_.came.push_back(*handle);
    return {};
  }

  Expected<void> recolour(const PlacedPolygon& polygon) {
    if (stroke_.deed == Deed::fill || polygon.block == stroke_.block) return {};
    const PolygonHandle handle = polygon.handle;
    if (const auto done = world_.setBlock(handle, stroke_.block); !done) return done;
    result_.changed.push_back({handle, {handle}});
    return {};
  }

  World& world_;
  const Stroke& stroke_;
  BrushResult& result_;
  std::vector<PlacedPolygon> placed_;
  std::vector<CellPolygon> old_;
  std::vector<PolygonHandle> handles_;
  std::vector<LocalPoint> local_;
  std::vector<PolygonHandle> removed_, placedHandles_;
  std::vector<NewPolygon> added_;
};

}  // namespace

Expected<void> apply(World& world, const Coverage& coverage, const Stroke& stroke, BrushResult& result) {
  Brush brush(world, stroke, result);
  for (const CellRect& cells : coverage.whole)
    if (const auto done = brush.whole(cells); !done) return done;
  for (const CutCell& cell : coverage.cut)
    if (const auto done = brush.cut(cell.cell, cell.pieces); !done) return done;
  return {};
}

}  // namespace lgs::brush
