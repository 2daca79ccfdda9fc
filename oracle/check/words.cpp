// What the results of a check are called.
#include "oracle/check/checker.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {

std::string describe(Mismatch::Kind kind) {
  switch (kind) {
    case Mismatch::Kind::verdict:
      return "an edit was not judged as it must be";
    case Mismatch::Kind::refusal:
      return "a refused edit changed something";
    case Mismatch::Kind::changes:
      return "the change list is wrong";
    case Mismatch::Kind::reading:
      return "the world does not read as it was edited";
    case Mismatch::Kind::naive:
      return "the outline differs from the naive reference's";
    case Mismatch::Kind::cgal:
      return "the outline differs from CGAL's";
    case Mismatch::Kind::loops:
      return "the loops are wrong";
    case Mismatch::Kind::reach:
      return "a brush changed what it does not reach";
    case Mismatch::Kind::rounding:
      return "a brush is too far from the exact result";
    case Mismatch::Kind::history:
      return "the outline depends on the order of the edits";
    case Mismatch::Kind::views:
      return "a view is not that of the world";
    case Mismatch::Kind::terrain:
      return "the terrain is not that of the world";
    case Mismatch::Kind::crash:
      return "there is no answer";
    case Mismatch::Kind::hang:
      return "there is no answer in time";
    case Mismatch::Kind::protocol:
      return "the engine does not keep to the protocol";
  }
  return {};
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
