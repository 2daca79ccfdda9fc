// What a world may hold, and how wide its handles are.
#pragma once

#include <cstddef>

namespace lgs {

/// Limits. Beyond them an edit is refused with ErrorCode::capacity. Two more refuse in this way: 2^23 - 1 distinct
/// contents of cells, and 2^28 - 1 polygons ever placed in one cell. The program ends, as when memory runs out, where a
/// commit needs more than 8 GiB for the lists of segments that cells show, or more than 2^31 - 4,097 segments; and
/// where an edit needs more than 8 GiB for the lists of polygons of cells that hold several.
///
/// A program for JavaScript, whose numbers are whole up to 2^53, may define LGS_HANDLES_IN_53_BITS for all of its
/// files. Then every PolygonHandle has cellRef < 2^30 and serial < 2^23: at most 2^20 - 1 chunks and, in one cell, 2^23
/// - 1 polygons ever placed.
inline constexpr std::size_t kMaxVerticesPerCell = 4'096;  ///< of all polygons of one cell together
inline constexpr std::size_t kMaxPolygonsPerCell = 254;    ///< in one cell
#ifdef LGS_HANDLES_IN_53_BITS
inline constexpr std::size_t kMaxChunks =
    (std::size_t{1} << 20) - 1;  ///< of 32×32 cells, ever touched by an edit, and not forgotten
#else
inline constexpr std::size_t kMaxChunks =
    (std::size_t{1} << 22) - 1;  ///< of 32×32 cells, ever touched by an edit, and not forgotten
#endif
inline constexpr std::size_t kMaxEntries = 0x7fff'ffff;  ///< of a call that takes many

#ifdef LGS_HANDLES_IN_53_BITS
/// Its name is how wide handles are.
enum class HandlesIn53Bits : bool {};
using Handles = HandlesIn53Bits;
#else
/// Its name is how wide handles are.
enum class HandlesIn60Bits : bool {};
/// Which handles a file was compiled for. It is a parameter of World's constructor that is never given: where a program
/// and its library disagree about LGS_HANDLES_IN_53_BITS, they do not link.
using Handles = HandlesIn60Bits;
#endif

}  // namespace lgs
