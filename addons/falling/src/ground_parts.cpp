#include "by_block.h"

#include <lgs/ground_parts.h>
#include <lgs/unloaded.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <utility>

namespace lgs {
namespace {

constexpr std::int32_t kInChunk = 31;

/// Eight bytes, the least first.
void putNumber(std::vector<std::byte>& out, std::uint64_t number) {
  for (int k = 0; k < 8; ++k) out.push_back(static_cast<std::byte>(number >> 8 * k));
}
void putReal(std::vector<std::byte>& out, double real) { putNumber(out, std::bit_cast<std::uint64_t>(real)); }
void putPair(std::vector<std::byte>& out, std::int32_t a, std::int32_t b) {
  putNumber(out, std::uint64_t{static_cast<std::uint32_t>(a)} << 32 | static_cast<std::uint32_t>(b));
}

class Reader {
 public:
  explicit Reader(std::span<const std::byte>& bytes) : bytes_(bytes) {}
  bool isGood() const { return isGood_; }
  std::uint64_t number() {
    if (bytes_.size() < 8) isGood_ = false;
    if (!isGood_) return 0;
    std::uint64_t number = 0;
    for (std::size_t k = 0; k < 8; ++k) number |= std::to_integer<std::uint64_t>(bytes_[k]) << 8 * k;
    bytes_ = bytes_.subspan(8);
    return number;
  }
  double real() { return std::bit_cast<double>(number()); }
  std::pair<std::int32_t, std::int32_t> pair() {
    const std::uint64_t both = number();
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(both >> 32)),
            static_cast<std::int32_t>(static_cast<std::uint32_t>(both))};
  }
  /// How many of something that takes so many bytes each, at least.
  std::uint64_t count(std::size_t bytesOfEach) {
    const std::uint64_t count = number();
    if (count > bytes_.size() / bytesOfEach) isGood_ = false;
    return isGood_ ? count : 0;
  }

 private:
  std::span<const std::byte>& bytes_;
  bool isGood_ = true;
};

constexpr std::uint64_t kFormat = 0x3164'6e72'6773'676c;  // "lgsgrnd1"

DoublePoint inCells(Point p) {
  return {static_cast<double>(p.x) / kUnitsPerCell, static_cast<double>(p.y) / kUnitsPerCell};
}

/// Where it was in the world.
CellRect cellsOf(const Body& body) {
  std::optional<CellRect> cells;
  for (const BodyPolygon& p : body.polygons) {
    const Cell at{body.origin.i + p.cell.i, body.origin.j + p.cell.j};
    cells = cells ? boxOf(*cells, {at, at}) : CellRect{at, at};
  }
  return cells.value_or(CellRect{body.origin, body.origin});
}

}  // namespace

Shelf shelfInMemory() {
  const auto chunks = std::make_shared<std::map<Cell, std::vector<std::byte>>>();
  return {.put = [chunks](Cell corner,
                          std::span<const std::byte> bytes) { (*chunks)[corner].assign(bytes.begin(), bytes.end()); },
          .get = [chunks](Cell corner) -> std::optional<std::vector<std::byte>> {
            const auto found = chunks->find(corner);
            if (found == chunks->end()) return std::nullopt;
            return found->second;
          }};
}

GroundDrawing drawingOf(const World& world, const CellRect& cells) {
  GroundDrawing drawing{cells, {}, {}};
  world.forEachPolygon(cells, [&](Cell cell, const PlacedPolygon& polygon) {
    GroundDrawing::Fill& fill = drawing.fills.emplace_back(GroundDrawing::Fill{polygon.block, {}});
    for (const LocalPoint v : polygon.vertices) fill.corners.push_back(inCells(toWorld(cell, v)));
  });
  for (const SegmentId id : world.segments(cells))
    if (const auto s = world.segment(id)) drawing.lines.push_back({s->block, inCells(s->start), inCells(s->end)});
  return drawing;
}

void ChangedSquares::note(Cell cell) {
  for (const std::int32_t dj : {-1, 1})  // what stands in a cell changes the outline in those around it
    for (const std::int32_t di : {-1, 1}) corners_.insert({(cell.i + di) & -kSide, (cell.j + dj) & -kSide});
}

