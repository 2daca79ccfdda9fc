/* A floor of ten blocks, dug in the middle: the smallest program with the C interface. */
#include <lgs/lgs.h>
#include <stdio.h>

enum { U = LGS_UNITS_PER_CELL };

/* A refused edit has changed nothing. Its error says what is wrong, and where. */
static int refused(const lgs_error* error) {
  char text[200];
  lgs_message(error, text, sizeof text, NULL);
  fprintf(stderr, "%s\n", text);
  return 1;
}

static int dig(lgs_world* world) {
  const lgs_local_point corners[] = {{0, 0}, {U, 0}, {U, U}, {0, U}};
  const lgs_point origin = {0, 0};
  lgs_shape_id square;
  lgs_placement placements[10];
  lgs_polygon_id floor[10];
  lgs_segment_double segments[8];
  lgs_changes changes;
  lgs_error error;
  size_t k;

  if (lgs_shape(world, corners, 4, &square, &error) != LGS_OK) return refused(&error);
  for (k = 0; k < 10; ++k) {
    placements[k].cell.i = (int32_t)k;
    placements[k].cell.j = 0;
    placements[k].shape = square;
    placements[k].block = 1; /* a number of your own, say of a material */
  }
  if (lgs_add_many(world, placements, 10, floor, &error) != LGS_OK) return refused(&error);
  lgs_commit(world, &changes);
  printf("%u segments\n", (unsigned)changes.added_count);

  if (lgs_remove(world, floor[5], &error) != LGS_OK) return refused(&error);
  lgs_commit(world, &changes); /* exactly what changed, to hand on to the physics engine */
  printf("%u removed, %u added, %u relinked\n", (unsigned)changes.removed_count, (unsigned)changes.added_count,
         (unsigned)changes.relinked_count);
  if (changes.added_count > 8) return 1;
  if (lgs_segments_double(world, changes.added, changes.added_count, origin, segments, &error) != LGS_OK)
    return refused(&error);
  for (k = 0; k < changes.added_count; ++k) { /* Box2D: (ghost1, start, end, ghost2) */
    const lgs_segment_double* s = &segments[k];
    printf("a segment of block %u from (%g, %g) to (%g, %g)\n", (unsigned)s->block, s->start.x, s->start.y, s->end.x,
           s->end.y);
  }
  return k == 2 ? 0 : 1;
}

int main(void) {
  lgs_world* world;
  int status;
  if (lgs_new(NULL, &world) != LGS_OK) return 1;
  status = dig(world);
  lgs_free(world);
  return status;
}
