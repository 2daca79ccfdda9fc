// Regular expressions of Perl's kind, as the worlds of Tiled have them. std::regex would throw, and may take
// exponential time; a world need not be trusted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace lgs::tiled {

/// A step of a compiled expression. Jumps count from the step itself.
struct RegexpStep {
  enum class Kind : std::uint8_t { letter, split, jump, save, begin, end };
  Kind kind{};
  std::ptrdiff_t first = 0;   ///< split, jump: where to go; split tries this first
  std::ptrdiff_t second = 0;  ///< split: where else
  std::size_t number = 0;     ///< letter: index of the set; save: the slot
};

/// A set of letters.
struct RegexpSet {
  std::vector<std::pair<char32_t, char32_t>> ranges;  ///< first and last letter of each
  bool isNegated = false;                             ///< all letters that are in none
};

/// It has letters, sets of them, groups, `|`, `^`, `$`, and `*`, `+`, `?` and `{2,3}`, greedy or lazy. Letters are
/// those of UTF-8.
class Regexp {
 public:
  static constexpr std::size_t kMaxSteps = 4'096;  ///< with all repetitions written out
  static constexpr std::size_t kKept = 2;          ///< how many captures match() gives

  /// Compiles a pattern, or says what in it is wrong or not supported.
  static tl::expected<Regexp, std::string> parse(std::string_view pattern);

  std::size_t captures() const { return captures_; }

  /// The first captures of the first match in a text; "" for one that took no part. Nothing if nothing matches. Takes
  /// time for each letter of the text and step of the expression together, and no more.
  std::optional<std::array<std::string, kKept>> match(std::string_view text) const;

 private:
  friend class RegexpParser;

  std::vector<RegexpStep> steps_;  // after the last one it has matched
  std::vector<RegexpSet> sets_;
  std::size_t captures_ = 0;
};

/// A text as letters. A byte that is not UTF-8 is a letter of its own, that no pattern names.
struct Letters {
  explicit Letters(std::string_view text);

  std::u32string letters;
  std::vector<std::size_t> offsets;  ///< where each begins, in bytes, and where the last one ends
};

}  // namespace lgs::tiled
