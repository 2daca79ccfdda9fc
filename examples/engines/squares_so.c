/* An engine for `lgs check --engine-so` in C: whole squares, recomputed at each commit.
 *
 *     cc -shared -fPIC -I oracle/engine/include examples/engines/squares_so.c -o squares.so
 *     lgs check --engine-so squares.so --edits 2000 */
#include <lgs/lgs_engine.h>

#include <stdlib.h>
#include <string.h>

typedef struct square { /* of a list; the engine itself is a pointer to the first */
  struct square* next;
  int64_t i, j;
  uint32_t block;
  char name[];
} square;

static void* create(void) { return calloc(1, sizeof(square*)); }

static void reset(void* self) {
  for (square **first = self, *gone; (gone = *first) != NULL; free(gone)) *first = gone->next;
}
static void destroy(void* self) { reset(self), free(self); }
static void preserve(void* self, uint32_t b1, uint32_t b2) { (void)self, (void)b1, (void)b2; }

static void add(void* self, const char* name, int32_t i, int32_t j, uint32_t block, const int32_t* xy, size_t count) {
  square **first = self, *s = malloc(sizeof *s + strlen(name) + 1);
  if (s == NULL) abort();
  s->next = *first, s->i = i, s->j = j, s->block = block;
  strcpy(s->name, name);
  *first = s;
  (void)xy, (void)count; /* it is the whole square */
}

static void removeNamed(void* self, const char* name) {
  square **at = self, *gone;
  while (gone = *at, strcmp(gone->name, name) != 0) at = &gone->next;
  *at = gone->next;
  free(gone);
}

static void commit(void* self, const lgs_engine_answer* answer) {
  static const int64_t kUnits = 65536, kWay[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const square *const all = *(square**)self, *beyond;
  for (const square* s = all; s != NULL; s = s->next) {
    lgs_engine_segment side = {.end = {s->i * kUnits, s->j * kUnits}, .block = s->block, .missing = 3};
    for (int k = 0; k < 4; ++k) { /* counter-clockwise, so the cell beyond is on the right */
      const int64_t dx = kWay[k][0], dy = kWay[k][1];
      memcpy(side.start, side.end, sizeof side.start);
      side.end[0] += dx * kUnits, side.end[1] += dy * kUnits;
      for (beyond = all; beyond && (beyond->i != s->i + dy || beyond->j != s->j - dx);) beyond = beyond->next;
      if (beyond == NULL) answer->segments(answer->to, &side, 1);
    }
  }
}

const lgs_engine_table* lgs_engine(void) {
  static const lgs_engine_table kTable = {LGS_ENGINE_VERSION, "squares.c", "squares blocks", create, destroy, reset,
                                          preserve,           add,         removeNamed,      commit};
  return &kTable;
}
