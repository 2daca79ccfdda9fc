/* Falling ground: an arm is cut off, falls as the game says, and is ground again, at an angle and in the saved game. */
#include "check.h"

#include <lgs/lgs_falling.h>

#include <math.h>
#include <string.h>

/* The parts of a body, added up. */
struct parts {
  size_t count;
  int64_t double_area;
  size_t most; /* vertices */
};
static void addPart(void* user, lgs_block block, const lgs_point* v, size_t count) {
  struct parts* sum = (struct parts*)user;
  size_t k;
  CHECK(block == 1 || block == 2);
  ++sum->count;
  if (count > sum->most) sum->most = count;
  for (k = 0; k < count; ++k) {
    const lgs_point a = v[k], b = v[k + 1 == count ? 0 : k + 1];
    sum->double_area += a.x * b.y - b.x * a.y;
  }
}

/* An arm of two blocks beside a pillar on the floor: five cells, of which the last is a ramp. */
static lgs_world* ground(void) {
  const lgs_local_point ramp[] = {{0, 0}, {U, 0}, {0, U}};
  lgs_world* world = newWorld();
  const lgs_shape_id square = squareOf(world);
  CHECK(lgs_fill(world, rectOf(0, 0, 20, 0), square, 9, NULL, NULL) == LGS_OK);
  CHECK(lgs_fill(world, rectOf(0, 1, 0, 8), square, 9, NULL, NULL) == LGS_OK);
  CHECK(lgs_fill(world, rectOf(1, 8, 3, 8), square, 1, NULL, NULL) == LGS_OK);
  CHECK(lgs_fill(world, rectOf(4, 8, 5, 8), square, 2, NULL, NULL) == LGS_OK);
  CHECK(lgs_add_points(world, cellAt(6, 8), ramp, 3, 2, NULL, NULL) == LGS_OK);
  CHECK(lgs_commit(world, NULL) == LGS_OK && lgs_follow_cells(world, 1, NULL) == LGS_OK);
  return world;
}
static int32_t isFloor(void* user, lgs_block block, lgs_cell cell) {
  (void)user;
  (void)cell;
  return block == 9;
}
static lgs_body* fallen(lgs_world* world, lgs_islands* view) {
  lgs_island_id loose = {0};
  lgs_body* body = NULL;
  lgs_changes changes;
  size_t count = 0;
  CHECK(lgs_clear(world, rectOf(1, 8, 1, 8), NULL, NULL) == LGS_OK && lgs_commit(world, &changes) == LGS_OK);
  CHECK(lgs_islands_update(view, world, &changes) == LGS_OK);
  CHECK(lgs_islands_ids(view, LGS_LOOSE, &loose, 1, &count) == LGS_OK && count == 1);
  CHECK(lgs_take(world, view, loose, &body, NULL) == LGS_OK && lgs_commit(world, &changes) == LGS_OK);
  CHECK(lgs_islands_update(view, world, &changes) == LGS_OK);
  return body;
}

