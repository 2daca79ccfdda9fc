// Law 12 needs twins: two worlds in which the same calls are made. One of them leaves now and then: it rolls back to a
// mark, is saved and loaded, or is copied. Nobody must be able to tell them apart.
#pragma once

#include "calls.h"

#include <cstddef>
#include <vector>

namespace lgs::test {

/// Makes the same calls in both worlds, which must answer the same, report the same and be saved as the same bytes.
void expectNoDifference(Caller& stayed, Caller& left, const Calls& calls);

/// Gives the bytes of a world or a chunk the checksum that they should have.
void seal(std::vector<std::byte>& bytes);

}  // namespace lgs::test
