// Which laws an engine must keep, and which are a recommendation to it.
#pragma once

#include "oracle/check/checker.h"

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace lgs::oracle {

/// Reads "ghosts=should minimality=should": ghosts, blocks, islands, history and minimality may be recommendations.
tl::expected<LawSet, std::string> parseLaws(std::string_view words);

/// The laws that a mismatch breaks.
LawSet brokenBy(const Mismatch& mismatch);

/// Whether these are recommendations, and no others.
inline bool isAdvice(const Mismatch& mismatch, LawSet recommended) {
  return recommended != 0 && (brokenBy(mismatch) & ~recommended) == 0;
}

}  // namespace lgs::oracle
