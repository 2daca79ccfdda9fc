/* Shapes, edits, commits, roll-back and redo. Edits change the polygons at once, and the segments with the next commit.
 * lgs/lgs.h has the rules. */
#ifndef LGS_C_EDIT_H
#define LGS_C_EDIT_H

/* NOLINTBEGIN(modernize-use-using): it is C */

#include <lgs/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/* --- Shapes ------------------------------------------------------------------------------------------------------ */

/* Validates and stores one polygon. It must be simple, run counter-clockwise, have a positive area and be inside the
 * closed cell. The same polygon, vertex by vertex, gives the same id. A shape is never forgotten. Refused: the statuses
 * from LGS_TOO_FEW_VERTICES to LGS_CLOCKWISE. Cost: a hash; O(n log n) the first time, O(n^2) for a refusal. */
LGS_API lgs_status lgs_shape(lgs_world* world, const lgs_local_point* vertices, size_t count, lgs_shape_id* shape,
                             lgs_error* error) LGS_NOTHROW;
LGS_API lgs_status lgs_shape_floats(lgs_world* world, const lgs_float_point* vertices, size_t count,
                                    lgs_shape_id* shape, lgs_error* error) LGS_NOTHROW;
LGS_API lgs_status lgs_shape_doubles(lgs_world* world, const lgs_double_point* vertices, size_t count,
                                     lgs_shape_id* shape, lgs_error* error) LGS_NOTHROW;

/* The same for several polygons with disjoint interiors. counts[k] says how many vertices polygon k has; all vertices
 * stand one after the other. Refused also: LGS_EMPTY_SHAPE, LGS_OVERLAP. LGS_CAPACITY comes first if there are more
 * polygons than LGS_MAX_CELL_POLYGONS. */
LGS_API lgs_status lgs_shape_of_several(lgs_world* world, const lgs_local_point* vertices, const uint32_t* counts,
                                        size_t polygons, lgs_shape_id* shape, lgs_error* error) LGS_NOTHROW;

/* How many polygons a shape has; the vertices of one of them, as a list; the least box around all. Refused:
 * LGS_UNKNOWN_SHAPE; LGS_BAD_ARGUMENT, if the shape has no polygon of this index. Cost of the box: it looks at each
 * vertex. */
LGS_API lgs_status lgs_shape_polygons(const lgs_world* world, lgs_shape_id shape, size_t* count) LGS_NOTHROW;
LGS_API lgs_status lgs_shape_vertices(const lgs_world* world, lgs_shape_id shape, size_t polygon,
                                      lgs_local_point* vertices, size_t capacity, size_t* count) LGS_NOTHROW;
LGS_API lgs_status lgs_shape_box(const lgs_world* world, lgs_shape_id shape, lgs_local_box* box) LGS_NOTHROW;

/* --- Edits ------------------------------------------------------------------------------------------------------- */

/* Places every polygon of a shape in a cell, all with this block. `polygon` receives the id of the first one. Refused:
 * LGS_CELL_OUT_OF_RANGE, LGS_UNLOADED, LGS_UNKNOWN_SHAPE, LGS_OVERLAP, LGS_CAPACITY. Cost: O(1) in a cell that is
 * empty. */
LGS_API lgs_status lgs_add(lgs_world* world, lgs_cell cell, lgs_shape_id shape, lgs_block block,
                           lgs_polygon_id* polygon, lgs_error* error) LGS_NOTHROW;

/* The same. `polygons` receives the ids of all polygons in the shape's order, or as many as it has room for. */
LGS_API lgs_status lgs_add_several(lgs_world* world, lgs_cell cell, lgs_shape_id shape, lgs_block block,
                                   lgs_polygon_id* polygons, size_t capacity, lgs_error* error) LGS_NOTHROW;

/* The same for one polygon given by its vertices: refused as by lgs_shape(), too. If it was seen before this costs a
 * hash, otherwise it is validated. */
LGS_API lgs_status lgs_add_points(lgs_world* world, lgs_cell cell, const lgs_local_point* vertices, size_t count,
                                  lgs_block block, lgs_polygon_id* polygon, lgs_error* error) LGS_NOTHROW;
LGS_API lgs_status lgs_add_floats(lgs_world* world, lgs_cell cell, const lgs_float_point* vertices, size_t count,
                                  lgs_block block, lgs_polygon_id* polygon, lgs_error* error) LGS_NOTHROW;
LGS_API lgs_status lgs_add_doubles(lgs_world* world, lgs_cell cell, const lgs_double_point* vertices, size_t count,
                                   lgs_block block, lgs_polygon_id* polygon, lgs_error* error) LGS_NOTHROW;