void ChangedSquares::note(const World& world) {
  world.forEachPolygon([&](Cell cell, const PlacedPolygon&) { note(cell); });
}

void ChangedSquares::noteSides(const CellRect& chunk) {
  const auto [min, max] = chunk;
  for (std::int32_t j = min.j;; j = std::min(j + kSide, max.j)) {
    note({min.i, j}), note({max.i, j});
    if (j == max.j) break;
  }
  for (std::int32_t i = min.i;; i = std::min(i + kSide, max.i)) {
    note({i, min.j}), note({i, max.j});
    if (i == max.i) break;
  }
}

void ChangedSquares::noteBesideUnloaded(const World& world, const CellRect& window) {
  for (const CellRect& chunk : unloadedChunks(world)) {
    const auto [min, max] = chunk;
    const bool isBeside = min.i <= window.max.i + 1 && window.min.i - 1 <= max.i && min.j <= window.max.j + 1 &&
                          window.min.j - 1 <= max.j;
    if (isBeside) noteSides(chunk);
  }
}

std::vector<GroundDrawing> ChangedSquares::draw(const World& world) {
  std::vector<GroundDrawing> drawings;
  for (const Cell corner : std::exchange(corners_, {}))
    drawings.push_back(drawingOf(world, {corner, {corner.i + kSide - 1, corner.j + kSide - 1}}));
  return drawings;
}

bool isSound(const Rock& rock) {
  const auto& [origin, cosine, sine] = rock.placing;
  const std::array reals{origin.x, origin.y, rock.velocity.x, rock.velocity.y, rock.spin};
  return std::ranges::all_of(reals, [](double real) { return std::abs(real) < 1e9; }) &&
         std::abs(cosine * cosine + sine * sine - 1) < 1e-3;
}

void putRock(std::vector<std::byte>& out, const Rock& rock) {
  for (const double real : {rock.placing.origin.x, rock.placing.origin.y, rock.placing.cosine, rock.placing.sine,
                            rock.velocity.x, rock.velocity.y, rock.spin})
    putReal(out, real);
  putPair(out, rock.ground.origin.i, rock.ground.origin.j);
  putNumber(out, rock.ground.polygons.size());
  for (const BodyPolygon& p : rock.ground.polygons) {
    putPair(out, p.cell.i, p.cell.j);
    putNumber(out, p.block);
    putNumber(out, p.vertices.size());
    for (const LocalPoint v : p.vertices) putPair(out, v.x, v.y);
  }
}

std::optional<Rock> takeRock(std::span<const std::byte>& bytes) {
  Reader in(bytes);
  Rock rock;
  for (double* const real : {&rock.placing.origin.x, &rock.placing.origin.y, &rock.placing.cosine, &rock.placing.sine,
                             &rock.velocity.x, &rock.velocity.y, &rock.spin})
    *real = in.real();
  if (!isSound(rock)) return std::nullopt;
  World alone;  // takes nothing that can not be ground
  Body& ground = rock.ground;
  const auto [i, j] = in.pair();
  ground.origin = {i, j};
  for (std::uint64_t count = in.count(24); count > 0 && in.isGood(); --count) {
    BodyPolygon& polygon = ground.polygons.emplace_back();
    const auto [column, row] = in.pair();
    polygon.cell = {column, row};
    polygon.block = static_cast<Block>(in.number());
    for (std::uint64_t vertices = in.count(8); vertices > 0; --vertices) {
      const auto [x, y] = in.pair();
      polygon.vertices.push_back({x, y});
    }
    // A body is at most as wide as the world, so the cells that it was in are in range.
    const auto isNear = [](std::int32_t index, std::int32_t by) {
      return std::max(std::int64_t{index} + by, -(std::int64_t{index} + by)) <= kMaxCell;
    };
    if (!isNear(i, column) || !isNear(j, row)) return std::nullopt;
    if (!alone.add({i + column, j + row}, polygon.vertices, polygon.block)) return std::nullopt;
  }
  if (!in.isGood() || ground.polygons.empty()) return std::nullopt;
  ground.cells = cellsOf(ground);
  ground.mass = massOf(ground.polygons);
  return rock;
}

CellRect chunkAround(Cell cell) {
  return {{std::max(cell.i & ~kInChunk, -kMaxCell), std::max(cell.j & ~kInChunk, -kMaxCell)},
          {std::min(cell.i | kInChunk, kMaxCell), std::min(cell.j | kInChunk, kMaxCell)}};
}

