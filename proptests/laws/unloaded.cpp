#include "unloaded.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::test {
namespace {

constexpr std::int32_t kFirst = -2, kLast = 1;  // chunks on each axis
constexpr CellRect kAll{{32 * kFirst - 64, 32 * kFirst - 64}, {32 * kLast + 95, 32 * kLast + 95}};

PreserveRelation relation(bool preserves) {
  if (!preserves) return {};
  return [](Block a, Block b) { return a == 0 && b == 1; };
}

Cell chunkOf(Cell cell) { return {cell.i & ~31, cell.j & ~31}; }

}  // namespace

World rowOfChunks(std::int32_t chunks) {
  World world;
  fill(world, {{0, 0}, {32 * chunks - 1, 31}});
  world.commit();
  return world;
}

Seen seen(const Segment& segment, bool withHandle) {
  const SegmentFields s = fieldsOf(segment);
  return {s.start, s.end, s.block, s.cell, s.ghost1, s.ghost2, withHandle ? s.polygon : PolygonHandle{}};
}

std::multiset<Seen> seen(const World& world, const std::vector<SegmentId>& ids, bool withHandles) {
  std::multiset<Seen> out;
  for (const SegmentId id : ids) out.insert(seen(must(world.segment(id)), withHandles));
  return out;
}

BesideTheWhole::BesideTheWhole(oracle::Random choices, WithOut with)
    : choices_(choices),
      with_(with),
      part_(relation(with.preserves)),
      whole_(relation(with.preserves)),
      follows_(choices_.chance(50)) {
  for (World* world : {&part_, &whole_}) {
    oracle::Random random(7);  // the same turns
    shapes_ = turnedShapes(*world, random);
  }
  EXPECT_TRUE(!follows_ || part_.followCells(true));
  loaded_ = loadedChunks();
  if (!with_.preserves) loops_.emplace(part_);
}

void BesideTheWhole::step() {
  const int what = choices_.below(100);
  if (what < 55) return edit();
  if (what < 75) return turn();
  if (what < 80 && with_.marks) return goBack();
  if (what < 82) {
    World copy = part_;
    part_ = std::move(copy);
    return;
  }
  commit();
}

/// Near the border of a chunk, as a rule.
std::int32_t BesideTheWhole::coordinate() {
  const std::int32_t chunk = choices_.between(kFirst, kLast);
  return 32 * chunk + (choices_.chance(90) ? choices_.between(-2, 1) : choices_.between(2, 29));
}

Cell BesideTheWhole::cell() { return {coordinate(), coordinate()}; }

CellRect BesideTheWhole::someChunks() {
  const std::int32_t i = choices_.between(kFirst, kLast), j = choices_.between(kFirst, kLast);
  return {chunkAt(i, j).min, chunkAt(i + choices_.below(3), j + choices_.below(3)).max};
}

void BesideTheWhole::edit() {
  const Cell at = cell();
  if (!isLoaded(at)) return editNowhere(at);
  const Block block = choices_.below(3U);
  if (choices_.chance(25)) {
    EXPECT_EQ(*part_.clear(at), *whole_.clear(at));
    return;
  }
  if (choices_.chance(15)) {
    const CellRect row{at, {at.i + choices_.below(4), at.j + choices_.below(4)}};
    if (const auto gone = part_.firstUnloaded(row)) {
      const auto done = part_.fill(row, shapes_[0], block);
      EXPECT_TRUE(done.error().code != ErrorCode::unloaded || done.error().cell == *gone);
      EXPECT_FALSE(done);
      EXPECT_EQ(part_.clear(row).error().cell, *gone);
      return;
    }
    EXPECT_EQ(*part_.clear(row), *whole_.clear(row));
    const auto here = part_.fill(row, shapes_[0], block), there = whole_.fill(row, shapes_[0], block);
    EXPECT_EQ(here.has_value(), there.has_value());
    return;
  }
  const auto polygons = part_.polygons(at);
  if (!polygons.empty() && choices_.chance(30)) {
    const PolygonHandle other = whole_.polygons(at)[0].handle;
    if (!with_.forgets) {
      EXPECT_EQ(polygons[0].handle, other);
    }
    const bool recolours = choices_.chance(50);
    const auto here = recolours ? part_.setBlock(polygons[0].handle, block) : part_.remove(polygons[0].handle);
    const auto there = recolours ? whole_.setBlock(other, block) : whole_.remove(other);
    EXPECT_EQ(here.has_value(), there.has_value());
    return;
  }
  const ShapeId shape = choices_.pick(shapes_);
  const auto here = part_.add(at, shape, block), there = whole_.add(at, shape, block);
  ASSERT_EQ(here.has_value(), there.has_value());
  if (here && !with_.forgets) {
    EXPECT_EQ(*here, *there);
  }
}

