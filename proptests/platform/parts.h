// What the program does, part by part: each adds to a hash of its own, so that a difference says where to look.
#pragma once

#include "hash.h"

namespace platform {

void edits(Hash& hash);      ///< every call that edits, refusals, lists, segments, loops
void relations(Hash& hash);  ///< the same under preserve relations
void executor(Hash& hash);   ///< first builds, job by job
void rollBack(Hash& hash);   ///< marks, roll-backs, copies, groups that are undone
void saves(Hash& hash);      ///< bytes of saved worlds, worlds from them, damaged ones
void unloading(Hash& hash);  ///< bytes of chunks that leave, and what is there without them
void brushes(Hash& hash);    ///< paint and carve
void views(Hash& hash);      ///< loops, islands and hashes of the ground, and what changed of them
void questions(Hash& hash);  ///< what is at places, by id
void radial(Hash& hash);     ///< links of any directed edges
void answers(Hash& hash);    ///< what is handed out as `double`, bit by bit

}  // namespace platform
