// The engine refuses with an Error as a value, and names the fields that it knows: refuse({.code = …, .cell = …}).
#pragma once

#include <lgs/error.h>

namespace lgs::detail {

inline tl::unexpected<Error> refuse(const Error& error) { return tl::unexpected(error); }

/// Refuses with an error that was found where nobody knew the cell.
inline tl::unexpected<Error> refuse(Error error, Cell cell) {
  error.cell = cell;
  return tl::unexpected(error);
}

}  // namespace lgs::detail
