// Which loop of now is which of before.
#include "loop_view.h"

#include "geometry/sort.h"

#include <algorithm>
#include <tuple>

namespace lgs::detail {

namespace {

/// With which a chain begins that comes from an unloaded chunk; of a closed one any.
SegmentId firstOfChain(const World& outline, SegmentId start) {
  SegmentId first = start;
  for (auto s = outline.segment(start); s; s = outline.segment(s->predecessor)) {
    first = s->id;
    if (s->predecessor == start) return start;
  }
  return first;
}

}  // namespace

void LoopView::load(const World& outline) {
  treaps_.reserve(outline.maxSegmentId());
  std::vector<std::uint32_t> ids;
  for (const SegmentId start : outline.segments()) {
    if (treaps_.has(start.value)) continue;
    ids.clear();
    const SegmentId first = firstOfChain(outline, start);
    auto s = outline.segment(first);
    do {
      treaps_.put(s->id.value, s->start, s->end);
      ids.push_back(s->id.value);
      s = outline.segment(s->successor);
    } while (s && s->id != first);
    const std::uint32_t root = treaps_.build(ids);
    treaps_[root].isClosed = s ? 1 : 0;
    if (s)
      newId(root);
    else
      hasOpen_ = true;
  }
}

std::vector<LoopId> LoopView::all() const {
  std::vector<LoopId> out;
  for (std::uint32_t id = 1; id < roots_.size(); ++id)
    if (roots_[id] != kNoNode) out.push_back({id});
  return out;
}

void LoopView::nameAll(std::span<const SegmentId> added) {
  detail::sort(changes_.before, [](const LoopFacts& a, const LoopFacts& b) { return a.id < b.id; });
  for (Rest& rest : rests_) rest.node = treaps_.climb(rest.node);
  made_.clear();
  for (const Rest& rest : rests_) made_.push_back(rest.node);
  for (const SegmentId id : added) made_.push_back(treaps_.climb(id.value));
  for (std::uint32_t& end : openEnds_) made_.push_back(end = treaps_.climb(end));
  detail::sort(made_);
  made_.erase(std::unique(made_.begin(), made_.end()), made_.end());
  for (const std::uint32_t root : made_) treaps_[root].loop = 0;
  const auto isOpen = [this](std::uint32_t root) { return treaps_[root].isClosed == 0; };
  if (std::erase_if(made_, isOpen) > 0) hasOpen_ = true;  // they lead into unloaded chunks
  std::erase_if(rests_, [&](const Rest& rest) { return isOpen(rest.node); });
  findShares();
  findHeirs();
  tell();
  for (const std::uint32_t root : openEnds_)
    if (treaps_[root].isClosed != 0) changes_.closed.push_back({treaps_[root].loop});
  detail::sort(changes_.closed);
  changes_.closed.erase(std::unique(changes_.closed.begin(), changes_.closed.end()), changes_.closed.end());
}

void LoopView::findShares() {
  shares_.clear();
  for (const Rest& rest : rests_) shares_.push_back({rest.loop, rest.node, rest.count});
  detail::sort(shares_, [](const Share& a, const Share& b) {
    return std::tie(a.loop, a.root, a.count) < std::tie(b.loop, b.root, b.count);
  });
  std::size_t last = 0;
  for (std::size_t k = 1; k < shares_.size(); ++k) {
    if (shares_[k].loop == shares_[last].loop && shares_[k].root == shares_[last].root)
      shares_[last].count += shares_[k].count;
    else
      shares_[++last] = shares_[k];
  }
  if (!shares_.empty()) shares_.resize(last + 1);
}

const LoopFacts& LoopView::before(std::uint32_t loop) const {
  return *std::lower_bound(changes_.before.begin(), changes_.before.end(), loop,
                           [](const LoopFacts& f, std::uint32_t id) { return f.id.value < id; });
}

/// Of two shares of one loop: which has the better claim on its id.
bool LoopView::isBetter(const Share& a, const Share& b) const {
  if (a.count != b.count) return a.count > b.count;
  const LoopNode &m = treaps_[a.root], &n = treaps_[b.root];
  if (m.west != n.west || m.doubleArea != n.doubleArea)
    return std::tie(m.west, m.doubleArea) < std::tie(n.west, n.doubleArea);
  return treaps_.westernmost(a.root) < treaps_.westernmost(b.root);
}

void LoopView::findHeirs() {
  heirs_.clear();
  for (auto share = shares_.begin(); share != shares_.end();) {
    const LoopFacts& old = before(share->loop);
    const Share* best = nullptr;
    for (; share != shares_.end() && share->loop == old.id.value; ++share) {
      const bool sameKind = treaps_[share->root].doubleArea.isNegative() == old.isHole();
      if (sameKind && (best == nullptr || isBetter(*share, *best))) best = &*share;
    }
    if (best != nullptr) heirs_.push_back({best->loop, best->root, old.segments});
  }
  detail::sort(heirs_, [](const Share& a, const Share& b) {
    return a.root != b.root ? a.root < b.root : a.count != b.count ? a.count > b.count : a.loop < b.loop;
  });
  for (const Share& heir : heirs_) {
    LoopNode& root = treaps_[heir.root];
    if (root.loop == 0) root.loop = heir.loop;
  }
}

void LoopView::tell() {
  for (const LoopFacts& old : changes_.before) roots_[old.id.value] = kNoNode;
  for (const std::uint32_t root : made_)
    if (treaps_[root].loop != 0) roots_[treaps_[root].loop] = root;
  for (const LoopFacts& old : changes_.before) {
    const bool stays = roots_[old.id.value] != kNoNode;
    (stays ? changes_.changed : changes_.removed).push_back(old.id);
  }
  for (const std::uint32_t root : made_)
    if (treaps_[root].loop == 0) changes_.added.push_back(newId(root));
  detail::sort(changes_.added);
  for (const LoopId id : changes_.removed) free_.push_back(id.value);  // for the next update: all new ids are given
  const auto isIn = [](const std::vector<LoopId>& ids, LoopId id) {
    return std::binary_search(ids.begin(), ids.end(), id);
  };
  named_.clear();
  for (const Share& share : shares_) {
    const LoopPair pair{{share.loop}, {treaps_[share.root].loop}};
    const bool isNew = isIn(changes_.added, pair.into), isOver = isIn(changes_.removed, pair.from);
    if (isNew) changes_.split.push_back(pair);
    if (isOver) changes_.joined.push_back(pair);
    if (isNew) named_.push_back(pair.into);
    if (isOver) named_.push_back(pair.from);
  }
  detail::sort(changes_.split);
  detail::sort(changes_.joined);
  detail::sort(named_);
  // What is named in a pair did not come from nothing, nor go for nothing.
  for (auto* ids : {&changes_.added, &changes_.removed})
    std::erase_if(*ids, [&](LoopId id) { return isIn(named_, id); });
}

LoopId LoopView::newId(std::uint32_t root) {
  std::uint32_t id = static_cast<std::uint32_t>(roots_.size());
  if (free_.empty()) {
    roots_.push_back(root);
  } else {
    id = free_.back();
    free_.pop_back();
    roots_[id] = root;
  }
  treaps_[root].loop = id;
  return {id};
}

LoopFacts LoopView::factsOf(LoopId id, std::uint32_t root) const {
  const LoopNode& n = treaps_[root];
  return {.id = id,
          .doubleArea = n.doubleArea,
          .segments = n.count,
          .min = {n.west.x, n.minY},
          .max = n.max,
          .west = n.west,
          .first = {treaps_.westernmost(root)}};
}

}  // namespace lgs::detail
