/* Reading: segments, polygons, loops, questions. */
#include "check.h"

/* Two blocks side by side, and a ramp to the right of them. */
static lgs_world* ground(lgs_polygon_id* polygons) {
  lgs_world* world = newWorld();
  const lgs_shape_id square = squareOf(world);
  polygons[0] = placed(world, cellAt(0, 0), square, 1);
  polygons[1] = placed(world, cellAt(1, 0), square, 2);
  CHECK(lgs_add_points(world, cellAt(3, 5), kRamp, 3, 3, &polygons[2], NULL) == LGS_OK);
  CHECK(lgs_commit(world, NULL) == LGS_OK);
  return world;
}

static void segments(void) {
  lgs_polygon_id polygons[3];
  lgs_world* world = ground(polygons);
  lgs_segment_id ids[64], some[64];
  lgs_segment all[64];
  lgs_segment_float floats[64];
  lgs_segment_double doubles[64];
  size_t count = 0, k;
  CHECK(lgs_all_segments(world, ids, 64, &count) == LGS_OK && count == 9);
  CHECK(lgs_all_segments(world, some, 2, &count) == LGS_SHORT_BUFFER && count == 9 && some[1].value == ids[1].value);
  CHECK(lgs_all_segments(world, NULL, 0, &count) == LGS_SHORT_BUFFER && count == 9);
  CHECK(lgs_segments_in(world, rectOf(3, 5, 9, 9), some, 64, &count) == LGS_OK && count == 3);
  CHECK(lgs_segments_in(world, rectOf(0, 0, -1, 0), some, 64, &count) == LGS_OK && count == 0);
  CHECK(lgs_segments_in(world, rectOf(0, 0, 1, 0), some, 5, &count) == LGS_SHORT_BUFFER && count == 6);

  for (k = 9; k < 64; ++k) ids[k] = ids[k % 9]; /* more than are read at once */
  CHECK(lgs_segments(world, ids, 64, all, NULL) == LGS_OK);
  CHECK(lgs_segments_float(world, ids, 64, pointAt(U / 2, -U), floats, NULL) == LGS_OK);
  CHECK(lgs_segments_double(world, ids, 64, pointAt(U / 2, -U), doubles, NULL) == LGS_OK);
  for (k = 0; k < 64; ++k) {
    const lgs_segment* s = &all[k];
    const lgs_segment_double* d = &doubles[k];
    const lgs_segment_float* f = &floats[k];
    lgs_segment links[2];
    CHECK(s->id.value == ids[k].value && s->block >= 1 && s->block <= 3);
    CHECK(samePolygon(s->polygon, polygons[s->block - 1]) && s->cell.i == (s->block == 3 ? 3 : (int)s->block - 1));
    links[0].id = s->predecessor;
    links[1].id = s->successor;
    CHECK(lgs_segments(world, &s->predecessor, 1, &links[0], NULL) == LGS_OK);
    CHECK(lgs_segments(world, &s->successor, 1, &links[1], NULL) == LGS_OK);
    CHECK(links[0].end.x == s->start.x && links[0].end.y == s->start.y);
    CHECK(links[0].start.x == s->ghost1.x && links[0].start.y == s->ghost1.y);
    CHECK(links[1].start.x == s->end.x && links[1].end.x == s->ghost2.x && links[1].end.y == s->ghost2.y);
    CHECK(d->id.value == s->id.value && d->predecessor.value == s->predecessor.value);
    CHECK(d->successor.value == s->successor.value && d->block == s->block && d->cell.j == s->cell.j);
    CHECK(samePolygon(d->polygon, s->polygon) && samePolygon(f->polygon, s->polygon));
    CHECK(d->start.x * U == (double)(s->start.x - U / 2) && d->start.y * U == (double)(s->start.y + U));
    CHECK(d->end.x * U == (double)(s->end.x - U / 2) && d->end.y * U == (double)(s->end.y + U));
    CHECK(d->ghost1.x * U == (double)(s->ghost1.x - U / 2) && d->ghost2.y * U == (double)(s->ghost2.y + U));
    CHECK(f->start.x == (float)d->start.x && f->end.y == (float)d->end.y && f->ghost1.y == (float)d->ghost1.y);
    CHECK(f->ghost2.x == (float)d->ghost2.x && f->id.value == d->id.value && f->block == d->block);
  }
  lgs_free(world);
}

