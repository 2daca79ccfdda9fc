/* Ground that falls, in C99 and C++: what a physics engine needs of a body, how a body that lies anywhere, at any angle,
 * comes back into the ground, and rocks in the air as bytes. What C++ calls ConvexPart, Placing and Rock is lgs_part_fn,
 * lgs_placing and lgs_rock here. The rules of lgs/lgs.h hold. No physics engine is known: the game steps the rocks.
 *
 *   lgs_islands_ids(islands, LGS_LOOSE, loose, 16, &count);      after an update (lgs/lgs_views.h)
 *   lgs_take(world, islands, loose[0], &body, NULL);             commit, and update the islands
 *   lgs_body_parts(body, 8, make_shape, physics, NULL);          a convex shape each
 *   ...
 *   lgs_put_as_it_lies(world, body, &rock.placing, NULL);        it rests: commit, and update the islands
 *   lgs_body_free(body);
 *
 * A take and a put are edits: an undo over a take brings the ground back, and then the game must drop the body; an undo
 * over a put takes the ground away, and then the game must have it in the air again. Either ends the redo. */
#ifndef LGS_LGS_FALLING_H
#define LGS_LGS_FALLING_H

/* NOLINTBEGIN(modernize-use-using): it is C */

#include <lgs/lgs_views.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Gets a convex part of a body: its vertices, counter-clockwise from the least one, in lattice units from the body's
 * origin. They stay until it returns. */
typedef void (*lgs_part_fn)(void* user, lgs_block block, const lgs_point* vertices, size_t count);

/* Calls visit() for each convex part of a body: by block, then by squares of 32x32 cells. The parts of a block make up
 * its polygons exactly, with no common interior; each has at most `max_vertices`. Whole cells of one block are merged to
 * rectangles. Refused: LGS_BAD_ARGUMENT, if `max_vertices` is less than 3 or more than LGS_MAX_CELL_VERTICES; and as by
 * lgs_put(), for a body that fits nowhere. Cost: as of lgs_pieces_new(), for each block. */
LGS_API lgs_status lgs_body_parts(const lgs_body* body, size_t max_vertices, lgs_part_fn visit, void* user,
                                  lgs_error* error) LGS_NOTHROW;

/* How a body lies: turned about its origin, then moved. The squares of cosine and sine have the sum 1. */
typedef struct lgs_placing {
  lgs_double_point origin; /* where the body's origin lies now: in cells of the world */
  double cosine;           /* of the angle */
  double sine;             /* of the angle: more than 0 is counter-clockwise */
} lgs_placing;

/* Sets a body into the ground as it lies: one edit, or nothing. Its vertices are rounded to the lattice, its polygons
 * are cut along the cells, and what is solid already stays as it is. So its polygons are others then, and the ids are
 * those that lgs_visit_cell_changes() shows after the commit. The body stays as it is. Refused: LGS_OUT_OF_REACH, where
 * a vertex would lie in no cell, or a block of it is more than 4,096 cells wide or high; LGS_UNLOADED, if it has a part
 * of an unloaded cell; LGS_CAPACITY; and as by lgs_put(), for a body that fits nowhere. Cost: in proportion to the cells
 * that it covers, for each of its blocks. LGS_BAD_ARGUMENT, if cosine and sine are no rotation. */
LGS_API lgs_status lgs_put_as_it_lies(lgs_world* world, const lgs_body* body, const lgs_placing* placing,
                                      lgs_error* error) LGS_NOTHROW;

/* How a body in the air lies and moves. With the body it is all that there is to know of a rock. */
typedef struct lgs_rock {
  lgs_placing placing;       /* how it lies */
  lgs_double_point velocity; /* of its centre of mass, in cells a second */
  double spin;               /* radians a second, counter-clockwise */
} lgs_rock;

/* A rock as bytes, as a list: to be saved beside the world, as the world does not know of it. Refused:
 * LGS_BAD_ARGUMENT, if its origin is out of the range of cells, velocity or spin are 10^9 or more, or something is no
 * number or no rotation. */
LGS_API lgs_status lgs_rock_save(const lgs_body* body, const lgs_rock* rock, uint8_t* bytes, size_t capacity,
                                 size_t* count) LGS_NOTHROW;

/* Makes the body again, and says how it lay and moved. Refused: LGS_SAVE_DAMAGED, if these are not the bytes of one
 * rock. Bytes that are made up are refused here, or the body that they give is by lgs_put() and the others. */
LGS_API lgs_status lgs_rock_load(const uint8_t* bytes, size_t count, lgs_body** body, lgs_rock* rock) LGS_NOTHROW;

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-use-using) */

#endif
