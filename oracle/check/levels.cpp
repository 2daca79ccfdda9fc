#include "oracle/check/levels.h"

#include "oracle/reference/compare.h"
#include "oracle/trace/line.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <utility>

namespace lgs::oracle {
namespace {

constexpr LawSet kGhosts = 1, kBlocks = 2, kIslands = 4, kHistory = 8, kMinimality = 16, kOthers = 32;
constexpr std::array<std::pair<std::string_view, LawSet>, 5> kWords{{{"ghosts=should", kGhosts},
                                                                     {"blocks=should", kBlocks},
                                                                     {"islands=should", kIslands},
                                                                     {"history=should", kHistory},
                                                                     {"minimality=should", kMinimality}}};

LawSet brokenBy(const Outline& expected, const Outline& actual) {
  LawSet broken = 0;
  for (const Difference& d : compare(expected, actual)) {
    const bool isGhost = d.kind == Difference::Kind::ghost1 || d.kind == Difference::Kind::ghost2;
    broken |= isGhost ? kGhosts : d.kind == Difference::Kind::block ? kBlocks : kOthers;
  }
  return broken == 0 ? kOthers : broken;
}

}  // namespace

tl::expected<LawSet, std::string> parseLaws(std::string_view words) {
  LawSet recommended = 0;
  for (const std::string_view word : splitWords(words)) {
    const auto known = std::ranges::find(kWords, word, &std::pair<std::string_view, LawSet>::first);
    if (known == kWords.end())
      return tl::unexpected(
          fmt::format("'{}' is no such word; there are ghosts=should, blocks=should, islands=should, "
                      "history=should and minimality=should",
                      word));
    recommended |= known->second;
  }
  return recommended;
}

LawSet brokenBy(const Mismatch& mismatch) {
  switch (mismatch.kind) {
    case Mismatch::Kind::naive:
    case Mismatch::Kind::cgal:
      return brokenBy(mismatch.expected, mismatch.actual);
    case Mismatch::Kind::history: {  // of ghosts alone: then they are wrong in one order
      const LawSet broken = brokenBy(mismatch.expected, mismatch.actual);
      return (broken & kOthers) != 0 ? kHistory : broken;
    }
    case Mismatch::Kind::views:
      return kIslands;
    case Mismatch::Kind::needless:
      return kMinimality;
    default:
      return kOthers;
  }
}

}  // namespace lgs::oracle
