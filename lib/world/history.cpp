#include "world/history.h"

#include "geometry/sort.h"
#include "storage/vectors.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <utility>

namespace lgs::detail {
namespace {

/// The ids that notes name, each once, in their order.
std::vector<std::uint32_t> notedSegments(std::span<const Note> notes, std::span<const Note> more = {}) {
  std::vector<std::uint32_t> ids;
  for (const auto& some : {notes, more})
    for (const Note& note : some)
      if (note.thing == Thing::segment) ids.push_back(note.key);
  sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());  // clang 14 does not take the one of std::ranges
  return ids;
}

}  // namespace

History::History(const History& other, Ground& ground, Outline& outline)
    : ground_(ground),
      outline_(outline),
      marks_(other.marks_),
      ahead_(other.ahead_),
      redoFrom_(other.redoFrom_),
      redoMark_(other.redoMark_),
      redoShapes_(other.redoShapes_),
      undoneShapes_(other.undoneShapes_),
      committed_(other.committed_),
      cellChanges_(other.cellChanges_),
      versionBefore_(other.versionBefore_) {
  for (std::size_t k = marks_.size(); k-- != 0;)
    if (marks_[k].of == Of::group) forget(marks_[k].mark);
}

// --- Marks

Mark History::mark(Of of) {
  const bool isOfGroup = of == Of::group;
  const Mark mark{numbers_.next()};  // greater than all before, also in a copy
  if (committed_ != 0) ground_.journal.hold(committed_);
  marks_.push_back({mark, of, ground_.journal.begin(), committed_, ground_.catalogue.shapeCount(), outline_.state(),
                    isOfGroup ? std::vector<Ground::ChangedCells>() : ground_.changedCells()});
  return mark;
}

std::vector<History::Marked>::const_iterator History::find(Mark mark) const {
  const auto found = std::ranges::lower_bound(marks_, mark, {}, &Marked::mark);
  return found != marks_.end() && found->mark == mark ? found : marks_.end();
}

void History::letGo(const Marked& mark) {
  ground_.letGo(mark.moment);
  if (mark.committed != 0) ground_.letGo(mark.committed);
}

void History::forget(Mark mark) {
  const auto at = find(mark);
  assert(at != marks_.end());
  const Marked gone = *at;
  marks_.erase(at);
  giveBackSpare(marks_);
  if (marks_.empty() || (!ahead_.empty() && ground_.journal.isEarlier(redoFrom_, marks_.front().moment)))
    forgetUndone();
  letGo(gone);
}

// --- Roll-back

void History::rollBack(Mark mark, Undone undone, Changes& changes) {
  assert(knows(mark));
  const Marked& found = *find(mark);
  const bool keeps = keepsAhead(found, undone), isFromRedo = keeps && undone == Undone::keep;
  if (!keeps) forgetUndone();
  dropLaterMarks(mark, undone);
  const Marked& to = marks_.back();
  travel(to, isFromRedo, notedSegments(ground_.journal.since(to.moment)), changes,
         [&](Moment moment) { undo(moment, undone); });
  while (ground_.catalogue.shapeCount() > to.shapes) {
    InternedShape shape = ground_.catalogue.takeShape();
    if (undone == Undone::keep) undoneShapes_.push_back(std::move(shape));
  }
  if (undone == Undone::keep) ahead_.empty() ? forgetUndone() : setRedo(to);
}

/// Marks after this one are void, or ahead.
void History::dropLaterMarks(Mark mark, Undone undone) {
  for (; marks_.back().mark != mark; marks_.pop_back()) {
    if (undone == Undone::keep && marks_.back().of == Of::game)
      ahead_.push_back(std::move(marks_.back()));
    else
      letGo(marks_.back());
  }
}

/// Whether what is ahead stays: the roll-back stops at redoFrom_ or short of it; or it goes beyond, is kept, too, and
/// nothing was edited since.
bool History::keepsAhead(const Marked& to, Undone undone) const {
  if (ahead_.empty()) return false;
  if (undone == Undone::drop) return !ground_.journal.isEarlier(to.moment, redoFrom_);
  return isUnedited() && marks_.back().mark <= redoMark_;
}

