/* The C interface of LocalGridSeg: a world of unit cells that hold polygons, and its boundary segments with their ghost
 * vertices. C99 and C++. The words are those of docs/contract.md; what C++ calls World is lgs_world here.
 *
 *   lgs_world* world;
 *   lgs_shape_id square;
 *   lgs_changes changes;
 *   const lgs_local_point corners[] = {{0, 0}, {65536, 0}, {65536, 65536}, {0, 65536}};
 *   if (lgs_new(NULL, &world) != LGS_OK) return;
 *   lgs_shape(world, corners, 4, &square, NULL);                 validated once
 *   lgs_add(world, (lgs_cell){3, 4}, square, 7, NULL, NULL);     7 is your own block id
 *   lgs_commit(world, &changes);                                 exactly what changed
 *   lgs_free(world);
 *
 * The rules, which hold for every function:
 *
 * - Result. A function that can be refused returns a lgs_status: LGS_OK, which is 0, or why it was refused. Whatever is
 *   not LGS_OK has changed nothing in the world.
 * - Arguments. The world is the first one, what the function writes comes last. A pointer to a value that is written
 *   may be NULL: then the value is not wanted. It must not be NULL where a world, a group, a list of loops or a mark is
 *   handed out: you could not free it. An array may be NULL if it has no elements. Any other pointer must not be NULL,
 *   unless the text says so. A NULL that must not be is refused as LGS_BAD_ARGUMENT, and so is a number that is none of
 *   the constants for it; where no refusal is named, it is the only one, and with "as a list" LGS_SHORT_BUFFER.
 *   Functions that return no status take a NULL world for an empty one.
 *   Not checked: that a pointer leads to as much memory as it should, and that a world, a group or a list of loops was
 *   not freed. A refused call leaves its outputs as they were, unless noted otherwise.
 * - Errors. If the last argument is a lgs_error*, it may be NULL. It is written only if the result is not LGS_OK.
 *   lgs_message() makes a sentence of it.
 * - Buffers. Where the text says "as a list", the function writes at most `capacity` elements and returns in *count how
 *   many there are. If these are more, the first ones are written, and the result is LGS_SHORT_BUFFER.
 * - Ownership. The library allocates what it makes and frees it: lgs_new(), lgs_copy() and lgs_load() with lgs_free();
 *   lgs_begin() with lgs_keep() or lgs_undo(); lgs_loops_new() with lgs_loops_free(). All else is yours. Nothing that
 *   you hand in is kept after the call, apart from a preserve relation: the function, and the `user` that comes with
 *   it.
 * - Lifetimes. The lists of a lgs_changes stay until the next commit or roll-back of that world, or until it is freed.
 *   Vertices that a callback gets stay until it returns. All else is copied into your memory.
 * - Values. Ids are small structs. Zero is null and names nothing. lgs_store_…() makes an integer of an id, to keep it
 *   where only integers go, and lgs_load_…() makes the id again. `reserved` fields are 0. Numbers have the same width
 *   on every machine. Only the sizes of arrays in memory, and places in them, are size_t, as everywhere in C.
 * - Options. A struct of options begins with its size and is filled by its lgs_default_…(). You then change what you
 *   like. So a program goes on working with a later library.
 * - Threads. Functions that take a const lgs_world* may be called at the same time, from several threads. While one
 *   that takes a lgs_world* runs, no other function may be called with the same world. Worlds do not know of each
 *   other: there are no globals, but for a counter of worlds, which is atomic.
 * - Callbacks get the `user` that came with them. They must return: no exception, no longjmp. They must not call a
 *   function with the same world, unless the text says so.
 * - Memory. When it runs out the program ends, as it does in C++. Nothing is thrown out of a function.
 * - Versions. Before 1.0 a minor version may change this interface. From 1.0 on there are only additions.
 */
#ifndef LGS_LGS_H
#define LGS_LGS_H

#include <lgs/c/edit.h>
#include <lgs/c/read.h>
#include <lgs/c/values.h>
#include <lgs/c/world.h>

#endif
