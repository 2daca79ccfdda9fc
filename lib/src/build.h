// A commit that finds no segments, on several threads.
#pragma once

#include "world_impl.h"

namespace lgs::detail {

/// Both phases for all dirty chunks of a world without segments, in which every cell that holds polygons is therefore
/// dirty. Same segments, ids and changes as if the chunks were renewed and linked one after the other.
void build(World::Impl& world, const Executor& executor);

}  // namespace lgs::detail