void History::setRedo(const Marked& to) {
  if (redoFrom_ != 0) ground_.letGo(redoFrom_);
  redoFrom_ = to.moment;
  redoMark_ = to.mark;
  redoShapes_ = to.shapes;
  ground_.journal.hold(redoFrom_);
}

/// Whether nothing was edited since the last roll-back or redo, nor a shape made.
bool History::isUnedited() const {
  const auto isOfEdit = [](const Note& note) { return note.thing == Thing::cell || note.thing == Thing::chunk; };
  return ground_.catalogue.shapeCount() == redoShapes_ &&
         std::ranges::none_of(ground_.journal.since(redoFrom_), isOfEdit);
}

/// A chunk that was unloaded after an edit made it stays when that is undone. What is ahead may need its number.
bool History::isAhead(Mark mark) const {
  const auto found = std::ranges::find(ahead_, mark, &Marked::mark);
  return found != ahead_.end() && isUnedited() &&
         std::ranges::none_of(ground_.journal.upTo(found->moment), [&](const Note& note) {
           return note.thing == Thing::chunk && !note.isMoot && ground_.grid.stateOf(note.key) != ChunkState::none;
         });
}

void History::redo(Mark mark, Changes& changes) {
  assert(isAhead(mark));
  for (; !marks_.empty() && marks_.back().mark > redoMark_; marks_.pop_back()) letGo(marks_.back());
  do {
    marks_.push_back(std::move(ahead_.back()));
    ahead_.pop_back();
  } while (marks_.back().mark != mark);
  const Marked& to = marks_.back();
  const std::vector ids = notedSegments(ground_.journal.since(redoFrom_), ground_.journal.upTo(to.moment));
  travel(to, true, ids, changes, [&](Moment moment) {
    ground_.journal.redoTo(
        moment, [this](Note& note) { exchange(note); }, [this](const Note& note) { ground_.drop(note); });
  });
  for (; ground_.catalogue.shapeCount() < to.shapes; undoneShapes_.pop_back())
    ground_.catalogue.putShape(std::move(undoneShapes_.back()));
  setRedo(to);
  if (ahead_.empty()) forgetUndone();
}

/// Goes to a mark by go(moment), which exchanges the notes up to a moment; from where the world went last, or from where
/// it is.
template <class Go>
void History::travel(const Marked& to, bool isFromRedo, const std::vector<std::uint32_t>& ids, Changes& changes,
                     Go&& go) {
  const auto before = outline_.seen(ground_.grid, ids);
  const std::uint64_t version = outline_.version();
  ground_.clearChanges();
  cellChanges_.clear();
  if (isFromRedo) returnToRedo();
  if (committed_ != 0) tell(to, go);
  go(to.moment);
  ground_.setChangedCells(to.changed);
  outline_.setState(to.outline);
  changes = {};
  const bool isStreamed = to.changed.empty() && showStreamed();
  constexpr std::array kLists{&Changes::removed, &Changes::added, &Changes::relinked};
  for (const auto list : kLists)  // what is not noted was until then as it was before
    if (isStreamed)
      std::ranges::copy_if(outline_.changes().*list, std::back_inserter(changes.*list),
                           [&](SegmentId id) { return !std::ranges::binary_search(ids, id.value); });
  outline_.compare(ground_.grid, ids, before, changes);
  if (isStreamed && !outline_.hasShownChange()) outline_.setVersion(to.outline.version);  // rims woke, or fell asleep
  for (const auto list : kLists)
    if (isStreamed) detail::sort(changes.*list);
  changes.before = versionBefore_ = version;
  changes.after = outline_.version();
}

/// Followers never saw the edits that are pending, here or there: so they are told what is different between the last
/// commits before the two moments. If these are one (`stay`), only chunks have left or come back since.
template <class Go>
void History::tell(const Marked& to, Go&& go) {
  using enum CellChanges::Way;
  if (to.committed == committed_) return cellChanges_.read(ground_, committed_, stay);
  if (ground_.journal.isAhead(to.committed)) {
    go(to.committed);
    cellChanges_.read(ground_, committed_, forth);
  } else {
    if (!ground_.journal.isAhead(to.moment)) go(committed_);  // undoes what is pending; redo() stands there already
    cellChanges_.read(ground_, to.committed, back);
  }
  ground_.journal.hold(to.committed);
  ground_.letGo(std::exchange(committed_, to.committed));
}

