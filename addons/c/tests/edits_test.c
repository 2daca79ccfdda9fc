/* Shapes and edits: what each does, and each reason to refuse it. */
#include "check.h"

#include <math.h>

static void shapes(void) {
  lgs_world* world = newWorld();
  lgs_shape_id shape = {0}, again = {0};
  const lgs_float_point floats[3] = {{0, 0}, {1, 0}, {1, 1}};
  const lgs_double_point doubles[3] = {{0, 0}, {1, 0}, {1, 1 - 0.4 / U}};
  const lgs_local_point both[7] = {{0, 0}, {U, 0}, {U, U}, {0, 0}, {U, U}, {U / 2, U}, {0, 8}};
  const uint32_t counts[2] = {3, 4};
  lgs_local_point vertices[4] = {{-1, -1}, {-1, -1}, {-1, -1}, {-1, -1}};
  lgs_local_box box = {{-1, -1}, {-1, -1}};
  size_t count = 0;

  CHECK(lgs_shape(world, kRamp, 3, &shape, NULL) == LGS_OK && shape.value != 0);
  CHECK(lgs_shape_floats(world, floats, 3, &again, NULL) == LGS_OK && again.value == shape.value);
  CHECK(lgs_shape_doubles(world, doubles, 3, &again, NULL) == LGS_OK && again.value == shape.value);
  CHECK(lgs_shape(world, kRamp, 3, NULL, NULL) == LGS_OK);

  CHECK(lgs_shape_of_several(world, both, counts, 2, &again, NULL) == LGS_OK && again.value != shape.value);
  CHECK(lgs_shape_polygons(world, again, &count) == LGS_OK && count == 2);
  CHECK(lgs_shape_vertices(world, again, 1, vertices, 4, &count) == LGS_OK && count == 4);
  CHECK(vertices[3].x == 0 && vertices[3].y == 8);
  vertices[2].x = -1;
  CHECK(lgs_shape_vertices(world, again, 0, vertices, 2, &count) == LGS_SHORT_BUFFER && count == 3);
  CHECK(vertices[1].x == U && vertices[2].x == -1);
  CHECK(lgs_shape_vertices(world, again, 2, vertices, 4, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_shape_vertices(world, again, 0, NULL, 1, &count) == LGS_BAD_ARGUMENT);
  CHECK(lgs_shape_box(world, shape, &box) == LGS_OK && box.min.x == 0 && box.max.y == U);

  again.value = 4711;
  CHECK(lgs_shape_polygons(world, again, &count) == LGS_UNKNOWN_SHAPE);
  CHECK(lgs_shape_vertices(world, again, 0, NULL, 0, NULL) == LGS_UNKNOWN_SHAPE);
  CHECK(lgs_shape_box(world, again, NULL) == LGS_UNKNOWN_SHAPE);
  lgs_free(world);
}

/* Tries a polygon as a shape and as an edit, which must say the same but for the cell. */
static lgs_error refusedPolygon(lgs_world* world, const lgs_local_point* vertices, size_t count, lgs_status status) {
  lgs_error error, inCell;
  lgs_shape_id shape = {7};
  lgs_polygon_id polygon = {7, 7};
  REFUSED(status, lgs_shape(world, vertices, count, &shape, &error));
  inCell = error;
  CHECK(shape.value == 7 && error.cell.i == INT32_MIN);
  REFUSED(status, lgs_add_points(world, cellAt(5, 6), vertices, count, 1, &polygon, &error));
  CHECK(polygon.serial == 7 && error.cell.i == 5 && error.cell.j == 6);
  CHECK(error.polygon == inCell.polygon && error.vertex == inCell.vertex && error.vertex2 == inCell.vertex2);
  return error;
}

static void badPolygons(void) {
  lgs_world* world = newWorld();
  lgs_error error;
  static lgs_local_point many[LGS_MAX_CELL_VERTICES + 1];
  const lgs_local_point outside[3] = {{0, 0}, {U + 1, 0}, {U, U}};
  const lgs_local_point repeated[4] = {{0, 0}, {U, 0}, {U, U}, {U, 0}};
  const lgs_local_point flat[3] = {{0, 0}, {5, 5}, {9, 9}};
  const lgs_local_point crossed[4] = {{0, 0}, {U, 0}, {U / 8, U / 2}, {U, U}};
  const lgs_local_point clockwise[3] = {{0, 0}, {0, U}, {U, U}};
  const lgs_local_point twice[6] = {{0, 0}, {U, 0}, {U, U}, {0, 0}, {U, 0}, {U, U}};
  const uint32_t counts[2] = {3, 3};
  const lgs_double_point notFinite[3] = {{0, 0}, {1, 0}, {1, NAN}};
  const lgs_float_point infinite[3] = {{0, 0}, {INFINITY, 0}, {1, 1}};

  CHECK(refusedPolygon(world, kSquare, 2, LGS_TOO_FEW_VERTICES).polygon == 0);
  CHECK(refusedPolygon(world, NULL, 0, LGS_TOO_FEW_VERTICES).polygon == 0);
  CHECK(refusedPolygon(world, many, LGS_MAX_CELL_VERTICES + 1, LGS_CAPACITY).polygon == 0);
  CHECK(refusedPolygon(world, outside, 3, LGS_OUTSIDE_CELL).vertex == 1);
  error = refusedPolygon(world, repeated, 4, LGS_REPEATED_VERTEX);
  CHECK(error.vertex == 1 && error.vertex2 == 3);
  CHECK(refusedPolygon(world, flat, 3, LGS_ZERO_AREA).vertex == -1);
  error = refusedPolygon(world, crossed, 4, LGS_SELF_INTERSECTING);
  CHECK(error.vertex == 1 && error.vertex2 == 3);
  CHECK(refusedPolygon(world, clockwise, 3, LGS_CLOCKWISE).index == -1);

  REFUSED(LGS_EMPTY_SHAPE, lgs_shape_of_several(world, NULL, NULL, 0, NULL, &error));
  REFUSED(LGS_OVERLAP, lgs_shape_of_several(world, twice, counts, 2, NULL, &error));
  CHECK(error.polygon == 1 && error.polygon2 == 0);
  REFUSED(LGS_NOT_FINITE, lgs_shape_doubles(world, notFinite, 3, NULL, &error));
  CHECK(error.vertex == 2);
  REFUSED(LGS_NOT_FINITE, lgs_shape_floats(world, infinite, 3, NULL, &error));
  REFUSED(LGS_NOT_FINITE, lgs_add_doubles(world, cellAt(0, 0), notFinite, 3, 1, NULL, &error));
  REFUSED(LGS_NOT_FINITE, lgs_add_floats(world, cellAt(0, 0), infinite, 3, 1, NULL, &error));
  CHECK(error.vertex == 1);
  lgs_free(world);
}

/* A count that nobody has memory for is refused like any other that is too great; and nothing of it is kept. */
static void tooMuch(void) {
  lgs_world* world = newWorld();
  static lgs_local_point points[LGS_MAX_CELL_VERTICES + 1];
  static lgs_float_point floats[LGS_MAX_CELL_VERTICES + 1];
  static lgs_double_point doubles[LGS_MAX_CELL_VERTICES + 1];
  const uint32_t counts[2] = {UINT32_MAX, 3};
  lgs_error error;
  lgs_stats before, after;
  CHECK(lgs_count(world, &before) == LGS_OK);
  REFUSED(LGS_CAPACITY, lgs_shape(world, points, SIZE_MAX, NULL, &error));
  CHECK(error.polygon == 0);
  REFUSED(LGS_CAPACITY, lgs_shape_floats(world, floats, SIZE_MAX, NULL, &error));
  REFUSED(LGS_CAPACITY, lgs_shape_doubles(world, doubles, SIZE_MAX, NULL, &error));
  REFUSED(LGS_CAPACITY, lgs_add_points(world, cellAt(5, 6), points, SIZE_MAX, 1, NULL, &error));
  CHECK(error.cell.i == 5 && error.polygon == 0);
  REFUSED(LGS_CELL_OUT_OF_RANGE, lgs_add_points(world, cellAt(INT32_MAX, 0), points, SIZE_MAX, 1, NULL, &error));
  REFUSED(LGS_CAPACITY, lgs_shape_of_several(world, points, counts, 2, NULL, &error));
  CHECK(error.polygon == 0);
  REFUSED(LGS_CAPACITY, lgs_shape_of_several(world, points, counts, SIZE_MAX / 2, NULL, &error));
  CHECK(error.polygon == -1);
  CHECK(lgs_count(world, &after) == LGS_OK);
  /* Working memory is kept and counted: a cell's worth of each kind of point, and not much more. */
  CHECK(after.bytes - before.bytes >= sizeof points + sizeof floats + sizeof doubles);
  CHECK(after.bytes - before.bytes < 2 * (sizeof points + sizeof floats + sizeof doubles));
  lgs_free(world);
}

/* As many polygons as a cell holds, and one more. */
static void severalAtMost(void) {
  lgs_world* world = newWorld();
  static lgs_local_point points[3 * (LGS_MAX_CELL_POLYGONS + 1)];
  static uint32_t counts[LGS_MAX_CELL_POLYGONS + 1];
  lgs_shape_id shape = {0};
  lgs_error error;
  size_t count = 0;
  int32_t k;
  for (k = 0; k <= LGS_MAX_CELL_POLYGONS; ++k) {
    const lgs_local_point triangle[3] = {{2 * k, 0}, {2 * k + 1, 0}, {2 * k + 1, 1}};
    memcpy(points + 3 * k, triangle, sizeof triangle);
    counts[k] = 3;
  }
  CHECK(lgs_shape_of_several(world, points, counts, LGS_MAX_CELL_POLYGONS, &shape, NULL) == LGS_OK);
  CHECK(lgs_shape_polygons(world, shape, &count) == LGS_OK && count == LGS_MAX_CELL_POLYGONS);
  REFUSED(LGS_CAPACITY, lgs_shape_of_several(world, points, counts, LGS_MAX_CELL_POLYGONS + 1, &shape, &error));
  lgs_free(world);
}

static void adding(void) {
  lgs_world* world = newWorld();
  const lgs_shape_id square = squareOf(world);
  const lgs_local_point both[6] = {{0, 0}, {U, 0}, {U, U}, {0, 0}, {U, U}, {0, U}};
  const lgs_float_point floats[3] = {{0, 0}, {1, 0}, {1, 0.5f}};
  const lgs_double_point doubles[3] = {{0, 0}, {0.25, 0.5}, {0, 1}};
  const uint32_t counts[2] = {3, 3};
  lgs_shape_id two = {0};
  lgs_polygon_id a = {0, 0}, b = {0, 0}, several[3] = {{0, 0}, {0, 0}, {9, 9}};
  lgs_polygon polygon;
  lgs_error error;

  CHECK(lgs_add(world, cellAt(3, 4), square, 7, &a, NULL) == LGS_OK && a.cell_ref != 0);
  CHECK(lgs_add(world, cellAt(4, 4), square, 7, NULL, NULL) == LGS_OK);
  CHECK(lgs_add_floats(world, cellAt(5, 4), floats, 3, 8, &b, NULL) == LGS_OK);
  CHECK(lgs_polygon_of(world, b, &polygon, NULL) == LGS_OK);
  CHECK(polygon.block == 8 && polygon.vertices == 3 && polygon.cell.i == 5 && samePolygon(polygon.id, b));
  CHECK(lgs_add_doubles(world, cellAt(5, 4), doubles, 3, 9, NULL, NULL) == LGS_OK);
  CHECK(lgs_add_points(world, cellAt(6, 4), kRamp, 3, 9, &b, NULL) == LGS_OK);

  CHECK(lgs_shape_of_several(world, both, counts, 2, &two, NULL) == LGS_OK);
  CHECK(lgs_add_several(world, cellAt(0, 0), two, 1, several, 3, NULL) == LGS_OK);
  CHECK(several[0].cell_ref == several[1].cell_ref && several[1].serial == several[0].serial + 1);
  CHECK(several[2].serial == 9);
  CHECK(lgs_replace(world, cellAt(0, 0), two, 2, several, 1, NULL) == LGS_OK);
  CHECK(several[0].serial == several[1].serial + 1);
  CHECK(lgs_replace(world, cellAt(0, 0), square, 2, NULL, 0, NULL) == LGS_OK);

  REFUSED(LGS_CELL_OUT_OF_RANGE, lgs_add(world, cellAt(LGS_MAX_CELL + 1, 0), square, 1, &a, &error));
  CHECK(error.cell.i == LGS_MAX_CELL + 1 && error.cell.j == 0);
  two.value = 99;
  REFUSED(LGS_UNKNOWN_SHAPE, lgs_add(world, cellAt(0, 0), two, 1, &a, &error));
  REFUSED(LGS_UNKNOWN_SHAPE, lgs_add_several(world, cellAt(0, 0), two, 1, NULL, 0, &error));
  REFUSED(LGS_UNKNOWN_SHAPE, lgs_replace(world, cellAt(0, 0), two, 1, NULL, 0, &error));
  REFUSED(LGS_OVERLAP, lgs_add(world, cellAt(3, 4), square, 1, NULL, &error));
  CHECK(samePolygon(error.other, a) && error.other_block == 7 && error.polygon == 0 && error.polygon2 == -1);
  lgs_free(world);
}

static void changing(void) {
  lgs_world* world = newWorld();
  const lgs_shape_id square = squareOf(world);
  const lgs_polygon_id one = placed(world, cellAt(0, 0), square, 1);
  lgs_shape_id unknown = {99};
  lgs_polygon polygon;
  lgs_error error;
  uint64_t number = 0;

  CHECK(lgs_set_block(world, one, 5, NULL) == LGS_OK);
  CHECK(lgs_polygon_of(world, one, &polygon, NULL) == LGS_OK && polygon.block == 5);
  CHECK(lgs_remove(world, one, NULL) == LGS_OK);
  REFUSED(LGS_STALE_HANDLE, lgs_remove(world, one, &error));
  CHECK(samePolygon(error.other, one));
  REFUSED(LGS_STALE_HANDLE, lgs_set_block(world, one, 5, &error));

  CHECK(lgs_fill(world, rectOf(0, 0, 9, 4), square, 1, &number, NULL) == LGS_OK && number == 50);
  REFUSED(LGS_OVERLAP, lgs_fill(world, rectOf(-1, 0, 0, 0), square, 1, &number, &error));
  CHECK(number == 50 && error.cell.i == 0);
  REFUSED(LGS_UNKNOWN_SHAPE, lgs_fill(world, rectOf(20, 0, 20, 0), unknown, 1, NULL, &error));
  REFUSED(LGS_CELL_OUT_OF_RANGE, lgs_fill(world, rectOf(0, 0, LGS_MAX_CELL + 1, 0), square, 1, NULL, &error));
  REFUSED(LGS_CELL_OUT_OF_RANGE, lgs_clear(world, rectOf(0, -LGS_MAX_CELL - 1, 0, 0), NULL, &error));
  CHECK(lgs_clear(world, rectOf(8, 0, 20, 9), &number, NULL) == LGS_OK && number == 10);
  CHECK(lgs_clear(world, rectOf(0, 0, -1, -1), &number, NULL) == LGS_OK && number == 0);
  lgs_free(world);
}

static void exchanging(void) {
  static lgs_new_polygon tooMany[LGS_MAX_CELL_POLYGONS + 1];
  lgs_world* world = newWorld();
  const lgs_local_point left[3] = {{0, 0}, {U, U}, {0, U}};
  const lgs_polygon_id old = placed(world, cellAt(2, 3), squareOf(world), 1);
  lgs_new_polygon halves[2] = {{kRamp, 3, 5, 0}, {left, 3, 6, 0}};
  lgs_polygon_id ids[2] = {{7, 7}, {7, 7}}, twice[2];
  lgs_polygon polygon;
  lgs_error error;
  size_t count = 0;

  /* Nothing changes where it is refused. */
  REFUSED(LGS_OVERLAP, lgs_exchange(world, cellAt(2, 3), NULL, 0, halves, 2, ids, &error));
  CHECK(ids[0].serial == 7 && samePolygon(error.other, old));
  REFUSED(LGS_STALE_HANDLE, lgs_exchange(world, cellAt(2, 4), &old, 1, halves, 2, ids, &error));
  CHECK(error.index == 0 && samePolygon(error.other, old));
  twice[0] = twice[1] = old;
  REFUSED(LGS_STALE_HANDLE, lgs_exchange(world, cellAt(2, 3), twice, 2, halves, 2, ids, &error));
  CHECK(error.index == 1);
  REFUSED(LGS_CELL_OUT_OF_RANGE, lgs_exchange(world, cellAt(LGS_MAX_CELL + 1, 0), NULL, 0, halves, 2, ids, &error));
  REFUSED(LGS_CAPACITY, lgs_exchange(world, cellAt(2, 3), &old, 1, tooMany, LGS_MAX_CELL_POLYGONS + 1, NULL, &error));
  halves[1].count = 2;
  REFUSED(LGS_TOO_FEW_VERTICES, lgs_exchange(world, cellAt(2, 3), &old, 1, halves, 2, ids, &error));
  CHECK(error.polygon == 1 && error.cell.i == 2 && ids[1].serial == 7);
  halves[1].count = 3;
  halves[1].reserved = 1;
  REFUSED(LGS_BAD_ARGUMENT, lgs_exchange(world, cellAt(2, 3), &old, 1, halves, 2, ids, &error));
  halves[1].reserved = 0;
  CHECK(lgs_polygon_of(world, old, NULL, NULL) == LGS_OK);

  /* A square becomes its two halves. */
  CHECK(lgs_exchange(world, cellAt(2, 3), &old, 1, halves, 2, ids, NULL) == LGS_OK);
  CHECK(lgs_polygon_of(world, ids[1], &polygon, NULL) == LGS_OK && polygon.block == 6 && polygon.cell.j == 3);
  CHECK(lgs_polygon_of(world, ids[0], &polygon, NULL) == LGS_OK && polygon.block == 5);
  CHECK(lgs_polygons_in(world, cellAt(2, 3), NULL, 0, &count) == LGS_SHORT_BUFFER && count == 2);
  CHECK(lgs_exchange(world, cellAt(2, 3), ids, 2, NULL, 0, NULL, NULL) == LGS_OK);
  CHECK(lgs_polygons_in(world, cellAt(2, 3), NULL, 0, &count) == LGS_OK && count == 0);

  REFUSED(LGS_BAD_ARGUMENT, lgs_exchange(NULL, cellAt(0, 0), NULL, 0, NULL, 0, NULL, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_exchange(world, cellAt(0, 0), NULL, 1, NULL, 0, NULL, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_exchange(world, cellAt(0, 0), NULL, 0, NULL, 1, NULL, &error));
  halves[0].vertices = NULL;
  REFUSED(LGS_BAD_ARGUMENT, lgs_exchange(world, cellAt(0, 0), NULL, 0, halves, 1, NULL, &error));
  lgs_free(world);
}

/* What a follower was told of the only cell that changed. */
struct told {
  int cells;
  lgs_cell cell;
  size_t before, now;
  uint32_t was, is; /* of a cell that had polygons and has some */
  lgs_local_point last;
};

static void tell(void* user, const lgs_cell_change* change) {
  struct told* told = (struct told*)user;
  size_t k, vertices = 0;
  for (k = 0; k < change->before_count; ++k) vertices += change->before[k].vertices;
  for (k = 0; k < change->now_count; ++k) vertices += change->now[k].vertices;
  ++told->cells;
  told->cell = change->cell;
  told->before = change->before_count;
  told->now = change->now_count;
  if (told->before != 0 && told->now != 0) {
    told->was = change->before[0].block;
    told->is = change->now[0].block;
  }
  if (vertices != 0) told->last = change->vertices[vertices - 1];
}

static struct told toldBy(const lgs_world* world) {
  struct told told;
  memset(&told, 0, sizeof told);
  CHECK(lgs_visit_cell_changes(world, tell, &told) == LGS_OK);
  return told;
}

static void following(void) {
  lgs_world* world = newWorld();
  const lgs_shape_id square = squareOf(world);
  lgs_error error;
  lgs_mark mark;
  struct told told;

  placed(world, cellAt(4, 5), square, 1);
  REFUSED(LGS_UNCOMMITTED, lgs_follow_cells(world, 1, &error));
  CHECK(lgs_commit(world, NULL) == LGS_OK && toldBy(world).cells == 0);
  REFUSED(LGS_BAD_ARGUMENT, lgs_follow_cells(world, 2, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_follow_cells(NULL, 1, &error));
  CHECK(lgs_follow_cells(world, 1, NULL) == LGS_OK && toldBy(world).cells == 0);

  CHECK(lgs_set_mark(world, &mark) == LGS_OK);
  CHECK(lgs_replace(world, cellAt(4, 5), square, 2, NULL, 0, NULL) == LGS_OK);
  CHECK(lgs_add_points(world, cellAt(4, 6), kRamp, 3, 1, NULL, NULL) == LGS_OK);
  CHECK(lgs_commit(world, NULL) == LGS_OK);
  told = toldBy(world);
  CHECK(told.cells == 2 && told.cell.j == 6 && told.before == 0 && told.now == 1);
  CHECK(told.last.x == U && told.last.y == U && told.was == 1 && told.is == 2);
  CHECK(lgs_roll_back(world, mark, NULL, NULL) == LGS_OK && toldBy(world).cells == 2);
  CHECK(lgs_forget(world, mark, NULL) == LGS_OK);
  CHECK(lgs_clear(world, rectOf(4, 5, 4, 5), NULL, NULL) == LGS_OK);
  CHECK(lgs_commit(world, NULL) == LGS_OK);
  told = toldBy(world);
  CHECK(told.cells == 1 && told.before == 1 && told.now == 0 && told.last.y == U);
  CHECK(lgs_follow_cells(world, 0, NULL) == LGS_OK && toldBy(world).cells == 0);
  CHECK(lgs_visit_cell_changes(world, NULL, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_visit_cell_changes(NULL, tell, &told) == LGS_BAD_ARGUMENT);
  lgs_free(world);
}

static void many(void) {
  lgs_world *world = newWorld(), *copy = NULL;
  const lgs_shape_id square = squareOf(world);
  lgs_placement placements[3];
  lgs_polygon_id polygons[3] = {{0, 0}, {0, 0}, {0, 0}};
  lgs_error error;
  char text[200] = "";
  int k;
  for (k = 0; k < 3; ++k) {
    placements[k].cell = cellAt(k, 0);
    placements[k].shape = square;
    placements[k].block = (lgs_block)k;
  }
  CHECK(lgs_add_many(world, placements, 2, polygons, NULL) == LGS_OK && polygons[1].serial == 1);
  CHECK(lgs_add_many(world, NULL, 0, NULL, NULL) == LGS_OK);
  CHECK(lgs_commit(world, NULL) == LGS_OK && lgs_copy(world, &copy) == LGS_OK);

  placements[0].cell = cellAt(7, 7);
  REFUSED(LGS_OVERLAP, lgs_add_many(world, placements, 3, polygons, &error));
  CHECK(error.index == 1 && error.cell.i == 1 && polygons[0].cell_ref == 0 && polygons[2].cell_ref == 0);
  CHECK(error.index2 == -1 && error.other.cell_ref != 0 && error.other_block == 1);
  polygons[0].serial = 7;
  REFUSED(LGS_CAPACITY, lgs_add_many(world, placements, (size_t)INT32_MAX + 1, polygons, &error));
  CHECK(error.index == -1 && polygons[0].serial == 7);
  placements[1].cell = cellAt(8, 8);
  placements[2].cell = cellAt(7, 7);
  REFUSED(LGS_OVERLAP, lgs_add_many(world, placements, 3, NULL, &error));
  CHECK(error.index == 2 && error.index2 == 0 && error.other.cell_ref == 0 && error.other_block == 0);
  CHECK(lgs_message(&error, text, sizeof text, NULL) == LGS_OK && strstr(text, "block 0 that entry 0 places"));
  CHECK(isUnchanged(world, copy));

  CHECK(lgs_replace(world, cellAt(0, 0), square, 1, polygons, 1, NULL) == LGS_OK);
  CHECK(lgs_replace(world, cellAt(1, 0), square, 1, polygons + 1, 1, NULL) == LGS_OK);
  polygons[2] = polygons[0];
  CHECK(lgs_commit(world, NULL) == LGS_OK);
  lgs_free(copy);
  CHECK(lgs_copy(world, &copy) == LGS_OK);
  REFUSED(LGS_STALE_HANDLE, lgs_remove_many(world, polygons, 3, &error));
  CHECK(error.index == 2 && samePolygon(error.other, polygons[0]) && isUnchanged(world, copy));
  CHECK(error.index2 == 0 && lgs_message(&error, text, sizeof text, NULL) == LGS_OK && strstr(text, "comes twice"));
  REFUSED(LGS_CAPACITY, lgs_remove_many(world, polygons, (size_t)INT32_MAX + 1, &error));
  CHECK(lgs_remove_many(world, polygons, 2, NULL) == LGS_OK);
  CHECK(lgs_remove_many(world, NULL, 0, NULL) == LGS_OK);
  lgs_free(copy);
  lgs_free(world);
}

static void nulls(void) {
  lgs_world* world = newWorld();
  const lgs_shape_id square = squareOf(world);
  const lgs_polygon_id polygon = {1, 1};
  const uint32_t count = 3;
  lgs_error error;
  const lgs_status bad = LGS_BAD_ARGUMENT;
  REFUSED(bad, lgs_shape(NULL, kSquare, 4, NULL, &error));
  REFUSED(bad, lgs_shape(world, NULL, 4, NULL, &error));
  REFUSED(bad, lgs_shape_floats(world, NULL, 4, NULL, &error));
  REFUSED(bad, lgs_shape_doubles(world, NULL, 4, NULL, &error));
  REFUSED(bad, lgs_shape_of_several(NULL, kSquare, &count, 1, NULL, &error));
  REFUSED(bad, lgs_shape_of_several(world, kSquare, NULL, 1, NULL, &error));
  REFUSED(bad, lgs_shape_of_several(world, NULL, &count, 1, NULL, &error));
  CHECK(lgs_shape_polygons(NULL, square, NULL) == bad && lgs_shape_box(NULL, square, NULL) == bad);
  CHECK(lgs_shape_vertices(NULL, square, 0, NULL, 0, NULL) == bad);
  REFUSED(bad, lgs_add(NULL, cellAt(0, 0), square, 1, NULL, &error));
  REFUSED(bad, lgs_add_several(NULL, cellAt(0, 0), square, 1, NULL, 0, &error));
  REFUSED(bad, lgs_add_several(world, cellAt(0, 0), square, 1, NULL, 1, &error));
  REFUSED(bad, lgs_add_points(NULL, cellAt(0, 0), kSquare, 4, 1, NULL, &error));
  REFUSED(bad, lgs_add_points(world, cellAt(0, 0), NULL, 4, 1, NULL, &error));
  REFUSED(bad, lgs_add_floats(world, cellAt(0, 0), NULL, 4, 1, NULL, &error));
  REFUSED(bad, lgs_add_doubles(world, cellAt(0, 0), NULL, 4, 1, NULL, &error));
  REFUSED(bad, lgs_add_many(NULL, NULL, 0, NULL, &error));
  REFUSED(bad, lgs_add_many(world, NULL, 1, NULL, &error));
  REFUSED(bad, lgs_remove(NULL, polygon, &error));
  REFUSED(bad, lgs_remove_many(NULL, NULL, 0, &error));
  REFUSED(bad, lgs_remove_many(world, NULL, 1, &error));
  REFUSED(bad, lgs_replace(NULL, cellAt(0, 0), square, 1, NULL, 0, &error));
  REFUSED(bad, lgs_replace(world, cellAt(0, 0), square, 1, NULL, 1, &error));
  REFUSED(bad, lgs_set_block(NULL, polygon, 1, &error));
  REFUSED(bad, lgs_fill(NULL, rectOf(0, 0, 0, 0), square, 1, NULL, &error));
  REFUSED(bad, lgs_clear(NULL, rectOf(0, 0, 0, 0), NULL, &error));
  CHECK(lgs_add(NULL, cellAt(0, 0), square, 1, NULL, NULL) == bad);
  lgs_free(world);
}

int main(void) {
  shapes();
  badPolygons();
  tooMuch();
  severalAtMost();
  adding();
  changing();
  exchanging();
  following();
  many();
  nulls();
  return 0;
}
