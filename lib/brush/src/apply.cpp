#include "apply.h"

#include "geometry/ring.h"

#include <algorithm>
#include <optional>

namespace lgs::brush {
namespace {

class Brush {
 public:
  Brush(World& world, const Stroke& stroke, BrushResult& result) : world_(world), stroke_(stroke), result_(result) {}

  Expected<void> whole(const CellRect& cells) {
    if (stroke_.deed == Deed::carve) return clear(cells);
    for (std::int32_t j = cells.min.j; j <= cells.max.j; ++j)
      for (std::int32_t i = cells.min.i; i <= cells.max.i; ++i)
        if (const auto done = paintWhole({i, j}); !done) return done;
    return {};
  }

  /// What goes and what comes is one change of the cell.
  Expected<void> cut(Cell cell, PieceSpan region) {
    const Frame frame;
    world_.polygons(cell, placed_);
    const CellEdit edit = editOf(placed_, region, stroke_);
    if (edit.isTooMuch) return tl::unexpected(Error{.code = ErrorCode::capacity, .cell = cell});

    List<PolygonHandle> removed;
    for (const std::size_t k : edit.gone) removed.push_back(placed_[k].handle);
    std::size_t vertices = 0;
    for (const NewPart& p : edit.placed) vertices += p.ring.size();
    List<LocalPoint> local;
    local.reserve(vertices);  // so what is added can point into it
    List<NewPolygon> added;
    for (const NewPart& p : edit.placed) {
      const std::size_t first = local.size();
      for (const Point v : p.ring) local.push_back({static_cast<std::int32_t>(v.x), static_cast<std::int32_t>(v.y)});
      added.push_back({std::span(local).subspan(first), p.block});
    }
    if (removed.empty() && added.empty()) return {};
    List<PolygonHandle> handles(added.size());
    if (const auto done = world_.exchange(cell, removed, added, handles); !done) return done;
    tell(edit, removed, handles);
    return {};
  }

 private:
  /// Removes what does not stay.
  Expected<void> clear(const CellRect& cells) {
    const std::size_t before = result_.removed.size();
    bool isAll = true;
    world_.forEachPolygon(cells, [&](Cell, const PlacedPolygon& p) {
      if (stroke_.stays(p.block))
        isAll = false;
      else
        result_.removed.push_back(p.handle);
    });
    if (!isAll) return world_.removeMany(std::span(result_.removed).subspan(before));
    if (const auto done = world_.clear(cells); !done) return tl::unexpected(done.error());
    return {};
  }

  void tell(const CellEdit& edit, std::span<const PolygonHandle> removed, std::span<const PolygonHandle> added) {
    for (const std::size_t k : edit.rounded)
      result_.rounded.push_back(removed[static_cast<std::size_t>(std::ranges::find(edit.gone, k) - edit.gone.begin())]);
    for (std::size_t n = 0; n < added.size(); ++n)
      if (edit.placed[n].from.empty()) result_.added.push_back(added[n]);
    for (std::size_t g = 0; g < removed.size(); ++g) {
      BrushChange change{removed[g], {}};
      for (std::size_t n = 0; n < added.size(); ++n)
        if (std::ranges::find(edit.placed[n].from, edit.gone[g]) != edit.placed[n].from.end())
          change.now.push_back(added[n]);
      if (change.now.empty()) {
        result_.removed.push_back(change.old);
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
      const auto stays = [&](const PlacedPolygon& p) { return stroke_.stays(p.block); };
      if (stroke_.deed == Deed::fill || std::ranges::any_of(placed_, stays)) return cut(cell, wholeCell());
      for (const PlacedPolygon& p : placed_) result_.removed.push_back(p.handle);
      if (const auto done = world_.clear(cell); !done) return tl::unexpected(done.error());
    }
    const auto handle = world_.add(cell, kUnitSquare, stroke_.block);
    if (!handle) return tl::unexpected(handle.error());
    result_.added.push_back(*handle);
    return {};
  }

  Expected<void> recolour(const PlacedPolygon& polygon) {
    if (stroke_.deed == Deed::fill || polygon.block == stroke_.block || stroke_.stays(polygon.block)) return {};
    const PolygonHandle handle = polygon.handle;
    if (const auto done = world_.setBlock(handle, stroke_.block); !done) return done;
    result_.changed.push_back({handle, {handle}});
    return {};
  }

  World& world_;
  const Stroke& stroke_;
  BrushResult& result_;
  std::vector<PlacedPolygon> placed_;
};

}  // namespace

Expected<void> apply(World& world, const Coverage& coverage, const Stroke& stroke, BrushResult& result) {
  const auto refused = [&](const CellRect& cells) -> std::optional<Error> {
    const auto cell = world.firstUnloaded(cells);
    return cell ? std::optional(Error{.code = ErrorCode::unloaded, .cell = *cell}) : std::nullopt;
  };
  for (const CellRect& cells : coverage.whole)
    if (const auto error = refused(cells)) return tl::unexpected(*error);
  for (const CutCell& cut : coverage.cut)
    if (const auto error = refused({cut.cell, cut.cell})) return tl::unexpected(*error);
  Brush brush(world, stroke, result);
  for (const CellRect& cells : coverage.whole)
    if (const auto done = brush.whole(cells); !done) return done;
  for (const CutCell& cell : coverage.cut)
    if (const auto done = brush.cut(cell.cell, cell.pieces); !done) return done;
  return {};
}

}  // namespace lgs::brush
