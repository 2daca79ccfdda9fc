// Loops, islands, bodies, pieces and hashes.
#include "body.h"

#include <lgs/hashes.h>
#include <lgs/islands.h>
#include <lgs/lgs_views.h>
#include <lgs/pieces.h>

#include <algorithm>

using namespace lgs::c;

struct lgs_islands {
  lgs::Islands view;
};
struct lgs_foreseen {
  lgs::Foreseen would;
};
struct lgs_pieces {
  lgs::Pieces view;
  std::vector<lgs_cell> changed;  ///< by the last update
};
struct lgs_hashes {
  lgs::GroundHashes view;
};

namespace {

lgs_cell_rect described(const lgs::CellRect& r) { return {toC(r.min), toC(r.max)}; }
lgs_hashed_square described(const lgs::HashedSquare& s) { return {s.hash, described(s.cells), s.level, 0}; }

lgs_loop_facts described(const lgs::LoopFacts& f) {
  return {f.doubleArea.high, f.doubleArea.low, f.area(),        toC(f.min), toC(f.max),
          toC(f.west),       {f.id.value},     {f.first.value}, f.segments, 0};
}
lgs_island described(const lgs::IslandFacts& f) { return {described(f.outer), f.anchors, {f.id.value}, 0}; }

template <class Out, class Id>
lgs_status putIds(const std::vector<Id>& ids, Out* out, std::size_t capacity, std::size_t* count) {
  return putList(ids, out, capacity, count, [](Id id) { return Out{id.value}; });
}
/// What islands and loops both list.
template <class Out, class View>
lgs_status putIdsOf(const View& view, std::int32_t which, Out* out, std::size_t capacity, std::size_t* count) {
  switch (which) {
    case LGS_ALL:
      return putIds(view.all(), out, capacity, count);
    case LGS_ADDED:
      return putIds(view.changes().added, out, capacity, count);
    case LGS_REMOVED:
      return putIds(view.changes().removed, out, capacity, count);
    case LGS_CHANGED:
      return putIds(view.changes().changed, out, capacity, count);
    default:
      return LGS_BAD_ARGUMENT;
  }
}
template <class Out, class Pair>
lgs_status putPairs(const std::vector<Pair>& pairs, Out* out, std::size_t capacity, std::size_t* count) {
  return putList(pairs, out, capacity, count, [](const Pair& p) { return Out{{p.from.value}, {p.into.value}}; });
}

std::vector<lgs::SegmentId> listOf(const lgs_segment_id* ids, std::size_t count) {
  std::vector<lgs::SegmentId> list(count);
  for (std::size_t k = 0; k < count; ++k) list[k] = fromC(ids[k]);
  return list;
}

std::span<const lgs::Piece> piecesOf(const lgs_pieces& pieces, lgs_cell cell, std::int32_t part) {
  return part == LGS_SOLID ? pieces.view.solidPieces(fromC(cell)) : pieces.view.freePieces(fromC(cell));
}

lgs_status newIslands(const lgs_world* world, lgs_anchor_fn is_anchor, void* user, lgs::AtEdge atEdge,
                      lgs_islands** islands) {
  if (!world || !islands) return LGS_BAD_ARGUMENT;
  lgs::IsAnchor isAnchor;
  if (is_anchor)
    isAnchor = [is_anchor, user](lgs::Block block, lgs::Cell cell) { return is_anchor(user, block, toC(cell)) != 0; };
  *islands = new lgs_islands{lgs::Islands(world->world, std::move(isAnchor), atEdge)};
  return LGS_OK;
}

/// Without the lists.
lgs::Changes versionsOf(const lgs_changes& changes) {
  lgs::Changes versions;
  versions.before = changes.before;
  versions.after = changes.after;
  return versions;
}

}  // namespace

lgs_status lgs_islands_new(const lgs_world* world, lgs_anchor_fn is_anchor, void* user,
                           lgs_islands** islands) noexcept {
  return newIslands(world, is_anchor, user, lgs::AtEdge::holds, islands);
}

lgs_status lgs_islands_new_open(const lgs_world* world, lgs_anchor_fn is_anchor, void* user,
                                lgs_islands** islands) noexcept {
  return newIslands(world, is_anchor, user, lgs::AtEdge::open, islands);
}

lgs_status lgs_islands_copy(const lgs_islands* islands, lgs_islands** copy) noexcept {
  if (!islands || !copy) return LGS_BAD_ARGUMENT;
  *copy = new lgs_islands(*islands);
  return LGS_OK;
}

void lgs_islands_free(lgs_islands* islands) noexcept { delete islands; }

