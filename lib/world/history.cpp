#include "world/history.h"

#include <algorithm>

namespace lgs::detail {

History::History(const History& other, Ground& ground, Outline& outline)
    : ground_(ground), outline_(outline), marks_(other.marks_) {
  std::erase_if(marks_, [](const Marked& m) { return m.ofGroup; });
  forgetNotes();
}

Mark History::mark(bool ofGroup) {
  ground_.startNoting(Ground::For::marks);
  outline_.startNoting();
  const Mark mark{numbers_.next()};  // greater than all before, also in a copy
  marks_.push_back({mark, ground_.now(), outline_.now(), outline_.version(), ofGroup});
  return mark;
}

std::vector<History::Marked>::const_iterator History::find(Mark mark) const {
  const auto found = std::ranges::lower_bound(marks_, mark, {}, &Marked::mark);
  return found != marks_.end() && found->mark == mark ? found : marks_.end();
}

void History::rollBack(Mark mark, Changes& changes) {
  const auto to = find(mark);
  outline_.goBack(ground_.grid, to->outline, to->version, changes);
  ground_.rollBack(to->ground);
  marks_.erase(to + 1, marks_.end());
}

void History::takeBack(Mark mark) {
  const auto to = find(mark);
  ground_.goBack(to->ground);
  marks_.erase(to + 1, marks_.end());
}

void History::forget(Mark mark) {
  marks_.erase(find(mark));
  forgetNotes();
}

/// Those that no mark needs.
void History::forgetNotes() {
  if (marks_.empty()) {
    ground_.stopNoting(Ground::For::marks);
    outline_.stopNoting();
  } else {
    ground_.forgetBefore(marks_.front().ground);
    outline_.forgetBefore(marks_.front().outline);
  }
}

}  // namespace lgs::detail