static void refusedSegments(void) {
  lgs_polygon_id polygons[3];
  lgs_world* world = ground(polygons);
  lgs_segment_id ids[64];
  lgs_segment all[64];
  lgs_segment_float floats[64];
  lgs_segment_double doubles[64];
  lgs_error error;
  size_t count = 0, k;
  CHECK(lgs_all_segments(world, ids, 64, &count) == LGS_OK && count == 9);
  for (k = 9; k < 64; ++k) ids[k] = ids[k % 9];
  ids[40].value = 4711;
  memset(all, 0, sizeof all);
  REFUSED(LGS_UNKNOWN_SEGMENT, lgs_segments(world, ids, 64, all, &error));
  CHECK(error.index == 40 && error.segment.value == 4711 && all[39].id.value != 0 && all[40].id.value == 0);
  REFUSED(LGS_UNKNOWN_SEGMENT, lgs_segments_float(world, ids, 64, pointAt(0, 0), floats, &error));
  CHECK(error.index == 40);
  REFUSED(LGS_OUT_OF_REACH, lgs_segments_double(world, NULL, 0, pointAt(INT64_MAX, 0), NULL, &error));
  REFUSED(LGS_OUT_OF_REACH, lgs_segments_float(world, ids, 64, pointAt(0, INT64_MIN), floats, &error));
  REFUSED(LGS_CAPACITY, lgs_segments(world, ids, (size_t)LGS_MAX_ENTRIES + 1, all, &error));
  CHECK(error.index == -1);
  REFUSED(LGS_CAPACITY, lgs_segments_float(world, ids, SIZE_MAX, pointAt(0, 0), floats, &error));
  REFUSED(LGS_CAPACITY, lgs_segments_double(world, ids, SIZE_MAX, pointAt(0, 0), doubles, &error));
  CHECK(lgs_segments(world, NULL, 0, NULL, NULL) == LGS_OK);
  REFUSED(LGS_BAD_ARGUMENT, lgs_segments(world, NULL, 1, all, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_segments(world, ids, 1, NULL, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_segments(NULL, ids, 1, all, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_segments_float(NULL, ids, 1, pointAt(0, 0), floats, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_segments_double(NULL, ids, 1, pointAt(0, 0), doubles, &error));
  CHECK(lgs_all_segments(NULL, ids, 64, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_all_segments(world, NULL, 1, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_segments_in(NULL, rectOf(0, 0, 1, 1), ids, 64, &count) == LGS_BAD_ARGUMENT);
  lgs_free(world);
}

typedef struct Visits {
  int count;
  uint32_t blocks, vertices;
} Visits;

static void visit(void* user, const lgs_polygon* polygon, const lgs_local_point* vertices) {
  Visits* visits = (Visits*)user;
  ++visits->count;
  visits->blocks += polygon->block;
  visits->vertices += polygon->vertices;
  CHECK(vertices[0].x == 0 && vertices[2].x == U && vertices[polygon->vertices - 1].y == U);
}

static void polygons(void) {
  lgs_polygon_id ids[3], none = {0, 0};
  lgs_world* world = ground(ids);
  lgs_polygon found[2];
  lgs_local_point vertices[4];
  lgs_segment_id segment;
  lgs_error error;
  lgs_cell_rect bounds;
  Visits visits = {0, 0, 0};
  int32_t isEmpty = 7;
  size_t count = 0;
  CHECK(lgs_polygon_of(world, ids[2], &found[0], NULL) == LGS_OK);
  CHECK(found[0].cell.i == 3 && found[0].cell.j == 5 && found[0].block == 3 && found[0].vertices == 3);
  error.code = 77; /* it is written only if there is one */
  CHECK(lgs_polygon_vertices(world, ids[2], vertices, 4, &count, &error) == LGS_OK && count == 3 && error.code == 77);
  CHECK(vertices[2].x == U && vertices[2].y == U);
  REFUSED(LGS_SHORT_BUFFER, lgs_polygon_vertices(world, ids[2], vertices, 2, &count, &error));
  REFUSED(LGS_STALE_HANDLE, lgs_polygon_of(world, none, NULL, &error));
  REFUSED(LGS_STALE_HANDLE, lgs_polygon_vertices(world, none, NULL, 0, NULL, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_polygon_of(NULL, none, NULL, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_polygon_vertices(NULL, none, NULL, 0, NULL, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_polygon_vertices(world, ids[0], NULL, 1, NULL, &error));

  CHECK(lgs_polygons_in(world, cellAt(1, 0), found, 2, &count) == LGS_OK && count == 1 && found[0].block == 2);
  CHECK(lgs_polygons_in(world, cellAt(1, 0), NULL, 0, &count) == LGS_SHORT_BUFFER && count == 1);
  CHECK(lgs_polygons_in(world, cellAt(LGS_MAX_CELL + 1, 0), found, 2, &count) == LGS_OK && count == 0);
  CHECK(lgs_polygons_in(NULL, cellAt(1, 0), found, 2, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_polygons_in(world, cellAt(1, 0), NULL, 1, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_is_empty(world, cellAt(1, 0), &isEmpty) == LGS_OK && isEmpty == 0);
  CHECK(lgs_is_empty(world, cellAt(2, 0), &isEmpty) == LGS_OK && isEmpty == 1);
  CHECK(lgs_is_empty(NULL, cellAt(1, 0), &isEmpty) == LGS_BAD_ARGUMENT);

  CHECK(lgs_visit_polygons(world, rectOf(1, 0, 3, 5), visit, &visits) == LGS_OK);
  CHECK(visits.count == 2 && visits.blocks == 5 && visits.vertices == 7);
  CHECK(lgs_visit_polygons(NULL, rectOf(0, 0, 1, 1), visit, &visits) == LGS_BAD_ARGUMENT);
  CHECK(lgs_visit_polygons(world, rectOf(0, 0, 1, 1), NULL, &visits) == LGS_BAD_ARGUMENT);
  CHECK(lgs_bounds(world, &bounds) == LGS_OK && bounds.min.i == 0 && bounds.max.i == 3 && bounds.max.j == 5);
  CHECK(lgs_bounds(NULL, &bounds) == LGS_BAD_ARGUMENT);

  CHECK(lgs_segments_in(world, rectOf(3, 5, 3, 5), &segment, 1, NULL) == LGS_SHORT_BUFFER);
  CHECK(lgs_owner(world, segment, &found[0], NULL) == LGS_OK);
  CHECK(samePolygon(found[0].id, ids[2]) && found[0].vertices == 3 && found[0].cell.j == 5 && found[0].block == 3);
  CHECK(lgs_set_block(world, ids[2], 4, NULL) == LGS_OK && lgs_owner(world, segment, &found[0], NULL) == LGS_OK);
  CHECK(found[0].vertices == 3 && found[0].block == 3); /* as of the last commit */
  CHECK(lgs_clear(world, rectOf(0, 0, 9, 9), NULL, NULL) == LGS_OK);
  CHECK(lgs_owner(world, segment, &found[0], NULL) == LGS_OK && found[0].vertices == 0 && found[0].block == 3);
  CHECK(lgs_bounds(world, &bounds) == LGS_OK && bounds.max.i == -1 && bounds.min.i == 0);
  segment.value = 0;
  REFUSED(LGS_UNKNOWN_SEGMENT, lgs_owner(world, segment, NULL, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_owner(NULL, segment, NULL, &error));
  lgs_free(world);
}

static void loops(void) {
  lgs_polygon_id ids[3];
  lgs_world* world = ground(ids);
  lgs_loops *all = NULL, *merged = NULL;
  lgs_loop loop;
  lgs_segment first;
  CHECK(lgs_loops_new(world, LGS_KEEP, &all) == LGS_OK && lgs_loops_count(all) == 2);
  CHECK(lgs_loops_new(world, LGS_MERGE, &merged) == LGS_OK && lgs_loops_count(merged) == 2);
  CHECK(lgs_loops_get(all, 0, &loop) == LGS_OK && loop.count == 6 && loop.vertices[0].x == 0);
  CHECK(lgs_segments(world, loop.segments, 1, &first, NULL) == LGS_OK && first.start.x == loop.vertices[0].x);
  CHECK(lgs_loops_get(merged, 0, &loop) == LGS_OK && loop.count == 4 && !loop.segments);
  CHECK(lgs_loops_get(all, 2, &loop) == LGS_BAD_ARGUMENT && lgs_loops_get(NULL, 0, &loop) == LGS_BAD_ARGUMENT);
  CHECK(lgs_loops_new(world, 2, &merged) == LGS_BAD_ARGUMENT && lgs_loops_new(NULL, 0, &merged) == LGS_BAD_ARGUMENT);
  CHECK(lgs_loops_new(world, LGS_KEEP, NULL) == LGS_BAD_ARGUMENT && lgs_loops_count(NULL) == 0);
  lgs_free(world);
  CHECK(lgs_loops_get(all, 1, &loop) == LGS_OK && loop.vertices[0].x == 3 * (int64_t)U);
  lgs_loops_free(all);
  lgs_loops_free(merged);
  lgs_loops_free(NULL);
}

static void questions(void) {
  lgs_polygon_id ids[3];
  lgs_world* world = ground(ids);
  lgs_spot spot;
  lgs_nearest_segment nearest;
  lgs_ray_hit hit;
  lgs_error error;
  const lgs_double_point position = {0.5, 2};
  const lgs_point above = lgs_lattice_point(position);
  CHECK(above.x == U / 2 && above.y == 2 * U && lgs_cell_at(above).j == 2 && lgs_cell_at(pointAt(-1, 0)).i == -1);
  CHECK(lgs_at(world, pointAt(U / 2, U / 2), &spot) == LGS_OK);
  CHECK(spot.where == LGS_INSIDE && samePolygon(spot.polygon, ids[0]) && spot.block == 1 && spot.cell.i == 0);
  CHECK(lgs_at(world, pointAt(U, U / 2), &spot) == LGS_OK && spot.where == LGS_EDGE);
  CHECK(lgs_at(world, above, &spot) == LGS_OK && spot.where == LGS_OUTSIDE && spot.polygon.cell_ref == 0);
  CHECK(lgs_at(NULL, above, &spot) == LGS_BAD_ARGUMENT);

  CHECK(lgs_nearest(world, above, 1.5, &nearest, NULL) == LGS_OK && nearest.segment.value != 0);
  CHECK(nearest.distance == 1 && nearest.point.x == 0.5 && nearest.point.y == 1 && nearest.reserved == 0);
  CHECK(lgs_nearest(world, above, 0.5, &nearest, NULL) == LGS_OK && nearest.segment.value == 0);
  REFUSED(LGS_OUT_OF_REACH, lgs_nearest(world, above, LGS_MAX_RADIUS + 1, &nearest, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_nearest(NULL, above, 1, &nearest, &error));

  CHECK(lgs_ray_cast(world, above, pointAt(above.x, 0), &hit, NULL) == LGS_OK && hit.segment.value != 0);
  CHECK(hit.fraction == 0.5 && hit.point.y == 1 && hit.normal.x == 0 && hit.normal.y == 1 && hit.reserved == 0);
  CHECK(lgs_ray_cast(world, above, above, &hit, NULL) == LGS_OK && hit.segment.value == 0 && hit.fraction == 1);
  REFUSED(LGS_OUT_OF_REACH, lgs_ray_cast(world, above, pointAt((LGS_MAX_RAY + 1) * (int64_t)U, 0), &hit, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_ray_cast(NULL, above, above, &hit, &error));
  lgs_free(world);
}

/* Whatever is not wanted may be left out. */
static void outputsLeftOut(void) {
  lgs_polygon_id ids[3];
  lgs_world* world = ground(ids);
  lgs_segment_id segment = {1};
  lgs_shape_id shape = squareOf(world);
  CHECK(lgs_at(world, pointAt(0, 0), NULL) == LGS_OK && lgs_nearest(world, pointAt(0, 0), 1, NULL, NULL) == LGS_OK);
  CHECK(lgs_ray_cast(world, pointAt(0, 0), pointAt(9, 9), NULL, NULL) == LGS_OK);
  CHECK(lgs_is_empty(world, cellAt(0, 0), NULL) == LGS_OK && lgs_bounds(world, NULL) == LGS_OK);
  CHECK(lgs_polygon_of(world, ids[0], NULL, NULL) == LGS_OK && lgs_owner(world, segment, NULL, NULL) == LGS_OK);
  CHECK(lgs_polygon_vertices(world, ids[0], NULL, 0, NULL, NULL) == LGS_SHORT_BUFFER);
  CHECK(lgs_polygons_in(world, cellAt(9, 9), NULL, 0, NULL) == LGS_OK);
  CHECK(lgs_shape_polygons(world, shape, NULL) == LGS_OK && lgs_shape_box(world, shape, NULL) == LGS_OK);
  CHECK(lgs_same_polygons(world, world, NULL) == LGS_OK);
  CHECK(lgs_segments_in(world, rectOf(9, 9, 9, 9), NULL, 0, NULL) == LGS_OK);
  lgs_free(world);
}

int main(void) {
  segments();
  refusedSegments();
  polygons();
  loops();
  questions();
  outputsLeftOut();
  return 0;
}