lgs_status lgs_islands_update(lgs_islands* islands, const lgs_world* world, const lgs_changes* changes) noexcept {
  if (!islands || !world || !changes) return LGS_BAD_ARGUMENT;
  if (!isArray(changes->removed, changes->removed_count) || !isArray(changes->added, changes->added_count) ||
      !isArray(changes->relinked, changes->relinked_count))
    return LGS_BAD_ARGUMENT;
  lgs::Changes lists = versionsOf(*changes);
  lists.removed = listOf(changes->removed, changes->removed_count);
  lists.added = listOf(changes->added, changes->added_count);
  lists.relinked = listOf(changes->relinked, changes->relinked_count);
  return islands->view.update(world->world, lists) ? LGS_OK : LGS_BAD_ARGUMENT;
}

lgs_status lgs_islands_ids(const lgs_islands* islands, int32_t which, lgs_island_id* out, size_t capacity,
                           size_t* count) noexcept {
  if (!islands) return LGS_BAD_ARGUMENT;
  if (which == LGS_LOOSE) return putIds(islands->view.loose(), out, capacity, count);
  return putIdsOf(islands->view, which, out, capacity, count);
}

lgs_status lgs_islands_loop_ids(const lgs_islands* islands, int32_t which, lgs_loop_id* out, size_t capacity,
                                size_t* count) noexcept {
  if (!islands) return LGS_BAD_ARGUMENT;
  return putIdsOf(islands->view.loops(), which, out, capacity, count);
}

lgs_status lgs_islands_pairs(const lgs_islands* islands, int32_t which, lgs_island_pair* out, size_t capacity,
                             size_t* count) noexcept {
  if (!islands || (which != LGS_PARTED && which != LGS_JOINED)) return LGS_BAD_ARGUMENT;
  const lgs::IslandChanges& told = islands->view.changes();
  return putPairs(which == LGS_PARTED ? told.cutOff : told.joined, out, capacity, count);
}

lgs_status lgs_islands_loop_pairs(const lgs_islands* islands, int32_t which, lgs_loop_pair* out, size_t capacity,
                                  size_t* count) noexcept {
  if (!islands || (which != LGS_PARTED && which != LGS_JOINED)) return LGS_BAD_ARGUMENT;
  const lgs::LoopChanges& told = islands->view.loops().changes();
  return putPairs(which == LGS_PARTED ? told.split : told.joined, out, capacity, count);
}

lgs_status lgs_islands_get(const lgs_islands* islands, lgs_island_id id, lgs_island* island) noexcept {
  if (!islands) return LGS_BAD_ARGUMENT;
  const auto facts = islands->view.island({id.value});
  if (!facts) return LGS_STALE_HANDLE;
  put(island, described(*facts));
  return LGS_OK;
}

lgs_status lgs_islands_loop(const lgs_islands* islands, lgs_loop_id id, lgs_loop_facts* loop) noexcept {
  if (!islands) return LGS_BAD_ARGUMENT;
  const auto facts = islands->view.loops().loop({id.value});
  if (!facts) return LGS_STALE_HANDLE;
  put(loop, described(*facts));
  return LGS_OK;
}

lgs_status lgs_islands_of(const lgs_islands* islands, const lgs_world* world, lgs_polygon_id polygon,
                          lgs_island_id* island) noexcept {
  if (!islands || !world) return LGS_BAD_ARGUMENT;
  put(island, lgs_island_id{islands->view.of(world->world, fromC(polygon)).value});
  return LGS_OK;
}

lgs_status lgs_islands_loop_of(const lgs_islands* islands, const lgs_world* world, lgs_segment_id segment,
                               lgs_loop_id* loop) noexcept {
  if (!islands || !world) return LGS_BAD_ARGUMENT;
  const lgs::Loops& loops = islands->view.loops();
  const bool isOwn = &loops.outline(world->world) == &world->world;
  put(loop, lgs_loop_id{isOwn ? loops.of(fromC(segment)).value : 0});
  return LGS_OK;
}

lgs_status lgs_take(lgs_world* world, const lgs_islands* islands, lgs_island_id island, lgs_body** body,
                    lgs_error* error) noexcept {
  if (!world || !islands || !body) return refuse(LGS_BAD_ARGUMENT, error);
  auto taken = lgs::take(world->world, islands->view, {island.value});
  if (!taken) return refuse(taken.error(), error);
  *body = new lgs_body(std::move(*taken));
  return LGS_OK;
}

lgs_status lgs_take_apart(lgs_world* world, const lgs_islands* islands, lgs_island_id island, lgs_body** bodies,
                          size_t capacity, size_t* count, lgs_error* error) noexcept {
  if (!world || !islands || !isArray(bodies, capacity)) return refuse(LGS_BAD_ARGUMENT, error);
  lgs::Transaction group = world->world.edit();
  auto taken = lgs::takeApart(world->world, islands->view, {island.value});
  if (!taken) return refuse(taken.error(), error);
  put(count, taken->size());
  if (taken->size() > capacity) return refuse(LGS_SHORT_BUFFER, error);
  group.keep();
  for (std::size_t k = 0; k < taken->size(); ++k) bodies[k] = new lgs_body(std::move((*taken)[k]));
  return LGS_OK;
}

