#include "island_view.h"

#include "geometry/sort.h"

#include <algorithm>

namespace lgs::detail {

void IslandView::load(const World& world, const Loops& loops) {
  for (const LoopId id : loops.all())
    if (!loops.loop(id)->isHole()) set(newId(), id, anchorsIn(world, loops, id));
}

std::optional<IslandFacts> IslandView::facts(const Loops& loops, IslandId id) const {
  const Island& island = islands_[id.value];
  const auto outer = loops.loop(island.outer);
  if (!outer) return std::nullopt;
  return IslandFacts{id, *outer, island.anchors};
}

std::vector<IslandId> IslandView::all() const {
  std::vector<IslandId> out;
  for (std::uint32_t id = 1; id < islands_.size(); ++id)
    if (islands_[id].outer) out.push_back({id});
  return out;
}

void IslandView::begin() {
  free_.insert(free_.end(), ended_.begin(), ended_.end());
  ended_.clear();
  changes_.came.clear();
  changes_.went.clear();
  changes_.changed.clear();
  changes_.cutOff.clear();
  changes_.joined.clear();
  changes_.before.clear();
  taken_.clear();
  shifts_.clear();
  kinShifts_.clear();
  olds_.clear();
  news_.clear();
  hasAdded_ = false;
}

void IslandView::update(const World& world, const Loops& loops) {
  begin();
  readCells(world);
  Kin kin(world, loops.outline(world), loops, taken_);
  collect(loops, kin);
  nameAll(world, loops);
}

void IslandView::readCells(const World& world) {
  for (const CellChange& change : world.cellChanges()) readCell(change);
  detail::sort(taken_,
               [](const Taken& a, const Taken& b) { return a.cell != b.cell ? a.cell < b.cell : a.ring < b.ring; });
}

/// What was taken away and added in a cell, whatever the blocks.
void IslandView::readCell(const CellChange& change) {
  const auto like = [](std::span<const PlacedPolygon> polygons, const PlacedPolygon& p) {
    return std::ranges::find_if(polygons,
                                [&](const PlacedPolygon& q) { return std::ranges::equal(p.vertices, q.vertices); });
  };
  const auto shift = [&](const PlacedPolygon& p, std::int64_t by) {
    if (by != 0) shifts_.push_back({change.cell, {p.vertices.begin(), p.vertices.end()}, by});
  };
  for (const PlacedPolygon& p : change.before) {
    const bool wasAnchor = isAnchor(p, change.cell);
    const auto same = like(change.now, p);
    if (same == change.now.end())
      taken_.push_back({change.cell, ringOf(change.cell, p.vertices), wasAnchor});
    else
      shift(*same, (isAnchor(*same, change.cell) ? 1 : 0) - (wasAnchor ? 1 : 0));
  }
  for (const PlacedPolygon& p : change.now) {
    if (like(change.before, p) != change.before.end()) continue;
    hasAdded_ = true;
    shift(p, isAnchor(p, change.cell) ? 1 : 0);
  }
}

// Where polygons were only taken away, and no outer loop came or went, each island of now lies in one of before and has
// its loop: nothing can have been cut off. Then there is nothing to look at, unless an anchor went.
void IslandView::collect(const Loops& loops, Kin& kin) {
  const LoopChanges& changed = loops.changes();
  const auto isOuter = [&](LoopId id) { return !loops.loop(id)->isHole(); };
  std::vector<LoopId> outers;  // that are new, or changed
  for (const LoopId id : changed.came)
    if (isOuter(id)) outers.push_back(id);
  for (const LoopPair& p : changed.split)
    if (isOuter(p.into)) outers.push_back(p.into);
  bool isOther = !outers.empty();
  for (const LoopFacts& f : changed.before) {
    if (f.isHole()) continue;
    if (std::ranges::binary_search(changed.changed, f.id))
      outers.push_back(f.id);
    else
      isOther = true;
  }
  const bool anchorsWent = std::ranges::count(taken_, true, &Taken::wasAnchor) > 0;
  if (hasAdded_ || isOther || anchorsWent) kin.connectAll();

  for (const LoopId id : outers) kin.ofOuter(id);
  for (const LoopFacts& f : changed.before)
    if (!f.isHole() && !std::ranges::binary_search(changed.changed, f.id))
      olds_.push_back({kin.at(f.west), {of(f.id), f, islands_[of(f.id).value].anchors}});
  for (std::size_t k = 0; k < taken_.size(); ++k)
    if (taken_[k].wasAnchor) kinShifts_.push_back({kin.ofTaken(k), -1});
  for (const Shift& s : shifts_) kinShifts_.push_back({kin.ofStanding(s.cell, s.vertices), s.by});

  for (const LoopId id : kin.outers()) {
    const LoopFacts now = *loops.loop(id);
    const auto before = std::ranges::lower_bound(changed.before, id, {}, &LoopFacts::id);
    const bool wasOther = before != changed.before.end() && before->id == id;
    news_.push_back({kin.ofOuter(id), now, {}});
    if (of(id)) olds_.push_back({kin.ofOuter(id), {of(id), wasOther ? *before : now, islands_[of(id).value].anchors}});
  }
  for (Old& old : olds_) old.kin = kin.root(old.kin);
  for (New& now : news_) now.kin = kin.root(now.kin);
  for (KinShift& shift : kinShifts_) shift.kin = kin.root(shift.kin);
}

/// The anchors of an island, counted by walking through it.
std::uint64_t IslandView::anchorsIn(const World& world, const Loops& loops, LoopId outer) {
  if (!isAnchor_) return 0;
  const Segment first = *loops.outline(world).segment(loops.loop(outer)->first);
  const auto start = ownerOf(world, first);
  if (!start) return 0;  // the world has edits that are not committed
  const std::vector<Standing>& all = walk_.from(world, *start, Contact::point);
  return static_cast<std::uint64_t>(
      std::ranges::count_if(all, [&](const Standing& s) { return isAnchor(s.polygon, s.cell); }));
}

void IslandView::set(IslandId id, LoopId outer, std::uint64_t anchors) {
  islands_[id.value] = {outer, 0, anchors};
  if (ofLoop_.size() <= outer.value) ofLoop_.resize(outer.value + std::size_t{1});
  ofLoop_[outer.value] = id;
}

IslandId IslandView::newId() {
  if (free_.empty()) {
    islands_.emplace_back();
    return {static_cast<std::uint32_t>(islands_.size() - 1)};
  }
  const IslandId id = free_.back();
  free_.pop_back();
  return id;
}

}  // namespace lgs::detail
