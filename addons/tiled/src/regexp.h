// Regular expressions of Perl's kind, as the worlds of Tiled have them. PCRE2 reads and matches them; a build for
// WebAssembly has no PCRE2 and refuses them all (regexp_refused.cpp).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::tiled {

/// A name that a pattern fits.
struct Fit {
  std::string name;
  std::array<std::string, 2> captures;  ///< of the first match; "" for one that took no part
};

/// All matches with the patterns of one world may take so many steps together. A step is an item of a pattern that is
/// tried at a letter of a name, or a letter that is looked at.
inline constexpr std::uint64_t kMaxPatternSteps = 10'000'000;

/// Those of some names of UTF-8 that a pattern with two captures fits; or what is wrong with the pattern. A world need
/// not be trusted, so all that a pattern can cost has a limit. Matching takes what it needs from `stepsLeft`.
tl::expected<std::vector<Fit>, std::string> namesThatFit(std::string_view pattern,
                                                         const std::vector<std::string>& names,
                                                         std::uint64_t& stepsLeft);

}  // namespace lgs::tiled
