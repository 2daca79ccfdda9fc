/* An engine as a shared object, for `lgs check --engine-so FILE.so`: the protocol of `lgs check --engine`, by calls
 * instead of lines. C99 and C++.
 *
 * The shared object exports one function, lgs_engine(), which returns a table of functions. A world's edits go in; at a
 * commit the engine reports which edits it refused, and puts out the whole outline, or what changed.
 *
 * Rules. The harness calls from one thread. What it passes belongs to it, and is valid during the call; what the engine
 * passes to an answer is read during that call. No exception may leave a function. Coordinates are lattice units,
 * 65,536 a cell: those of polygons from their cell's lower-left corner, those of segments in the world. */
#ifndef LGS_ENGINE_H
#define LGS_ENGINE_H

/* NOLINTBEGIN(modernize-use-using): it is C */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of this table. */
#define LGS_ENGINE_VERSION 1

/* Lets the harness find the function. */
#if defined(_WIN32)
#define LGS_ENGINE_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define LGS_ENGINE_EXPORT __attribute__((visibility("default")))
#else
#define LGS_ENGINE_EXPORT
#endif

/* The solid is on the left of start to end. ghost1 is the start of the segment before, ghost2 the end of the one after
 * it; a missing ghost has its bit of `missing` set: 1 for ghost1, 2 for ghost2. */
typedef struct lgs_engine_segment {
  int64_t start[2], end[2], ghost1[2], ghost2[2]; /* x, y */
  uint32_t block;                                 /* of the polygon */
  uint32_t missing;                               /* bits */
} lgs_engine_segment;

/* Where the answer to a commit goes. First `to`, then:
 *   refused   an edit since the last commit, by its name, and why; in the order of the edits
 *   segments  some segments, `count` of them; in any order, in any number of calls
 *   changed   of an engine that declares `delta`, in the place of `segments`: '-' and the id of a segment that is gone,
 *             '+' and one that is new, '~' and one that is another one now; `segment` is null with '-' */
typedef struct lgs_engine_answer {
  void* to;                                                                     /* comes first in each call */
  void (*refused)(void* to, const char* name, const char* reason);              /* an edit */
  void (*segments)(void* to, const lgs_engine_segment* segments, size_t count); /* some of them */
  void (*changed)(void* to, char sign, uint64_t id, const lgs_engine_segment* segment);
} lgs_engine_answer;

/* What an engine is. `self` is what create() has returned; null there means that it failed. */
typedef struct lgs_engine_table {
  uint32_t version;            /* LGS_ENGINE_VERSION */
  const char* name;            /* one word */
  const char* capabilities;    /* words, parted by single spaces: "ghosts blocks several slants preserve refuses" */
  void* (*create)(void);       /* an engine with an empty world */
  void (*destroy)(void* self); /* frees it */
  void (*reset)(void* self);   /* a new, empty world */
  void (*preserve)(void* self, uint32_t b1, uint32_t b2); /* only right after reset() */
  /* A polygon of so many vertices, with their x and y one after the other, into the cell (i, j). */
  void (*add)(void* self, const char* name, int32_t i, int32_t j, uint32_t block, const int32_t* xy, size_t vertices);
  void (*remove)(void* self, const char* name);                /* a polygon */
  void (*commit)(void* self, const lgs_engine_answer* answer); /* answers with the whole outline, or what changed */
} lgs_engine_table;

/* What the shared object exports. The table stays valid as long as it is loaded. */
LGS_ENGINE_EXPORT const lgs_engine_table* lgs_engine(void);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-use-using) */

#endif
