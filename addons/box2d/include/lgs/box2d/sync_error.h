// Why changes can not be applied to a copy of a world's segments.
#pragma once

#include <cstdint>

namespace lgs::box2d {

/// What speaks against changes.
enum class SyncError : std::uint8_t {
  notTheLast,    ///< they are not what the world did last: they are older, or another world's
  shownAlready,  ///< they lead to what the copy is already
  leftOut,       ///< the copy was not given all changes before these, or the world was assigned to
};

/// In words.
const char* message(SyncError error);

}  // namespace lgs::box2d