/// Edits of what is unloaded are refused.
void BesideTheWhole::editNowhere(Cell at) {
  const auto refuses = [&](const auto& done) {
    EXPECT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::unloaded);
    EXPECT_EQ(done.error().cell, at);
  };
  const ShapeId shape = choices_.pick(shapes_);
  refuses(part_.add(at, shape, 1));
  refuses(part_.add(at, unitSquare(), 1));
  refuses(part_.replace(at, shape, 1));
  refuses(part_.clear(at));
  refuses(part_.fill({at, at}, shape, 1));
  refuses(part_.exchange(at, {}, {}));
  const Placement placement{at, shape, 1};
  refuses(part_.addMany({&placement, 1}));
  EXPECT_TRUE(part_.polygons(at).empty());
  if (with_.forgets) return;
  for (const PlacedPolygon& p : whole_.polygons(at)) {
    refuses(part_.remove(p.handle));
    refuses(part_.setBlock(p.handle, 2));
    refuses(part_.polygon(p.handle));
    refuses(part_.removeMany({&p.handle, 1}));
  }
}

/// Chunks go, or come.
void BesideTheWhole::turn() {
  const CellRect cells = someChunks();
  if (choices_.chance(50)) {
    EXPECT_TRUE(part_.unload(cells, shelf_.sink()));
    if (with_.forgets && choices_.chance(30)) {
      commit();
      forget();
    }
    return;
  }
  for (std::int32_t j = cells.min.j; j <= cells.max.j; j += 32)
    for (std::int32_t i = cells.min.i; i <= cells.max.i; i += 32)
      EXPECT_TRUE(isLoaded({i, j}) || shelf_.reload(part_, {i, j}));
}

/// What is forgotten would count as empty: it comes back at once, and some of it goes again.
void BesideTheWhole::forget() {
  std::vector<Cell> unloaded;
  for (const Cell corner : corners())
    if (!isLoaded(corner)) unloaded.push_back(corner);
  EXPECT_TRUE(part_.forget(kAll));
  for (const Cell corner : unloaded) EXPECT_TRUE(!isLoaded(corner) || shelf_.reload(part_, corner));
  EXPECT_TRUE(part_.unload(someChunks(), shelf_.sink()));
}

void BesideTheWhole::bringAllBack() {
  for (const Cell corner : corners()) EXPECT_TRUE(isLoaded(corner) || shelf_.reload(part_, corner));
}

/// The lower-left cells of all chunks that there may be.
std::vector<Cell> BesideTheWhole::corners() {
  std::vector<Cell> out;
  for (std::int32_t j = kFirst - 2; j <= kLast + 3; ++j)
    for (std::int32_t i = kFirst - 2; i <= kLast + 3; ++i) out.push_back(chunkAt(i, j).min);
  return out;
}

void BesideTheWhole::goBack() {
  if (choices_.chance(40) || marks_.empty()) {
    marks_.push_back({part_.checkpoint(), whole_.checkpoint(), loaded_});
    ahead_.clear();
    return;
  }
  const std::size_t which = choices_.below(marks_.size());
  if (choices_.chance(15)) {
    EXPECT_TRUE(part_.forget(marks_[which].part));
    EXPECT_TRUE(whole_.forget(marks_[which].whole));
    marks_.erase(marks_.begin() + static_cast<std::ptrdiff_t>(which));
    ahead_.clear();
    return;
  }
  if (!ahead_.empty() && choices_.chance(40)) {
    const Marks to = ahead_.back();
    if (!part_.rollForward(to.part)) return;  // something was edited since, or a chunk came or went
    EXPECT_TRUE(whole_.rollForward(to.whole));
    while (!marks_.empty() && marks_.back().part > ahead_.back().part) marks_.pop_back();
    ahead_.pop_back();
    marks_.push_back(to);
  } else {
    const Undone undone = choices_.chance(60) ? Undone::keep : Undone::drop;
    EXPECT_TRUE(part_.rollBack(marks_[which].part, undone));
    EXPECT_TRUE(whole_.rollBack(marks_[which].whole, undone));
    ahead_.clear();
    if (undone == Undone::keep) ahead_.assign(marks_.rbegin(), marks_.rend() - static_cast<std::ptrdiff_t>(which) - 1);
    marks_.resize(which + 1);
  }
  loaded_ = marks_.back().loaded;
  follow(part_.changesOfRollBack());
  followCells();
}

