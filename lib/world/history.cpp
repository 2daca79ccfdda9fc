#include "world/history.h"

#include <algorithm>
#include <iterator>

namespace lgs::detail {

History::History(const History& other, Ground& ground, Outline& outline)
    : ground_(ground), outline_(outline), marks_(other.marks_), ahead_(other.ahead_), went_(other.went_) {
  std::erase_if(marks_, [](const Marked& m) { return m.ofGroup; });
  forgetNotes();
}

Mark History::mark(bool ofGroup) {
  ground_.notes.start(CellNotes::For::marks);
  outline_.notes.start();
  const Mark mark{numbers_.next()};  // greater than all before, also in a copy
  marks_.push_back({mark, ground_.notes.now(), outline_.notes.now(), outline_.version(), ofGroup});
  return mark;
}

std::vector<History::Marked>::const_iterator History::find(Mark mark) const {
  const auto found = std::ranges::lower_bound(marks_, mark, {}, &Marked::mark);
  return found != marks_.end() && found->mark == mark ? found : marks_.end();
}

void History::rollBack(Mark mark, Undone undone, Changes& changes) {
  if (!ahead_.empty()) leave(*find(mark), undone);
  const auto to = find(mark);
  outline_.goBack(ground_.grid, to->outline, to->version, undone, changes);
  ground_.notes.rollBack(to->ground, undone);
  if (undone == Undone::keep) {
    std::copy_if(marks_.crbegin(), std::make_reverse_iterator(to + 1), std::back_inserter(ahead_),
                 [](const Marked& m) { return !m.ofGroup; });
    went_ = *to;
    if (ahead_.empty()) forgetUndone();
  }
  marks_.erase(to + 1, marks_.end());
}

/// Before it goes back: what is ahead stays if the world goes no further than to where it went, or goes further from
/// there and keeps that, too.
void History::leave(const Marked& to, Undone undone) {
  if (undone == Undone::keep) {
    const bool goesOn = isWhereItWent() && marks_.back().mark <= went_.mark;
    goesOn ? returnToWhereItWent() : forgetUndone();
  } else if (to.ground.notes < went_.ground.notes || to.outline < went_.outline) {
    forgetUndone();
  }
}

bool History::isAhead(Mark mark) const {
  return std::ranges::find(ahead_, mark, &Marked::mark) != ahead_.end() && isWhereItWent();
}

void History::rollForward(Mark mark, Changes& changes) {
  returnToWhereItWent();
  while (went_.mark != mark) {
    went_ = ahead_.back();
    ahead_.pop_back();
    marks_.push_back(went_);
  }
  ground_.notes.rollForward(went_.ground);
  outline_.goForward(ground_.grid, went_.outline, went_.version, changes);
  if (ahead_.empty()) forgetUndone();
}

/// Whether nothing was edited since the world went back or forward, nor a shape made. A commit that found nothing does
/// no harm.
bool History::isWhereItWent() const {
  const CellNotes::Moment now = ground_.notes.now();
  return now.notes == went_.ground.notes && now.shapes == went_.ground.shapes;
}

/// Takes back commits that found nothing, and marks that were made since.
void History::returnToWhereItWent() {
  Changes none;
  outline_.goBack(ground_.grid, went_.outline, outline_.version(), Undone::drop, none);
  std::erase_if(marks_, [&](const Marked& m) { return m.mark > went_.mark; });
}

void History::forgetUndone() {
  ahead_.clear();
  ground_.notes.forgetUndone();
  outline_.forgetUndone();
}

void History::squeeze() {
  const bool isRedoLater = !ahead_.empty() && went_.mark > marks_.back().mark;
  const Marked& last = isRedoLater ? went_ : marks_.back();
  ground_.notes.squeeze(last.ground);
  outline_.notes.squeeze(last.outline);
}

void History::takeBack(Mark mark) {
  const auto to = find(mark);
  if (!ahead_.empty() && to->ground.notes < went_.ground.notes) forgetUndone();
  ground_.notes.goBack(to->ground);
  marks_.erase(to + 1, marks_.end());
}

void History::forget(Mark mark) {
  marks_.erase(find(mark));
  forgetNotes();
}

/// Those that no mark needs.
void History::forgetNotes() {
  if (marks_.empty()) {
    forgetUndone();
    ground_.notes.stop(CellNotes::For::marks);
    outline_.notes.stop();
  } else {
    const Marked& first = marks_.front();
    if (first.ground.notes > went_.ground.notes || first.outline > went_.outline) forgetUndone();
    ground_.notes.forgetBefore(first.ground);
    outline_.notes.forgetBefore(first.outline);
  }
}

}  // namespace lgs::detail
