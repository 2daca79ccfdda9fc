// What the results of a check are called.
#include "oracle/check/checker.h"
#include "oracle/trace/call_text.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {

std::string describe(Mismatch::Kind kind) {
  constexpr std::array kWords{"a call was not answered as it must be",
                              "a refused edit changed something",
                              "the change list is wrong",
                              "the change list reports what did not change",
                              "the world does not read as it was edited",
                              "the outline differs from the naive reference's",
                              "the outline differs from CGAL's",
                              "the loops are wrong",
                              "a brush changed what it does not reach",
                              "a region is too far from the exact result",
                              "the outline depends on the order of the edits",
                              "what was undone has left a trace",
                              "what went has left something",
                              "a view is not that of the world",
                              "the terrain is not that of the world",
                              "there is no answer",
                              "there is no answer in time",
                              "the engine does not keep to the protocol"};
  static_assert(kWords.size() == static_cast<std::size_t>(Mismatch::Kind::protocol) + 1);
  return kWords[static_cast<std::size_t>(kind)];
}

std::string callsInWords(const CheckStats& stats) {
  std::uint64_t all = 0;
  for (const std::uint64_t calls : stats.made) all += calls;
  std::string text;
  for (std::size_t k = 0; k < Call::kKinds; ++k) {
    if (stats.made[k] == 0) continue;
    text += fmt::format("{}{} {:.1f}%", text.empty() ? "" : ", ", wordFor(static_cast<Call::Kind>(k)),
                        100.0 * static_cast<double>(stats.made[k]) / static_cast<double>(all));
  }
  return text;
}

}  // namespace lgs::oracle