lgs_status lgs_put(lgs_world* world, const lgs_body* body, lgs_cell cell, lgs_polygon_id* polygons, size_t capacity,
                   lgs_error* error) noexcept {
  if (!world || !body || !isArray(polygons, capacity)) return refuse(LGS_BAD_ARGUMENT, error);
  const auto done = lgs::put(world->world, body->body, fromC(cell));
  if (!done) return refuse(done.error(), error);
  for (std::size_t k = 0; k < std::min(done->size(), capacity); ++k) polygons[k] = toC((*done)[k]);
  return LGS_OK;
}

lgs_status lgs_body_get(const lgs_body* body, lgs_body_facts* facts) noexcept {
  if (!body) return LGS_BAD_ARGUMENT;
  const lgs::Body& b = body->body;
  put(facts,
      {b.mass.area, toC(b.mass.centroid), b.mass.secondMoment, described(b.cells), toC(b.origin), b.polygons.size()});
  return LGS_OK;
}

lgs_status lgs_body_polygon_at(const lgs_body* body, size_t index, lgs_body_polygon* polygon) noexcept {
  if (!body || index >= body->body.polygons.size()) return LGS_BAD_ARGUMENT;
  const lgs::BodyPolygon& p = body->body.polygons[index];
  put(polygon, {body->vertices.data() + body->firsts[index], p.vertices.size(), toC(p.cell), p.block, 0});
  return LGS_OK;
}

void lgs_body_free(lgs_body* body) noexcept { delete body; }

lgs_status lgs_foresee(lgs_world* world, lgs_islands* islands, lgs_edit_fn edit, void* user,
                       lgs_foreseen** foreseen) noexcept {
  if (!world || !islands || !edit || !foreseen) return LGS_BAD_ARGUMENT;
  const auto make = [&](lgs::World&) { return edit(user, world) != 0; };
  *foreseen = new lgs_foreseen{lgs::foresee(world->world, islands->view, make)};
  return LGS_OK;
}

void lgs_foreseen_free(lgs_foreseen* foreseen) noexcept { delete foreseen; }

lgs_status lgs_foreseen_ids(const lgs_foreseen* foreseen, int32_t which, lgs_island_id* out, size_t capacity,
                            size_t* count) noexcept {
  if (!foreseen) return LGS_BAD_ARGUMENT;
  const auto& [changes, after] = foreseen->would;
  std::vector<lgs::IslandId> ids;
  switch (which) {
    case LGS_ALL:
    case LGS_LOOSE:
      for (const lgs::IslandFacts& f : after)
        if (which == LGS_ALL || f.anchors == 0) ids.push_back(f.id);
      break;
    case LGS_ADDED:
      ids = changes.added;
      break;
    case LGS_REMOVED:
      ids = changes.removed;
      break;
    case LGS_CHANGED:
      ids = changes.changed;
      break;
    default:
      return LGS_BAD_ARGUMENT;
  }
  return putIds(ids, out, capacity, count);
}

lgs_status lgs_foreseen_pairs(const lgs_foreseen* foreseen, int32_t which, lgs_island_pair* out, size_t capacity,
                              size_t* count) noexcept {
  if (!foreseen || (which != LGS_PARTED && which != LGS_JOINED)) return LGS_BAD_ARGUMENT;
  const lgs::IslandChanges& changes = foreseen->would.changes;
  return putPairs(which == LGS_PARTED ? changes.cutOff : changes.joined, out, capacity, count);
}

lgs_status lgs_foreseen_get(const lgs_foreseen* foreseen, lgs_island_id id, lgs_island* island) noexcept {
  if (!foreseen) return LGS_BAD_ARGUMENT;
  const auto& after = foreseen->would.after;
  const auto found = std::ranges::find(after, lgs::IslandId{id.value}, &lgs::IslandFacts::id);
  if (found == after.end()) return LGS_STALE_HANDLE;
  put(island, described(*found));
  return LGS_OK;
}

lgs_status lgs_pieces_new(const lgs_world* world, size_t max_vertices, lgs_pieces** pieces) noexcept {
  if (!world || !pieces || max_vertices < 3 || max_vertices > lgs::kMaxVerticesPerCell) return LGS_BAD_ARGUMENT;
  *pieces = new lgs_pieces{lgs::Pieces(world->world, {max_vertices}), {}};
  return LGS_OK;
}

