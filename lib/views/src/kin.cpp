#include "kin.h"

#include <algorithm>

namespace lgs::detail {
namespace {

/// The cells around one.
CellRect around(Cell c) {
  const auto inWorld = [](std::int64_t index) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(index, -kMaxCell, kMaxCell));
  };
  return {{inWorld(std::int64_t{c.i} - 1), inWorld(std::int64_t{c.j} - 1)},
          {inWorld(std::int64_t{c.i} + 1), inWorld(std::int64_t{c.j} + 1)}};
}

}  // namespace

Kin::Kin(const World& world, const World& outline, const Loops& loops, std::span<const Taken> taken)
    : world_(world), outline_(outline), loops_(loops), locator_(outline, loops), taken_(taken) {
  for (Node node = 0; node < taken.size(); ++node) links_.push_back({node, {}});
}

Kin::Node Kin::root(Node node) {
  while (links_[node].parent != node) node = links_[node].parent = links_[links_[node].parent].parent;
  return node;
}

Kin::Node Kin::nodeOf(LoopId loop) {
  const auto node = static_cast<Node>(links_.size());
  const auto [known, isNew] = nodes_.try_emplace(loop.value, node);
  if (isNew) {
    loop_.push_back(loop);
    links_.push_back({node, loop, 1});
  }
  return known->second;
}

void Kin::unite(Node a, Node b) {
  a = root(a);
  b = root(b);
  if (a == b) return;
  links_[a].parent = b;
  links_[b].loops += links_[a].loops;
  if (!links_[b].loop) links_[b].loop = links_[a].loop;
}

template <class Visit>
void Kin::forTakenNear(Cell cell, Visit&& visit) const {
  const CellRect cells = around(cell);
  for (std::int32_t i = cells.min.i; i <= cells.max.i; ++i) {
    const auto first = std::ranges::lower_bound(taken_, Cell{i, cells.min.j}, {}, &Taken::cell);
    for (auto t = first; t != taken_.end() && t->cell <= Cell{i, cells.max.j}; ++t)
      visit(static_cast<std::size_t>(t - taken_.begin()));
  }
}

/// Connects a polygon that was taken away with the loops that it meets.
void Kin::connect(std::size_t index) {
  const Taken& taken = taken_[index];
  for (const SegmentId id : outline_.segments(around(taken.cell))) {
    const Segment s = *outline_.segment(id);
    if (meets(taken.ring, s.start, s.end)) unite(static_cast<Node>(index), nodeOf(loops_.of(id)));
  }
}

// Loops that are connected in the end are on one island, or on islands that are kin. Of a single loop nobody needs to
// know the island yet.
void Kin::connectAll() {
  for (std::size_t k = 0; k < taken_.size(); ++k) {
    connect(k);
    forTakenNear(taken_[k].cell, [&](std::size_t other) {
      if (other < k && root(static_cast<Node>(k)) != root(static_cast<Node>(other)) &&
          touch(taken_[k].ring, taken_[other].ring))
        unite(static_cast<Node>(k), static_cast<Node>(other));
    });
  }
  std::vector<LoopId> several;
  for (const LoopId loop : loop_)
    if (links_[root(nodeOf(loop))].loops > 1) several.push_back(loop);
  for (const LoopId loop : several) unite(nodeOf(loop), nodeOf(locator_.ofLoop(loop)));
}

Kin::Node Kin::ofTaken(std::size_t index) {
  const auto node = static_cast<Node>(index);
  if (const LoopId loop = links_[root(node)].loop) {
    unite(node, nodeOf(locator_.ofLoop(loop)));
    return node;
  }
  // It meets no loop. So it lies in the interior of one island, or in the free.
  const Spot spot = world_.at(taken_[index].ring.front());
  if (const auto p = world_.polygon(spot.polygon)) unite(node, ofStanding(spot.cell, p->vertices));
  return node;
}

Kin::Node Kin::at(Point point) {
  std::optional<std::size_t> taken;
  forTakenNear(cellAt(point), [&](std::size_t k) {
    if (!taken && contains(taken_[k].ring, point)) taken = k;
  });
  if (taken) return ofTaken(*taken);
  const Spot spot = world_.at(point);
  if (const auto p = world_.polygon(spot.polygon)) return ofStanding(spot.cell, p->vertices);
  return nodeOf({});  // the world has edits that are not committed
}

std::vector<LoopId> Kin::outers() const {
  std::vector<LoopId> out;
  for (const LoopId loop : loop_) {
    const auto facts = loops_.loop(loop);
    if (facts && !facts->isHole()) out.push_back(loop);
  }
  return out;
}

}  // namespace lgs::detail
