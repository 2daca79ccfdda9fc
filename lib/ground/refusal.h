// The engine refuses with an Error as a value, and names the fields that it knows: refuse({.code = …, .cell = …}).
#pragma once

#include <lgs/error.h>
#include <lgs/lattice.h>

#include <cstddef>

namespace lgs::detail {

inline tl::unexpected<Error> refuse(const Error& error) { return tl::unexpected(error); }

/// Refuses with an error that was found where the cell is not known.
inline tl::unexpected<Error> refuse(Error error, Cell cell) {
  error.cell = cell;
  return tl::unexpected(error);
}

/// Refuses one of many: `index` is the field that says which.
inline tl::unexpected<Error> refuseAt(Error error, std::int32_t Error::*index, std::size_t which) {
  error.*index = static_cast<std::int32_t>(which);
  return tl::unexpected(error);
}

/// Whether a rectangle that is not empty lies in the world.
inline Expected<void> checkCorners(const CellRect& cells) {
  for (const Cell corner : {cells.min, cells.max})
    if (!inRange(corner)) return refuse({.code = ErrorCode::cellOutOfRange, .cell = corner});
  return {};
}

}  // namespace lgs::detail