lgs_status lgs_pieces_copy(const lgs_pieces* pieces, lgs_pieces** copy) noexcept {
  if (!pieces || !copy) return LGS_BAD_ARGUMENT;
  *copy = new lgs_pieces(*pieces);
  return LGS_OK;
}

void lgs_pieces_free(lgs_pieces* pieces) noexcept { delete pieces; }

lgs_status lgs_pieces_update(lgs_pieces* pieces, const lgs_world* world, const lgs_changes* changes,
                             const lgs_cell** cells, size_t* count) noexcept {
  if (!pieces || !world || !changes || !pieces->view.update(world->world, versionsOf(*changes)))
    return LGS_BAD_ARGUMENT;
  pieces->changed.clear();
  for (const lgs::Cell cell : pieces->view.changed()) pieces->changed.push_back(toC(cell));
  put<const lgs_cell*>(cells, pieces->changed.data());
  put(count, pieces->changed.size());
  return LGS_OK;
}

lgs_status lgs_pieces_count(const lgs_pieces* pieces, lgs_cell cell, int32_t part, size_t* count) noexcept {
  if (!pieces || (part != LGS_SOLID && part != LGS_FREE)) return LGS_BAD_ARGUMENT;
  put(count, piecesOf(*pieces, cell, part).size());
  return LGS_OK;
}

lgs_status lgs_pieces_get(const lgs_pieces* pieces, const lgs_world* world, lgs_cell cell, int32_t part, size_t index,
                          lgs_local_point* vertices, size_t capacity, size_t* count, lgs_polygon_id* polygon) noexcept {
  if (!pieces || !world || (part != LGS_SOLID && part != LGS_FREE)) return LGS_BAD_ARGUMENT;
  const auto list = piecesOf(*pieces, cell, part);
  if (index >= list.size() || !isArray(vertices, capacity)) return LGS_BAD_ARGUMENT;
  const lgs::Piece& piece = list[index];
  if (polygon) {
    lgs::PolygonHandle handle;
    if (part == LGS_SOLID) {
      const auto held = lgs::polygonsByPieces(world->world, fromC(cell));
      if (piece.polygon < held.size()) handle = held[piece.polygon].handle;
    }
    *polygon = toC(handle);
  }
  return putList(piece.vertices, vertices, capacity, count);
}

lgs_status lgs_pieces_portals(const lgs_pieces* pieces, lgs_cell cell, uint32_t index, lgs_portal* out, size_t capacity,
                              size_t* count) noexcept {
  if (!pieces) return LGS_BAD_ARGUMENT;
  return putList(pieces->view.portals({fromC(cell), index}), out, capacity, count, [](const lgs::Portal& p) {
    return lgs_portal{toC(p.to.cell), p.to.index, 0, toC(p.right), toC(p.left)};
  });
}

lgs_status lgs_hashes_new(const lgs_world* world, lgs_hashes** hashes) noexcept {
  if (!world || !hashes) return LGS_BAD_ARGUMENT;
  *hashes = new lgs_hashes{lgs::GroundHashes(world->world)};
  return LGS_OK;
}

lgs_status lgs_hashes_copy(const lgs_hashes* hashes, lgs_hashes** copy) noexcept {
  if (!hashes || !copy) return LGS_BAD_ARGUMENT;
  *copy = new lgs_hashes(*hashes);
  return LGS_OK;
}

void lgs_hashes_free(lgs_hashes* hashes) noexcept { delete hashes; }

lgs_status lgs_hashes_update(lgs_hashes* hashes, const lgs_world* world, const lgs_changes* changes) noexcept {
  if (!hashes || !world || !changes) return LGS_BAD_ARGUMENT;
  return hashes->view.update(world->world, versionsOf(*changes)) ? LGS_OK : LGS_BAD_ARGUMENT;
}

lgs_status lgs_hashes_whole(const lgs_hashes* hashes, lgs_hashed_square* square) noexcept {
  if (!hashes) return LGS_BAD_ARGUMENT;
  put(square, described(hashes->view.whole()));
  return LGS_OK;
}

lgs_status lgs_hashes_in(const lgs_hashes* hashes, lgs_cell_rect cells, int32_t level, lgs_hashed_square* out,
                         size_t capacity, size_t* count) noexcept {
  if (!hashes) return LGS_BAD_ARGUMENT;
  return putList(hashes->view.hashes(fromC(cells), level), out, capacity, count,
                 [](const lgs::HashedSquare& square) { return described(square); });
}

lgs_status lgs_hashes_differences(const lgs_hashes* a, const lgs_hashes* b, lgs_cell_rect* out, size_t capacity,
                                  size_t* count) noexcept {
  if (!a || !b) return LGS_BAD_ARGUMENT;
  return putList(differences(a->view, b->view), out, capacity, count,
                 [](const lgs::CellRect& cells) { return described(cells); });
}
