// Shapes, edits and groups of edits.
#include "inside.h"

#include <cstddef>

using namespace lgs::c;
using lgs::Expected;
using lgs::PolygonHandle;
using lgs::ShapeId;

namespace {

static_assert(offsetof(lgs_placement, shape) == offsetof(lgs::Placement, shape) &&
              offsetof(lgs_placement, block) == offsetof(lgs::Placement, block));

/// The vertices of a polygon as C++ has them. Of too many it takes one too many: that is enough to refuse them.
template <class From, class To>
std::span<const To> copied(const From* vertices, std::size_t count, std::vector<To>& to) {
  copyBytes(vertices, std::min(count, lgs::kMaxVerticesPerCell + 1), to);
  return to;
}

// The same in the working memory for points of each kind.
auto pointsOf(lgs_world& w, const lgs_local_point* vertices, std::size_t count) {
  return copied(vertices, count, w.points);
}
auto pointsOf(lgs_world& w, const lgs_float_point* vertices, std::size_t count) {
  return copied(vertices, count, w.floats);
}
auto pointsOf(lgs_world& w, const lgs_double_point* vertices, std::size_t count) {
  return copied(vertices, count, w.doubles);
}

lgs_status answer(const Expected<ShapeId>& made, lgs_shape_id* out, lgs_error* error) {
  if (!made) return refuse(made.error(), error);
  put(out, lgs_shape_id{made->value});
  return LGS_OK;
}

lgs_status answer(const Expected<PolygonHandle>& placed, lgs_polygon_id* out, lgs_error* error) {
  if (!placed) return refuse(placed.error(), error);
  put(out, toC(*placed));
  return LGS_OK;
}

lgs_status answer(const Expected<std::uint64_t>& number, uint64_t* out, lgs_error* error) {
  if (!number) return refuse(number.error(), error);
  put(out, *number);
  return LGS_OK;
}

lgs_status answer(const Expected<void>& done, lgs_error* error) { return done ? LGS_OK : refuse(done.error(), error); }

template <class PointC>
lgs_status makeShape(lgs_world* world, const PointC* vertices, std::size_t count, lgs_shape_id* out, lgs_error* error) {
  if (!world || !isArray(vertices, count)) return refuse(LGS_BAD_ARGUMENT, error);
  return answer(world->world.shape(pointsOf(*world, vertices, count)), out, error);
}

template <class PointC>
lgs_status addPolygon(lgs_world* world, lgs_cell cell, const PointC* vertices, std::size_t count, lgs_block block,
                      lgs_polygon_id* out, lgs_error* error) {
  if (!world || !isArray(vertices, count)) return refuse(LGS_BAD_ARGUMENT, error);
  return answer(world->world.add(fromC(cell), pointsOf(*world, vertices, count), block), out, error);
}

/// An edit that gives as many handles as there is room for.
template <class Edit>
lgs_status withHandles(lgs_world* world, lgs_polygon_id* out, std::size_t capacity, lgs_error* error, Edit&& edit) {
  if (!world || !isArray(out, capacity)) return refuse(LGS_BAD_ARGUMENT, error);
  std::vector<PolygonHandle> handles(std::min(capacity, lgs::kMaxPolygonsPerCell));
  const Expected<PolygonHandle> done = edit(world->world, std::span(handles));
  if (!done) return refuse(done.error(), error);
  for (std::size_t k = 0; k < handles.size() && handles[k]; ++k) out[k] = toC(handles[k]);
  return LGS_OK;
}

}  // namespace

// --- Shapes ----------------------------------------------------------------------------------------------------------

lgs_status lgs_shape(lgs_world* world, const lgs_local_point* vertices, size_t count, lgs_shape_id* shape,
                     lgs_error* error) noexcept {
  return makeShape(world, vertices, count, shape, error);
}
lgs_status lgs_shape_floats(lgs_world* world, const lgs_float_point* vertices, size_t count, lgs_shape_id* shape,
                            lgs_error* error) noexcept {
  return makeShape(world, vertices, count, shape, error);
}
lgs_status lgs_shape_doubles(lgs_world* world, const lgs_double_point* vertices, size_t count, lgs_shape_id* shape,
                             lgs_error* error) noexcept {
  return makeShape(world, vertices, count, shape, error);
}

