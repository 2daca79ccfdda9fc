// What there is of PCRE2 in the importer. Its interpreter matches, not code that it makes at run time: a hostile
// pattern should meet as little machinery as can be.
#include "regexp.h"

#define PCRE2_CODE_UNIT_WIDTH 8
#include <pcre2.h>
#include <algorithm>

namespace lgs::tiled {
namespace {

constexpr std::uint32_t kMaxNesting = 64;       // of groups
constexpr std::uint32_t kMaxTries = 1'000'000;  // of a match from one letter on, and how deep they may nest
constexpr std::uint32_t kMaxKibibytes = 4'096;  // of a match

struct Free {
  void operator()(pcre2_compile_context* context) const { pcre2_compile_context_free(context); }
  void operator()(pcre2_match_context* context) const { pcre2_match_context_free(context); }
  void operator()(pcre2_match_data* data) const { pcre2_match_data_free(data); }
};

std::string textOf(int error) {
  std::array<PCRE2_UCHAR, 256> text{};
  pcre2_get_error_message(error, text.data(), text.size());
  return reinterpret_cast<const char*>(text.data());
}

const PCRE2_UCHAR* unitsOf(std::string_view text) { return reinterpret_cast<const PCRE2_UCHAR*>(text.data()); }

/// PCRE2 calls this before each item of a pattern that it tries. A number below 0 ends the match.
int takeStep(pcre2_callout_block*, void* stepsLeft) {
  auto& left = *static_cast<std::uint64_t*>(stepsLeft);
  if (left == 0) return PCRE2_ERROR_MATCHLIMIT;
  --left;
  return 0;
}

}  // namespace

tl::expected<Regexp, std::string> Regexp::parse(std::string_view pattern) {
  if (pattern.size() > kMaxLength) return tl::unexpected("has more than " + std::to_string(kMaxLength) + " bytes");
  const std::unique_ptr<pcre2_compile_context, Free> limits(pcre2_compile_context_create(nullptr));
  pcre2_set_parens_nest_limit(limits.get(), kMaxNesting);
  int error = 0;
  PCRE2_SIZE at = 0;
  // A text that is not UTF-8 is matched all the same: a name of a file may have any bytes.
  constexpr std::uint32_t kOptions = PCRE2_UTF | PCRE2_MATCH_INVALID_UTF | PCRE2_NEVER_BACKSLASH_C | PCRE2_AUTO_CALLOUT;
  Regexp result;
  result.code_ = {pcre2_compile(unitsOf(pattern), pattern.size(), kOptions, &error, &at, limits.get()),
                  [](void* code) { pcre2_code_free(static_cast<pcre2_code*>(code)); }};
  if (!result.code_) return tl::unexpected("is wrong at byte " + std::to_string(at + 1) + ": " + textOf(error));
  std::uint32_t captures = 0;
  pcre2_pattern_info(static_cast<pcre2_code*>(result.code_.get()), PCRE2_INFO_CAPTURECOUNT, &captures);
  result.captures_ = captures;
  return result;
}

tl::expected<Regexp::Match, std::string> Regexp::match(std::string_view text, std::uint64_t& stepsLeft) const {
  const auto* const code = static_cast<const pcre2_code*>(code_.get());
  const std::unique_ptr<pcre2_match_context, Free> limits(pcre2_match_context_create(nullptr));
  pcre2_set_match_limit(limits.get(), kMaxTries);
  pcre2_set_depth_limit(limits.get(), kMaxTries);
  pcre2_set_heap_limit(limits.get(), kMaxKibibytes);
  pcre2_set_callout(limits.get(), takeStep, &stepsLeft);
  const std::unique_ptr<pcre2_match_data, Free> data(pcre2_match_data_create_from_pattern(code, nullptr));
  stepsLeft -= std::min<std::uint64_t>(stepsLeft, text.size());
  const int found = pcre2_match(code, unitsOf(text), text.size(), 0, PCRE2_NO_JIT, data.get(), limits.get());
  if (found == PCRE2_ERROR_NOMATCH) return Match{};
  if (found < 0) return tl::unexpected("takes too long to match: " + textOf(found));
  Match result{true, {}};
  const PCRE2_SIZE* const ends = pcre2_get_ovector_pointer(data.get());
  for (std::size_t k = 0; k < std::min(kKept, static_cast<std::size_t>(found) - 1); ++k) {
    const PCRE2_SIZE begin = ends[2 * k + 2], end = ends[2 * k + 3];
    if (begin != PCRE2_UNSET) result.captures[k] = text.substr(begin, end - begin);
  }
  return result;
}

}  // namespace lgs::tiled