/* A shape and where it shall be. */
typedef struct lgs_placement {
  lgs_cell cell;      /* where */
  lgs_shape_id shape; /* what */
  lgs_block block;    /* the number that all its polygons get */
} lgs_placement;

/* Places many shapes, each as lgs_add() would, one after the other: all of them or none. polygons[k] receives the id of
 * the first polygon of placements[k]; null ids, if an entry is refused. It may be NULL. Refused as by lgs_add(), and
 * the error's `index` names which one; if it overlaps an earlier one, `index2` names which. Refused without an index:
 * LGS_CAPACITY, if there are more than LGS_MAX_ENTRIES. Cost: as of single edits while there is a mark. */
LGS_API lgs_status lgs_add_many(lgs_world* world, const lgs_placement* placements, size_t count,
                                lgs_polygon_id* polygons, lgs_error* error) LGS_NOTHROW;

/* Removes one polygon. Refused: LGS_STALE_HANDLE; LGS_UNLOADED; LGS_CAPACITY, if what is left in the cell would be a
 * content too many. */
LGS_API lgs_status lgs_remove(lgs_world* world, lgs_polygon_id polygon, lgs_error* error) LGS_NOTHROW;

/* Removes many polygons: all of them or none. Refused as by lgs_remove(), and the error's `index` names which one; so
 * for an id that comes twice, and `index2` is where it was first. Refused without an index, and cost: as of
 * lgs_add_many(). */
LGS_API lgs_status lgs_remove_many(lgs_world* world, const lgs_polygon_id* polygons, size_t count,
                                   lgs_error* error) LGS_NOTHROW;

/* Puts a shape in the place of all polygons of a cell, which may be empty: both happen, or neither. `polygons` is as
 * for lgs_add_several(). Refused as by lgs_add(), but never for overlap. */
LGS_API lgs_status lgs_replace(lgs_world* world, lgs_cell cell, lgs_shape_id shape, lgs_block block,
                               lgs_polygon_id* polygons, size_t capacity, lgs_error* error) LGS_NOTHROW;

/* A polygon that shall be placed: for lgs_exchange(). */
typedef struct lgs_new_polygon {
  const lgs_local_point* vertices; /* counter-clockwise, in its cell */
  size_t count;                    /* of the vertices */
  lgs_block block;                 /* the number that it gets */
  uint32_t reserved;               /* 0 */
} lgs_new_polygon;

/* Removes some polygons of a cell and places others in it, as one edit: all of it happens, or nothing. Ids, segments
 * and lists are as by lgs_remove() and lgs_add_points() one after the other; but polygons need not be apart from those
 * that go. polygons[k] receives the id of added[k]; it may be NULL. Refused: LGS_CELL_OUT_OF_RANGE; LGS_UNLOADED;
 * LGS_STALE_HANDLE, for an id that is not of this cell or comes twice, and the error's `index` names which; as by
 * lgs_shape(), and the error's `polygon` names which; LGS_OVERLAP; LGS_CAPACITY, without looking at any, if more than
 * LGS_MAX_CELL_POLYGONS are added. Cost: as of one lgs_add_points(). */
LGS_API lgs_status lgs_exchange(lgs_world* world, lgs_cell cell, const lgs_polygon_id* removed, size_t removed_count,
                                const lgs_new_polygon* added, size_t added_count, lgs_polygon_id* polygons,
                                lgs_error* error) LGS_NOTHROW;

/* Gives a polygon another block. It keeps its id and its place. The next commit removes its segments and adds them
 * again, as another block is another owner; all others keep their ids. Refused: LGS_STALE_HANDLE; LGS_UNLOADED;
 * LGS_CAPACITY, if a preserve relation makes one content too many of the cell. */
LGS_API lgs_status lgs_set_block(lgs_world* world, lgs_polygon_id polygon, lgs_block block,
                                 lgs_error* error) LGS_NOTHROW;

/* Places a shape in every cell of a rectangle, or in none. `filled` receives their number. Refused as lgs_add() would
 * be for the first cell, by rows from min, that it would refuse; but LGS_CELL_OUT_OF_RANGE names a corner of the
 * rectangle that is out of range, and LGS_CAPACITY names min if the rectangle reaches more chunks than the world has
 * room for. An empty rectangle is no error. */
LGS_API lgs_status lgs_fill(lgs_world* world, lgs_cell_rect cells, lgs_shape_id shape, lgs_block block,
                            uint64_t* filled, lgs_error* error) LGS_NOTHROW;

/* Removes every polygon in every cell of a rectangle. `removed` receives the number of polygons. Refused:
 * LGS_CELL_OUT_OF_RANGE, with a corner of the rectangle that is out of range; LGS_UNLOADED, with the first such
 * cell. */
LGS_API lgs_status lgs_clear(lgs_world* world, lgs_cell_rect cells, uint64_t* removed, lgs_error* error) LGS_NOTHROW;

