// Strokes whose instructions are counted.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lgs::bench {

enum class StrokeGround : std::uint8_t { full, mixed };

/// Carves that many round holes out of a world of 100×100 cells, each with its commit: 32-gons of radius 3 around any
/// lattice point, none of which meets another. If each is undone, a mark is set before it, and the world rolls back to
/// that.
void carveHoles(StrokeGround ground, std::size_t count, bool isUndone);

/// How many cells the edges of that many holes run through.
std::size_t cellsCut(std::size_t count);

}  // namespace lgs::bench
