// Changes an input a little: by whole records where inputs are records, by words of the format where they are text.
// Used by the plain driver, and by libFuzzer beside its own ways.
#pragma once

#include "fuzz/target.h"
#include "oracle/calls/random.h"

#include <cstdint>
#include <vector>

namespace lgs::fuzz {

using Buffer = std::vector<std::uint8_t>;

/// The result is not longer than `maxSize`.
void mutate(const Target& target, Buffer& input, std::size_t maxSize, oracle::Random& random);

}  // namespace lgs::fuzz
