#include "treap.h"

#include <algorithm>

namespace lgs::detail {
namespace {

/// The finalizer of MurmurHash3: no two ids have the same.
constexpr std::uint32_t priority(std::uint32_t id) {
  id ^= id >> 16;
  id *= 0x85eb'ca6bU;
  id ^= id >> 13;
  id *= 0xc2b2'ae35U;
  return id ^ (id >> 16);
}

}  // namespace

void Treaps::reserve(std::uint32_t maxId) {
  if (nodes_.size() <= maxId) nodes_.resize(std::size_t{maxId} + 1);
}

void Treaps::put(std::uint32_t id, Point start, Point end) {
  LoopNode& n = nodes_[id];
  n = {};
  n.start = start;
  n.dx = static_cast<std::int32_t>(end.x - start.x);
  n.dy = static_cast<std::int32_t>(end.y - start.y);
  pull(id);
}

/// The sums of a node: its own, and those of the two below.
void Treaps::pull(std::uint32_t id) {
  ++visited_;
  LoopNode& n = nodes_[id];
  const LoopNode &l = nodes_[n.left], &r = nodes_[n.right];
  n.count = l.count + r.count + 1;
  // The cross product of both ends is that of the start and the way to the end.
  n.doubleArea = l.doubleArea + r.doubleArea + (lgs::multiply(n.start.x, n.dy) - lgs::multiply(n.start.y, n.dx));
  n.west = std::min({n.start, l.west, r.west});
  n.minY = std::min({n.start.y, l.minY, r.minY});
  n.max = {std::max({n.start.x, l.max.x, r.max.x}), std::max({n.start.y, l.max.y, r.max.y})};
}

void Treaps::pullUp(std::uint32_t id) {
  for (; id != kNoNode; id = nodes_[id].parent) pull(id);
}

// The nodes of the right spine wait until all that is below them is there (Vuillemin: A unifying look at data
// structures, 1980).
std::uint32_t Treaps::build(std::span<const std::uint32_t> ids) {
  spine_.clear();
  for (const std::uint32_t id : ids) {
    std::uint32_t below = kNoNode;
    while (!spine_.empty() && priority(spine_.back()) < priority(id)) {
      below = spine_.back();
      pull(below);
      spine_.pop_back();
    }
    nodes_[id].left = below;
    if (below != kNoNode) nodes_[below].parent = id;
    if (!spine_.empty()) {
      nodes_[spine_.back()].right = id;
      nodes_[id].parent = spine_.back();
    }
    spine_.push_back(id);
  }
  for (std::size_t k = spine_.size(); k > 0; --k) pull(spine_[k - 1]);
  return spine_.front();
}

std::uint32_t Treaps::root(std::uint32_t id) const {
  while (nodes_[id].parent != kNoNode) id = nodes_[id].parent;
  return id;
}

std::uint32_t Treaps::westernmost(std::uint32_t root) const {
  const Point west = nodes_[root].west;
  for (std::uint32_t at = root;;) {
    const LoopNode& n = nodes_[at];
    if (n.left != kNoNode && nodes_[n.left].west == west)
      at = n.left;
    else if (n.start == west)
      return at;
    else
      at = n.right;
  }
}

std::uint32_t Treaps::climb(std::uint32_t id) {
  for (++visited_; nodes_[id].parent != kNoNode; ++visited_) id = nodes_[id].parent;
  return id;
}

std::uint32_t Treaps::first(std::uint32_t root) {
  for (++visited_; nodes_[root].left != kNoNode; ++visited_) root = nodes_[root].left;
  return root;
}

std::uint32_t Treaps::last(std::uint32_t root) {
  for (++visited_; nodes_[root].right != kNoNode; ++visited_) root = nodes_[root].right;
  return root;
}

std::uint32_t Treaps::next(std::uint32_t id) {
  if (const std::uint32_t right = nodes_[id].right; right != kNoNode) return first(right);
  for (;; ++visited_) {
    const std::uint32_t up = nodes_[id].parent;
    if (up == kNoNode || nodes_[up].left == id) return up;
    id = up;
  }
}

std::uint32_t Treaps::previous(std::uint32_t id) {
  if (const std::uint32_t left = nodes_[id].left; left != kNoNode) return last(left);
  for (;; ++visited_) {
    const std::uint32_t up = nodes_[id].parent;
    if (up == kNoNode || nodes_[up].right == id) return up;
    id = up;
  }
}

std::uint32_t Treaps::merge(std::uint32_t a, std::uint32_t b) {
  if (a == kNoNode || b == kNoNode) return a == kNoNode ? b : a;
  const std::uint32_t top = priority(a) > priority(b) ? a : b;
  std::uint32_t above = kNoNode;
  bool isRight = false;  // where the next node goes below the one above
  const auto attach = [&](std::uint32_t id) {
    nodes_[id].parent = above;
    if (above != kNoNode) (isRight ? nodes_[above].right : nodes_[above].left) = id;
    above = id;
  };
  while (a != kNoNode && b != kNoNode) {
    const bool isA = priority(a) > priority(b);
    attach(isA ? a : b);
    isRight = isA;
    std::uint32_t& from = isA ? a : b;
    from = isA ? nodes_[from].right : nodes_[from].left;
  }
  const std::uint32_t lowest = above;
  attach(a != kNoNode ? a : b);
  pullUp(lowest);
  return top;
}

Treaps::Halves Treaps::splitAfter(std::uint32_t id) {
  Halves halves{id, nodes_[id].right};
  std::uint32_t up = nodes_[id].parent;
  nodes_[id].right = kNoNode;
  pull(id);
  for (std::uint32_t below = id; up != kNoNode;) {
    LoopNode& n = nodes_[up];
    const std::uint32_t further = n.parent;
    const bool wasLeft = n.left == below;
    std::uint32_t& half = wasLeft ? halves.right : halves.left;
    (wasLeft ? n.left : n.right) = half;
    if (half != kNoNode) nodes_[half].parent = up;
    pull(up);
    half = below = up;
    up = further;
  }
  nodes_[halves.left].parent = kNoNode;
  if (halves.right != kNoNode) nodes_[halves.right].parent = kNoNode;
  return halves;
}

}  // namespace lgs::detail
