#include "kin.h"

#include "beyond.h"

#include <algorithm>

namespace lgs::detail {
Kin::Kin(const World& world, const World& outline, const Loops& loops, std::span<const Taken> taken,
         std::span<const CellRect> back)
    : world_(world), outline_(outline), loops_(loops), locator_(outline, loops), taken_(taken), back_(back) {
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
  const CellRect cells = cellsAround(cell);
  for (std::int32_t i = cells.min.i; i <= cells.max.i; ++i) {
    const auto first = std::ranges::lower_bound(taken_, Cell{i, cells.min.j}, {}, &Taken::cell);
    for (auto t = first; t != taken_.end() && t->cell <= Cell{i, cells.max.j}; ++t)
      visit(static_cast<std::size_t>(t - taken_.begin()));
  }
}

/// Whether a polygon that was taken away touched the square of a chunk that is unloaded, or was: it can not be seen now
/// what it touched there.
bool Kin::isBesideUnloaded(const Taken& taken) const {
  if (!isAtRimOfChunk(taken.cell)) return false;
  const CellRect own = chunkWith(taken.cell), around = cellsAround(taken.cell);
  for (std::int32_t i = around.min.i; i <= around.max.i; ++i) {
    for (std::int32_t j = around.min.j; j <= around.max.j; ++j) {
      const Cell cell{i, j};
      const auto has = [&](const CellRect& chunk) { return lgs::contains(chunk, cell); };
      if (has(own) || !(isUnloaded(world_, cell) || std::ranges::any_of(back_, has))) continue;
      if (touch(taken.ring, ringOf(cell, kUnitSquare))) return true;
    }
  }
  return false;
}

/// Connects a polygon that was taken away with the loops that it meets.
void Kin::connect(std::size_t index) {
  const Taken& taken = taken_[index];
  for (const SegmentId id : outline_.segments(cellsAround(taken.cell))) {
    const Segment s = *outline_.segment(id);
    if (meets(taken.ring, s.start, s.end)) unite(static_cast<Node>(index), nodeOf(loops_.of(id)));
  }
}

// Loops that are connected in the end are on one island, or on islands that are kin. The island of a single
// loop is not needed yet.
void Kin::connectAll() {
  for (std::size_t k = 0; k < taken_.size(); ++k) {
    const bool isAway = taken_[k].isAway;
    if (isAway || isBesideUnloaded(taken_[k])) unite(static_cast<Node>(k), beyond());
    if (isAway && !isAtRimOfChunk(taken_[k].cell)) continue;  // around it is nothing but that chunk
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
  if (const auto standing = standingAt(taken_[index].ring.front())) unite(node, *standing);
  return node;
}

/// The node of what stands at a point. Where one of its cells is unloaded World::at() does not look at the others.
std::optional<Kin::Node> Kin::standingAt(Point point) {
  const Spot spot = world_.at(point);
  if (const auto p = world_.polygon(spot.polygon)) return ofStanding(spot.cell, p->vertices);
  if (spot.where != Spot::Where::unloaded) return std::nullopt;
  const Cell high = cellAt(point), low = cellAt({point.x - 1, point.y - 1});
  for (const Cell cell : {high, Cell{low.i, high.j}, Cell{high.i, low.j}, low})
    for (const PlacedPolygon& p : world_.polygons(cell))
      if (contains(ringOf(cell, p.vertices), point)) return ofStanding(cell, p.vertices);
  return std::nullopt;
}

Kin::Node Kin::at(Point point) {
  std::optional<std::size_t> taken;
  forTakenNear(cellAt(point), [&](std::size_t k) {
    if (!taken && contains(taken_[k].ring, point)) taken = k;
  });
  if (taken) return ofTaken(*taken);
  if (const auto standing = standingAt(point)) return *standing;
  return beyond();  // the world has edits that are not committed
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
