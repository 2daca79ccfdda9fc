/* Worlds: to make, copy, compare, save and load them. lgs/lgs.h has the rules. */
#ifndef LGS_C_WORLD_H
#define LGS_C_WORLD_H

/* NOLINTBEGIN(modernize-use-using): it is C */

#include <lgs/c/values.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A world of unit cells that hold polygons, unbounded. Chunks of 32x32 cells take memory once an edit reached them,
 * until lgs_forget_chunks() lets go of them. */
typedef struct lgs_world lgs_world;

/* Returns whether the overlap between polygons of these two blocks is kept (not 0) or cancelled (0). The smaller block
 * always comes first. It must give the same answer every time. A commit with an executor calls it from several threads
 * at the same time, and so do commits of copies: they share `user`, which must live as long as the last of them. */
typedef int32_t (*lgs_preserve_fn)(void* user, lgs_block smaller, lgs_block greater);

/* How to make a world: see lgs_new(). */
typedef struct lgs_world_options {
  uint32_t size;            /* of this struct in bytes */
  uint32_t reserved;        /* 0 */
  lgs_preserve_fn preserve; /* NULL: every overlap is cancelled. This is the default. */
  void* user;               /* handed to `preserve` */
} lgs_world_options;

/* Fills in what is the default. `size` is sizeof(lgs_world_options): no more is written than that. */
LGS_API void lgs_default_world_options(lgs_world_options* options, size_t size) LGS_NOTHROW;

/* Makes an empty world. `options` may be NULL for the default. Refused: LGS_BAD_ARGUMENT, if `world` is NULL, too. */
LGS_API lgs_status lgs_new(const lgs_world_options* options, lgs_world** world) LGS_NOTHROW;

/* NULL is no error. End every group before you free its world; lists of loops may outlive it. */
LGS_API void lgs_free(lgs_world* world) LGS_NOTHROW;

/* Makes a world with the same polygons, ids, shapes, segments, marks and edits that are not committed. From then on the
 * same edits give the same ids and lists in both. If a group is open the copy has the edits made so far, and no group.
 * Refused as by lgs_new(). Cost: in proportion to the world. */
LGS_API lgs_status lgs_copy(const lgs_world* world, lgs_world** copy) LGS_NOTHROW;

/* Writes whether two worlds hold the same polygons with the same blocks in the same cells (1 or 0), after all edits,
 * committed or not. It does not matter with which vertex a polygon begins, nor which ids, shapes, marks and relations
 * the worlds have. Cost: in proportion to the cells that have a chunk. */
LGS_API lgs_status lgs_same_polygons(const lgs_world* a, const lgs_world* b, int32_t* same) LGS_NOTHROW;

/* Writes 1 if the world's relation keeps the overlap between polygons of these two blocks, otherwise 0. It does not
 * matter which of them comes first. */
LGS_API lgs_status lgs_preserves(const lgs_world* world, lgs_block a, lgs_block b, int32_t* preserves) LGS_NOTHROW;

/* --- Saving ------------------------------------------------------------------------------------------------------ */

/* Takes the bytes of a saved world in order, in pieces of at most 4,096. It may read the world. */
typedef void (*lgs_write_fn)(void* user, const uint8_t* bytes, size_t count);

/* Writes the world as bytes: polygons, shapes, the ids of all. Marks are not written, nor is the preserve relation,
 * which is a function. docs/internals/snapshot.md has the format. Refused: LGS_UNCOMMITTED. Cost: in proportion to the
 * world. Full blocks take less than a byte for each cell, ramps some four. */
LGS_API lgs_status lgs_save(const lgs_world* world, lgs_write_fn write, void* user, lgs_error* error) LGS_NOTHROW;

/* The same into a buffer, as a list of bytes. Refused: LGS_UNCOMMITTED. */
LGS_API lgs_status lgs_save_to_buffer(const lgs_world* world, uint8_t* bytes, size_t capacity, size_t* count,
                                      lgs_error* error) LGS_NOTHROW;

/* Makes the world that was saved. It goes on exactly: the same edits give the same ids and lists as if it had never
 * been saved. It has no marks. `bytes` are what lgs_save() wrote and nothing more: a file with more in it stores how
 * long this part is. The options must have the relation that it was saved with; NULL if it had none. Refused:
 * LGS_SAVE_…, and the error has the offset of the byte. Bytes that are cut, damaged or made up are refused, and take no
 * more memory than a constant for each. Cost: in proportion to the world, and quadratic in the vertices of each content
 * of a cell, as lgs_shape() is. */
LGS_API lgs_status lgs_load(const uint8_t* bytes, size_t count, const lgs_world_options* options, lgs_world** world,
                            lgs_error* error) LGS_NOTHROW;

/* --- What there is ----------------------------------------------------------------------------------------------- */

/* How much there is in a world: see lgs_count(). */
typedef struct lgs_stats {
  uint64_t polygons;    /* placed ones */
  uint64_t cells;       /* cells that hold at least one polygon */
  uint64_t segments;    /* live ones, as of the last commit */
  uint64_t shapes;      /* made so far */
  uint64_t contents;    /* distinct contents of cells; those that no cell has are forgotten in time */
  uint64_t chunks;      /* of 32x32 cells, ever touched by an edit, and not forgotten */
  uint64_t bytes;       /* allocated, with spare capacity; an estimate for unloaded chunks */
  uint64_t reserved[5]; /* 0 */
} lgs_stats;

/* Cost: it looks at every cell of every chunk. */
LGS_API lgs_status lgs_count(const lgs_world* world, lgs_stats* stats) LGS_NOTHROW;

/* The version of the ground and its segments, as of the last commit. Each commit that finds an edit, or a chunk that
 * left memory or came back, makes a new one, also if no segment changes, and no world of this process ever makes the
 * same one. A copy has that of its original, until one of them changes. lgs_roll_back() brings back that of the mark,
 * unless chunks left or came back since. A loaded world has a new one. Versions mean nothing else: the same edits make
 * other ones in another run. */
LGS_API uint64_t lgs_world_version(const lgs_world* world) LGS_NOTHROW;

/* The highest segment id in use so far: an array for what you know of segments needs one place more. Only
 * lgs_roll_back() lowers it, and the `removed` that it writes then names higher ones. */
LGS_API uint32_t lgs_max_segment_id(const lgs_world* world) LGS_NOTHROW;

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-use-using) */

#endif
