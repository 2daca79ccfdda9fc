/* Views of a world, in C99 and C++: loops and islands, bodies, convex pieces, hashes of the ground. What C++ calls
 * Islands, Body, Pieces and GroundHashes is lgs_islands, lgs_body, lgs_pieces and lgs_hashes here; the words are those
 * of docs/islands.md, docs/pieces.md and docs/sync.md. The rules of lgs/lgs.h hold: results, arguments, buffers,
 * errors, threads.
 *
 *   lgs_islands* islands;
 *   lgs_changes changes;
 *   lgs_island_id loose[16];
 *   size_t count;
 *   lgs_follow_cells(world, 1, NULL);
 *   lgs_islands_new(world, is_bedrock, NULL, &islands);          looks at everything once
 *   lgs_commit(world, &changes);
 *   lgs_islands_update(islands, world, &changes);                after each commit and roll-back
 *   lgs_islands_ids(islands, LGS_LOOSE, loose, 16, &count);      what nothing holds any more
 *   lgs_take(world, islands, loose[0], &body, NULL);             it is a body now
 *   lgs_islands_free(islands);
 *
 * A view is yours: what ends in _new(), _copy(), and lgs_take(), lgs_take_apart(), lgs_foresee() give is given back by
 * the _free() of its type. It does not keep its world, which is handed in again. It must be the same one, or a copy that
 * has gone the same way: this is not checked. */
#ifndef LGS_LGS_VIEWS_H
#define LGS_LGS_VIEWS_H

/* NOLINTBEGIN(modernize-use-using): it is C */

#include <lgs/lgs.h>

