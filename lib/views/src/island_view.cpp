#include "island_view.h"

#include "geometry/sort.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace lgs::detail {

namespace {

/// Whether a cell is one square now.
bool isWhole(const CellChange& change) {
  if (change.now.size() != 1 || change.now.front().vertices.size() != 4) return false;
  return std::ranges::all_of(change.now.front().vertices, [](LocalPoint v) {
    return (v.x == 0 || v.x == kUnitsPerCell) && (v.y == 0 || v.y == kUnitsPerCell);
  });
}

}  // namespace

void IslandView::load(const World& world, const Loops& loops) {
  for (const CellRect& chunk : unloadedChunks(world)) away_.insert(chunk.min);
  std::vector<LoopId> outers;
  for (const LoopId id : loops.all())
    if (!loops.loop(id)->isHole()) outers.push_back(id);
  findOpen(world, loops, outers);
  for (const LoopId id : outers)
    if (!isOpen(id)) set(newId(), id, anchorsIn(world, loops, id));
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
  changes_.added.clear();
  changes_.removed.clear();
  changes_.changed.clear();
  changes_.cutOff.clear();
  changes_.joined.clear();
  changes_.before.clear();
  taken_.clear();
  left_.clear();
  back_.clear();
  came_.clear();
  shifts_.clear();
  kinShifts_.clear();
  olds_.clear();
  news_.clear();
  hasAdded_ = false;
}

void IslandView::update(const World& world, const Loops& loops) {
  begin();
  readCells(world);
  const std::vector<LoopId> outers = changedOuters(loops);
  wasOpen_ = std::exchange(open_, {});
  findOpen(world, loops, outers);
  Kin kin(world, loops.outline(world), loops, taken_, back_);
  collect(world, loops, outers, kin);
  nameAll(world, loops, kin.root(kin.beyond()));
  for (const CellRect& chunk : left_) away_.insert(chunk.min);
  for (const CellRect& chunk : back_) away_.erase(chunk.min);
  dropForgotten(world);
}

/// Forgotten chunks are not reported. They are looked for when there may be as many as others.
void IslandView::dropForgotten(const World& world) {
  constexpr std::size_t kFew = 64;
  if (away_.size() < kFew + 2 * kept_) return;
  std::erase_if(away_, [&](Cell corner) { return !isUnloaded(world, corner); });
  kept_ = away_.size();
}

void IslandView::readCells(const World& world) {
  Passage passage = Passage::stays;
  CellRect chunk{{0, 0}, {-1, -1}};
  for (const CellChange& change : world.cellChanges()) {
    if (!lgs::contains(chunk, change.cell)) {
      chunk = chunkWith(change.cell);
      passage = passageOf(world, change.cell);
      if (passage == Passage::left) left_.push_back(chunk);
      if (passage == Passage::came) back_.push_back(chunk);
    }
    readCell(change, passage);
    if (passage == Passage::came) came_.push_back(static_cast<std::size_t>(&change - world.cellChanges().data()));
  }
  detail::sort(taken_,
               [](const Taken& a, const Taken& b) { return a.cell != b.cell ? a.cell < b.cell : a.ring < b.ring; });
}

IslandView::Passage IslandView::passageOf(const World& world, Cell cell) {
  if (isUnloaded(world, cell)) return Passage::left;
  return away_.contains(chunkWith(cell).min) ? Passage::came : Passage::stays;
}

