// A Ground as bytes, and back.
#include "by_block.h"

#include <lgs/ground_window.h>
#include <lgs/unloaded.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace lgs {
namespace {

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

}  // namespace

bool isSound(const Rock& rock) {
  const auto& [origin, cosine, sine] = rock.placing;
  const std::array reals{rock.velocity.x, rock.velocity.y, rock.spin};
  return std::abs(origin.x) <= kMaxCell + 1.0 && std::abs(origin.y) <= kMaxCell + 1.0 &&
         std::ranges::all_of(reals, [](double real) { return std::abs(real) < 1e9; }) &&
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
  ground.cells = detail::cellsOf(ground);
  ground.mass = massOf(ground.polygons);
  return rock;
}

// What an undo owes to a chunk on the shelf is paid when it comes back: so each of them comes back, and leaves again.
Expected<void> saveGround(World world, const Shelf& shelf, const std::vector<Rock>& rocks,
                          const std::vector<Cell>& land, const ByteSink& sink) {
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
  if (const auto done = world.unload({{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}}, write); !done)
    return tl::unexpected(done.error());
  for (const CellRect& chunk : away) {
    const auto bytes = shelf.get(chunk.min);
    if (!bytes || !world.reload(*bytes)) return tl::unexpected(Error{.code = ErrorCode::unloaded, .cell = chunk.min});
    if (const auto done = world.unload(chunk, write); !done) return tl::unexpected(done.error());
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

}  // namespace lgs
