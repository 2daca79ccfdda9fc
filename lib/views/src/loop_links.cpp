// Links that are gone are cut, links that are new are joined. Each takes O(log n) expected.
#include "loop_view.h"

#include "geometry/sort.h"

#include <algorithm>
#include <cassert>

namespace lgs::detail {

/// The segments of the lists; false where the lists can not be those of the outline.
bool LoopView::read(const World& outline, const Changes& lists) {
  const auto byId = [](std::span<const SegmentId> from, std::vector<SegmentId>& to) {
    to.assign(from.begin(), from.end());
    detail::sort(to, [](SegmentId a, SegmentId b) { return a < b; });
    return std::adjacent_find(to.begin(), to.end()) == to.end();
  };
  if (!byId(lists.removed, removed_) || !byId(lists.added, added_) || !byId(lists.relinked, relinked_)) return false;
  const auto in = [](const std::vector<SegmentId>& list, SegmentId id) {
    return std::binary_search(list.begin(), list.end(), id);
  };
  const auto was = [&](SegmentId id) { return treaps_.has(id.value); };
  const auto stays = [&](SegmentId id) { return was(id) && !in(removed_, id); };
  const auto isGone = [&](SegmentId id) { return was(id) && (in(added_, id) || !outline.segment(id)); };
  if (!std::ranges::all_of(removed_, isGone) || std::ranges::any_of(added_, stays) ||
      !std::ranges::all_of(relinked_, stays))
    return false;

  const std::size_t added = lists.added.size();
  segments_.resize(added + lists.relinked.size());
  if (!outline.segments(lists.added, std::span(segments_).first(added)) ||
      !outline.segments(lists.relinked, std::span(segments_).subspan(added)))
    return false;
  // What is not to be read is beyond the end of what is loaded: chains are open there.
  const auto isLinked = [&](SegmentId id) { return stays(id) || in(added_, id) || !outline.segment(id); };
  return std::ranges::all_of(segments_,
                             [&](const Segment& s) { return isLinked(s.predecessor) && isLinked(s.successor); });
}

bool LoopView::update(const World& outline, const Changes& lists) {
  if (!read(outline, lists)) return false;
  begin();
  treaps_.reserve(outline.maxSegmentId());
  const std::size_t added = lists.added.size();
  cutAll(lists.removed, std::span(segments_).subspan(added));
  dropAll(lists.removed);
  findRests();
  findOpenEnds();
  putAll(std::span(segments_).first(added));
  for (const Segment& s : segments_) {
    join(s.predecessor.value, s.id.value);
    join(s.id.value, s.successor.value);
  }
  nameAll(lists.added);
  return true;
}

void LoopView::begin() {
  changes_.added.clear();
  changes_.removed.clear();
  changes_.changed.clear();
  changes_.split.clear();
  changes_.joined.clear();
  changes_.before.clear();
  changes_.closed.clear();
  ends_.clear();
  rests_.clear();
  gone_.clear();
}

/// First come the links of what is removed. Of a link that is gone between two segments that stay, both are relinked,
/// as each has another ghost: no two segments of now have the same ends. So it is enough to look at what follows.
void LoopView::cutAll(std::span<const SegmentId> removed, std::span<const Segment> relinked) {
  for (const SegmentId id : removed) {
    cutBefore(id.value);
    if (const std::uint32_t after = following(id.value); after != kNoNode) cutBefore(after);
  }
  for (const Segment& s : relinked) {
    const std::uint32_t after = following(s.id.value);
    if (after != kNoNode && after != s.successor.value) cutBefore(after);
  }
}

/// Cuts the link from the segment before this one, if there still is one.
void LoopView::cutBefore(std::uint32_t id) {
  const std::uint32_t root = treaps_.climb(id), loop = treaps_[root].loop;
  const bool wasClosed = treaps_[root].isClosed != 0;
  if (wasClosed) open(root);
  const std::uint32_t before = treaps_.previous(id);
  if (before == kNoNode) {
    if (!wasClosed) return;
    ends_.push_back(treaps_.last(root));
  } else {
    const Treaps::Halves halves = treaps_.splitAfter(before);
    if (wasClosed) {
      setRoot(treaps_.merge(halves.right, halves.left), loop);
    } else {
      setRoot(halves.left, loop);
      setRoot(halves.right, loop);
    }
    ends_.push_back(before);
  }
  ends_.push_back(id);
}

/// The segment that is linked after this one; none, if that link was cut.
std::uint32_t LoopView::following(std::uint32_t id) {
  const std::uint32_t after = treaps_.next(id);
  if (after != kNoNode) return after;
  const std::uint32_t root = treaps_.climb(id);
  return treaps_[root].isClosed != 0 ? treaps_.first(root) : kNoNode;
}

/// Before the first cut of a loop: what it was.
void LoopView::open(std::uint32_t root) {
  changes_.before.push_back(factsOf({treaps_[root].loop}, root));
  treaps_[root].isClosed = 0;
}

void LoopView::setRoot(std::uint32_t root, std::uint32_t loop) {
  treaps_[root].loop = loop;
  treaps_[root].isClosed = 0;
}

void LoopView::dropAll(std::span<const SegmentId> removed) {
  for (const SegmentId id : removed) {
    const LoopNode& n = treaps_[id.value];
    assert(n.count == 1 && n.parent == kNoNode);
    gone_.push_back({n.start, {n.start.x + n.dx, n.start.y + n.dy}, n.loop});
    treaps_.drop(id.value);
  }
  detail::sort(gone_, [](const Gone& a, const Gone& b) { return a < b; });
}

/// What is left of the loops of before: each rest has a cut on both sides.
void LoopView::findRests() {
  for (const std::uint32_t id : ends_) {
    if (!treaps_.has(id)) continue;
    const std::uint32_t root = treaps_.climb(id);
    if (treaps_[root].loop != 0) rests_.push_back({root, treaps_[root].loop, treaps_[root].count});
  }
  detail::sort(rests_, [](const Rest& a, const Rest& b) { return a.node < b.node; });
  const auto same = [](const Rest& a, const Rest& b) { return a.node == b.node; };
  rests_.erase(std::unique(rests_.begin(), rests_.end(), same), rests_.end());
}

/// A chain that led into unloaded ground may close by links alone: where nothing is added, only these name it.
void LoopView::findOpenEnds() {
  openEnds_.clear();
  if (!hasOpen_) return;
  for (const Segment& s : segments_) {
    for (const SegmentId id : {s.predecessor, s.id, s.successor}) {
      if (!treaps_.has(id.value)) continue;
      const LoopNode& root = treaps_[treaps_.climb(id.value)];
      if (root.loop == 0 && root.isClosed == 0) openEnds_.push_back(id.value);
    }
  }
}

/// A new segment with the ends of one that is gone goes on for it: it has another owner, or only another id.
void LoopView::putAll(std::span<const Segment> added) {
  for (const Segment& s : added) {
    treaps_.put(s.id.value, s.start, s.end);
    const auto same = std::lower_bound(gone_.begin(), gone_.end(), Gone{s.start, s.end, 0});
    if (same == gone_.end() || same->start != s.start || same->end != s.end) continue;
    if (same->loop != 0)
      rests_.push_back({s.id.value, same->loop, 1});
    else
      openEnds_.push_back(s.id.value);
  }
}

/// Joins a segment with the one that follows it, if they are not joined yet. One of an unloaded chunk is not here.
void LoopView::join(std::uint32_t a, std::uint32_t b) {
  if (!treaps_.has(a) || !treaps_.has(b) || treaps_.next(a) != kNoNode) return;
  const std::uint32_t first = treaps_.climb(a), second = treaps_.climb(b);
  if (first == second)
    treaps_[first].isClosed = 1;
  else
    setRoot(treaps_.merge(first, second), 0);
}

}  // namespace lgs::detail