/// Undoes the commits since the last roll-back or redo. Nothing was edited since; but a later commit may have told
/// followers of edits that were pending then. These are not undone, and what followers know is the ground with them.
void History::returnToRedo() {
  if (committed_ > redoFrom_) {
    ground_.journal.hold(redoFrom_);
    ground_.letGo(std::exchange(committed_, redoFrom_));
  }
  undo(redoFrom_, Undone::drop);
  ground_.letGo(std::exchange(redoFrom_, 0));
}

/// Chunks that came or went since the mark are shown and hidden. Whether there are any.
bool History::showStreamed() {
  renewOutline({});
  const bool isDone = noteFound();
  ground_.endCommit();
  freeSleeping();
  return isDone;
}

void History::undo(Moment moment, Undone undone) {
  ground_.journal.undoTo(
      moment, undone, [this](Note& note) { exchange(note); }, [this](const Note& note) { ground_.drop(note); });
}

void History::exchange(Note& note) {
  switch (note.thing) {
    case Thing::list:
      ground_.wake(note.key / kChunkCells);
      [[fallthrough]];
    case Thing::segment:
    case Thing::freeId:
    case Thing::hidden:
      return outline_.exchange(ground_.grid, ground_.journal, note);
    default:
      return ground_.exchange(note);
  }
}

void History::takeBack(Mark mark) {
  assert(knows(mark, Of::group) && !committedSince(mark));
  if (!ahead_.empty() && ground_.journal.isEarlier(find(mark)->moment, redoFrom_)) forgetUndone();
  dropLaterMarks(mark, Undone::drop);
  ground_.takeBack(marks_.back().moment);
  while (ground_.catalogue.shapeCount() > marks_.back().shapes) static_cast<void>(ground_.catalogue.takeShape());
}

void History::forgetUndone() {
  if (redoFrom_ != 0) ground_.letGo(std::exchange(redoFrom_, 0));
  ground_.journal.forgetUndone([this](const Note& note) { ground_.drop(note); });
  for (const Marked& mark : ahead_)
    if (mark.committed != 0 && ground_.journal.has(mark.committed)) ground_.letGo(mark.committed);
  ahead_.clear();
  undoneShapes_.clear();
}

// --- Commits, and followers

/// Frees what takes part in no commit.
void History::freeSleeping() {
  const std::vector<std::uint32_t> chunks = ground_.sleep();
  for (const std::uint32_t chunk : chunks) outline_.lists.forget(chunk);
  if (!chunks.empty() && !hasMarks()) outline_.giveBackPages();
}

/// Whether a commit found something.
bool History::noteFound() {
  const bool hasFound = !ground_.changedChunks().empty();
  if (hasFound) ground_.journal.addOnce(Thing::commit, 0);
  return hasFound;
}

/// While there are marks, or followers.
void History::noteCommit() {
  if (committed_ != 0) cellChanges_.read(ground_, committed_, CellChanges::Way::forth);
  versionBefore_ = outline_.changes().before;
  if (!noteFound() || committed_ == 0) return;
  ground_.letGo(committed_);
  committed_ = ground_.journal.begin();
}

void History::follow(bool follow) {
  if (follow == (committed_ != 0)) return;
  cellChanges_.clear();
  cellChanges_.forgetStreamed();
  versionBefore_ = outline_.version();
  if (follow)
    committed_ = ground_.journal.begin();
  else
    ground_.letGo(std::exchange(committed_, 0));
}

std::uint64_t History::bytes() const {
  std::uint64_t sum = heldBytes(marks_, ahead_, undoneShapes_) + cellChanges_.bytes();
  for (const auto* marks : {&marks_, &ahead_})
    for (const Marked& mark : *marks) sum += heldBytes(mark.changed);
  return sum;
}

}  // namespace lgs::detail