static void parts(const lgs_body* body) {
  struct parts sum;
  lgs_error error;
  memset(&sum, 0, sizeof sum);
  REFUSED(LGS_BAD_ARGUMENT, lgs_body_parts(NULL, 8, addPart, &sum, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_body_parts(body, 8, NULL, &sum, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_body_parts(body, 2, addPart, &sum, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_body_parts(body, LGS_MAX_CELL_VERTICES + 1, addPart, &sum, &error));
  CHECK(sum.count == 0);
  CHECK(lgs_body_parts(body, 8, addPart, &sum, NULL) == LGS_OK);
  CHECK(sum.count == 3 && sum.double_area == 9 * (int64_t)U * U && sum.most == 4); /* a rectangle of each, a ramp */
  memset(&sum, 0, sizeof sum);
  CHECK(lgs_body_parts(body, 3, addPart, &sum, NULL) == LGS_OK);
  CHECK(sum.count == 9 && sum.double_area == 9 * (int64_t)U * U && sum.most == 3);
}

static void settles(void) {
  lgs_world* world = ground();
  lgs_islands* view = NULL;
  lgs_body *body, *again = NULL;
  lgs_rock rock = {{{2, 8}, 1, 0}, {0, -3}, 0.5}, loaded;
  lgs_body_facts facts, same;
  lgs_placing wrong;
  lgs_mark inTheAir;
  lgs_changes changes;
  lgs_error error;
  lgs_stats stats;
  lgs_island_id ids[2];
  uint8_t bytes[1024];
  size_t count = 0, size = 0;
  CHECK(lgs_islands_new(world, isFloor, NULL, &view) == LGS_OK);
  body = fallen(world, view);
  parts(body);
  CHECK(lgs_set_mark(world, &inTheAir) == LGS_OK);

  /* Saved in the air. */
  CHECK(lgs_rock_save(NULL, &rock, bytes, sizeof bytes, &size) == LGS_BAD_ARGUMENT);
  CHECK(lgs_rock_save(body, NULL, bytes, sizeof bytes, &size) == LGS_BAD_ARGUMENT);
  CHECK(lgs_rock_save(body, &rock, NULL, 1, &size) == LGS_BAD_ARGUMENT);
  CHECK(lgs_rock_save(body, &rock, NULL, 0, &size) == LGS_SHORT_BUFFER && size > 100 && size < sizeof bytes);
  CHECK(lgs_rock_save(body, &rock, bytes, sizeof bytes, &size) == LGS_OK);
  CHECK(lgs_rock_load(NULL, size, &again, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_rock_load(bytes, size, NULL, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_rock_load(bytes, size - 1, &again, NULL) == LGS_SAVE_DAMAGED && again == NULL);
  CHECK(lgs_rock_load(bytes, size, &again, &loaded) == LGS_OK && memcmp(&rock, &loaded, sizeof rock) == 0);
  CHECK(lgs_body_get(body, &facts) == LGS_OK && lgs_body_get(again, &same) == LGS_OK);
  CHECK(facts.area == 4.5 && memcmp(&facts, &same, sizeof facts) == 0);
  /* What cannot be loaded is not saved; what is in range is. */
  {
    const double odd[] = {NAN, INFINITY, -1e300};
    size_t k;
    for (k = 0; k < 3; ++k) {
      lgs_rock bad = rock;
      bad.placing.origin.x = odd[k];
      CHECK(lgs_rock_save(body, &bad, bytes, sizeof bytes, &size) == LGS_BAD_ARGUMENT);
      bad = rock;
      bad.velocity.y = odd[k];
      CHECK(lgs_rock_save(body, &bad, bytes, sizeof bytes, &size) == LGS_BAD_ARGUMENT);
      bad = rock;
      bad.placing.sine = odd[k];
      CHECK(lgs_rock_save(body, &bad, bytes, sizeof bytes, &size) == LGS_BAD_ARGUMENT);
    }
    for (k = 0; k < 3; ++k) {
      lgs_rock far = rock;
      lgs_body* there = NULL;
      far.placing.origin.x = k == 0 ? LGS_MAX_CELL : k == 1 ? -LGS_MAX_CELL : 1000000500;
      CHECK(lgs_rock_save(body, &far, bytes, sizeof bytes, &size) == LGS_OK);
      CHECK(lgs_rock_load(bytes, size, &there, &loaded) == LGS_OK && memcmp(&far, &loaded, sizeof far) == 0);
      lgs_body_free(there);
    }
  }
  lgs_body_free(body);

  /* It comes to rest on the floor, turned by a quarter: the ramp is on top. */
  rock.placing.origin.x = 10;
  rock.placing.origin.y = 1;
  rock.placing.cosine = 0;
  rock.placing.sine = 1;
  wrong = rock.placing;
  wrong.origin.x = 1e300;
  REFUSED(LGS_BAD_ARGUMENT, lgs_put_as_it_lies(NULL, again, &rock.placing, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_put_as_it_lies(world, NULL, &rock.placing, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_put_as_it_lies(world, again, NULL, &error));
  REFUSED(LGS_OUT_OF_REACH, lgs_put_as_it_lies(world, again, &wrong, &error));
  wrong = rock.placing;
  wrong.sine = 0;
  REFUSED(LGS_BAD_ARGUMENT, lgs_put_as_it_lies(world, again, &wrong, &error)); /* it would be a point */
  wrong.cosine = 3;
  REFUSED(LGS_BAD_ARGUMENT, lgs_put_as_it_lies(world, again, &wrong, &error));
  CHECK(lgs_put_as_it_lies(world, again, &rock.placing, NULL) == LGS_OK && lgs_commit(world, &changes) == LGS_OK);
  CHECK(lgs_islands_update(view, world, &changes) == LGS_OK);
  CHECK(lgs_islands_ids(view, LGS_ALL, ids, 2, &count) == LGS_OK && count == 1);
  CHECK(lgs_count(world, &stats) == LGS_OK && stats.polygons == 34);

  /* An undo takes it into the air again. */
  CHECK(lgs_roll_back(world, inTheAir, &changes, NULL) == LGS_OK);
  CHECK(lgs_islands_update(view, world, &changes) == LGS_OK);
  CHECK(lgs_count(world, &stats) == LGS_OK && stats.polygons == 29);
  lgs_body_free(again);
  lgs_islands_free(view);
  lgs_free(world);
}

int main(void) {
  settles();
  return 0;
}