/* A group of edits, which happens as a whole or not at all. lgs_undo() takes back the edits since lgs_begin(), as if
 * they had not been made, and lgs_keep() lets them be; each ends the group and frees it. A commit keeps what was edited
 * before it, and what follows is not undone. A world that rolled back to a mark older than the group has undone it. Of
 * groups within groups the inner one ends first. The world must live until then. NULL is no error. */
typedef struct lgs_group lgs_group;
/* Begins a group, ends it and keeps its edits, ends it and takes them back: see lgs_group. */
LGS_API lgs_status lgs_begin(lgs_world* world, lgs_group** group) LGS_NOTHROW;
LGS_API void lgs_keep(lgs_group* group) LGS_NOTHROW;
LGS_API void lgs_undo(lgs_group* group) LGS_NOTHROW;

/* --- Commits ----------------------------------------------------------------------------------------------------- */

/* What a commit did to the segments. No id is in two lists. A segment whose ends, owner and ghosts are as before is in
 * none. Ids in `removed` name nothing from now on. The order of each list follows from the edits since the last commit,
 * in their order: the same edits in another order may give the same segments other ids and places. A list that is empty
 * may be NULL.
 *
 * The lists lead from one lgs_world_version() to another. A copy of the segments is kept with the version,
 * too. The lists fit the copy if `before` is that version; then `after` is the new one. So it shows when lists were
 * left out, applied twice, or are those of another world. Both are the same if the commit found nothing to do. Where
 * they are not, the lists may be empty: inside the ground polygons come and go without a segment. */
typedef struct lgs_changes {
  const lgs_segment_id* removed;  /* alive before, and not any more */
  const lgs_segment_id* added;    /* alive now, and not before */
  const lgs_segment_id* relinked; /* alive before and after, with another ghost */
  size_t removed_count;           /* how many `removed` has */
  size_t added_count;             /* how many `added` has */
  size_t relinked_count;          /* how many `relinked` has */
  uint64_t before;                /* the version from which the lists lead */
  uint64_t after;                 /* the version to which they lead */
} lgs_changes;

/* Brings the segments up to date with all edits since the last commit. Cost: in proportion to the contents of the
 * edited cells and of the eight around each. Allocates nothing once the world has reached its size. */
LGS_API lgs_status lgs_commit(lgs_world* world, lgs_changes* changes) LGS_NOTHROW;

/* Work that may run on any thread. */
typedef void (*lgs_job_fn)(void* job, size_t index);

/* Calls run(job, 0) ... run(job, count - 1), each exactly once, in any order and on any threads, and returns when all
 * of them have returned. So the application lends its own threads to a commit. A commit may call it several times, and
 * `count` may be 0. */
typedef void (*lgs_executor_fn)(void* user, size_t count, lgs_job_fn run, void* job);

/* The same to the last id, on the executor's threads if the world has no segments yet, as in its first commit. Then
 * there is most work to spread; any other commit is as above. A job is the work on a chunk of 32x32 cells. Allocates
 * working memory in proportion to the cells with segments. */
LGS_API lgs_status lgs_commit_with(lgs_world* world, lgs_executor_fn executor, void* user,
                                   lgs_changes* changes) LGS_NOTHROW;

/* --- Marks, roll-back, redo -------------------------------------------------------------------------------------- */

/* Notes this moment. Edits may be pending. A mark is for this world and its later copies; no other world of this
 * process ever makes the same one. Its number means nothing else, and differs from run to run. While there are marks an
 * edit costs some more, and memory grows with the edits and commits since the oldest one. Cost: O(1). */
LGS_API lgs_status lgs_set_mark(lgs_world* world, lgs_mark* mark) LGS_NOTHROW;

/* Rolls back to a mark: every later output, id and list is as if the edits and commits after it had not been made. So
 * ids that were given out after it name nothing until they are given out again. What a shape that was made after it
 * holds stays in memory. The mark stays, so that the world can roll back to it again; later ones are invalidated.
 * `changes` receives what this did to the segments: the lists of a commit, by id, but an id that named one segment and
 * names another one now is removed, and then added. Refused: LGS_UNKNOWN_MARK. Cost: in proportion to the edits since
 * the mark. */
LGS_API lgs_status lgs_roll_back(lgs_world* world, lgs_mark mark, lgs_changes* changes, lgs_error* error) LGS_NOTHROW;

/* The same, and what it undoes is kept: the later marks are ahead, and lgs_redo() leads there. It takes memory
 * until the world rolls back further without keeping, rolls back with keeping after an edit or another mark, or has no
 * mark left from before. */
LGS_API lgs_status lgs_roll_back_keeping(lgs_world* world, lgs_mark mark, lgs_changes* changes,
                                         lgs_error* error) LGS_NOTHROW;

