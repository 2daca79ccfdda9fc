// What there is of PCRE2 in the importer. Its interpreter matches, not code that it makes at run time: a hostile
// pattern should meet as little machinery as can be.
#include "regexp.h"

#include "xml.h"

#define PCRE2_CODE_UNIT_WIDTH 8
#include <pcre2.h>
#include <algorithm>
#include <memory>

namespace lgs::tiled {
namespace {

constexpr std::size_t kMaxLength = 1'024;       // of a pattern, in bytes
constexpr std::uint32_t kMaxNesting = 64;       // of groups
constexpr std::uint32_t kMaxTries = 1'000'000;  // of a match from one letter on, and how deep they may nest
constexpr std::uint32_t kMaxKibibytes = 4'096;  // of a match

template <class T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

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

tl::expected<std::vector<Fit>, std::string> namesThatFit(std::string_view pattern,
                                                         const std::vector<std::string>& names,
                                                         std::uint64_t& stepsLeft) {
  if (pattern.size() > kMaxLength) return tl::unexpected(concat("has more than ", kMaxLength, " bytes"));
  const Owned<pcre2_compile_context> nesting(pcre2_compile_context_create(nullptr), pcre2_compile_context_free);
  pcre2_set_parens_nest_limit(nesting.get(), kMaxNesting);
  int error = 0;
  PCRE2_SIZE at = 0;
  // A text that is not UTF-8 is matched all the same: a name of a file may have any bytes.
  constexpr std::uint32_t kOptions = PCRE2_UTF | PCRE2_MATCH_INVALID_UTF | PCRE2_NEVER_BACKSLASH_C | PCRE2_AUTO_CALLOUT;
  const Owned<pcre2_code> code(pcre2_compile(unitsOf(pattern), pattern.size(), kOptions, &error, &at, nesting.get()),
                               pcre2_code_free);
  if (!code) return tl::unexpected(concat("is wrong at byte ", at + 1, ": ", textOf(error)));
  std::uint32_t captures = 0;
  pcre2_pattern_info(code.get(), PCRE2_INFO_CAPTURECOUNT, &captures);
  if (captures != 2)
    return tl::unexpected(concat("has ", captures, " captures. It needs two: (…) for the column and (…) for the row"));
  const Owned<pcre2_match_context> limits(pcre2_match_context_create(nullptr), pcre2_match_context_free);
  pcre2_set_match_limit(limits.get(), kMaxTries);
  pcre2_set_depth_limit(limits.get(), kMaxTries);
  pcre2_set_heap_limit(limits.get(), kMaxKibibytes);
  pcre2_set_callout(limits.get(), takeStep, &stepsLeft);
  const Owned<pcre2_match_data> data(pcre2_match_data_create_from_pattern(code.get(), nullptr), pcre2_match_data_free);
  std::vector<Fit> fits;
  for (const std::string& name : names) {
    stepsLeft -= std::min<std::uint64_t>(stepsLeft, name.size());
    const int found = pcre2_match(code.get(), unitsOf(name), name.size(), 0, PCRE2_NO_JIT, data.get(), limits.get());
    if (found == PCRE2_ERROR_NOMATCH) continue;
    if (found < 0)
      return tl::unexpected(concat("takes too long to match: ", textOf(found), "; the file is ", inQuotes(name)));
    Fit& fit = fits.emplace_back(Fit{name, {}});
    const PCRE2_SIZE* const ends = pcre2_get_ovector_pointer(data.get());
    for (std::size_t k = 0; k + 1 < static_cast<std::size_t>(found); ++k) {
      const PCRE2_SIZE begin = ends[2 * k + 2], end = ends[2 * k + 3];
      if (begin != PCRE2_UNSET) fit.captures[k] = name.substr(begin, end - begin);
    }
  }
  return fits;
}

}  // namespace lgs::tiled
