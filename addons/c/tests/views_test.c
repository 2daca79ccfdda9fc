/* Views: loops and islands, bodies, pieces, hashes. */
#include "check.h"

#include <lgs/lgs_views.h>

/* Row 0 is bedrock. It counts how often it is asked. */
static int32_t isBedrock(void* user, lgs_block block, lgs_cell cell) {
  ++*(int*)user;
  return block == 9 && cell.j == 0;
}

/* A floor of bedrock, a pillar, and an arm of two cells. */
static lgs_world* ground(void) {
  lgs_world* world = newWorld();
  const lgs_shape_id square = squareOf(world);
  CHECK(lgs_fill(world, rectOf(0, 0, 5, 0), square, 9, NULL, NULL) == LGS_OK);
  CHECK(lgs_fill(world, rectOf(0, 1, 0, 2), square, 1, NULL, NULL) == LGS_OK);
  CHECK(lgs_fill(world, rectOf(1, 2, 3, 2), square, 2, NULL, NULL) == LGS_OK);
  CHECK(lgs_commit(world, NULL) == LGS_OK);
  CHECK(lgs_follow_cells(world, 1, NULL) == LGS_OK);
  return world;
}

static lgs_changes cut(lgs_world* world) {
  lgs_changes changes;
  CHECK(lgs_clear(world, rectOf(1, 2, 1, 2), NULL, NULL) == LGS_OK);
  CHECK(lgs_commit(world, &changes) == LGS_OK);
  return changes;
}

