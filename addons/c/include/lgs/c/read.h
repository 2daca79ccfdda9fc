/* Reading a world: segments, polygons, loops, and questions about places. Nothing here changes it. lgs/lgs.h has the
 * rules. */
#ifndef LGS_C_READ_H
#define LGS_C_READ_H

/* NOLINTBEGIN(modernize-use-using): it is C */

#include <lgs/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/* --- Segments, as of the last commit ----------------------------------------------------------------------------- */

/* One boundary segment. The solid is on the left of start to end, the outward normal on the right. ghost1 is the start
 * of the predecessor, ghost2 the end of the successor; each means nothing if that one is null, which happens only under
 * a preserve relation. With x = end.x - start.x and y = end.y - start.y its length in cells is hypot(x, y) / 65536, and
 * its normal of length 1 is (y / hypot(x, y), -x / hypot(x, y)). */
typedef struct lgs_segment {
  lgs_segment_id id;          /* its name, until a commit removes it */
  lgs_segment_id predecessor; /* the segment that leads to its start */
  lgs_segment_id successor;   /* the segment that goes on from its end */
  lgs_block block;            /* that of `polygon` */
  lgs_polygon_id polygon;     /* stale if it was removed since the last commit */
  lgs_cell cell;              /* that of `polygon` */
  lgs_point start;            /* where it starts */
  lgs_point end;              /* where it ends */
  lgs_point ghost1;           /* means nothing if `predecessor` is null */
  lgs_point ghost2;           /* means nothing if `successor` is null */
} lgs_segment;

/* The same in cells, from an origin of yours. */
typedef struct lgs_segment_float {
  lgs_segment_id id;          /* its name, until a commit removes it */
  lgs_segment_id predecessor; /* the segment that leads to its start */
  lgs_segment_id successor;   /* the segment that goes on from its end */
  lgs_block block;            /* that of `polygon` */
  lgs_polygon_id polygon;     /* stale if it was removed since the last commit */
  lgs_cell cell;              /* that of `polygon` */
  lgs_float_point start;      /* where it starts */
  lgs_float_point end;        /* where it ends */
  lgs_float_point ghost1;     /* means nothing if `predecessor` is null */
  lgs_float_point ghost2;     /* means nothing if `successor` is null */
} lgs_segment_float;

/* As lgs_segment_float, but double. */
typedef struct lgs_segment_double {
  lgs_segment_id id;          /* its name, until a commit removes it */
  lgs_segment_id predecessor; /* the segment that leads to its start */
  lgs_segment_id successor;   /* the segment that goes on from its end */
  lgs_block block;            /* that of `polygon` */
  lgs_polygon_id polygon;     /* stale if it was removed since the last commit */
  lgs_cell cell;              /* that of `polygon` */
  lgs_double_point start;     /* where it starts */
  lgs_double_point end;       /* where it ends */
  lgs_double_point ghost1;    /* means nothing if `predecessor` is null */
  lgs_double_point ghost2;    /* means nothing if `successor` is null */
} lgs_segment_double;

/* Many segments: segments[k] is that of ids[k]. In cells, the differences from the origin are exact before they are
 * rounded, and double is exact. Refused: LGS_UNKNOWN_SEGMENT, the error's `index` names which one, and what comes
 * before it was written; LGS_OUT_OF_REACH, if the origin is out of range; LGS_CAPACITY, if there are more than
 * LGS_MAX_ENTRIES. */
LGS_API lgs_status lgs_segments(const lgs_world* world, const lgs_segment_id* ids, size_t count, lgs_segment* segments,
                                lgs_error* error) LGS_NOTHROW;
LGS_API lgs_status lgs_segments_float(const lgs_world* world, const lgs_segment_id* ids, size_t count, lgs_point origin,
                                      lgs_segment_float* segments, lgs_error* error) LGS_NOTHROW;
LGS_API lgs_status lgs_segments_double(const lgs_world* world, const lgs_segment_id* ids, size_t count,
                                       lgs_point origin, lgs_segment_double* segments, lgs_error* error) LGS_NOTHROW;

/* The ids of all segments, as a list, in increasing order. Cost: in proportion to lgs_max_segment_id(). */
LGS_API lgs_status lgs_all_segments(const lgs_world* world, lgs_segment_id* ids, size_t capacity,
                                    size_t* count) LGS_NOTHROW;

/* Those of polygons in these cells, as a list, in no particular order. Cost: in proportion to the cells there that have
 * a chunk. */
LGS_API lgs_status lgs_segments_in(const lgs_world* world, lgs_cell_rect cells, lgs_segment_id* ids, size_t capacity,
                                   size_t* count) LGS_NOTHROW;

