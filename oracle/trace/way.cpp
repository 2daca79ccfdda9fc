#include "oracle/trace/way.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {

std::string print(const Way& way, const Way& plain) {
  if (way == plain) return "";
  std::string text = " by";
  if (way.door != plain.door) text += fmt::format(" {}", describe(way.door));
  if (way.number != 0) text += fmt::format(" {}", way.number);
  if (way.detour != Detour::none) text += fmt::format(" {}", kDetourNames[static_cast<std::size_t>(way.detour)]);
  return text + (way.joins ? " too" : "");
}

bool readWay(std::string_view word, Way& way) {
  const auto door = std::ranges::find(kDoorNames, word);
  const auto detour = std::ranges::find(kDetourNames, word);
  if (door != kDoorNames.end()) way.door = static_cast<Door>(door - kDoorNames.begin());
  if (detour != kDetourNames.end()) way.detour = static_cast<Detour>(detour - kDetourNames.begin());
  way.joins = way.joins || word == "too";
  return door != kDoorNames.end() || detour != kDetourNames.end() || word == "too";
}

}  // namespace lgs::oracle