std::vector<Cell> chunksAround(const CellRect& cells) {
  std::vector<Cell> corners;
  const auto grown = [](std::int32_t index, std::int32_t by) { return std::clamp(index + by, -kMaxCell, kMaxCell); };
  const Cell min = chunkAround({grown(cells.min.i, -kInChunk - 1), grown(cells.min.j, -kInChunk - 1)}).min;
  const Cell max = chunkAround({grown(cells.max.i, kInChunk + 1), grown(cells.max.j, kInChunk + 1)}).max;
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

bool reloadInside(World& world, const CellRect& chunks, const Shelf& shelf, std::size_t& most) noexcept {
  while (const auto cell = world.firstUnloaded(chunks)) {
    if (most == 0) return false;
    const auto bytes = shelf.get(chunkAround(*cell).min);
    if (!bytes || !world.reload(*bytes)) return false;
    --most;
  }
  return true;
}

// A copy gives the bytes, so that nothing leaves the world itself. What an undo owes to a chunk on the shelf is paid
// when it comes back: so each of them comes back, and leaves again.
Expected<void> saveGround(const World& world, const Shelf& shelf, const std::vector<Rock>& rocks,
                          const std::vector<Cell>& land, const ByteSink& sink) {
  World copy = world;
  std::vector<std::byte> out;
  putNumber(out, kFormat);
  putNumber(out, land.size());
  for (const Cell corner : land) putPair(out, corner.i, corner.j);
  putNumber(out, rocks.size());
  for (const Rock& rock : rocks) putRock(out, rock);
  sink(out);
  const ChunkSink write = [&](Cell, std::span<const std::byte> bytes) {
    out.clear();
    putNumber(out, bytes.size());
    sink(out);
    sink(bytes);
  };
  const std::vector<CellRect> away = unloadedChunks(world);
  if (const auto done = copy.unload({{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}}, write); !done)
    return tl::unexpected(done.error());
  for (const CellRect& chunk : away) {
    const auto bytes = shelf.get(chunk.min);
    if (!bytes || !copy.reload(*bytes)) return tl::unexpected(Error{.code = ErrorCode::unloaded, .cell = chunk.min});
    if (const auto done = copy.unload(chunk, write); !done) return tl::unexpected(done.error());
  }
  write({}, {});  // the end
  return {};
}

std::optional<LoadedGround> loadGround(std::span<const std::byte> bytes, const PreserveRelation& preserve,
                                       const CellRect& window, const Shelf& shelf) {
  Reader in(bytes);
  if (in.number() != kFormat) return std::nullopt;
  LoadedGround loaded{World(preserve), {}, {}};
  for (std::uint64_t count = in.count(8); count > 0; --count) {
    const auto [i, j] = in.pair();
    loaded.land.push_back({i, j});
  }
  for (std::uint64_t count = in.count(8); count > 0; --count) {
    auto rock = takeRock(bytes);
    if (!rock) return std::nullopt;
    loaded.rocks.push_back(std::move(*rock));
  }
  std::vector<std::pair<Cell, std::vector<std::byte>>> leave;
  while (const auto size = static_cast<std::size_t>(in.count(1))) {
    const auto corner = loaded.world.reload(bytes.first(size));
    if (!corner) return std::nullopt;
    bytes = bytes.subspan(size);
    if (contains(window, *corner)) continue;
    const auto keep = [&](Cell chunk, std::span<const std::byte> kept) {
      leave.emplace_back(chunk, std::vector(kept.begin(), kept.end()));
    };
    if (!loaded.world.unload(chunkAround(*corner), keep)) return std::nullopt;
  }
  if (!in.isGood() || !bytes.empty()) return std::nullopt;
  for (const auto& [corner, kept] : leave) shelf.put(corner, kept);
  return loaded;
}

Expected<RockInParts> RockInParts::of(Rock rock, const Placing& placing, std::size_t polygonsAtOnce) {
  auto parts = partsAsTheyLie(rock.ground, placing, polygonsAtOnce);
  if (!parts) return tl::unexpected(parts.error());
  RockInParts made;
  made.rock_ = std::move(rock);
  made.placing_ = placing;
  made.atOnce_ = polygonsAtOnce;
  made.parts_ = std::move(*parts);
  bool isFirst = true;
  for (const std::vector<LyingBlock>& part : made.parts_)
    for (const LyingBlock& one : part)
      for (const Ring& ring : one.region.rings)
        for (const Point p : ring) {
          if (std::exchange(isFirst, false)) made.min_ = made.max_ = p;
          made.min_ = {std::min(made.min_.x, p.x), std::min(made.min_.y, p.y)};
          made.max_ = {std::max(made.max_.x, p.x), std::max(made.max_.y, p.y)};
        }
  return made;
}

Rock RockInParts::rest(std::size_t from) const {
  if (from == 0) return rock_;
  Rock rest{rock_.ground, placing_};
  auto& polygons = rest.ground.polygons;
  polygons.erase(polygons.begin(),
                 polygons.begin() + static_cast<std::ptrdiff_t>(std::min(from * atOnce_, polygons.size())));
  rest.ground.cells = cellsOf(rest.ground);
  rest.ground.mass = massOf(polygons);
  return rest;
}

bool RockInParts::isNear(const LoopFacts& loop) const {
  return loop.min.x <= max_.x && min_.x <= loop.max.x && loop.min.y <= max_.y && min_.y <= loop.max.y;
}

CellRect RockInParts::chunks() const {
  return boxOf(chunkAround(cellAt({min_.x - 1, min_.y - 1})), chunkAround(cellAt({max_.x + 1, max_.y + 1})));
}

Expected<void> RockInParts::put(World& world, std::size_t from, std::size_t to) const noexcept {
  Transaction group = world.edit();
  for (std::size_t part = from; part < to; ++part)
    if (const auto done = putPart(world, parts_[part]); !done) return done;
  group.keep();
  return {};
}

NoPhysics::Handle NoPhysics::make(const Rock& rock) {
  rocks_[++last_] = rock;
  return last_;
}

namespace {

/// In cells.
double areaIn(const World& world, const CellRect& cells) {
  std::int64_t twice = 0;
  world.forEachPolygon(cells, [&](Cell, const PlacedPolygon& p) {
    for (std::size_t k = 0; k < p.vertices.size(); ++k) {
      const LocalPoint a = p.vertices[k], b = p.vertices[k + 1 < p.vertices.size() ? k + 1 : 0];
      twice += std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
    }
  });
  return static_cast<double>(twice) / 2 / kUnitsPerCell / kUnitsPerCell;
}
/// How long its outline is, in cells.
double sidesOf(const Body& body) {
  const auto world = detail::worldOf(body, std::vector<Block>(body.polygons.size()));
  if (!world) return 0;
  double sum = 0;
  for (const SegmentId id : world->segments()) {
    const Segment side = world->segment(id).value();
    sum += std::hypot(side.end.x - side.start.x, side.end.y - side.start.y);
  }
  return sum / kUnitsPerCell;
}

/// What is ground already would stay, and that part of the rock be lost: so it is refused.
Expected<void> putWhole(World& world, const Rock& rock) {
  const auto lying = RockInParts::of(rock, rock.placing, rock.ground.polygons.size());
  if (!lying) return tl::unexpected(lying.error());
  const CellRect cells = lying->chunks();
  const double before = areaIn(world, cells);
  Transaction group = world.edit();
  if (const auto done = lying->put(world, 0, lying->count()); !done) return done;
  if (areaIn(world, cells) - before < rock.ground.mass.area - sidesOf(rock.ground) / 100)
    return tl::unexpected(Error{.code = ErrorCode::overlap});
  group.keep();
  return {};
}

}  // namespace

Expected<void> NoPhysics::settle(Handle handle) {
  const Rock& rock = rocks_.at(handle);
  const auto& [ground, placing, velocity, spin] = rock;
  const Point at = latticePoint(placing.origin);
  if (placing.cosine == 1 && inRange(at) && toWorld(cellAt(at), {}) == at) {
    if (const auto done = put(world_, ground, cellAt(at)); !done) return tl::unexpected(done.error());
  } else if (const auto done = putWhole(world_, rock); !done) {
    return done;
  }
  destroy(handle);
  return {};
}

}  // namespace lgs