/* Redoes up to a mark that is ahead, as if the world had not rolled back beyond it: the edits and commits up to it come
 * back with their polygon, shape and segment ids. Marks made since the roll-back are invalidated; those further ahead
 * stay ahead. `changes` is as for lgs_roll_back(). Refused: LGS_UNKNOWN_MARK, if the mark is not ahead, or if something
 * was edited, or a shape made, since the roll-back or redo, and that was not undone. Cost: as of lgs_roll_back(). */
LGS_API lgs_status lgs_redo(lgs_world* world, lgs_mark mark, lgs_changes* changes, lgs_error* error) LGS_NOTHROW;

/* Releases a mark. Other marks stay. Refused: LGS_UNKNOWN_MARK. */
LGS_API lgs_status lgs_forget(lgs_world* world, lgs_mark mark, lgs_error* error) LGS_NOTHROW;

/* --- Leaving places ---------------------------------------------------------------------------------------------- */

/* Releases a place that the game has left. Each chunk of 32x32 cells that lies in the rectangle as a whole and holds
 * no polygon gives its memory back, and so does each unloaded one that had no loaded chunk around it at the last
 * commit, unless a roll-back or redo changed it since it was unloaded; other chunks stay. `forgotten` receives how many
 * were forgotten. An empty rectangle is no error. All polygon ids that were ever given out for cells of these chunks
 * are invalidated: they name nothing until they are given out again, maybe for another place. Segments, shapes and all
 * other ids are not touched. Refused: LGS_CELL_OUT_OF_RANGE, with a corner of the rectangle that is out of range;
 * LGS_UNCOMMITTED, while edits are not committed or there are marks. Cost: in proportion to the cells of the chunks in
 * the rectangle, and to the chunks in the rectangle or in the world, whichever are fewer. */
LGS_API lgs_status lgs_forget_chunks(lgs_world* world, lgs_cell_rect cells, uint64_t* forgotten,
                                     lgs_error* error) LGS_NOTHROW;

/* Takes the bytes of one chunk, whose lower-left cell is `corner`. It may read the world. */
typedef void (*lgs_chunk_fn)(void* user, lgs_cell corner, const uint8_t* bytes, size_t count);

/* Chunks of 32x32 cells leave memory: those that are loaded and lie in the rectangle as a whole, by rows. `take` gets
 * the bytes of each; it may be NULL. `unloaded` receives how many chunks these are. The next commit reports which
 * segments were removed. What is loaded shows the segments and ghosts that it has in the whole world: no wall appears
 * where it ends. In an unloaded chunk every edit is refused as LGS_UNLOADED, and so are ids of its polygons and
 * segments; questions that would have to look there return that; lists and counts leave it out. Marks stay good.
 * Refused: LGS_CELL_OUT_OF_RANGE, with a corner of the rectangle that is out of range. Cost: in proportion to the cells
 * of these chunks. */
LGS_API lgs_status lgs_unload(lgs_world* world, lgs_cell_rect cells, lgs_chunk_fn take, void* user, uint64_t* unloaded,
                              lgs_error* error) LGS_NOTHROW;

/* A chunk comes back as it was, to the last id. `bytes` are what lgs_unload() gave last for this chunk; where there is
 * no chunk they may be what any world gave that has the same preserve relation, and the ids are new. `corner` receives
 * its lower-left cell. Refused: LGS_SAVE_…, and the error has the offset of the byte. Cost: in proportion to the cells
 * of the chunk, and quadratic in the vertices of each content of a cell that is new. */
LGS_API lgs_status lgs_reload(lgs_world* world, const uint8_t* bytes, size_t count, lgs_cell* corner,
                              lgs_error* error) LGS_NOTHROW;

/* The unloaded chunks that lie in a rectangle as a whole come back, and are empty: for a game that makes their ground
 * again before the next commit. Ids of polygons from before name nothing, and are never given out again. `reloaded`
 * receives how many chunks these are. Refused: LGS_CELL_OUT_OF_RANGE, with a corner of the rectangle that is out of
 * range. Cost: in proportion to the cells of these chunks. */
LGS_API lgs_status lgs_reload_empty(lgs_world* world, lgs_cell_rect cells, uint64_t* reloaded,
                                    lgs_error* error) LGS_NOTHROW;

/* Writes whether a rectangle has an unloaded cell (1 or 0), and the first such cell, by rows. Cost: in proportion to
 * the chunks in the rectangle or in the world, whichever are fewer. */
LGS_API lgs_status lgs_first_unloaded(const lgs_world* world, lgs_cell_rect cells, int32_t* found,
                                      lgs_cell* first) LGS_NOTHROW;

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-use-using) */

#endif
