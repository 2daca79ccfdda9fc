// What the results of a check are called.
#include "oracle/check/checker.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {

std::string describe(Mismatch::Kind kind) {
  constexpr std::array kWords{"an edit was not judged as it must be",
                              "a refused edit changed something",
                              "the change list is wrong",
                              "the world does not read as it was edited",
                              "the outline differs from the naive reference's",
                              "the outline differs from CGAL's",
                              "the loops are wrong",
                              "a brush changed what it does not reach",
                              "a brush is too far from the exact result",
                              "the outline depends on the order of the edits",
                              "a view is not that of the world",
                              "the terrain is not that of the world",
                              "there is no answer",
                              "there is no answer in time",
                              "the engine does not keep to the protocol"};
  static_assert(kWords.size() == static_cast<std::size_t>(Mismatch::Kind::protocol) + 1);
  return kWords[static_cast<std::size_t>(kind)];
}

std::string doorsInWords(const CheckStats& stats) {
  std::uint64_t all = 0;
  for (const std::uint64_t edits : stats.doors) all += edits;
  std::string text;
  for (std::size_t k = 0; k < kDoors; ++k) {
    if (static_cast<Door>(k) == Door::brush && stats.brushed == 0) continue;  // it is there only if it was asked for
    text +=
        fmt::format("{}{} {:.0f}%", k == 0 ? "" : ", ", describe(static_cast<Door>(k)),
                    100.0 * static_cast<double>(stats.doors[k]) / static_cast<double>(std::max<std::uint64_t>(all, 1)));
  }
  return text;
}

std::string detoursInWords(const CheckStats& stats) {
  std::string text;
  for (std::size_t k = 1; k < kDetours; ++k)
    text += fmt::format("{}{} {}", k == 1 ? "" : ", ", kDetourNames[k], stats.detours[k]);
  return text;
}

}  // namespace lgs::oracle
