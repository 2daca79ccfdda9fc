/* Worlds as a whole: options, copies, commits, groups, roll-backs; ids as integers; errors as sentences. */
#include "check.h"

static void options(void) {
  lgs_world* world = NULL;
  lgs_world_options options;
  lgs_changes changes;
  lgs_shape_id square;
  int32_t preserves = 7;
  int calls = 0;
  memset(&options, 0x55, sizeof options);
  lgs_default_world_options(&options, sizeof options);
  lgs_default_world_options(NULL, sizeof options);
  CHECK(options.size == sizeof options && options.reserved == 0 && !options.preserve && !options.user);
  options.preserve = keepsOthers;
  options.user = &calls;
  CHECK(lgs_new(&options, &world) == LGS_OK);
  square = squareOf(world);
  placed(world, cellAt(0, 0), square, 2);
  placed(world, cellAt(1, 0), square, 1);
  placed(world, cellAt(2, 0), square, 1);
  CHECK(lgs_commit(world, &changes) == LGS_OK && changes.added_count == 10 && calls > 0);
  CHECK(lgs_preserves(world, 2, 1, &preserves) == LGS_OK && preserves == 1); /* it asks for the smaller one first */
  CHECK(lgs_preserves(world, 2, 2, &preserves) == LGS_OK && preserves == 0);
  lgs_free(world);
  world = newWorld();
  preserves = 7;
  CHECK(lgs_preserves(world, 1, 2, &preserves) == LGS_OK && preserves == 0);
  CHECK(lgs_preserves(world, 1, 2, NULL) == LGS_OK && lgs_preserves(NULL, 1, 2, &preserves) == LGS_BAD_ARGUMENT);
  lgs_free(world);

  world = NULL;
  options.size = sizeof options + 8;
  CHECK(lgs_new(&options, &world) == LGS_BAD_ARGUMENT && !world);
  options.size = 4;
  CHECK(lgs_new(&options, &world) == LGS_BAD_ARGUMENT);
  lgs_default_world_options(&options, sizeof options);
  options.reserved = 1;
  CHECK(lgs_new(&options, &world) == LGS_BAD_ARGUMENT);
  CHECK(lgs_new(NULL, NULL) == LGS_BAD_ARGUMENT);
  options.preserve = keepsOthers;
  lgs_default_world_options(&options, 4); /* of a caller with a smaller struct: the rest is not touched */
  CHECK(options.size == 4 && options.preserve == keepsOthers);
  lgs_free(NULL);
}