static void islands(void) {
  lgs_world* world = ground();
  lgs_islands *view = NULL, *copy = NULL;
  lgs_island_id ids[8], loose = {0};
  lgs_loop_id loops[8], loop = {7};
  lgs_island_pair pairs[4];
  lgs_loop_pair loopPairs[4];
  lgs_island facts;
  lgs_loop_facts outline;
  lgs_changes changes, wrong;
  lgs_polygon held;
  lgs_polygon_id polygon;
  size_t count = 0;
  int asked = 0;
  CHECK(lgs_islands_new(NULL, isBedrock, &asked, &view) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_new(world, isBedrock, &asked, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_new(world, isBedrock, &asked, &view) == LGS_OK && asked > 0);
  CHECK(lgs_islands_copy(NULL, &copy) == LGS_BAD_ARGUMENT && lgs_islands_copy(view, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_copy(view, &copy) == LGS_OK);
  CHECK(lgs_islands_ids(view, LGS_ALL, ids, 8, &count) == LGS_OK && count == 1);
  CHECK(lgs_islands_get(view, ids[0], &facts) == LGS_OK && facts.id.value == ids[0].value && facts.anchors == 6);
  CHECK(facts.outer.area == 11 && facts.outer.double_area_high == 0 && facts.outer.segments == 24);
  CHECK(facts.outer.double_area_low == (uint64_t)22 * U * U && facts.outer.west.x == 0 && facts.outer.max.y == 3 * U);

  changes = cut(world);
  wrong = changes;
  ++wrong.before;
  CHECK(lgs_islands_update(NULL, world, &changes) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_update(view, NULL, &changes) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_update(view, world, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_update(view, world, &wrong) == LGS_BAD_ARGUMENT);
  wrong = changes;
  wrong.added = NULL;
  CHECK(changes.added_count > 0 && lgs_islands_update(view, world, &wrong) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_update(view, world, &changes) == LGS_OK);
  CHECK(lgs_islands_update(view, world, &changes) == LGS_BAD_ARGUMENT); /* once is enough */
  CHECK(lgs_islands_ids(view, LGS_LOOSE, &loose, 1, &count) == LGS_OK && count == 1);
  CHECK(lgs_islands_get(view, loose, &facts) == LGS_OK && facts.anchors == 0 && facts.outer.area == 2);
  CHECK(lgs_islands_pairs(view, LGS_PARTED, pairs, 4, &count) == LGS_OK && count == 1);
  CHECK(pairs[0].from.value == ids[0].value && pairs[0].into.value == loose.value);
  CHECK(lgs_islands_pairs(view, LGS_JOINED, pairs, 4, &count) == LGS_OK && count == 0);
  CHECK(lgs_islands_pairs(view, 2, pairs, 4, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_loop_pairs(view, LGS_PARTED, loopPairs, 4, &count) == LGS_OK && count == 1);
  CHECK(lgs_islands_loop_pairs(view, LGS_JOINED, loopPairs, 4, &count) == LGS_OK && count == 0);
  CHECK(lgs_islands_loop_pairs(view, -1, loopPairs, 4, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_ids(view, LGS_CHANGED, ids, 8, &count) == LGS_OK && count == 1);
  CHECK(lgs_islands_ids(view, LGS_ADDED, ids + 1, 7, &count) == LGS_OK && count == 0);
  CHECK(lgs_islands_ids(view, LGS_REMOVED, ids + 1, 7, &count) == LGS_OK && count == 0);
  CHECK(lgs_islands_ids(view, LGS_ALL, ids, 1, &count) == LGS_SHORT_BUFFER && count == 2);
  CHECK(lgs_islands_ids(view, 5, ids, 8, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_ids(NULL, LGS_ALL, ids, 8, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_ids(view, LGS_ALL, NULL, 8, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_ids(copy, LGS_ALL, ids, 8, &count) == LGS_OK && count == 1); /* it has gone no way */

  CHECK(lgs_islands_loop_ids(view, LGS_ALL, loops, 8, &count) == LGS_OK && count == 2);
  CHECK(lgs_islands_loop_ids(view, LGS_CHANGED, loops, 8, &count) == LGS_OK && count == 1);
  CHECK(lgs_islands_loop_ids(view, LGS_ADDED, loops, 8, &count) == LGS_OK && count == 0);
  CHECK(lgs_islands_loop_ids(view, LGS_REMOVED, loops, 8, &count) == LGS_OK && count == 0);
  CHECK(lgs_islands_loop_ids(view, LGS_LOOSE, loops, 8, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_islands_loop(view, facts.outer.id, &outline) == LGS_OK && outline.area == 2);
  CHECK(lgs_islands_loop_of(view, world, outline.first, &loop) == LGS_OK && loop.value == outline.id.value);
  CHECK(lgs_islands_loop_of(view, NULL, outline.first, &loop) == LGS_BAD_ARGUMENT);
  loop.value = 999;
  CHECK(lgs_islands_loop(view, loop, &outline) == LGS_STALE_HANDLE);
  CHECK(lgs_polygons_in(world, cellAt(3, 2), &held, 1, &count) == LGS_OK && count == 1);
  polygon = held.id;
  CHECK(lgs_islands_of(view, world, polygon, ids) == LGS_OK && ids[0].value == loose.value);
  polygon.serial += 7;
  CHECK(lgs_islands_of(view, world, polygon, ids) == LGS_OK && ids[0].value == 0);
  CHECK(lgs_islands_of(NULL, world, polygon, ids) == LGS_BAD_ARGUMENT);
  loose.value = 999;
  CHECK(lgs_islands_get(view, loose, &facts) == LGS_STALE_HANDLE);
  CHECK(lgs_islands_get(NULL, loose, &facts) == LGS_BAD_ARGUMENT);
  lgs_islands_free(copy);
  lgs_islands_free(view);
  lgs_islands_free(NULL);
  lgs_free(world);
}

static void bodies(void) {
  lgs_world* world = ground();
  lgs_islands* view = NULL;
  lgs_island_id loose = {0};
  lgs_body* body = NULL;
  lgs_body_facts facts;
  lgs_body_polygon polygon;
  lgs_polygon_id put;
  lgs_polygon held;
  lgs_changes changes;
  lgs_error error;
  size_t count = 0;
  CHECK(lgs_islands_new(world, NULL, NULL, &view) == LGS_OK);
  changes = cut(world);
  CHECK(lgs_islands_update(view, world, &changes) == LGS_OK);
  CHECK(lgs_islands_pairs(view, LGS_PARTED, NULL, 0, &count) == LGS_SHORT_BUFFER && count == 1);
  CHECK(lgs_islands_ids(view, LGS_LOOSE, &loose, 1, &count) == LGS_SHORT_BUFFER && count == 2); /* no anchors */
  CHECK(lgs_islands_ids(view, LGS_ALL, &loose, 1, &count) == LGS_SHORT_BUFFER);
  {
    lgs_island_id both[2];
    lgs_island island;
    CHECK(lgs_islands_ids(view, LGS_ALL, both, 2, &count) == LGS_OK);
    CHECK(lgs_islands_get(view, both[0], &island) == LGS_OK);
    loose = island.outer.area == 2 ? both[0] : both[1];
  }
  REFUSED(LGS_BAD_ARGUMENT, lgs_take(NULL, view, loose, &body, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_take(world, view, loose, NULL, &error));
  CHECK(lgs_take(world, view, loose, &body, NULL) == LGS_OK);
  REFUSED(LGS_STALE_HANDLE, lgs_take(world, view, loose, &body, &error));
  CHECK(lgs_body_get(body, &facts) == LGS_OK && lgs_body_get(NULL, &facts) == LGS_BAD_ARGUMENT);
  CHECK(facts.polygons == 2 && facts.origin.i == 2 && facts.origin.j == 2 && facts.cells.max.i == 3);
  CHECK(facts.area == 2 && facts.centroid.x == 1 && facts.centroid.y == 0.5);
  CHECK(facts.second_moment > 0.8333 && facts.second_moment < 0.8334); /* (2 * 1 + 1 * 8) / 12 */
  CHECK(lgs_body_polygon_at(body, 1, &polygon) == LGS_OK && polygon.count == 4 && polygon.block == 2);
  CHECK(polygon.cell.i == 1 && polygon.cell.j == 0 && polygon.vertices[2].x == U && polygon.vertices[2].y == U);
  CHECK(lgs_body_polygon_at(body, 2, &polygon) == LGS_BAD_ARGUMENT);
  CHECK(lgs_body_polygon_at(NULL, 0, &polygon) == LGS_BAD_ARGUMENT);
  REFUSED(LGS_OVERLAP, lgs_put(world, body, cellAt(0, 0), NULL, 0, &error));
  CHECK(error.index == 0);
  REFUSED(LGS_BAD_ARGUMENT, lgs_put(world, NULL, cellAt(0, 0), NULL, 0, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_put(world, body, cellAt(2, 1), NULL, 1, &error));
  CHECK(lgs_put(world, body, cellAt(2, 1), &put, 1, NULL) == LGS_OK); /* on the floor */
  CHECK(lgs_polygons_in(world, cellAt(2, 1), &held, 1, &count) == LGS_OK && held.id.serial == put.serial);
  CHECK(lgs_commit(world, &changes) == LGS_OK && lgs_islands_update(view, world, &changes) == LGS_OK);
  CHECK(lgs_islands_ids(view, LGS_ALL, &loose, 1, &count) == LGS_OK && count == 1);
  lgs_body_free(body);
  lgs_body_free(NULL);
  lgs_islands_free(view);
  lgs_free(world);
}

static int32_t cutOne(void* user, lgs_world* world) {
  *(int*)user += 1;
  return lgs_clear(world, (lgs_cell_rect){{1, 0}, {1, 9}}, NULL, NULL) == LGS_OK;
}
static int32_t refused(void* user, lgs_world* world) {
  (void)user;
  (void)world;
  return 0;
}

static void foreseen(void) {
  lgs_world* world = ground();
  lgs_islands* view = NULL;
  lgs_foreseen* would = NULL;
  lgs_island_id ids[8], all[8];
  lgs_island_pair pairs[8];
  lgs_island island;
  lgs_body* parts[2] = {NULL, NULL};
  lgs_error error;
  size_t count = 0, k, before = 0;
  int calls = 0;
  CHECK(lgs_islands_new(world, NULL, NULL, &view) == LGS_OK);
  CHECK(lgs_islands_ids(view, LGS_ALL, all, 8, &before) == LGS_OK && before > 0);
  CHECK(lgs_foresee(NULL, view, cutOne, &calls, &would) == LGS_BAD_ARGUMENT);
  CHECK(lgs_foresee(world, view, NULL, &calls, &would) == LGS_BAD_ARGUMENT);
  CHECK(lgs_foresee(world, view, cutOne, &calls, NULL) == LGS_BAD_ARGUMENT && calls == 0);
  CHECK(lgs_foresee(world, view, cutOne, &calls, &would) == LGS_OK && calls == 1);
  CHECK(lgs_foreseen_ids(would, LGS_ALL, ids, 8, &count) == LGS_OK && count > 0);
  for (k = 0; k < count; ++k) CHECK(lgs_foreseen_get(would, ids[k], &island) == LGS_OK && island.anchors == 0);
  CHECK(lgs_foreseen_ids(would, LGS_LOOSE, NULL, 0, &k) == LGS_SHORT_BUFFER && k == count);
  CHECK(lgs_foreseen_ids(would, LGS_CHANGED, ids, 8, &count) == LGS_OK);
  CHECK(lgs_foreseen_ids(would, LGS_ADDED, ids, 8, &count) == LGS_OK);
  CHECK(lgs_foreseen_ids(would, LGS_REMOVED, ids, 8, &count) == LGS_OK);
  CHECK(lgs_foreseen_ids(would, 5, ids, 8, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_foreseen_ids(NULL, LGS_ALL, ids, 8, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_foreseen_pairs(would, LGS_PARTED, pairs, 8, &count) == LGS_OK);
  CHECK(lgs_foreseen_pairs(would, LGS_JOINED, pairs, 8, &count) == LGS_OK && count == 0);
  CHECK(lgs_foreseen_pairs(would, 2, pairs, 8, &count) == LGS_BAD_ARGUMENT);
  ids[0].value = 999;
  CHECK(lgs_foreseen_get(would, ids[0], &island) == LGS_STALE_HANDLE);
  CHECK(lgs_foreseen_get(NULL, ids[0], &island) == LGS_BAD_ARGUMENT);
  lgs_foreseen_free(would);
  lgs_foreseen_free(NULL);
  CHECK(lgs_foresee(world, view, refused, NULL, &would) == LGS_OK);
  CHECK(lgs_foreseen_ids(would, LGS_ALL, ids, 8, &count) == LGS_OK && count == 0);
  lgs_foreseen_free(would);
  CHECK(lgs_islands_ids(view, LGS_ALL, all, 8, &count) == LGS_OK && count == before);

  REFUSED(LGS_SHORT_BUFFER, lgs_take_apart(world, view, all[0], parts, 0, &count, &error));
  CHECK(count == 1);
  REFUSED(LGS_BAD_ARGUMENT, lgs_take_apart(world, view, all[0], NULL, 1, &count, &error));
  CHECK(lgs_take_apart(world, view, all[0], parts, 2, &count, NULL) == LGS_OK && count == 1 && parts[0] && !parts[1]);
  REFUSED(LGS_STALE_HANDLE, lgs_take_apart(world, view, all[0], parts + 1, 1, &count, &error));
  lgs_body_free(parts[0]);
  lgs_islands_free(view);
  lgs_free(world);
}

static void pieces(void) {
  lgs_world* world = newWorld();
  lgs_changes changes;
  lgs_pieces* view = NULL;
  lgs_polygon_id ramp, polygon;
  lgs_local_point vertices[8];
  lgs_portal portals[8];
  const lgs_cell* cells = NULL;
  size_t count = 0, k;
  CHECK(lgs_add_points(world, cellAt(0, 0), kRamp, 3, 5, &ramp, NULL) == LGS_OK);
  CHECK(lgs_commit(world, NULL) == LGS_OK && lgs_follow_cells(world, 1, NULL) == LGS_OK);
  CHECK(lgs_pieces_new(world, 2, &view) == LGS_BAD_ARGUMENT && lgs_pieces_new(world, 5000, &view) == LGS_BAD_ARGUMENT);
  CHECK(lgs_pieces_new(NULL, 8, &view) == LGS_BAD_ARGUMENT && lgs_pieces_new(world, 8, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_pieces_new(world, 8, &view) == LGS_OK);
  CHECK(lgs_pieces_count(view, cellAt(0, 0), LGS_SOLID, &count) == LGS_OK && count == 1);
  CHECK(lgs_pieces_count(view, cellAt(0, 0), 2, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_pieces_count(NULL, cellAt(0, 0), LGS_FREE, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_pieces_get(view, world, cellAt(0, 0), LGS_SOLID, 0, vertices, 8, &count, &polygon) == LGS_OK && count == 3);
  CHECK(samePolygon(polygon, ramp) && vertices[0].x == 0 && vertices[1].x == U && vertices[2].y == U);
  CHECK(lgs_pieces_get(view, world, cellAt(0, 0), LGS_SOLID, 0, vertices, 2, &count, NULL) == LGS_SHORT_BUFFER);
  CHECK(lgs_pieces_get(view, world, cellAt(0, 0), LGS_FREE, 0, vertices, 8, &count, &polygon) == LGS_OK);
  CHECK(polygon.serial == 0 && polygon.cell_ref == 0 && vertices[1].x == U && vertices[2].x == 0);
  CHECK(lgs_pieces_get(view, world, cellAt(0, 0), LGS_FREE, 1, vertices, 8, &count, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_pieces_get(view, world, cellAt(0, 0), LGS_FREE, 0, NULL, 8, &count, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_pieces_get(view, NULL, cellAt(0, 0), LGS_FREE, 0, vertices, 8, &count, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_pieces_portals(view, cellAt(0, 0), 0, portals, 8, &count) == LGS_OK && count == 2); /* north and west */
  for (k = 0; k < count; ++k) CHECK(portals[k].reserved == 0 && (portals[k].cell.i == -1 || portals[k].cell.j == 1));
  CHECK(portals[1].cell.i == -1 && portals[1].right.y == U && portals[1].left.y == 0);
  CHECK(lgs_pieces_portals(view, cellAt(0, 0), 1, portals, 8, &count) == LGS_OK && count == 0);
  CHECK(lgs_pieces_portals(NULL, cellAt(0, 0), 0, portals, 8, &count) == LGS_BAD_ARGUMENT);

  CHECK(lgs_remove(world, ramp, NULL) == LGS_OK && lgs_commit(world, &changes) == LGS_OK);
  CHECK(lgs_pieces_update(NULL, world, &changes, &cells, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_pieces_update(view, NULL, &changes, &cells, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_pieces_update(view, world, NULL, &cells, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_pieces_update(view, world, &changes, &cells, &count) == LGS_OK && count == 1 && cells[0].i == 0);
  CHECK(lgs_pieces_update(view, world, &changes, &cells, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_pieces_count(view, cellAt(0, 0), LGS_SOLID, &count) == LGS_OK && count == 0);
  {
    lgs_pieces* copy = NULL;
    CHECK(lgs_pieces_copy(view, NULL) == LGS_BAD_ARGUMENT && lgs_pieces_copy(NULL, &copy) == LGS_BAD_ARGUMENT);
    CHECK(lgs_pieces_copy(view, &copy) == LGS_OK);
    lgs_pieces_free(view);
    CHECK(lgs_pieces_count(copy, cellAt(0, 0), LGS_FREE, &count) == LGS_OK);
    view = copy;
  }
  lgs_pieces_free(view);
  lgs_pieces_free(NULL);
  lgs_free(world);
}

static void hashes(void) {
  lgs_world* world = ground();
  lgs_changes changes;
  lgs_hashes *view = NULL, *copy = NULL;
  lgs_hashed_square whole = {0}, squares[4];
  lgs_cell_rect differ[4];
  size_t count = 0;
  CHECK(lgs_hashes_new(NULL, &view) == LGS_BAD_ARGUMENT && lgs_hashes_new(world, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_hashes_new(world, &view) == LGS_OK);
  CHECK(lgs_hashes_copy(NULL, &copy) == LGS_BAD_ARGUMENT && lgs_hashes_copy(view, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_hashes_copy(view, &copy) == LGS_OK);
  CHECK(lgs_hashes_whole(NULL, &whole) == LGS_BAD_ARGUMENT && lgs_hashes_whole(view, NULL) == LGS_OK);
  CHECK(lgs_hashes_whole(view, &whole) == LGS_OK && whole.hash != 0 && whole.level == 0 && whole.reserved == 0);
  CHECK(whole.cells.min.i == 0 && whole.cells.min.j == 0 && whole.cells.max.i == 31 && whole.cells.max.j == 31);
  CHECK(lgs_hashes_in(view, rectOf(-9, -9, 9, 9), 0, squares, 4, &count) == LGS_OK && count == 1);
  CHECK(squares[0].hash == whole.hash && squares[0].reserved == 0);
  CHECK(lgs_hashes_in(view, rectOf(-9, -9, 9, 9), 0, squares, 0, &count) == LGS_SHORT_BUFFER && count == 1);
  CHECK(lgs_hashes_in(view, rectOf(-9, -9, -1, 9), 0, squares, 4, &count) == LGS_OK && count == 0);
  CHECK(lgs_hashes_in(view, rectOf(-9, -9, -1, 9), 1, squares, 4, &count) == LGS_OK && count == 1 &&
        squares[0].level == 1);
  CHECK(lgs_hashes_in(view, rectOf(0, 0, 0, 0), 15, squares, 4, &count) == LGS_OK && count == 0);
  CHECK(lgs_hashes_in(NULL, rectOf(0, 0, 0, 0), 0, squares, 4, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_hashes_in(view, rectOf(0, 0, 0, 0), 0, NULL, 4, &count) == LGS_BAD_ARGUMENT);

  CHECK(lgs_hashes_differences(view, copy, differ, 4, &count) == LGS_OK && count == 0);
  changes = cut(world);
  CHECK(lgs_hashes_update(NULL, world, &changes) == LGS_BAD_ARGUMENT);
  CHECK(lgs_hashes_update(view, NULL, &changes) == LGS_BAD_ARGUMENT);
  CHECK(lgs_hashes_update(view, world, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_hashes_update(view, world, &changes) == LGS_OK);
  CHECK(lgs_hashes_differences(view, copy, differ, 4, &count) == LGS_OK && count == 1);
  CHECK(differ[0].min.i == 0 && differ[0].max.j == 31);
  CHECK(lgs_hashes_differences(view, copy, differ, 0, &count) == LGS_SHORT_BUFFER && count == 1);
  CHECK(lgs_hashes_differences(view, copy, NULL, 1, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_hashes_differences(NULL, copy, differ, 4, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_hashes_differences(view, NULL, differ, 4, &count) == LGS_BAD_ARGUMENT);

  CHECK(lgs_clear(world, rectOf(0, 0, 9, 9), NULL, NULL) == LGS_OK && lgs_commit(world, &changes) == LGS_OK);
  CHECK(lgs_hashes_update(view, world, &changes) == LGS_OK);
  CHECK(lgs_hashes_whole(view, &whole) == LGS_OK && whole.hash == 0);
  lgs_hashes_free(view);
  lgs_hashes_free(copy);
  lgs_hashes_free(NULL);
  lgs_free(world);
}

int main(void) {
  islands();
  bodies();
  foreseen();
  pieces();
  hashes();
  return 0;
}
