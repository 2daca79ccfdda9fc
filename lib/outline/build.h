// An update on several threads, while there are no segments yet.
#pragma once

#include "outline/outline.h"

namespace lgs::detail {

/// Both phases for all changed chunks, if there are no segments: then every cell that holds polygons has changed.
/// Segments, ids and changes are the same as if the chunks were renewed and linked one after the other.
void build(const Ground& ground, Outline& outline, const Executor& executor);

}  // namespace lgs::detail