static void copies(void) {
  lgs_world *world = newWorld(), *copy = NULL, *other = NULL;
  const lgs_shape_id square = squareOf(world);
  lgs_polygon_id here, there;
  lgs_changes changes;
  lgs_stats stats, others;
  int32_t same = 7;
  placed(world, cellAt(0, 0), square, 1);
  CHECK(lgs_commit(world, NULL) == LGS_OK && lgs_copy(world, &copy) == LGS_OK);
  CHECK(lgs_world_version(world) == lgs_world_version(copy));
  CHECK(lgs_same_polygons(world, copy, &same) == LGS_OK && same == 1);
  here = placed(world, cellAt(1, 0), square, 1);
  CHECK(lgs_same_polygons(world, copy, &same) == LGS_OK && same == 0);
  there = placed(copy, cellAt(1, 0), square, 1);
  CHECK(samePolygon(here, there));
  CHECK(lgs_commit(world, NULL) == LGS_OK && lgs_world_version(world) != lgs_world_version(copy));
  CHECK(lgs_max_segment_id(world) >= 6 && lgs_max_segment_id(copy) == 4);
  CHECK(lgs_count(world, &stats) == LGS_OK);
  CHECK(stats.polygons == 2 && stats.cells == 2 && stats.segments == 6 && stats.shapes == 1 && stats.chunks == 1);
  CHECK(stats.contents >= 1 && stats.bytes > 1000 && stats.reserved[4] == 0);
  CHECK(lgs_clear(world, rectOf(0, 0, 1, 0), NULL, NULL) == LGS_OK && lgs_commit(world, NULL) == LGS_OK);
  CHECK(lgs_fill(world, rectOf(0, 0, 9999, 0), square, 1, NULL, NULL) == LGS_OK);
  CHECK(lgs_copy(world, &other) == LGS_OK && lgs_commit(world, &changes) == LGS_OK &&
        lgs_commit(other, NULL) == LGS_OK);
  CHECK(lgs_count(world, &stats) == LGS_OK && lgs_count(other, &others) == LGS_OK);
  CHECK(stats.bytes >= others.bytes + changes.added_count * sizeof(lgs_segment_id)); /* the lists that it keeps */
  lgs_free(other);
  CHECK(lgs_count(world, NULL) == LGS_OK && lgs_count(NULL, &stats) == LGS_BAD_ARGUMENT);
  CHECK(lgs_copy(NULL, &copy) == LGS_BAD_ARGUMENT && lgs_copy(world, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_same_polygons(NULL, copy, &same) == LGS_BAD_ARGUMENT);
  CHECK(lgs_same_polygons(world, NULL, &same) == LGS_BAD_ARGUMENT);
  CHECK(lgs_world_version(NULL) == 0 && lgs_max_segment_id(NULL) == 0);
  lgs_free(copy);
  lgs_free(world);
}

/* The jobs from the last to the first. */
static void backwards(void* user, size_t count, lgs_job_fn run, void* job) {
  *(size_t*)user += count;
  while (count-- > 0) run(job, count);
}

static void commits(void) {
  lgs_world *world = newWorld(), *other = newWorld();
  const lgs_shape_id square = squareOf(world);
  lgs_changes changes, expected;
  uint64_t version;
  size_t jobs = 0, before, k;
  squareOf(other);
  CHECK(lgs_fill(world, rectOf(0, 0, 99, 0), square, 1, NULL, NULL) == LGS_OK);
  CHECK(lgs_fill(other, rectOf(0, 0, 99, 0), square, 1, NULL, NULL) == LGS_OK);
  CHECK(lgs_commit_with(world, backwards, &jobs, &changes) == LGS_OK);
#ifndef LGS_SMALL_CODE /* which has no threads */
  CHECK(jobs > 0);
#endif
  CHECK(lgs_commit(other, &expected) == LGS_OK && expected.added_count == 202 && changes.added_count == 202);
  for (k = 0; k < 202; ++k) CHECK(changes.added[k].value == expected.added[k].value);
  CHECK(changes.removed_count == 0 && changes.relinked_count == 0);
  version = lgs_world_version(world);
  CHECK(changes.before == 0 && version != 0 && changes.after == version);

  CHECK(lgs_clear(world, rectOf(50, 0, 50, 0), NULL, NULL) == LGS_OK);
  CHECK(lgs_commit(world, &changes) == LGS_OK);
  CHECK(changes.removed_count == 2 && changes.added_count == 2 && changes.relinked_count == 4);
  CHECK(changes.before == version && changes.after != version && changes.after == lgs_world_version(world));
  before = jobs;
  CHECK(lgs_clear(world, rectOf(10, 0, 10, 0), NULL, NULL) == LGS_OK);
  CHECK(lgs_commit_with(world, backwards, &jobs, &changes) == LGS_OK && changes.added_count == 2);
  CHECK(jobs == before); /* there are segments, so there is little to spread */
  CHECK(lgs_commit(NULL, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_commit_with(NULL, backwards, NULL, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_commit_with(world, NULL, NULL, NULL) == LGS_BAD_ARGUMENT);
  lgs_free(other);
  lgs_free(world);
}

static void groups(void) {
  lgs_world* world = newWorld();
  const lgs_shape_id square = squareOf(world);
  lgs_group *group = NULL, *inner = NULL;
  int32_t isEmpty = 7;
  CHECK(lgs_begin(world, &group) == LGS_OK);
  placed(world, cellAt(0, 0), square, 1);
  CHECK(lgs_begin(world, &inner) == LGS_OK);
  placed(world, cellAt(1, 0), square, 1);
  lgs_undo(inner);
  lgs_keep(group);
  CHECK(lgs_is_empty(world, cellAt(0, 0), &isEmpty) == LGS_OK && isEmpty == 0);
  CHECK(lgs_is_empty(world, cellAt(1, 0), &isEmpty) == LGS_OK && isEmpty == 1);
  lgs_undo(NULL);
  lgs_keep(NULL);
  CHECK(lgs_begin(NULL, &group) == LGS_BAD_ARGUMENT && lgs_begin(world, NULL) == LGS_BAD_ARGUMENT);
  lgs_free(world);
}

/* A copy has the edits of a group that is open, and nothing to undo them. */
static void copiesOfGroups(void) {
  lgs_world *world = newWorld(), *during = NULL, *after = NULL;
  const lgs_shape_id square = squareOf(world);
  lgs_group* group = NULL;
  lgs_stats a, b;
  int32_t same = 0;
  CHECK(lgs_begin(world, &group) == LGS_OK);
  placed(world, cellAt(0, 0), square, 1);
  CHECK(lgs_copy(world, &during) == LGS_OK);
  lgs_keep(group);
  CHECK(lgs_copy(world, &after) == LGS_OK && lgs_same_polygons(during, after, &same) == LGS_OK && same == 1);
  CHECK(lgs_fill(during, rectOf(0, 1, 31, 31), square, 1, NULL, NULL) == LGS_OK && lgs_commit(during, NULL) == LGS_OK);
  CHECK(lgs_fill(after, rectOf(0, 1, 31, 31), square, 1, NULL, NULL) == LGS_OK && lgs_commit(after, NULL) == LGS_OK);
  CHECK(lgs_count(during, &a) == LGS_OK && lgs_count(after, &b) == LGS_OK);
  CHECK(a.bytes < b.bytes + 1000); /* it had room for a mark; 992 edits would take more */
  lgs_free(during);
  lgs_free(after);
  lgs_free(world);
}

static void goingBack(void) {
  lgs_world* world = newWorld();
  const lgs_shape_id square = squareOf(world);
  lgs_mark mark = {0}, later = {0};
  lgs_changes changes;
  lgs_error error;
  uint64_t version;
  placed(world, cellAt(0, 0), square, 1);
  CHECK(lgs_commit(world, NULL) == LGS_OK);
  version = lgs_world_version(world);
  CHECK(lgs_set_mark(world, &mark) == LGS_OK && mark.value != 0);
  placed(world, cellAt(1, 0), square, 1);
  CHECK(lgs_commit(world, NULL) == LGS_OK && lgs_set_mark(world, &later) == LGS_OK);
  CHECK(lgs_roll_back(world, mark, &changes, NULL) == LGS_OK);
  CHECK(changes.removed_count == 3 && changes.added_count == 1 && changes.after == version);
  CHECK(lgs_roll_back(world, mark, NULL, NULL) == LGS_OK);
  REFUSED(LGS_UNKNOWN_MARK, lgs_roll_back(world, later, &changes, &error));
  REFUSED(LGS_UNKNOWN_MARK, lgs_redo(world, later, &changes, &error));
  placed(world, cellAt(1, 0), square, 1);
  CHECK(lgs_commit(world, NULL) == LGS_OK && lgs_set_mark(world, &later) == LGS_OK);
  CHECK(lgs_roll_back_keeping(world, mark, NULL, NULL) == LGS_OK);
  CHECK(lgs_redo(world, later, &changes, NULL) == LGS_OK);
  CHECK(changes.removed_count == 1 && changes.added_count == 3 && changes.before == version);
  REFUSED(LGS_BAD_ARGUMENT, lgs_redo(NULL, later, NULL, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_roll_back_keeping(NULL, later, NULL, &error));
  CHECK(lgs_roll_back_keeping(world, mark, &changes, NULL) == LGS_OK && changes.added_count == 1);
  CHECK(lgs_forget(world, mark, NULL) == LGS_OK);
  REFUSED(LGS_UNKNOWN_MARK, lgs_forget(world, mark, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_forget(NULL, mark, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_roll_back(NULL, mark, NULL, &error));
  CHECK(lgs_set_mark(NULL, &mark) == LGS_BAD_ARGUMENT && lgs_set_mark(world, NULL) == LGS_BAD_ARGUMENT);
  lgs_free(world);
}

static void places(void) {
  lgs_world* world = newWorld();
  const lgs_shape_id square = squareOf(world);
  lgs_error error;
  lgs_stats stats;
  uint64_t gone = 7;
  const lgs_polygon_id polygon = placed(world, cellAt(0, 0), square, 1);
  placed(world, cellAt(32, 0), square, 1);
  REFUSED(LGS_UNCOMMITTED, lgs_forget_chunks(world, rectOf(0, 0, 63, 31), &gone, &error));
  CHECK(lgs_remove(world, polygon, NULL) == LGS_OK && lgs_commit(world, NULL) == LGS_OK);
  CHECK(lgs_forget_chunks(world, rectOf(0, 0, 63, 31), &gone, NULL) == LGS_OK && gone == 1);
  CHECK(lgs_forget_chunks(world, rectOf(0, 0, 63, 31), NULL, NULL) == LGS_OK);
  CHECK(lgs_count(world, &stats) == LGS_OK && stats.chunks == 1 && stats.polygons == 1);
  REFUSED(LGS_BAD_ARGUMENT, lgs_forget_chunks(NULL, rectOf(0, 0, 63, 31), &gone, &error));
  lgs_free(world);
}

/* The bytes of one chunk. */
typedef struct shelf {
  uint8_t bytes[256];
  size_t count;
  lgs_cell corner;
} shelf;

static void keep(void* user, lgs_cell corner, const uint8_t* bytes, size_t count) {
  shelf* kept = user;
  CHECK(count <= sizeof kept->bytes);
  memcpy(kept->bytes, bytes, count);
  kept->count = count;
  kept->corner = corner;
}

static void unloading(void) {
  lgs_world* world = newWorld();
  const lgs_shape_id square = squareOf(world);
  const lgs_cell_rect first = rectOf(0, 0, 31, 31);
  lgs_changes changes;
  lgs_error error;
  lgs_spot spot;
  lgs_cell cell = {7, 7};
  lgs_point inside = {LGS_UNITS_PER_CELL * 31 + 1, 1};
  shelf kept;
  uint64_t count = 7;
  int32_t found = 7;
  const lgs_polygon_id polygon = placed(world, cellAt(31, 0), square, 1);
  placed(world, cellAt(32, 0), square, 1);
  CHECK(lgs_commit(world, &changes) == LGS_OK && changes.added_count == 6);
  CHECK(lgs_unload(world, first, keep, &kept, &count, NULL) == LGS_OK && count == 1);
  CHECK(kept.corner.i == 0 && kept.corner.j == 0);
  CHECK(lgs_commit(world, &changes) == LGS_OK && changes.removed_count == 3);
  CHECK(changes.added_count == 0 && changes.relinked_count == 0);
  REFUSED(LGS_UNLOADED, lgs_remove(world, polygon, &error));
  CHECK(error.cell.i == 31 && error.cell.j == 0);
  CHECK(lgs_at(world, inside, &spot) == LGS_OK && spot.where == LGS_UNKNOWN && spot.cell.i == 31);
  CHECK(lgs_first_unloaded(world, rectOf(5, 5, 40, 40), &found, &cell) == LGS_OK && found == 1);
  CHECK(cell.i == 5 && cell.j == 5);
  CHECK(lgs_first_unloaded(world, rectOf(32, 0, 40, 40), &found, NULL) == LGS_OK && found == 0);
  CHECK(lgs_first_unloaded(world, first, NULL, NULL) == LGS_OK);
  REFUSED(LGS_SAVE_CUT, lgs_reload(world, kept.bytes, 0, &cell, &error));
  CHECK(lgs_reload(world, kept.bytes, kept.count, &cell, NULL) == LGS_OK && cell.i == 0 && cell.j == 0);
  REFUSED(LGS_SAVE_LOADED, lgs_reload(world, kept.bytes, kept.count, &cell, &error));
  CHECK(lgs_commit(world, &changes) == LGS_OK && changes.added_count == 3);
  CHECK(lgs_remove(world, polygon, NULL) == LGS_OK);
  CHECK(lgs_unload(world, first, NULL, NULL, NULL, NULL) == LGS_OK && lgs_commit(world, NULL) == LGS_OK);
  REFUSED(LGS_SAVE_OTHER_BYTES, lgs_reload(world, kept.bytes, kept.count, NULL, &error));
  CHECK(lgs_reload_empty(world, first, &count, NULL) == LGS_OK && count == 1);
  REFUSED(LGS_STALE_HANDLE, lgs_remove(world, polygon, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_unload(NULL, first, keep, &kept, &count, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_reload(NULL, kept.bytes, kept.count, &cell, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_reload(world, NULL, kept.count, &cell, &error));
  REFUSED(LGS_BAD_ARGUMENT, lgs_reload_empty(NULL, first, &count, &error));
  CHECK(lgs_first_unloaded(NULL, first, &found, &cell) == LGS_BAD_ARGUMENT);
  lgs_free(world);
}

static void integers(void) {
  lgs_polygon_id polygon = {0x12345678, 0x9abcdef0};
  lgs_shape_id shape = {7};
  lgs_segment_id segment = {8};
  lgs_mark mark = {UINT64_C(1) << 40};
  CHECK(lgs_store_polygon(polygon) == UINT64_C(0x123456789abcdef0));
  CHECK(samePolygon(lgs_load_polygon(lgs_store_polygon(polygon)), polygon));
  CHECK(lgs_load_shape(lgs_store_shape(shape)).value == 7);
  CHECK(lgs_load_segment(lgs_store_segment(segment)).value == 8);
  CHECK(lgs_load_mark(lgs_store_mark(mark)).value == mark.value);
  CHECK(lgs_load_polygon(0).cell_ref == 0 && lgs_load_polygon(0).serial == 0);
  CHECK(lgs_version() == LGS_EXPECTED_VERSION);
}

/* From each first status to the last of its kind: no number between them is without a sentence, and none is beside. */
static void statuses(void) {
  static const lgs_status ranges[][2] = {
      {LGS_OK, LGS_ANCHORED}, {LGS_BAD_ARGUMENT, LGS_SHORT_BUFFER}, {LGS_SAVE_NO_SNAPSHOT, LGS_SAVE_OTHER_BYTES}};
  static const lgs_status none[] = {-1, 20, 99, 102, 199, 212, INT32_MAX, INT32_MIN};
  static char texts[34][400];
  lgs_status all[34], status;
  lgs_error error;
  char text[200] = "";
  size_t count = 0, a, b;
  for (a = 0; a < 3; ++a)
    for (status = ranges[a][0]; status <= ranges[a][1]; ++status) all[count++] = status;
  CHECK(count == 34);
  for (a = 0; a < count; ++a) {
    memset(&error, 0, sizeof error);
    error.code = all[a];
    error.polygon = error.polygon2 = error.vertex = error.vertex2 = error.index = -1;
    CHECK(lgs_message(&error, texts[a], sizeof texts[a], NULL) == LGS_OK);
    CHECK(strcmp(texts[a], "unknown error") != 0 && strcmp(lgs_status_name(all[a]), "unknown error") != 0);
    for (b = 0; b < a; ++b) {
      CHECK(strcmp(texts[a], texts[b]) != 0);
      CHECK(strcmp(lgs_status_name(all[a]), lgs_status_name(all[b])) != 0);
    }
  }
  for (a = 0; a < sizeof none / sizeof none[0]; ++a) {
    error.code = none[a];
    CHECK(strcmp(lgs_status_name(none[a]), "unknown error") == 0);
    CHECK(lgs_message(&error, text, sizeof text, NULL) == LGS_OK && strcmp(text, "unknown error") == 0);
  }
}

/* Each number of an error has its place in the sentence. */
static void numbers(void) {
  lgs_error error;
  char text[200] = "";
  memset(&error, 0, sizeof error);
  error.code = LGS_SAVE_UNKNOWN_VERSION;
  error.index = 71;
  error.index2 = 5;
  CHECK(lgs_message(&error, text, sizeof text, NULL) == LGS_OK);
  CHECK(strstr(text, "has version 71 of its format") && strstr(text, "from 1 to 5"));
  REFUSED(LGS_BAD_ARGUMENT, lgs_forget_chunks(NULL, rectOf(0, 0, 0, 0), NULL, &error)); /* it has no numbers */
  CHECK(error.polygon == -1 && error.index == -1 && error.other_block == 0 && error.cell.i == INT32_MIN);
}

static void sentences(void) {
  lgs_world* world = newWorld();
  lgs_error error;
  char text[200] = "";
  char small[8] = "xxxxxxx";
  size_t count = 0;
  placed(world, cellAt(3, -4), squareOf(world), 7);
  REFUSED(LGS_OVERLAP, lgs_add_points(world, cellAt(3, -4), kRamp, 3, 1, NULL, &error));
  CHECK(lgs_message(&error, text, sizeof text, &count) == LGS_OK && count == strlen(text));
  CHECK(strstr(text, "cell (3, -4), polygon 0: its interior overlaps that of a polygon of block 7 ") == text);
  CHECK(lgs_message(&error, small, 5, &count) == LGS_SHORT_BUFFER && count == strlen(text));
  CHECK(memcmp(small, "cell\0xx", 8) == 0);
  CHECK(lgs_message(&error, text, count, NULL) == LGS_SHORT_BUFFER);
  CHECK(lgs_message(&error, NULL, 0, &count) == LGS_SHORT_BUFFER && count == strlen(text) + 1);
  CHECK(lgs_message(&error, NULL, 1, NULL) == LGS_BAD_ARGUMENT);
  CHECK(lgs_message(NULL, text, sizeof text, NULL) == LGS_BAD_ARGUMENT);
  lgs_free(world);
}

int main(void) {
  options();
  copies();
  commits();
  groups();
  copiesOfGroups();
  goingBack();
  places();
  unloading();
  integers();
  statuses();
  numbers();
  sentences();
  return 0;
}
