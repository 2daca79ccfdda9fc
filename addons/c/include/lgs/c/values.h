/* The values of the C interface. Each is plain data of fixed size; lgs/lgs.h has the rules. */
#ifndef LGS_C_VALUES_H
#define LGS_C_VALUES_H

/* NOLINTBEGIN(modernize-use-using): it is C */

#include <stddef.h>
#include <stdint.h>

/* Before <lgs/lgs.h>: LGS_STATIC says that the static library is linked. It matters on Windows alone. */
#if defined(_WIN32) && !defined(LGS_STATIC)
#ifdef LGS_BUILDS_SHARED
#define LGS_API __declspec(dllexport)
#else
#define LGS_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define LGS_API __attribute__((visibility("default")))
#else
#define LGS_API
#endif

/* No function throws. */
#ifdef __cplusplus
#define LGS_NOTHROW noexcept
extern "C" {
#else
#define LGS_NOTHROW
#endif

/* Of this header. lgs_version() has that of the library. */
#define LGS_VERSION_MAJOR 0
#define LGS_VERSION_MINOR 3 /* of this header */
#define LGS_VERSION_PATCH 0 /* of this header */

/* --- Limits and units -------------------------------------------------------------------------------------------- */

/* An edit beyond a limit is refused as LGS_CAPACITY. Two more refuse in this way: 2^23 - 1 distinct contents of cells,
 * and 2^28 - 1 polygons ever placed in one cell. A commit that needs more than 8 GiB for the records of cells with
 * segments, or more than 2^31 - 4,097 segments, ends the program, as it does when memory runs out. */
#define LGS_UNITS_PER_CELL 65536   /* lattice units along one side of a cell */
#define LGS_MAX_CELL 1073741824    /* cells run from -LGS_MAX_CELL to +LGS_MAX_CELL on both axes */
#define LGS_MAX_CELL_VERTICES 4096 /* of all polygons of one cell together */
#define LGS_MAX_CELL_POLYGONS 254  /* in one cell */
#define LGS_MAX_CHUNKS 4194303     /* of 32x32 cells, ever touched by an edit */
#define LGS_MAX_ENTRIES 2147483647 /* of a call that takes many */
#define LGS_MAX_RADIUS 4096        /* of lgs_nearest(), in cells */
#define LGS_MAX_RAY 16384          /* of lgs_ray_cast(), in cells on each axis */

/* --- Status ------------------------------------------------------------------------------------------------------ */

/* LGS_OK, or why a call was refused. */
typedef int32_t lgs_status;

enum {
  LGS_OK = 0,
  /* An edit or a question is refused. A polygon is checked in this order; the first reason that applies is reported. */
  LGS_CELL_OUT_OF_RANGE = 1, /* a cell index beyond LGS_MAX_CELL */
  LGS_EMPTY_SHAPE = 2,       /* a shape without polygons */
  LGS_TOO_FEW_VERTICES = 3,  /* fewer than 3 vertices */
  LGS_CAPACITY = 4,          /* more than the engine can hold; see the limits */
  LGS_NOT_FINITE = 5,        /* a coordinate is infinite or not a number */
  LGS_OUTSIDE_CELL = 6,      /* a vertex, once rounded, is not in the closed cell */
  LGS_REPEATED_VERTEX = 7,   /* two vertices are the same lattice point; vertex2 is the first that repeats another */
  LGS_ZERO_AREA = 8,         /* the signed area is 0 */
  LGS_SELF_INTERSECTING = 9, /* two edges of one polygon cross, overlap or touch */
  LGS_CLOCKWISE = 10,        /* the signed area is negative */
  LGS_OVERLAP = 11,          /* the interior meets that of another polygon of the cell, or of the shape */
  LGS_UNKNOWN_SHAPE = 12,    /* a shape that this world did not make */
  LGS_STALE_HANDLE = 13,     /* a polygon that is null, unknown or removed */
  LGS_UNKNOWN_SEGMENT = 14,  /* an id that names no live segment */
  LGS_UNKNOWN_MARK = 15,     /* a mark that this world did not make, or forgot, or rolled back beyond */
  LGS_UNCOMMITTED = 16,      /* edits are not committed, or there are marks */
  LGS_OUT_OF_REACH = 17,     /* a point, a radius or a ray of a question goes too far */
  LGS_UNLOADED = 18,         /* ground that is not in memory: see lgs_unload() */
  LGS_ANCHORED = 19,         /* an island that something holds can not fall: of FallingGround in C++, which C has not */
  /* A call is refused. */
  LGS_BAD_ARGUMENT = 100, /* NULL where that must not be, a number that means nothing, options of an unknown size */
  LGS_SHORT_BUFFER = 101, /* there is more than the buffer has room for */
  /* A saved world is refused: lgs_error has the offset of the byte at which that was noticed. */
  LGS_SAVE_NO_SNAPSHOT = 200,     /* it does not begin as one */
  LGS_SAVE_UNKNOWN_VERSION = 201, /* it has a version of the format that this library does not know */
  LGS_SAVE_CUT = 202,             /* it ends too early */
  LGS_SAVE_DAMAGED = 203,         /* its checksum does not fit */
  LGS_SAVE_TOO_LONG = 204,        /* bytes follow its end */
  LGS_SAVE_RELATION = 205,        /* it was saved with another preserve relation, as far as its cells show */
  LGS_SAVE_BAD_NUMBER = 206,      /* a number is out of its range */
  LGS_SAVE_BAD_POLYGON = 207,     /* a polygon is none, or two of one cell overlap */
  LGS_SAVE_BAD_SEGMENTS = 208,    /* the ids of the segments are not those of its segments, or one occurs twice */
  LGS_SAVE_CAPACITY = 209,        /* more than the engine can hold */
  LGS_SAVE_LOADED = 210,          /* of lgs_reload(): the chunk is not unloaded */
  LGS_SAVE_OTHER_BYTES = 211      /* of lgs_reload(): not the bytes with which the chunk was unloaded last */
};

/* --- Ids --------------------------------------------------------------------------------------------------------- */

/* A number of yours that a polygon carries, say of a material, a kind of tile or an entity. The world does not read
 * it. */
typedef uint32_t lgs_block;

/* Polygons that a world has validated and stored. Valid for that world, as long as it lives. */
typedef struct lgs_shape_id {
  uint32_t value; /* for the world that made it */
} lgs_shape_id;

/* One placed polygon. Once it is removed its id is stale: that is an error, and never another polygon, unless the world
 * rolls back to a time before that polygon was. The fields mean something to the world only. */
typedef struct lgs_polygon_id {
  uint32_t cell_ref; /* 0 in a null id */
  uint32_t serial;   /* not for you */
} lgs_polygon_id;

/* One boundary segment. Small dense integers, so an array can hold what you know of segments. A commit that reports a
 * segment as removed sets its id free: from the next commit on it may name another one. */
typedef struct lgs_segment_id {
  uint32_t value; /* good as an index */
} lgs_segment_id;

/* A moment to which a world can roll back. */
typedef struct lgs_mark {
  uint64_t value; /* for the world that made it */
} lgs_mark;

/* All of an id in 64 bits, to keep it where only integers go; 0 for null. */
LGS_API uint64_t lgs_store_shape(lgs_shape_id shape) LGS_NOTHROW;
LGS_API uint64_t lgs_store_polygon(lgs_polygon_id polygon) LGS_NOTHROW;
LGS_API uint64_t lgs_store_segment(lgs_segment_id segment) LGS_NOTHROW;
LGS_API uint64_t lgs_store_mark(lgs_mark mark) LGS_NOTHROW;
/* A number that was not stored from such an id gives an id that names nothing, or anything; one that is too large for
 * a shape or a segment gives null. */
LGS_API lgs_shape_id lgs_load_shape(uint64_t stored) LGS_NOTHROW;
LGS_API lgs_polygon_id lgs_load_polygon(uint64_t stored) LGS_NOTHROW;
LGS_API lgs_segment_id lgs_load_segment(uint64_t stored) LGS_NOTHROW;
LGS_API lgs_mark lgs_load_mark(uint64_t stored) LGS_NOTHROW;

/* --- Places ------------------------------------------------------------------------------------------------------ */

/* The unit cell [i, i+1] x [j, j+1]. */
typedef struct lgs_cell {
  int32_t i; /* the column, counted to the right */
  int32_t j; /* the row, counted upwards */
} lgs_cell;

/* All cells from min to max, both included. Empty if an index of max is below that of min. */
typedef struct lgs_cell_rect {
  lgs_cell min; /* the lower left cell */
  lgs_cell max; /* the upper right cell */
} lgs_cell_rect;

/* In its cell, in lattice units from the lower left corner, y up: 0 to LGS_UNITS_PER_CELL, the boundary included. */
typedef struct lgs_local_point {
  int32_t x; /* to the right */
  int32_t y; /* up */
} lgs_local_point;

/* A box in one closed cell. */
typedef struct lgs_local_box {
  lgs_local_point min; /* its lower left corner */
  lgs_local_point max; /* its upper right corner, included */
} lgs_local_box;

/* In the world, in lattice units. At most 2^46 + 2^16 in magnitude. */
typedef struct lgs_point {
  int64_t x; /* to the right */
  int64_t y; /* up */
} lgs_point;

/* In cells: 1.0 is the far side. Where one enters it is rounded to the nearest lattice point, halves away from zero. */
typedef struct lgs_float_point {
  float x; /* to the right */
  float y; /* up */
} lgs_float_point;

/* As lgs_float_point, but double. */
typedef struct lgs_double_point {
  double x; /* to the right */
  double y; /* up */
} lgs_double_point;

/* The lattice point nearest to a position of the world in cells, halves away from zero. If the position is beyond the
 * last cell, or no number, every question refuses the result as LGS_OUT_OF_REACH, and lgs_at() finds nothing there. */
LGS_API lgs_point lgs_lattice_point(lgs_double_point position) LGS_NOTHROW;

/* The cell in which a point lies. Cells are half-open here: a point on a common side belongs to the cell on its right,
 * or above it. So one on the upper or right side of the last cell is in none that is in range. The point must be in
 * range; another one gives any cell. */
LGS_API lgs_cell lgs_cell_at(lgs_point point) LGS_NOTHROW;

/* --- Errors ------------------------------------------------------------------------------------------------------ */

/* What was refused, and where. A number that does not apply is -1 (the cell INT32_MIN), an id null. */
typedef struct lgs_error {
  lgs_status code;        /* why it was refused */
  lgs_cell cell;          /* the cell of the edit; none while a shape is made */
  int32_t polygon;        /* index in the polygons given to the call */
  int32_t vertex;         /* index in that polygon; for an edge, its first vertex */
  int32_t vertex2;        /* the other vertex or edge involved */
  int32_t polygon2;       /* overlap within one call: the index of the other polygon */
  lgs_polygon_id other;   /* overlap with a placed polygon: that polygon, see index2; stale handle: the handle */
  lgs_block other_block;  /* overlap with a placed polygon: its block; it is in `cell` */
  lgs_segment_id segment; /* unknown segment: that id */
  int32_t index;          /* a call that takes many: index of the one that is refused */
  uint64_t offset;        /* a saved world: the byte */
  int32_t index2;         /* a call that takes many: index of the other one involved. It placed the other polygon, which
                             is undone, so that `other` is null; or it has the same handle. LGS_SAVE_UNKNOWN_VERSION:
                             `index` is the version of the format, and this the newest that is read. */
  uint32_t reserved[3];   /* 0 */
} lgs_error;

/* A short name, in English, e.g. "self-intersecting". "unknown error" for a number that is no status. It stays. */
LGS_API const char* lgs_status_name(lgs_status status) LGS_NOTHROW;

/* Writes a whole sentence that ends with a 0 and is cut to `capacity`, as a list of characters: *count is its length
 * without the 0, and LGS_SHORT_BUFFER is returned if it was cut. UTF-8; a cut may go through a character. */
LGS_API lgs_status lgs_message(const lgs_error* error, char* buffer, size_t capacity, size_t* count) LGS_NOTHROW;

/* The library's own version: major << 16 | minor << 8 | patch. */
LGS_API uint32_t lgs_version(void) LGS_NOTHROW;

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-use-using) */

#endif
