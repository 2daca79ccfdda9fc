// Rules 1 and 2 of edges.h: from segments to strips, from strips to edges.
#include "geometry/predicates.h"

#include <lgs/box2d/edges.h>

#include <algorithm>

namespace lgs::box2d {

using detail::operator-;  // NOLINT(misc-unused-using-decls): a template below uses it

// A segment of the world; none, too, if its chunk is unloaded.
const Segment* EdgeSet::find(SegmentId id) {
  constexpr std::size_t kPage = 64;
  const auto place = [&](std::size_t k) -> Segment& { return reads_[k / kPage][k % kPage]; };
  Record& record = records_[id.value];
  if (record.read < readCount_ && place(record.read).id == id) return &place(record.read);
  const auto found = world_->segment(id);
  if (!found) return nullptr;
  if (readCount_ == kPage * reads_.size()) reads_.emplace_back(kPage);
  record.read = static_cast<std::uint32_t>(readCount_++);
  return &(place(record.read) = *found);
}

// Else an update of all segments would have a copy of all. It is called between two groups, where nobody holds a pointer
// to one that was read.
void EdgeSet::forgetReads() {
  constexpr std::size_t kMost = 1'024;
  if (readCount_ > kMost) readCount_ = 0;
}

const Segment* EdgeSet::neighbour(const Segment& s, Way way) {
  const bool isBefore = way == Way::before;
  const Segment* const other = find(isBefore ? s.predecessor : s.successor);
  return other && (isBefore ? other->successor : other->predecessor) == s.id ? other : nullptr;
}

// Whether two neighbours belong to one strip.
bool EdgeSet::straight(const Segment& a, const Segment& b) const {
  if (!detail::sameDirection(a.end - a.start, b.end - b.start)) return false;
  const Frame frame{1, {}, options_.chunkCells};
  if (frame.chunkOf(a.cell) != frame.chunkOf(b.cell)) return false;
  return a.block == b.block || !options_.material || options_.material(a.block) == options_.material(b.block);
}

// The first or the last segment of the strip that s is in.
const Segment& EdgeSet::stripEnd(const Segment& from, Way way) {
  const Segment* s = &from;
  while (options_.merge) {
    const Segment* const next = neighbour(*s, way);
    if (!next || !straight(*s, *next)) break;
    s = next;
  }
  return *s;
}

// One strip spans at most a chunk, and strips since the last edge hardly more than `shortest`: squares fit in 64 bits.
bool EdgeSet::isShort(Point from, Point to) const {
  const detail::Vector v = to - from;
  return dot(v, v) < options_.shortest * options_.shortest;
}

// Whether a ghost beside an end of an edge is another one to a physics engine.
bool EdgeSet::isTurned(const std::optional<Point>& before, const std::optional<Point>& now, Point end) const {
  if (before == now) return false;
  if (!before || !now || isShort(*before, end) || isShort(*now, end)) return true;
  return !detail::sameDirection(*before - end, *now - end);
}

// Works out the edges of the group that a segment is in. A group is one strip that is long enough, or all short strips
// in a row.
void EdgeSet::renew(SegmentId id) {
  gather(id);
  bool wasShort = false;
  for (const Segment* s : group_) {
    Record& record = records_[s->id.value];
    wasShort = wasShort || record.fate == Fate::welded || record.fate == Fate::leftOut;
    record.renewed = update_;
    record.predecessor = s->predecessor.value;
    record.successor = s->successor.value;
    retire(record.edge);
  }
  ends_.emplace_back(group_.front()->id, group_.back()->id);
  const std::size_t last = group_.size() - 1;
  if (strips_.size() > 1 || isShort(group_[0]->start, group_[last]->end)) {
    weld();
  } else {
    if (wasShort) {  // the strip has grown. The short strips beside it were of its group and are not any more
      seed(group_.front()->predecessor);
      seed(group_.back()->successor);
    }
    place(0, last, last == 0 ? Fate::single : Fate::merged);
  }
}

// Fills group_ and strips_ with the group that a segment is in.
void EdgeSet::gather(SegmentId id) {
  group_.clear();
  strips_.clear();
  const Segment* const begin = &stripEnd(read(id), Way::before);
  if (!isShort(begin->start, stripEnd(*begin, Way::after).end)) return gatherStrip(*begin);

  const Segment* first = begin;
  bool ring = false;
  while (const Segment* const previous = neighbour(*first, Way::before)) {
    const Segment* const start = &stripEnd(*previous, Way::before);
    if (!isShort(start->start, previous->end)) break;
    ring = start == begin;
    first = start;
    if (ring) break;
  }
  const Segment* const end = first;
  do {
    gatherStrip(*first);
    first = neighbour(*group_.back(), Way::after);
  } while (first && first != end && isShort(first->start, stripEnd(*first, Way::after).end));
  if (ring) startRingAtLeast();
}

void EdgeSet::gatherStrip(const Segment& first) {
  const std::size_t begin = group_.size();
  group_.push_back(&first);
  while (options_.merge) {
    const Segment* const next = neighbour(*group_.back(), Way::after);
    if (!next || !straight(*group_.back(), *next)) break;
    group_.push_back(next);
  }
  strips_.push_back({begin, group_.size() - 1});
}

// A ring of short strips has no first one. It begins with the least, so that the edges do not depend on the seed.
void EdgeSet::startRingAtLeast() {
  const auto ends = [&](const Strip& s) { return std::pair(group_[s.first]->start, group_[s.first]->end); };
  const auto least = std::min_element(strips_.begin(), strips_.end(),
                                      [&](const Strip& a, const Strip& b) { return ends(a) < ends(b); });
  const std::size_t shift = least->first;
  std::rotate(group_.begin(), group_.begin() + static_cast<std::ptrdiff_t>(shift), group_.end());
  std::rotate(strips_.begin(), least, strips_.end());
  for (Strip& s : strips_) {
    s.first = (s.first + group_.size() - shift) % group_.size();
    s.last = (s.last + group_.size() - shift) % group_.size();
  }
}

void EdgeSet::weld() {
  std::optional<Strip> edge;  // the last one, which may grow
  std::size_t first = 0;      // of the segments since then
  for (const Strip& strip : strips_) {
    if (isShort(group_[first]->start, group_[strip.last]->end)) continue;
    if (edge) place(edge->first, edge->last, Fate::welded);
    edge = {first, strip.last};
    first = strip.last + 1;
  }
  if (edge && !isShort(group_[edge->first]->start, group_.back()->end)) {
    edge->last = group_.size() - 1;
    first = group_.size();
  }
  if (edge) place(edge->first, edge->last, Fate::welded);
  for (; first < group_.size(); ++first) {
    Record& record = records_[group_[first]->id.value];
    record.edge = 0;
    setFate(record, Fate::leftOut);
  }
}

}  // namespace lgs::box2d
