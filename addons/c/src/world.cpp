// Worlds: made, copied, compared, saved, loaded and counted.
#include "inside.h"

#include <memory>

using namespace lgs::c;

namespace {

/// The size of the first version of the options. No caller has a smaller one.
constexpr std::size_t kFirstOptions = sizeof(lgs_world_options);

constexpr lgs_world_options kDefault{sizeof(lgs_world_options), 0, nullptr, nullptr};

/// Whether these options are of a size that this library knows.
bool areKnown(const lgs_world_options* options) {
  return !options ||
         (options->size >= kFirstOptions && options->size <= sizeof(lgs_world_options) && options->reserved == 0);
}

lgs::PreserveRelation relationOf(const lgs_world_options* options) {
  if (!options || !options->preserve) return {};
  return [preserve = options->preserve, user = options->user](lgs::Block a, lgs::Block b) {
    return preserve(user, a, b) != 0;
  };
}

/// What the C side of a world takes, beside the world.
std::uint64_t ownBytes(const lgs_world& w) {
  const auto of = [](const auto&... v) { return (... + (v.capacity() * sizeof(v[0]))); };
  return sizeof w - sizeof w.world + of(w.changed, w.points, w.floats, w.doubles);
}

}  // namespace

void lgs_default_world_options(lgs_world_options* options, size_t size) noexcept {
  if (!options) return;
  lgs_world_options filled = kDefault;
  filled.size = static_cast<std::uint32_t>(std::min(size, sizeof filled));
  std::memcpy(options, &filled, filled.size);
}

lgs_status lgs_new(const lgs_world_options* options, lgs_world** world) noexcept {
  if (!world || !areKnown(options)) return LGS_BAD_ARGUMENT;
  *world = new lgs_world(lgs::World(relationOf(options)));
  return LGS_OK;
}

void lgs_free(lgs_world* world) noexcept { delete world; }

lgs_status lgs_copy(const lgs_world* world, lgs_world** copy) noexcept {
  if (!world || !copy) return LGS_BAD_ARGUMENT;
  *copy = new lgs_world(lgs::World(world->world));
  return LGS_OK;
}

lgs_status lgs_same_polygons(const lgs_world* a, const lgs_world* b, int32_t* same) noexcept {
  if (!a || !b) return LGS_BAD_ARGUMENT;
  put(same, std::int32_t{lgs::samePolygons(a->world, b->world)});
  return LGS_OK;
}

lgs_status lgs_preserves(const lgs_world* world, lgs_block a, lgs_block b, int32_t* preserves) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  const lgs::PreserveRelation& relation = world->world.preserveRelation();
  put(preserves, std::int32_t{relation && relation(std::min(a, b), std::max(a, b))});
  return LGS_OK;
}

lgs_status lgs_save(const lgs_world* world, lgs_write_fn write, void* user, lgs_error* error) noexcept {
  if (!world || !write) return refuse(LGS_BAD_ARGUMENT, error);
  const auto done = world->world.save([&](std::span<const std::byte> bytes) {
    write(user, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  });
  return done ? LGS_OK : refuse(done.error(), error);
}

lgs_status lgs_save_to_buffer(const lgs_world* world, uint8_t* bytes, size_t capacity, size_t* count,
                              lgs_error* error) noexcept {
  if (!world || !isArray(bytes, capacity)) return refuse(LGS_BAD_ARGUMENT, error);
  std::size_t size = 0;
  const auto done = world->world.save([&](std::span<const std::byte> piece) {
    if (size < capacity) std::memcpy(bytes + size, piece.data(), std::min(piece.size(), capacity - size));
    size += piece.size();
  });
  if (!done) return refuse(done.error(), error);
  put(count, size);
  return size <= capacity ? LGS_OK : refuse(LGS_SHORT_BUFFER, error);
}

lgs_status lgs_load(const uint8_t* bytes, size_t count, const lgs_world_options* options, lgs_world** world,
                    lgs_error* error) noexcept {
  if (!world || !isArray(bytes, count) || !areKnown(options)) return refuse(LGS_BAD_ARGUMENT, error);
  auto loaded = lgs::World::load(std::as_bytes(std::span(bytes, count)), relationOf(options));
  if (!loaded) return refuse(loaded.error(), error);
  *world = new lgs_world(std::move(*loaded));
  return LGS_OK;
}

lgs_status lgs_count(const lgs_world* world, lgs_stats* stats) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  const lgs::Stats s = world->world.stats();
  put(stats,
      lgs_stats{s.polygons, s.cells, s.segments, s.shapes, s.contents, s.chunks, s.bytes + ownBytes(*world), {}});
  return LGS_OK;
}

uint64_t lgs_world_version(const lgs_world* world) noexcept { return world ? world->world.version() : 0; }
uint32_t lgs_max_segment_id(const lgs_world* world) noexcept { return world ? world->world.maxSegmentId() : 0; }
