#include <lgs/ground_window.h>

#include <algorithm>
#include <optional>

namespace lgs {
namespace {

constexpr std::int32_t kInChunk = 31;

std::int32_t inWorld(std::int32_t index) { return std::clamp(index, -kMaxCell, kMaxCell); }

}  // namespace

CellRect chunkAround(Cell cell) {
  return {{inWorld(cell.i & ~kInChunk), inWorld(cell.j & ~kInChunk)},
          {inWorld(cell.i | kInChunk), inWorld(cell.j | kInChunk)}};
}

std::vector<Cell> chunksAround(const CellRect& cells) {
  std::vector<Cell> corners;
  const Cell min = chunkAround({inWorld(cells.min.i - kInChunk - 1), inWorld(cells.min.j - kInChunk - 1)}).min;
  const Cell max = chunkAround({inWorld(cells.max.i + kInChunk + 1), inWorld(cells.max.j + kInChunk + 1)}).max;
  for (std::int32_t j = min.j; j <= max.j; j = (j | kInChunk) + 1)
    for (std::int32_t i = min.i; i <= max.i; i = (i | kInChunk) + 1) corners.push_back({i, j});
  return corners;
}

CellRect boxOf(const CellRect& a, const CellRect& b) {
  return {{std::min(a.min.i, b.min.i), std::min(a.min.j, b.min.j)},
          {std::max(a.max.i, b.max.i), std::max(a.max.j, b.max.j)}};
}

void unloadOutside(World& world, const CellRect& chunks, const Shelf& shelf) noexcept {
  const auto [min, max] = chunks;
  for (const CellRect& cells : {CellRect{{-kMaxCell, -kMaxCell}, {kMaxCell, min.j - 1}},
                                {{-kMaxCell, max.j + 1}, {kMaxCell, kMaxCell}},
                                {{-kMaxCell, min.j}, {min.i - 1, max.j}},
                                {{max.i + 1, min.j}, {kMaxCell, max.j}}})
    if (!isEmpty(cells)) static_cast<void>(world.unload(cells, shelf.put));
}

// In the order of places: so no row is looked through again that all came back to.
bool reloadInside(World& world, const CellRect& chunks, const Shelf& shelf, std::size_t& most) noexcept {
  CellRect rest = chunks;
  while (const auto cell = world.firstUnloaded(rest)) {
    if (most == 0) return false;
    const auto bytes = shelf.get(chunkAround(*cell).min);
    if (!bytes || !world.reload(*bytes)) return false;
    --most;
    rest.min.j = cell->j;
  }
  return true;
}

}  // namespace lgs

namespace lgs::detail {

bool GroundWindow::moveTo(const CellRect& cells) {
  const CellRect chunks{chunkAround(cells.min).min, chunkAround(cells.max).max};
  if (chunks == window_) return !isWhole_;
  leaving_ = boxOf(leaving_, window_);
  window_ = chunks;
  return true;
}

// Land first, as a chunk that comes in needs to know what is beside it.
void GroundWindow::stream(World& world, std::int64_t now, const BeforeLand& beforeLand) {
  std::size_t most = std::max<std::size_t>(options_.chunksAtOnce, 1);
  isWhole_ = makeLand(world, now, beforeLand, most) && unload(world, most) &&
             reloadInside(world, window_, options_.shelf, most);
  if (isWhole_) mayLackLand_ = false;
}

void GroundWindow::restart(std::span<const Cell> land) {
  isWhole_ = false;
  mayLackLand_ = static_cast<bool>(options_.land);
  made_ = {land.begin(), land.end()};
  new_.clear();
}

/// Whether no chunk is in memory out of the window. At first, when all may be, they leave at once.
bool GroundWindow::unload(World& world, std::size_t& most) {
  const auto isSmall = [](std::int32_t min, std::int32_t max) { return std::int64_t{max} - min < 2'048; };
  if (isSmall(leaving_.min.i, leaving_.max.i) && isSmall(leaving_.min.j, leaving_.max.j)) {
    for (const Cell corner : chunksAround(leaving_)) {
      if (contains(window_, corner)) continue;
      if (most == 0) return false;
      if (world.unload(chunkAround(corner), options_.shelf.put).value_or(0) > 0) --most;
    }
  }
  unloadOutside(world, window_, options_.shelf);
  leaving_ = window_;
  return true;
}

// --- Land

std::optional<Cell> GroundWindow::firstWithoutLand(const CellRect& cells) const {
  if (!options_.land || isEmpty(cells)) return std::nullopt;
  const Cell first = chunkAround(cells.min).min, last = chunkAround(cells.max).max;
  for (std::int32_t j = first.j; j <= last.j; j = (j | kInChunk) + 1)
    for (std::int32_t i = first.i; i <= last.i; i = (i | kInChunk) + 1)
      if (!made_.contains({i, j})) return Cell{i, j};
  return std::nullopt;
}

/// Whether all of it is made. Until it is, none of it is in memory: what is beside land that is not made would fall.
bool GroundWindow::makeLand(World& world, std::int64_t now, const BeforeLand& beforeLand, std::size_t& most) {
  if (!options_.land) return true;
  for (const Cell corner : chunksAround(window_)) {
    if (made_.contains(corner)) continue;
    if (most == 0 || !make(world, corner, now, beforeLand)) return false;
    --most;
    static_cast<void>(world.unload(chunkAround(corner), options_.shelf.put));
  }
  return true;
}

/// Whether it could, or the shelf has not given what is there already: an undo went over it, or the game has built
/// there. That stays: land that would overlap it is refused.
bool GroundWindow::make(World& world, Cell corner, std::int64_t now, const BeforeLand& beforeLand) {
  const CellRect chunk = chunkAround(corner);
  std::size_t most = 1;
  if (!reloadInside(world, chunk, options_.shelf, most)) return false;
  beforeLand(chunk);
  made_.insert(corner);
  new_.emplace_back(corner, now);
  World land(options_.preserve);
  options_.land(land, chunk);
  std::vector<std::byte> all;
  static_cast<void>(
      land.unload(chunk, [&](Cell, std::span<const std::byte> bytes) { all.assign(bytes.begin(), bytes.end()); }));
  if (all.empty() || world.reload(all) || !land.reload(all)) return true;
  land.forEachPolygon(
      chunk, [&](Cell cell, const PlacedPolygon& p) { static_cast<void>(world.add(cell, p.vertices, p.block)); });
  return true;
}

bool GroundWindow::remakeLand(World& world, std::int64_t now, const BeforeLand& beforeLand) {
  std::vector<Cell> again;
  for (const auto& [corner, at] : new_)
    if (at >= now) again.push_back(corner);
  if (again.empty()) return false;
  std::erase_if(new_, [&](const auto& land) { return land.second >= now; });
  for (const Cell corner : again) {
    if (make(world, corner, now, beforeLand)) continue;
    made_.erase(corner);  // by the next window()
    isWhole_ = false;
  }
  unloadOutside(world, window_, options_.shelf);
  return true;
}

void GroundWindow::keepNew(std::int64_t now) {
  for (auto& land : new_)
    if (land.second == now) --land.second;
}

}  // namespace lgs::detail