#ifdef __cplusplus
extern "C" {
#endif

/* --- Loops and islands ------------------------------------------------------------------------------------------- */

/* A loop. A name of the moment: after a roll-back the same loop may have another one. */
typedef struct lgs_loop_id {
  uint32_t value; /* good as an index; 0 is null */
} lgs_loop_id;
/* An island. The same holds for it. */
typedef struct lgs_island_id {
  uint32_t value; /* good as an index; 0 is null */
} lgs_island_id;

/* What is known of a loop. Twice its signed area in square lattice units is high * 2^64 + low, exactly: less than 0 for
 * a hole. */
typedef struct lgs_loop_facts {
  int64_t double_area_high; /* the upper half, with the sign */
  uint64_t double_area_low; /* the lower half */
  double area;              /* signed, in cells, rounded once */
  lgs_point min;            /* the lower-left corner of its box */
  lgs_point max;            /* the upper-right corner of its box */
  lgs_point west;           /* its westernmost vertex; of several the southernmost */
  lgs_loop_id id;           /* its name */
  lgs_segment_id first;     /* a segment that starts at `west` */
  uint32_t segments;        /* how many it has */
  uint32_t reserved;        /* 0 */
} lgs_loop_facts;

/* What is known of an island. */
typedef struct lgs_island {
  lgs_loop_facts outer; /* its outer loop; the area is with all holes */
  uint64_t anchors;     /* how many of its polygons are anchors */
  lgs_island_id id;     /* its name */
  uint32_t reserved;    /* 0 */
} lgs_island;

/* An island of before, and one of now. */
typedef struct lgs_island_pair {
  lgs_island_id from; /* of before */
  lgs_island_id into; /* of now */
} lgs_island_pair;
/* A loop of before, and one of now. */
typedef struct lgs_loop_pair {
  lgs_loop_id from; /* of before */
  lgs_loop_id into; /* of now */
} lgs_loop_pair;

/* Lists of ids: all that there are, and what the last update did. LGS_LOOSE are the islands of now that it names and
 * that nothing holds; of loops there are none. */
enum { LGS_ALL = 0, LGS_ADDED = 1, LGS_REMOVED = 2, LGS_CHANGED = 3, LGS_LOOSE = 4 };
/* Lists of pairs. LGS_PARTED: `into` is a new id, of what was cut off (islands) or split (loops). LGS_JOINED: `from` is
 * an id that is no more. */
enum { LGS_PARTED = 0, LGS_JOINED = 1 };

/* Whether a polygon of this block in this cell holds its island: 0 or not. It must give the same answer every time. */
typedef int32_t (*lgs_anchor_fn)(void* user, lgs_block block, lgs_cell cell);

/* The loops and islands of a world. */
typedef struct lgs_islands lgs_islands;

/* Looks at all polygons of a world that has no edits that are not committed. If it has some, what the view returns may
 * be wrong, and nothing worse. `is_anchor` may be NULL: then nothing is an anchor; else it is kept, with its `user`,
 * for as long as the view and its copies live. Cost: in proportion to the world. */
LGS_API lgs_status lgs_islands_new(const lgs_world* world, lgs_anchor_fn is_anchor, void* user,
                                   lgs_islands** islands) LGS_NOTHROW;
/* The same, but unloaded ground counts as empty: an island ends at the edge of memory, and only anchors in memory hold
 * it. It keeps a second world. */
LGS_API lgs_status lgs_islands_new_open(const lgs_world* world, lgs_anchor_fn is_anchor, void* user,
                                        lgs_islands** islands) LGS_NOTHROW;
LGS_API lgs_status lgs_islands_copy(const lgs_islands* islands, lgs_islands** copy) LGS_NOTHROW;
LGS_API void lgs_islands_free(lgs_islands* islands) LGS_NOTHROW;

/* Takes over what the last commit or roll-back changed. The world must follow its cells. Refused, and nothing changes:
 * LGS_BAD_ARGUMENT, if these changes do not lead from what the view shows to what the world shows: then make a new
 * view; and if the world does not follow its cells: then call lgs_follow_cells() and make a new view. If the world has
 * edits that are not committed, what the view returns of islands may be wrong from then on, and nothing worse. Cost:
 * docs/islands.md. */
LGS_API lgs_status lgs_islands_update(lgs_islands* islands, const lgs_world* world,
                                      const lgs_changes* changes) LGS_NOTHROW;

/* As a list, by id. Cost: LGS_ALL in proportion to the ids, the others to what the update changed. */
LGS_API lgs_status lgs_islands_ids(const lgs_islands* islands, int32_t which, lgs_island_id* out, size_t capacity,
                                   size_t* count) LGS_NOTHROW;
LGS_API lgs_status lgs_islands_loop_ids(const lgs_islands* islands, int32_t which, lgs_loop_id* out, size_t capacity,
                                        size_t* count) LGS_NOTHROW;
/* As a list. */
LGS_API lgs_status lgs_islands_pairs(const lgs_islands* islands, int32_t which, lgs_island_pair* out, size_t capacity,
                                     size_t* count) LGS_NOTHROW;
LGS_API lgs_status lgs_islands_loop_pairs(const lgs_islands* islands, int32_t which, lgs_loop_pair* out,
                                          size_t capacity, size_t* count) LGS_NOTHROW;

/* What is known. Refused: LGS_STALE_HANDLE, if the id names none. */
LGS_API lgs_status lgs_islands_get(const lgs_islands* islands, lgs_island_id id, lgs_island* island) LGS_NOTHROW;
LGS_API lgs_status lgs_islands_loop(const lgs_islands* islands, lgs_loop_id id, lgs_loop_facts* loop) LGS_NOTHROW;

/* The island that a polygon is of, and the loop that a segment is on; null, if there is none. Of a polygon that was
 * placed since the last update it may be any island, or null. Under a preserve relation no segment of the world is on a
 * loop. */
LGS_API lgs_status lgs_islands_of(const lgs_islands* islands, const lgs_world* world, lgs_polygon_id polygon,
                                  lgs_island_id* island) LGS_NOTHROW;
LGS_API lgs_status lgs_islands_loop_of(const lgs_islands* islands, const lgs_world* world, lgs_segment_id segment,
                                       lgs_loop_id* loop) LGS_NOTHROW;

/* --- Bodies ------------------------------------------------------------------------------------------------------ */

/* An island that has left the ground. */
typedef struct lgs_body lgs_body;

/* What is known of it, where each square unit weighs one. */
typedef struct lgs_body_facts {
  double area;               /* in square cells */
  lgs_double_point centroid; /* in cells, from the lower-left corner of the origin */
  double second_moment;      /* about the centroid, in cells to the power of 4: times density it is inertia */
  lgs_cell_rect cells;       /* its box, in the world */
  lgs_cell origin;           /* where it was: the lower-left cell of that */
  size_t polygons;           /* how many it has */
} lgs_body_facts;

/* A polygon of a body. The vertices live as long as the body. */
typedef struct lgs_body_polygon {
  const lgs_local_point* vertices; /* in its cell */
  size_t count;                    /* how many */
  lgs_cell cell;                   /* counted from the body's origin */
  lgs_block block;                 /* as it was in the ground */
  uint32_t reserved;               /* 0 */
} lgs_body_polygon;

/* Takes an island out of the ground: one edit. Refused: LGS_STALE_HANDLE, if the id names no island, or its polygons
 * are gone. Cost: in proportion to the island. */
LGS_API lgs_status lgs_take(lgs_world* world, const lgs_islands* islands, lgs_island_id island, lgs_body** body,
                            lgs_error* error) LGS_NOTHROW;
/* The same with solids apart that touch in points only: a body for each part whose polygons share more than points. All
 * of them leave the ground. `count` receives how many there are. Refused also: LGS_SHORT_BUFFER, if that is more than
 * `capacity`; then nothing changes. */
LGS_API lgs_status lgs_take_apart(lgs_world* world, const lgs_islands* islands, lgs_island_id island, lgs_body** bodies,
                                  size_t capacity, size_t* count, lgs_error* error) LGS_NOTHROW;
/* Sets a body into the ground, so that its origin is this cell: one edit, or nothing. `polygons` receives the ids of its
 * polygons, in their order, or as many as it has room for. Refused: as by lgs_add_points(), for the first polygon that
 * does not fit; `index` names which. The body stays as it is. */
LGS_API lgs_status lgs_put(lgs_world* world, const lgs_body* body, lgs_cell cell, lgs_polygon_id* polygons,
                           size_t capacity, lgs_error* error) LGS_NOTHROW;
LGS_API lgs_status lgs_body_get(const lgs_body* body, lgs_body_facts* facts) LGS_NOTHROW;
/* Refused: LGS_BAD_ARGUMENT, if there is no polygon of this index. */
LGS_API lgs_status lgs_body_polygon_at(const lgs_body* body, size_t index, lgs_body_polygon* polygon) LGS_NOTHROW;
LGS_API void lgs_body_free(lgs_body* body) LGS_NOTHROW;

/* --- What an edit would do --------------------------------------------------------------------------------------- */

/* What an edit would do to the islands. Its ids name nothing in the view. */
typedef struct lgs_foreseen lgs_foreseen;

/* An edit that is tried: 0, if it was refused. It may change the world, but not commit, roll back or make marks. */
typedef int32_t (*lgs_edit_fn)(void* user, lgs_world* world);

/* Makes an edit, looks, and takes it back: world and view are as before, but for which ids come next, and the redo is
 * over, as after any edit. An edit that is refused would do nothing. No edit may be pending: else what is foreseen may
 * be wrong, and nothing worse. Cost: that of the edit, of two updates and of a roll-back. */
LGS_API lgs_status lgs_foresee(lgs_world* world, lgs_islands* islands, lgs_edit_fn edit, void* user,
                               lgs_foreseen** foreseen) LGS_NOTHROW;
LGS_API void lgs_foreseen_free(lgs_foreseen* foreseen) LGS_NOTHROW;
/* As a list, by id: the islands that there would be and that are named by another list (LGS_ALL), of these what nothing
 * would hold (LGS_LOOSE), and what would be added, removed and changed. */
LGS_API lgs_status lgs_foreseen_ids(const lgs_foreseen* foreseen, int32_t which, lgs_island_id* out, size_t capacity,
                                    size_t* count) LGS_NOTHROW;
/* As a list: LGS_PARTED or LGS_JOINED. */
LGS_API lgs_status lgs_foreseen_pairs(const lgs_foreseen* foreseen, int32_t which, lgs_island_pair* out,
                                      size_t capacity, size_t* count) LGS_NOTHROW;
/* What an island of LGS_ALL would be. Refused: LGS_STALE_HANDLE, if the id is not there. */
LGS_API lgs_status lgs_foreseen_get(const lgs_foreseen* foreseen, lgs_island_id id, lgs_island* island) LGS_NOTHROW;

/* --- Convex pieces ----------------------------------------------------------------------------------------------- */

/* The convex pieces of a world. */
typedef struct lgs_pieces lgs_pieces;

/* What pieces are of: what polygons cover, or what they leave. */
enum { LGS_SOLID = 0, LGS_FREE = 1 };

/* A portal of a free piece: what it and another one have in common. */
typedef struct lgs_portal {
  lgs_cell cell;     /* that of the piece to which it leads */
  uint32_t index;    /* of that piece among the free ones of its cell */
  uint32_t reserved; /* 0 */
  lgs_point right;   /* the end on the right when passing */
  lgs_point left;    /* the end on the left */
} lgs_portal;

/* Reads all polygons. Refused: LGS_BAD_ARGUMENT, if `max_vertices` is less than 3 or more than a cell may have. */
LGS_API lgs_status lgs_pieces_new(const lgs_world* world, size_t max_vertices, lgs_pieces** pieces) LGS_NOTHROW;
LGS_API lgs_status lgs_pieces_copy(const lgs_pieces* pieces, lgs_pieces** copy) LGS_NOTHROW;
LGS_API void lgs_pieces_free(lgs_pieces* pieces) LGS_NOTHROW;

/* Takes over what the last commit or roll-back changed. Reports which cells have other pieces now; the list stays until
 * the next update. Refused, and nothing changes: LGS_BAD_ARGUMENT, as by lgs_islands_update(). */
LGS_API lgs_status lgs_pieces_update(lgs_pieces* pieces, const lgs_world* world, const lgs_changes* changes,
                                     const lgs_cell** cells, size_t* count) LGS_NOTHROW;

/* How many pieces a cell has: LGS_SOLID or LGS_FREE. */
LGS_API lgs_status lgs_pieces_count(const lgs_pieces* pieces, lgs_cell cell, int32_t part, size_t* count) LGS_NOTHROW;
/* One of them: its vertices as a list, counter-clockwise from the least one, and of a solid piece the polygon that it
 * is of; of a free one null. Refused: LGS_BAD_ARGUMENT, if there is none of this index. Cost: of a solid one O(n log n)
 * for the n vertices of the cell, unless `polygon` is NULL. */
LGS_API lgs_status lgs_pieces_get(const lgs_pieces* pieces, const lgs_world* world, lgs_cell cell, int32_t part,
                                  size_t index, lgs_local_point* vertices, size_t capacity, size_t* count,
                                  lgs_polygon_id* polygon) LGS_NOTHROW;
/* The portals of a free piece, as a list. A piece that is not there has none. */
LGS_API lgs_status lgs_pieces_portals(const lgs_pieces* pieces, lgs_cell cell, uint32_t index, lgs_portal* out,
                                      size_t capacity, size_t* count) LGS_NOTHROW;

/* --- Hashes of the ground ---------------------------------------------------------------------------------------- */

/* The hashes of a world. */
typedef struct lgs_hashes lgs_hashes;

/* A square of cells, and the hash of what is in it: docs/sync.md. */
typedef struct lgs_hashed_square {
  uint64_t hash;       /* 0: nothing is in it */
  lgs_cell_rect cells; /* its cells, as far as they are in range */
  int32_t level;       /* 0: a chunk of 32×32 cells; each level has squares of 4×4 of the one below; up to 14 */
  uint32_t reserved;   /* 0 */
} lgs_hashed_square;

/* Reads all polygons of a world that has no edits that are not committed. Cost: in proportion to the world. */
LGS_API lgs_status lgs_hashes_new(const lgs_world* world, lgs_hashes** hashes) LGS_NOTHROW;
LGS_API lgs_status lgs_hashes_copy(const lgs_hashes* hashes, lgs_hashes** copy) LGS_NOTHROW;
LGS_API void lgs_hashes_free(lgs_hashes* hashes) LGS_NOTHROW;

/* Takes over what the last commit or roll-back changed. Refused, and nothing changes: LGS_BAD_ARGUMENT, as by
 * lgs_islands_update(). Cost: in proportion to what is in the changed cells. */
LGS_API lgs_status lgs_hashes_update(lgs_hashes* hashes, const lgs_world* world,
                                     const lgs_changes* changes) LGS_NOTHROW;

/* The least square that all ground lies in: its hash is that of the world. Cost: O(1). */
LGS_API lgs_status lgs_hashes_whole(const lgs_hashes* hashes, lgs_hashed_square* square) LGS_NOTHROW;
/* As a list: the squares of a level that have a cell of a rectangle, and whose hash is not 0. */
LGS_API lgs_status lgs_hashes_in(const lgs_hashes* hashes, lgs_cell_rect cells, int32_t level, lgs_hashed_square* out,
                                 size_t capacity, size_t* count) LGS_NOTHROW;
/* As a list: the cells of the chunks whose ground differs. Cost: in proportion to these. */
LGS_API lgs_status lgs_hashes_differences(const lgs_hashes* a, const lgs_hashes* b, lgs_cell_rect* out, size_t capacity,
                                          size_t* count) LGS_NOTHROW;

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-use-using) */

#endif