/* --- Polygons, after all edits, committed or not ----------------------------------------------------------------- */

/* A polygon as it stands in a cell. */
typedef struct lgs_polygon {
  lgs_polygon_id id; /* its name */
  lgs_cell cell;     /* where it is */
  lgs_block block;   /* the number that it was given */
  uint32_t vertices; /* how many it has */
} lgs_polygon;

/* The polygon of an id; its vertices, as a list. Refused: LGS_STALE_HANDLE. */
LGS_API lgs_status lgs_polygon_of(const lgs_world* world, lgs_polygon_id id, lgs_polygon* polygon,
                                  lgs_error* error) LGS_NOTHROW;
LGS_API lgs_status lgs_polygon_vertices(const lgs_world* world, lgs_polygon_id id, lgs_local_point* vertices,
                                        size_t capacity, size_t* count, lgs_error* error) LGS_NOTHROW;

/* The polygon that a segment belongs to: which tile was hit? Its block is that of the last commit. If it was removed
 * since then, `vertices` is 0. Refused: LGS_UNKNOWN_SEGMENT. */
LGS_API lgs_status lgs_owner(const lgs_world* world, lgs_segment_id segment, lgs_polygon* owner,
                             lgs_error* error) LGS_NOTHROW;

/* The polygons of a cell, as a list, by id. A cell out of range, or of an unloaded chunk, holds none. */
LGS_API lgs_status lgs_polygons_in(const lgs_world* world, lgs_cell cell, lgs_polygon* polygons, size_t capacity,
                                   size_t* count) LGS_NOTHROW;

/* Writes 1 if a cell holds no polygon that is in memory, otherwise 0: 1, too, in an unloaded chunk. */
LGS_API lgs_status lgs_is_empty(const lgs_world* world, lgs_cell cell, int32_t* is_empty) LGS_NOTHROW;

/* Gets a polygon; `vertices` has polygon->vertices points, and stays until it returns. It may read the world. */
typedef void (*lgs_polygon_fn)(void* user, const lgs_polygon* polygon, const lgs_local_point* vertices);

/* Calls visit() for every polygon in a rectangle of cells, those inside the ground too: chunk by chunk, in any order;
 * each by rows, each cell by id. Cost: in proportion to the cells there that have a chunk. */
LGS_API lgs_status lgs_visit_polygons(const lgs_world* world, lgs_cell_rect cells, lgs_polygon_fn visit,
                                      void* user) LGS_NOTHROW;

/* --- Which cells changed: for views of the ground, which need no segments ----------------------------------------- */

/* Whether lgs_visit_cell_changes() has something to report from now on (1) or not (0); a new world has not. A copy
 * follows as its original does, a loaded world follows nothing yet. Refused: LGS_UNCOMMITTED, while edits are not
 * committed or there are marks. While a world follows, edits cost what they cost while there is a mark; and a commit
 * reads the edited cells, in time and memory in proportion to their polygons and vertices, before and now. */
LGS_API lgs_status lgs_follow_cells(lgs_world* world, int32_t follow, lgs_error* error) LGS_NOTHROW;

/* A cell that a commit or a roll-back changed. The polygons are by id. Ids in `before` name nothing any more, if their
 * polygons are gone. */
typedef struct lgs_cell_change {
  lgs_cell cell;                   /* where */
  const lgs_polygon* before;       /* what it held as of the commit or roll-back before */
  const lgs_polygon* now;          /* what it holds as of this one */
  size_t before_count;             /* how many `before` has */
  size_t now_count;                /* how many `now` has */
  const lgs_local_point* vertices; /* of those in `before`, then of those in `now`, one after the other */
} lgs_cell_change;

/* Gets a cell that changed; all of it stays until it returns. It may read the world. */
typedef void (*lgs_cell_change_fn)(void* user, const lgs_cell_change* change);

/* Calls visit() for each cell that the last commit or roll-back changed, each once, in the order of their first change.
 * After a roll-back these are the cells edited, and committed, since the last commit before the mark; `now` is as of
 * that commit, and edits that were pending at the mark are reported by the next commit. A cell is named even if it
 * holds again what it held. None, if nothing is followed. To be called before the next edit. */
LGS_API lgs_status lgs_visit_cell_changes(const lgs_world* world, lgs_cell_change_fn visit, void* user) LGS_NOTHROW;

/* The least rectangle of cells with all polygons; an empty one, min (0, 0) and max (-1, -1), if there are none. Cost:
 * in proportion to the cells that have a chunk. */
LGS_API lgs_status lgs_bounds(const lgs_world* world, lgs_cell_rect* cells) LGS_NOTHROW;

/* --- Loops ------------------------------------------------------------------------------------------------------- */

