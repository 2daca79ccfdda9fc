// Whether a world is in order as a whole, for assert(): each word, list, link, number and note is looked at, and what is
// counted in two ways is compared.
#pragma once

#include "world/impl.h"

namespace lgs::detail {

/// Of a world without pending edits. Asserts what must hold, so that a debugger stops where it does not; true at the end.
/// Cost: in proportion to the world.
bool isValid(const World::Impl& world);

}  // namespace lgs::detail
