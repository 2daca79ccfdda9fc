// How the engine refuses: with an Error as a value. It names the fields that it knows: refuse({.code = …, .cell = …}).
#pragma once

#include <lgs/error.h>

namespace lgs::detail {

inline tl::unexpected<Error> refuse(const Error& error) { return tl::unexpected(error); }

/// Refuses for a reason that was found without knowing the cell.
inline tl::unexpected<Error> refuse(Error error, Cell cell) {
  error.cell = cell;
  return tl::unexpected(error);
}

}  // namespace lgs::detail
