/* An engine for `lgs check --engine-so` in C: whole squares, recomputed at each commit.
 *
 *     cc -shared -fPIC -I oracle/engine/include examples/engines/squares_so.c -o squares.so
 *     lgs check --engine-so squares.so --edits 2000 */
#include <lgs/lgs_engine.h>

#include <stdlib.h>
#include <string.h>

#define UNITS ((int64_t)65536) /* of the lattice, in a cell */

typedef struct square {
  char* name;
  int64_t i, j;
  uint32_t block;
} square;

typedef struct engine {
  square* squares;
  size_t count, room;
} engine;

static void* create(void) { return calloc(1, sizeof(engine)); }

static void reset(void* self) {
  engine* e = self;
  while (e->count > 0) free(e->squares[--e->count].name);
}

static void destroy(void* self) {
  reset(self);
  free(((engine*)self)->squares);
  free(self);
}

static void preserve(void* self, uint32_t b1, uint32_t b2) { (void)self, (void)b1, (void)b2; }

static void add(void* self, const char* name, int32_t i, int32_t j, uint32_t block, const int32_t* xy,
                size_t vertices) {
  engine* e = self;
  (void)xy, (void)vertices;
  if (e->count == e->room) {
    e->room = 2 * e->room + 1;
    e->squares = realloc(e->squares, e->room * sizeof *e->squares);
    if (e->squares == NULL) abort();
  }
  square* s = &e->squares[e->count++];
  s->name = malloc(strlen(name) + 1);
  if (s->name == NULL) abort();
  strcpy(s->name, name);
  s->i = i, s->j = j, s->block = block;
}

static void removeNamed(void* self, const char* name) {
  engine* e = self;
  size_t k = 0;
  while (strcmp(e->squares[k].name, name) != 0) ++k;
  free(e->squares[k].name);
  e->squares[k] = e->squares[--e->count];
}

static int isThere(const engine* e, int64_t i, int64_t j) {
  for (size_t k = 0; k < e->count; ++k)
    if (e->squares[k].i == i && e->squares[k].j == j) return 1;
  return 0;
}

static void commit(void* self, const lgs_engine_answer* answer) {
  static const int kCorners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}},
                   kBeyond[4][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  const engine* e = self;
  for (size_t k = 0; k < 4 * e->count; ++k) {
    const square* s = &e->squares[k / 4];
    const int *from = kCorners[k % 4], *to = kCorners[k % 4 + 1], *beyond = kBeyond[k % 4];
    if (isThere(e, s->i + beyond[0], s->j + beyond[1])) continue;
    const lgs_engine_segment segment = {{(s->i + from[0]) * UNITS, (s->j + from[1]) * UNITS},
                                        {(s->i + to[0]) * UNITS, (s->j + to[1]) * UNITS},
                                        {0, 0},
                                        {0, 0},
                                        s->block,
                                        3};
    answer->segments(answer->to, &segment, 1);
  }
}

const lgs_engine_table* lgs_engine(void) {
  static const lgs_engine_table kTable = {LGS_ENGINE_VERSION, "squares.c", "squares blocks", create, destroy, reset,
                                          preserve,           add,         removeNamed,      commit};
  return &kTable;
}
