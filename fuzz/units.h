// Lengths that several targets use.
#pragma once

#include <lgs/lattice.h>

#include <cstdint>

namespace lgs::fuzz {

inline constexpr std::int32_t U = kUnitsPerCell;      ///< a cell in lattice units
inline constexpr std::int64_t kCell = kUnitsPerCell;  ///< the same, for sums beyond a cell
inline constexpr std::int32_t kChunkSide = 32;        ///< in cells

}  // namespace lgs::fuzz