std::set<Cell> BesideTheWhole::loadedChunks() const {
  std::set<Cell> chunks;
  for (const Cell corner : corners())
    if (isLoaded(corner)) chunks.insert(corner);
  return chunks;
}

std::multiset<Seen> BesideTheWhole::seenIn(const std::set<Cell>& chunks, const World& world,
                                           std::vector<SegmentId> ids) const {
  std::erase_if(ids, [&](SegmentId id) { return !chunks.contains(chunkOf(must(world.segment(id)).cell)); });
  return seen(world, ids, !with_.forgets);
}

void BesideTheWhole::commit() {
  std::map<SegmentId, Segment> wholeBefore;
  for (const SegmentId id : whole_.segments()) wholeBefore[id] = *whole_.segment(id);
  const auto partBefore = copy_;
  const std::uint64_t version = part_.version();
  const Changes& here = part_.commit();
  const Changes& there = whole_.commit();
  EXPECT_EQ(here.before, version);
  EXPECT_EQ(here.after, part_.version());
  EXPECT_EQ(here.before == here.after, here.removed.empty() && here.added.empty() && here.relinked.empty());

  // Of chunks that were loaded and are, both report the same.
  std::set<Cell> stayed;
  const std::set<Cell> now = loadedChunks();
  std::ranges::set_intersection(loaded_, now, std::inserter(stayed, stayed.end()));
  std::multiset<Seen> removedHere, removedThere;
  for (const SegmentId id : here.removed) {
    ASSERT_TRUE(partBefore.contains(id)) << "segment " << id.value << " was removed, and never was there";
    if (const Segment& s = partBefore.at(id); stayed.contains(chunkOf(s.cell)))
      removedHere.insert(seen(s, !with_.forgets));
  }
  for (const SegmentId id : there.removed)
    if (const Segment& s = wholeBefore.at(id); stayed.contains(chunkOf(s.cell)))
      removedThere.insert(seen(s, !with_.forgets));
  EXPECT_EQ(removedHere, removedThere);
  EXPECT_EQ(seenIn(stayed, part_, here.added), seenIn(stayed, whole_, there.added));
  EXPECT_EQ(seenIn(stayed, part_, here.relinked), seenIn(stayed, whole_, there.relinked));
  loaded_ = now;
  follow(here);
  followCells();
  if (follows_) {
    EXPECT_EQ(told_, polygonsOf(part_));
  }
}

/// Whoever applies the lists alone has the segments.
void BesideTheWhole::follow(const Changes& changes) {
  for (const SegmentId id : changes.removed) EXPECT_EQ(copy_.erase(id), 1U);
  for (const SegmentId id : changes.added) EXPECT_FALSE(copy_.contains(id));
  for (const SegmentId id : changes.relinked) EXPECT_TRUE(copy_.contains(id));
  for (const auto* ids : {&changes.added, &changes.relinked})
    for (const SegmentId id : *ids)
      if (const auto s = part_.segment(id)) copy_[id] = *s;
  std::vector<SegmentId> ids;
  for (const auto& [id, s] : copy_) {
    ids.push_back(id);
    const auto now = must(part_.segment(id));
    EXPECT_EQ(seen(s, !with_.forgets), seen(now, !with_.forgets))
        << "a change of segment " << id.value << " was not told";
  }
  EXPECT_EQ(part_.segments(), ids);
  EXPECT_EQ(part_.stats().segments, ids.size());
  expectSameOutline();
  if (loops_) expectSameLoops(changes);
  expectSameGround();
  expectSameAnswers();
}

void BesideTheWhole::expectSameOutline() {
  EXPECT_EQ(seenIn(loaded_, part_, part_.segments()), seenIn(loaded_, whole_, whole_.segments()));
  EXPECT_EQ(part_.segments().size(), part_.segments(kAll).size());
  if (with_.preserves) return;
  // Loops that never leave what is loaded are the same.
  std::vector<std::vector<Point>> here, there, merged;
  for (const Loop& loop : part_.loops()) here.push_back(loop.vertices);
  for (const Loop& loop : whole_.loops())
    if (std::ranges::all_of(loop.segments,
                            [&](SegmentId id) { return loaded_.contains(chunkOf(whole_.segment(id)->cell)); }))
      there.push_back(loop.vertices);
  EXPECT_EQ(here, there);
  for (const Loop& loop : whole_.loops(Collinear::merge)) merged.push_back(loop.vertices);
  const std::vector<Loop> loops = part_.loops(Collinear::merge);
  for (const Loop& loop : loops) EXPECT_NE(std::ranges::find(merged, loop.vertices), merged.end());
  EXPECT_EQ(loops.size(), here.size());
}