lgs_status lgs_shape_of_several(lgs_world* world, const lgs_local_point* vertices, const uint32_t* counts,
                                size_t polygons, lgs_shape_id* shape, lgs_error* error) noexcept {
  if (!world || !isArray(counts, polygons)) return refuse(LGS_BAD_ARGUMENT, error);
  if (polygons > lgs::kMaxPolygonsPerCell) return refuse(LGS_CAPACITY, error);
  std::vector<std::vector<lgs::LocalPoint>> all;
  for (std::size_t k = 0; k < polygons; ++k) {
    if (!isArray(vertices, counts[k])) return refuse(LGS_BAD_ARGUMENT, error);
    copied(vertices, counts[k], all.emplace_back());
    if (counts[k] > lgs::kMaxVerticesPerCell) break;  // it is refused: what follows is of no interest
    if (counts[k] != 0) vertices += counts[k];
  }
  return answer(world->world.shape(std::span<const std::vector<lgs::LocalPoint>>(all)), shape, error);
}

lgs_status lgs_shape_polygons(const lgs_world* world, lgs_shape_id shape, size_t* count) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  const auto polygons = world->world.polygonsOf(fromC(shape));
  if (!polygons) return refuse(polygons.error(), nullptr);
  put(count, polygons->size());
  return LGS_OK;
}

lgs_status lgs_shape_vertices(const lgs_world* world, lgs_shape_id shape, size_t polygon, lgs_local_point* vertices,
                              size_t capacity, size_t* count) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  const auto polygons = world->world.polygonsOf(fromC(shape));
  if (!polygons) return refuse(polygons.error(), nullptr);
  if (polygon >= polygons->size()) return LGS_BAD_ARGUMENT;
  return putList((*polygons)[polygon], vertices, capacity, count);
}

lgs_status lgs_shape_box(const lgs_world* world, lgs_shape_id shape, lgs_local_box* box) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  const auto found = world->world.boundingBox(fromC(shape));
  if (!found) return refuse(found.error(), nullptr);
  put(box, lgs_local_box{toC(found->min), toC(found->max)});
  return LGS_OK;
}

// --- Edits -----------------------------------------------------------------------------------------------------------

lgs_status lgs_add(lgs_world* world, lgs_cell cell, lgs_shape_id shape, lgs_block block, lgs_polygon_id* polygon,
                   lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  return answer(world->world.add(fromC(cell), fromC(shape), block), polygon, error);
}

lgs_status lgs_add_several(lgs_world* world, lgs_cell cell, lgs_shape_id shape, lgs_block block,
                           lgs_polygon_id* polygons, size_t capacity, lgs_error* error) noexcept {
  return withHandles(world, polygons, capacity, error, [&](lgs::World& w, std::span<PolygonHandle> handles) {
    return w.add(fromC(cell), fromC(shape), block, handles);
  });
}

lgs_status lgs_add_points(lgs_world* world, lgs_cell cell, const lgs_local_point* vertices, size_t count,
                          lgs_block block, lgs_polygon_id* polygon, lgs_error* error) noexcept {
  return addPolygon(world, cell, vertices, count, block, polygon, error);
}
lgs_status lgs_add_floats(lgs_world* world, lgs_cell cell, const lgs_float_point* vertices, size_t count,
                          lgs_block block, lgs_polygon_id* polygon, lgs_error* error) noexcept {
  return addPolygon(world, cell, vertices, count, block, polygon, error);
}
lgs_status lgs_add_doubles(lgs_world* world, lgs_cell cell, const lgs_double_point* vertices, size_t count,
                           lgs_block block, lgs_polygon_id* polygon, lgs_error* error) noexcept {
  return addPolygon(world, cell, vertices, count, block, polygon, error);
}

lgs_status lgs_add_many(lgs_world* world, const lgs_placement* placements, size_t count, lgs_polygon_id* polygons,
                        lgs_error* error) noexcept {
  if (!world || !isArray(placements, count)) return refuse(LGS_BAD_ARGUMENT, error);
  if (count > lgs::kMaxEntries) return refuse(LGS_CAPACITY, error);  // before it is copied
  std::vector<lgs::Placement> all;
  copyBytes(placements, count, all);
  std::vector<PolygonHandle> handles(polygons ? count : 0);
  const auto done = world->world.addMany(all, handles);
  for (std::size_t k = 0; polygons && k < count; ++k) polygons[k] = toC(handles[k]);
  return answer(done, error);
}

lgs_status lgs_remove(lgs_world* world, lgs_polygon_id polygon, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  return answer(world->world.remove(fromC(polygon)), error);
}

lgs_status lgs_remove_many(lgs_world* world, const lgs_polygon_id* polygons, size_t count, lgs_error* error) noexcept {
  if (!world || !isArray(polygons, count)) return refuse(LGS_BAD_ARGUMENT, error);
  if (count > lgs::kMaxEntries) return refuse(LGS_CAPACITY, error);
  std::vector<PolygonHandle> all;
  copyBytes(polygons, count, all);
  return answer(world->world.removeMany(all), error);
}

