/* A walker on a floor of blocks, in a loop of frames: each second a bomb takes away the block below. The walker falls in
 * and climbs out. game.cpp is the same game in C++. */
#include <lgs/lgs.h>
#include <stdio.h>
#include <string.h>

enum { U = LGS_UNITS_PER_CELL, EDGES = 256 };

/* The game's own copy of the outline, by id. A game with a physics engine would have a body's edges there. */
typedef struct edge {
  int alive;
  lgs_point start, end;
} edge;

static edge outline[EDGES];

/* Takes over what a commit has changed, and nothing else. A relinked segment has other ghosts only, which this
 * game does not need. */
static int update(const lgs_world* world, const lgs_changes* changes, lgs_error* error) {
  size_t k;
  for (k = 0; k < changes->removed_count; ++k) outline[changes->removed[k].value].alive = 0;
  for (k = 0; k < changes->added_count; ++k) {
    const lgs_segment_id id = changes->added[k];
    lgs_segment segment;
    if (id.value >= EDGES || lgs_segments(world, &id, 1, &segment, error) != LGS_OK) return 0;
    outline[id.value].alive = 1;
    outline[id.value].start = segment.start;
    outline[id.value].end = segment.end;
  }
  return 1;
}

static int count(void) {
  int k, alive = 0;
  for (k = 0; k < EDGES; ++k) alive += outline[k].alive;
  return alive;
}

/* How high the ground is below a point. The solid is on the left of an edge, so edges to the left are floors. */
static int64_t floor_below(lgs_point p) {
  int64_t height = 0;
  const edge* e;
  for (e = outline; e < outline + EDGES; ++e)
    if (e->alive && e->end.x <= p.x && p.x < e->start.x && e->start.y <= p.y && e->start.y > height)
      height = e->start.y;
  return height;
}

/* Whether a step to the right ends at a wall: an edge that goes down. */
static int is_blocked(lgs_point p, int64_t step) {
  const edge* e;
  for (e = outline; e < outline + EDGES; ++e)
    if (e->alive && e->start.x == e->end.x && e->end.y <= p.y && p.y < e->start.y && p.x < e->start.x &&
        e->start.x <= p.x + step)
      return 1;
  return 0;
}

static int play(lgs_world* world, lgs_error* error) {
  const lgs_local_point corners[] = {{0, 0}, {U, 0}, {U, U}, {0, U}};
  const lgs_cell_rect ground = {{0, 0}, {15, 3}};
  lgs_point walker = {U / 2, 5 * U};
  lgs_shape_id square;
  lgs_changes changes;
  int frame;

  if (lgs_shape(world, corners, 4, &square, error) != LGS_OK) return 0;
  if (lgs_fill(world, ground, square, 1, NULL, error) != LGS_OK) return 0;
  for (frame = 0; frame < 300; ++frame) {
    if (frame % 60 == 59) { /* a bomb, where the walker stands */
      lgs_point below = walker;
      lgs_cell_rect hole;
      below.y -= 1;
      hole.min = hole.max = lgs_cell_at(below);
      if (lgs_clear(world, hole, NULL, error) != LGS_OK) return 0;
    }
    lgs_commit(world, &changes); /* once in each frame; it costs what was edited */
    if (!update(world, &changes, error)) return 0;
    if (changes.added_count != 0) {
      printf("frame %d: %d removed, %d added, %d relinked; %d edges\n", frame, (int)changes.removed_count,
             (int)changes.added_count, (int)changes.relinked_count, count());
    }
    if (is_blocked(walker, U / 32)) {
      walker.y += U / 16; /* it climbs */
    } else {
      int64_t fallen = walker.y - U / 8, below;
      walker.x += U / 32;
      below = floor_below(walker);
      walker.y = below > fallen ? below : fallen;
    }
  }
  printf("the walker is at (%.3f, %.3f)\n", (double)walker.x / U, (double)walker.y / U);
  return 1;
}

int main(void) {
  lgs_world* world;
  lgs_error error;
  char text[200] = "too many edges";
  int played;
  memset(&error, 0, sizeof error);
  if (lgs_new(NULL, &world) != LGS_OK) return 1;
  played = play(world, &error);
  lgs_free(world);
  if (played) return 0;
  if (error.code != LGS_OK) lgs_message(&error, text, sizeof text, NULL);
  fprintf(stderr, "%s\n", text);
  return 1;
}