/// The view that follows has the closed loops, as one has that begins now.
void BesideTheWhole::expectSameLoops(const Changes& changes) {
  EXPECT_TRUE(loops_->update(part_, changes));
  const auto factsOf = [](const Loops& loops) {
    std::multiset<std::tuple<Point, bool, std::uint64_t>> facts;
    for (const LoopId id : loops.all()) {
      const LoopFacts f = *loops.loop(id);
      facts.emplace(f.west, f.isHole(), f.segments);
    }
    return facts;
  };
  EXPECT_EQ(factsOf(*loops_), factsOf(Loops(part_)));
  std::set<SegmentId> closed;
  for (const Loop& loop : part_.loops()) closed.insert(loop.segments.begin(), loop.segments.end());
  for (const SegmentId id : part_.segments()) EXPECT_EQ(static_cast<bool>(loops_->of(id)), closed.contains(id));
}

BesideTheWhole::Polygons BesideTheWhole::polygonsOf(const World& world) const {
  Polygons out;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    out[cell].push_back({with_.forgets ? PolygonHandle{} : p.handle, p.block, {p.vertices.begin(), p.vertices.end()}});
  });
  return out;
}

void BesideTheWhole::expectSameGround() {
  Polygons there = polygonsOf(whole_);
  std::erase_if(there, [&](const auto& entry) { return !isLoaded(entry.first); });
  EXPECT_EQ(polygonsOf(part_), there);
  EXPECT_EQ(part_.stats().cells, there.size());
}

/// Whoever follows cells knows what is loaded, once all is committed.
void BesideTheWhole::followCells() {
  if (!follows_) return;
  for (const CellChange& change : part_.cellChanges()) {
    std::vector<PolygonFields> before, now;
    for (const auto& [from, to] : {std::pair(change.before, &before), std::pair(change.now, &now)})
      for (const PlacedPolygon& p : from)
        to->push_back({with_.forgets ? PolygonHandle{} : p.handle, p.block, {p.vertices.begin(), p.vertices.end()}});
    EXPECT_EQ(told_[change.cell], before);
    told_[change.cell] = now;
    if (now.empty()) told_.erase(change.cell);
  }
}

void BesideTheWhole::expectSameAnswers() {
  for (int k = 0; k < 4; ++k) {
    const Cell a = cell(), b = cell();
    const auto units = [&] { return choices_.chance(30) ? 0 : choices_.between(0, U); };
    const Point p = toWorld(a, {units(), units()}), q = toWorld(b, {units(), units()});
    const Spot here = part_.at(p), there = whole_.at(p);
    if (here.where == Spot::Where::unloaded) {
      EXPECT_FALSE(isLoaded(here.cell));
    } else {
      EXPECT_EQ(here.where, there.where);
      EXPECT_EQ(here.block, there.block);
      EXPECT_EQ(here.cell, there.cell);
      EXPECT_TRUE(isLoaded(lgs::cellAt(p)));
    }
    const auto same = [&](SegmentId mine, SegmentId theirs) {
      if (!mine || !theirs) return mine == theirs;
      return seen(*part_.segment(mine), !with_.forgets) == seen(*whole_.segment(theirs), !with_.forgets);
    };
    const auto hitsHere = part_.rayCast(p, q), hitsThere = whole_.rayCast(p, q);
    if (hitsHere) {
      EXPECT_TRUE(same(hitsHere->segment, hitsThere->segment));
      EXPECT_EQ(hitsHere->fraction, hitsThere->fraction);
    } else {
      EXPECT_EQ(hitsHere.error().code, ErrorCode::unloaded);
      EXPECT_FALSE(loaded_.contains(chunkOf(hitsHere.error().cell)));
    }
    const auto nearHere = part_.nearest(p, 40), nearThere = whole_.nearest(p, 40);
    if (nearHere) {
      EXPECT_TRUE(same(nearHere->segment, nearThere->segment));
    } else {
      EXPECT_EQ(nearHere.error().code, ErrorCode::unloaded);
      EXPECT_FALSE(loaded_.contains(chunkOf(nearHere.error().cell)));
    }
  }
}

}  // namespace lgs::test
