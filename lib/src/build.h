// A commit on several threads, while there are no segments yet.
#pragma once

#include "world_impl.h"

namespace lgs::detail {

/// Both phases for all dirty chunks of a world without segments. Every cell that holds polygons is dirty there.
/// Segments, ids and changes are the same as if the chunks were renewed and linked one after the other.
void build(World::Impl& world, const Executor& executor);

}  // namespace lgs::detail
