// Regular expressions of Perl's kind, as the worlds of Tiled have them. PCRE2 reads and matches them; a build for
// WebAssembly has no PCRE2 and refuses them all (regexp_refused.cpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace lgs::tiled {

/// A pattern, compiled. A world need not be trusted, so all that a pattern can cost has a limit.
class Regexp {
 public:
  static constexpr std::size_t kKept = 2;           ///< how many captures match() gives
  static constexpr std::size_t kMaxLength = 1'024;  ///< of a pattern, in bytes

  /// All matches with the patterns of one world may take so many steps together. A step is an item of a pattern that is
  /// tried at a letter of a name, or a letter that is looked at.
  static constexpr std::uint64_t kMaxSteps = 10'000'000;

  /// Compiles a pattern, or says what in it is wrong.
  static tl::expected<Regexp, std::string> parse(std::string_view pattern);

  std::size_t captures() const { return captures_; }

  /// What a text has of a match.
  struct Match {
    bool isThere = false;
    std::array<std::string, kKept> captures;  ///< the first ones of the first match; "" for one that took no part
  };

  /// Matches a text of UTF-8. It takes what it needs from `stepsLeft`; if that is too little, it says so.
  tl::expected<Match, std::string> match(std::string_view text, std::uint64_t& stepsLeft) const;

 private:
  std::shared_ptr<void> code_;  // of PCRE2
  std::size_t captures_ = 0;
};

}  // namespace lgs::tiled