lgs_status lgs_replace(lgs_world* world, lgs_cell cell, lgs_shape_id shape, lgs_block block, lgs_polygon_id* polygons,
                       size_t capacity, lgs_error* error) noexcept {
  return withHandles(world, polygons, capacity, error, [&](lgs::World& w, std::span<PolygonHandle> handles) {
    return w.replace(fromC(cell), fromC(shape), block, handles);
  });
}

lgs_status lgs_exchange(lgs_world* world, lgs_cell cell, const lgs_polygon_id* removed, size_t removed_count,
                        const lgs_new_polygon* added, size_t added_count, lgs_polygon_id* polygons,
                        lgs_error* error) noexcept {
  if (!world || !isArray(removed, removed_count) || !isArray(added, added_count))
    return refuse(LGS_BAD_ARGUMENT, error);
  if (added_count > lgs::kMaxPolygonsPerCell) return refuse(LGS_CAPACITY, error);
  // More than a cell can hold are refused in any case: for the first that is stale, or that comes twice.
  std::vector<PolygonHandle> gone(std::min(removed_count, lgs::kMaxPolygonsPerCell + 1)), handles(added_count);
  for (std::size_t k = 0; k < gone.size(); ++k) gone[k] = fromC(removed[k]);
  std::vector<std::vector<lgs::LocalPoint>> vertices(added_count);
  std::vector<lgs::NewPolygon> come;
  for (std::size_t k = 0; k < added_count; ++k) {
    if (!isArray(added[k].vertices, added[k].count) || added[k].reserved != 0) return refuse(LGS_BAD_ARGUMENT, error);
    come.push_back({copied(added[k].vertices, added[k].count, vertices[k]), added[k].block});
  }
  const auto done = world->world.exchange(fromC(cell), gone, come, handles);
  if (!done) return refuse(done.error(), error);
  if (polygons) std::ranges::transform(handles, polygons, [](PolygonHandle handle) { return toC(handle); });
  return LGS_OK;
}

lgs_status lgs_set_block(lgs_world* world, lgs_polygon_id polygon, lgs_block block, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  return answer(world->world.setBlock(fromC(polygon), block), error);
}

lgs_status lgs_fill(lgs_world* world, lgs_cell_rect cells, lgs_shape_id shape, lgs_block block, uint64_t* filled,
                    lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  return answer(world->world.fill(fromC(cells), fromC(shape), block), filled, error);
}

lgs_status lgs_clear(lgs_world* world, lgs_cell_rect cells, uint64_t* removed, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  return answer(world->world.clear(fromC(cells)), removed, error);
}

lgs_status lgs_forget_chunks(lgs_world* world, lgs_cell_rect cells, uint64_t* forgotten, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  return answer(world->world.forgetChunks(fromC(cells)), forgotten, error);
}

lgs_status lgs_unload(lgs_world* world, lgs_cell_rect cells, lgs_chunk_fn take, void* user, uint64_t* unloaded,
                      lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  const lgs::ChunkSink sink = [&](lgs::Cell corner, std::span<const std::byte> bytes) {
    if (take) take(user, toC(corner), reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  };
  return answer(world->world.unload(fromC(cells), sink), unloaded, error);
}

lgs_status lgs_reload(lgs_world* world, const uint8_t* bytes, size_t count, lgs_cell* corner,
                      lgs_error* error) noexcept {
  if (!world || !isArray(bytes, count)) return refuse(LGS_BAD_ARGUMENT, error);
  const auto done = world->world.reload(std::as_bytes(std::span(bytes, count)));
  if (!done) return refuse(done.error(), error);
  put(corner, toC(*done));
  return LGS_OK;
}

lgs_status lgs_reload_empty(lgs_world* world, lgs_cell_rect cells, uint64_t* reloaded, lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  return answer(world->world.reloadEmpty(fromC(cells)), reloaded, error);
}

lgs_status lgs_first_unloaded(const lgs_world* world, lgs_cell_rect cells, int32_t* found, lgs_cell* first) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  const auto cell = world->world.firstUnloaded(fromC(cells));
  put(found, std::int32_t{cell.has_value()});
  if (cell) put(first, toC(*cell));
  return LGS_OK;
}

// --- Groups ----------------------------------------------------------------------------------------------------------

struct lgs_group {
  lgs::Transaction transaction;
};

lgs_status lgs_begin(lgs_world* world, lgs_group** group) noexcept {
  if (!world || !group) return LGS_BAD_ARGUMENT;
  *group = new lgs_group{lgs::Transaction(world->world)};
  return LGS_OK;
}

void lgs_keep(lgs_group* group) noexcept {
  if (group) group->transaction.keep();
  delete group;
}

void lgs_undo(lgs_group* group) noexcept { delete group; }