/// What was taken away and added in a cell, whatever the blocks. What left memory, and what came back, hangs together
/// with what is beyond: the anchors of whatever that makes or cuts off are counted anew.
void IslandView::readCell(const CellChange& change, Passage passage) {
  if (passage != Passage::stays) {
    for (const PlacedPolygon& p : change.before)
      taken_.push_back({change.cell, ringOf(change.cell, p.vertices), false, passage == Passage::left});
    return;
  }
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

/// Outer loops that are new, or changed.
std::vector<LoopId> IslandView::changedOuters(const Loops& loops) const {
  const LoopChanges& changed = loops.changes();
  std::vector<LoopId> outers = changed.added;
  for (const LoopPair& p : changed.split) outers.push_back(p.into);
  outers.insert(outers.end(), changed.changed.begin(), changed.changed.end());
  std::erase_if(outers, [&](LoopId id) { return loops.loop(id)->isHole(); });
  return outers;
}

// Where polygons were only taken away, and no outer loop came or went, each island of now lies in one of before and has
// its loop: nothing can have been cut off. Then there is nothing to look at, unless an anchor went.
void IslandView::collect(const World& world, const Loops& loops, std::span<const LoopId> outers, Kin& kin) {
  const LoopChanges& changed = loops.changes();
  const auto stays = [&](LoopId id) { return std::ranges::binary_search(changed.changed, id); };
  const auto isOther = [&](const LoopFacts& f) { return !f.isHole() && !stays(f.id); };
  const bool anchorsWent = std::ranges::count(taken_, true, &Taken::wasAnchor) > 0;
  const bool turns = !left_.empty() || !back_.empty() || open_ != wasOpen_;
  if (hasAdded_ || anchorsWent || turns || !std::ranges::all_of(outers, stays) ||
      std::ranges::any_of(changed.before, isOther))
    kin.connectAll();

  for (const LoopId id : outers) kin.ofOuter(id);
  uniteBeyond(world, loops, kin);
  for (const LoopFacts& f : changed.before)
    if (const IslandId id = islandOf(f.id); id && isOther(f))
      olds_.push_back({kin.at(f.west), {id, f, islands_[id.value].anchors}});
  for (std::size_t k = 0; k < taken_.size(); ++k)
    if (taken_[k].wasAnchor) kinShifts_.push_back({kin.ofTaken(k), -1});
  for (const Shift& s : shifts_) kinShifts_.push_back({kin.ofStanding(s.cell, s.vertices), s.by});

  for (const LoopId id : kin.outers()) {
    const LoopFacts now = *loops.loop(id);
    const auto before = std::ranges::lower_bound(changed.before, id, {}, &LoopFacts::id);
    const bool wasOther = before != changed.before.end() && before->id == id;
    if (!isOpen(id)) news_.push_back({kin.ofOuter(id), now, {}});
    if (const IslandId old = islandOf(id))
      olds_.push_back({kin.ofOuter(id), {old, wasOther ? *before : now, islands_[old.value].anchors}});
  }
  for (Old& old : olds_) old.kin = kin.root(old.kin);
  for (New& now : news_) now.kin = kin.root(now.kin);
  for (KinShift& shift : kinShifts_) shift.kin = kin.root(shift.kin);
}

/// An outer loop that leads into an unloaded chunk is none. So only of those that run around one it must be found out
/// whether their islands reach it.
void IslandView::findOpen(const World& world, const Loops& loops, std::span<const LoopId> outers) {
  const auto cellsIn = [](const LoopFacts& f) { return CellRect{cellAt(f.min), cellAt({f.max.x - 1, f.max.y - 1})}; };
  const auto isWide = [&](LoopId id) {
    const auto facts = loops.loop(id);
    return facts && !facts->isHole() &&
           std::min(facts->max.x - facts->min.x, facts->max.y - facts->min.y) > kChunkSide * kUnitsPerCell;
  };
  std::erase_if(wide_, [&](LoopId id) { return !isWide(id); });
  std::ranges::copy_if(outers, std::inserter(wide_, wide_.end()), isWide);
  for (const LoopId id : wide_) {
    if (!world.firstUnloaded(cellsIn(*loops.loop(id)))) continue;
    const std::vector<Standing>& all = walk(world, loops, id);
    if (std::ranges::any_of(all, [&](const Standing& s) { return reachesUnloaded(loops.outline(world), s); }))
      open_.insert(id);
  }
}

/// What hung together with ground beyond the edge of memory, or does.
void IslandView::uniteBeyond(const World& world, const Loops& loops, Kin& kin) const {
  const LoopChanges& changed = loops.changes();
  const auto isOuter = [&](LoopId id) {
    const auto facts = loops.loop(id);
    return facts && !facts->isHole();
  };
  for (const LoopId id : changed.closed) kin.isBeyond(id);
  const CellChange* last = nullptr;
  for (const std::size_t k : came_) {
    const CellChange& change = world.cellChanges()[k];
    const bool goesOn =
        last && change.cell == Cell{last->cell.i + 1, last->cell.j} && isWhole(*last) && isWhole(change);
    last = &change;
    if (goesOn) continue;  // it is of the island of the cell beside it
    for (const PlacedPolygon& p : change.now) kin.isBeyond(change.cell, p.vertices);
  }
  for (const LoopId id : open_) kin.isBeyond(id);
  for (const LoopId id : wasOpen_)
    if (isOuter(id)) kin.isBeyond(id);
  for (const LoopFacts& f : changed.before)
    if (wasOpen_.contains(f.id) && !isOuter(f.id)) kin.isBeyond(f.west);
}

const std::vector<Standing>& IslandView::walk(const World& world, const Loops& loops, LoopId outer) {
  static const std::vector<Standing> kNothing;
  const Segment first = *loops.outline(world).segment(loops.loop(outer)->first);
  const auto start = ownerOf(world, first);
  if (!start) return kNothing;  // the world has edits that are not committed
  return walk_.from(world, *start, Contact::point);
}

/// The anchors of an island, counted by walking through it.
std::uint64_t IslandView::anchorsIn(const World& world, const Loops& loops, LoopId outer) {
  if (!isAnchor_) return 0;
  const std::vector<Standing>& all = walk(world, loops, outer);
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
