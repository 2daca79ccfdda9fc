#include "oracle/engine/delta.h"

#include "oracle/engine/answer.h"

#include <fmt/format.h>
#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

namespace lgs::oracle {

void Delta::take(SegmentChanges changes) {
  changes_ = std::move(changes);
  wrongId_.clear();
  unchanged_.clear();
  Outline gone, come;
  std::set<std::string_view> listed;
  for (const auto& [sign, id, segment] : changes_) {
    const auto old = segments_.find(id);
    const bool isThere = old != segments_.end();
    const bool isFirst = listed.insert(id).second;
    if (!isFirst || isThere == (sign == '+')) {
      const char* const why = !isFirst  ? "a line before this one has the same id"
                              : isThere ? "this id is taken"
                                        : "there is no such id";
      if (wrongId_.empty()) wrongId_ = fmt::format("'{} {}': {}", sign, shortened(id), why);
      continue;
    }
    if (sign == '~' && old->second == segment) unchanged_.push_back(segment);
    if (sign == '-') gone.push_back(old->second);
    if (sign == '+') come.push_back(segment);
    sign == '-' ? static_cast<void>(segments_.erase(old)) : static_cast<void>(segments_[id] = segment);
  }
  std::ranges::sort(gone);
  std::ranges::sort(come);
  remade_.clear();
  std::ranges::set_intersection(gone, come, std::back_inserter(remade_));
}

Outline Delta::outline() const {
  Outline outline;
  for (const auto& entry : segments_) outline.push_back(entry.second);
  std::ranges::sort(outline);
  return outline;
}

}  // namespace lgs::oracle
