/* What the tests in C share: an expectation, a square, a world. */
#ifndef LGS_PROPTESTS_C_CHECK_H
#define LGS_PROPTESTS_C_CHECK_H

#include <lgs/lgs.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK(condition)                                                        \
  do {                                                                          \
    if (!(condition)) {                                                         \
      fprintf(stderr, "%s:%d: expected: %s\n", __FILE__, __LINE__, #condition); \
      exit(1);                                                                  \
    }                                                                           \
  } while (0)

/* The call is refused, and its error says so. `error` must be there. */
#define REFUSED(status, call)           \
  do {                                  \
    memset(&error, 0x55, sizeof error); \
    CHECK((call) == (status));          \
    CHECK(error.code == (status));      \
  } while (0)

enum { U = LGS_UNITS_PER_CELL };

static const lgs_local_point kSquare[4] = {{0, 0}, {U, 0}, {U, U}, {0, U}};
static const lgs_local_point kRamp[3] = {{0, 0}, {U, 0}, {U, U}};

static inline lgs_cell cellAt(int32_t i, int32_t j) {
  const lgs_cell cell = {i, j};
  return cell;
}

static inline lgs_cell_rect rectOf(int32_t i0, int32_t j0, int32_t i1, int32_t j1) {
  const lgs_cell_rect rect = {{i0, j0}, {i1, j1}};
  return rect;
}

static inline lgs_point pointAt(int64_t x, int64_t y) {
  const lgs_point point = {x, y};
  return point;
}

static inline int samePolygon(lgs_polygon_id a, lgs_polygon_id b) {
  return a.cell_ref == b.cell_ref && a.serial == b.serial;
}

static inline lgs_world* newWorld(void) {
  lgs_world* world = NULL;
  CHECK(lgs_new(NULL, &world) == LGS_OK);
  return world;
}

static inline lgs_shape_id squareOf(lgs_world* world) {
  lgs_shape_id shape = {0};
  CHECK(lgs_shape(world, kSquare, 4, &shape, NULL) == LGS_OK);
  return shape;
}

/* Places a shape where that must succeed. */
static inline lgs_polygon_id placed(lgs_world* world, lgs_cell cell, lgs_shape_id shape, lgs_block block) {
  lgs_polygon_id polygon = {0, 0};
  CHECK(lgs_add(world, cell, shape, block, &polygon, NULL) == LGS_OK);
  return polygon;
}

/* A preserve relation that keeps the overlap of different blocks. It counts how often it is asked. */
static inline int32_t keepsOthers(void* user, lgs_block smaller, lgs_block greater) {
  CHECK(smaller <= greater);
  ++*(int*)user;
  return smaller != greater;
}

/* Whether the world has the same polygons as that copy, and no edit since its commit that a save would refuse. */
static inline int isUnchanged(const lgs_world* world, const lgs_world* copy) {
  int32_t same = 0;
  return lgs_same_polygons(world, copy, &same) == LGS_OK && same == 1 &&
         lgs_save_to_buffer(world, NULL, 0, NULL, NULL) == LGS_SHORT_BUFFER;
}

#endif
