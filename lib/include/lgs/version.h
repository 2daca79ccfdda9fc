// Which version of the library this is.
#pragma once

#include <compare>
#include <cstdint>

namespace lgs {

/// A version, as in the file name of a release. Later versions are greater. While `major` is 0, another `minor` may
/// have another interface; from 1.0 on only another `major` may.
struct Version {
  std::uint32_t major = 0;  ///< the first number
  std::uint32_t minor = 0;  ///< the second number
  std::uint32_t patch = 0;  ///< the third number
  friend constexpr auto operator<=>(const Version&, const Version&) = default;
};

/// The version of these headers.
inline constexpr Version kVersion{0, 3, 0};

/// The version of the library that the program runs with. A shared library may be newer than the headers that the
/// program was compiled with.
Version version();

}  // namespace lgs