/* What happens to a vertex where the outline goes straight on. LGS_MERGE drops it, but for a vertex that another
 * passage of the outline shares, of the same loop or of another one: two solids touch there. */
enum { LGS_KEEP = 0, LGS_MERGE = 1 };

/* Closed chains of segments, as they were when the list was made. */
typedef struct lgs_loops lgs_loops;

/* One of them, in the direction of its segments. The arrays live as long as the list. */
typedef struct lgs_loop {
  const lgs_point* vertices;      /* from the least one on, by x, then y; the last edge leads back to it */
  const lgs_segment_id* segments; /* segments[k] starts at vertices[k]; NULL if collinear ones were merged */
  size_t count;                   /* of the vertices */
} lgs_loop;

/* Makes the list of all closed chains, sorted by their vertices, as of the last commit. Under a preserve relation only
 * those whose links are all mutual. `collinear` is LGS_KEEP or LGS_MERGE. Cost: in proportion to the segments. */
LGS_API lgs_status lgs_loops_new(const lgs_world* world, int32_t collinear, lgs_loops** loops) LGS_NOTHROW;
LGS_API size_t lgs_loops_count(const lgs_loops* loops) LGS_NOTHROW;
/* Refused: LGS_BAD_ARGUMENT, if there is no loop of this index. */
LGS_API lgs_status lgs_loops_get(const lgs_loops* loops, size_t index, lgs_loop* loop) LGS_NOTHROW;
LGS_API void lgs_loops_free(lgs_loops* loops) LGS_NOTHROW;

/* --- Questions about places -------------------------------------------------------------------------------------- */

/* All comparisons are exact. Only what is handed out as double is rounded, at the very end. */

enum {
  LGS_OUTSIDE = 0, /* no polygon */
  LGS_EDGE = 1,    /* on the outline of a polygon, or of several */
  LGS_INSIDE = 2,  /* in the interior of one polygon */
  LGS_UNKNOWN = 3  /* one of the cells that the point is in is unloaded; it is `cell` */
};

/* What lies at a point: see lgs_at(). */
typedef struct lgs_spot {
  int32_t where;          /* one of the constants above */
  lgs_polygon_id polygon; /* null outside; on an edge the first that has it, by cell (j, then i) and id */
  lgs_block block;        /* of that polygon */
  lgs_cell cell;          /* of that polygon; outside the cell of the point */
} lgs_spot;

/* Which polygon is at a point, after all edits, committed or not. A point out of range is outside. Cost: in proportion
 * to the vertices in the cell; on a common side in both cells, in a corner in all four. */
LGS_API lgs_status lgs_at(const lgs_world* world, lgs_point point, lgs_spot* spot) LGS_NOTHROW;

/* The segment nearest to a point: see lgs_nearest(). */
typedef struct lgs_nearest_segment {
  lgs_segment_id segment; /* null: no segment within the radius */
  uint32_t reserved;      /* 0 */
  lgs_double_point point; /* the nearest point of that segment, in cells */
  double distance;        /* to it, in cells */
} lgs_nearest_segment;

/* The segment nearest to a point, as of the last commit, at most `radius` cells away, rounded to the lattice. Of
 * several at the same distance the least by start, end and block. Refused: LGS_OUT_OF_REACH, if the point is out of
 * range or the radius is not from 0 to LGS_MAX_RADIUS. Cost: in proportion to the cells with a chunk within twice the
 * distance found, or within the radius. */
LGS_API lgs_status lgs_nearest(const lgs_world* world, lgs_point point, double radius, lgs_nearest_segment* nearest,
                               lgs_error* error) LGS_NOTHROW;

/* What a ray meets first: see lgs_ray_cast(). */
typedef struct lgs_ray_hit {
  lgs_segment_id segment;  /* null: nothing was hit */
  uint32_t reserved;       /* 0 */
  double fraction;         /* of the way from the start to the end of the ray; 1 if nothing was hit */
  lgs_double_point point;  /* where, in cells */
  lgs_double_point normal; /* outward unit normal of the segment */
} lgs_ray_hit;

/* The first segment that a ray meets on its outward side, as of the last commit. A ray that starts in a solid leaves it
 * without a hit; one that runs along a segment does not hit it. The ends of a segment count. Of several at the same
 * place the least by start, end and block. Refused: LGS_OUT_OF_REACH, if an end is out of range or the ray is longer
 * than LGS_MAX_RAY cells on an axis. Cost: in proportion to the cells that the ray touches, up to the hit. */
LGS_API lgs_status lgs_ray_cast(const lgs_world* world, lgs_point from, lgs_point to, lgs_ray_hit* hit,
                                lgs_error* error) LGS_NOTHROW;

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-use-using) */

#endif
