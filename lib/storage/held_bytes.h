#pragma once

#include <cstdint>

namespace lgs::detail {

/// What vectors have allocated, in bytes; not what their elements have.
template <class... Vectors>
std::uint64_t heldBytes(const Vectors&... vectors) {
  return (... + (vectors.capacity() * sizeof(typename Vectors::value_type)));
}

}  // namespace lgs::detail
