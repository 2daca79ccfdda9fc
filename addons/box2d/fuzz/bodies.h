// Bodies of Box2D on ground that changes.
#pragma once

#include "fuzz/target.h"

namespace lgs::fuzz {

/// A game: bodies fall, are thrown and dug out; ground is painted, carved, undone and redone under them, falls as bodies
/// and settles. After each move and each step law 13 must hold, nobody is buried.
///
///   header  byte 1  the terrain: merged or not, how large cells and chunks are, what becomes of bodies in new ground
///   record  a move: each choice takes the next byte, and then there are zeros
std::optional<Finding> checkBodies(Bytes input, oracle::CheckStats& stats);

}  // namespace lgs::fuzz
