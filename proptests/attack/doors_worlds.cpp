// Doors that change a world.
#include "door.h"

#include <algorithm>

namespace lgs::test {
namespace {

/// Makes room for handles, hands it to the call, and says what that said.
template <class Call>
auto withRoom(Room room, Call call) {
  std::vector<PolygonHandle> handles(room.size);
  return call(std::span(handles));
}

/// The call by an initializer list, which has so many points as the list has at most.
template <class Call>
auto byList(const Points& p, Call call) {
  const auto at = [&](std::size_t k) { return p.empty() ? LocalPoint{INT32_MIN, INT32_MAX} : p[k % p.size()]; };
  if (p.empty()) return call(std::initializer_list<LocalPoint>{});
  if (p.size() < 4) return call({at(0), at(1), at(2)});
  return call({at(0), at(1), at(2), at(3)});
}

bool isOutOfRange(Cell cell) { return !inRange(cell); }
bool isUnknown(const Scene& s, ShapeId id) { return id.value == 0 || id.value > s.world.stats().shapes; }

}  // namespace

void addDoorsOfWorlds(Doors& door) {
  door("World::World(PreserveRelation, Handles)", [](Scene&, const PreserveRelation& relation) {
    World world(relation);
    place(world, {0, 0}, unitSquare(), 1);
    place(world, {1, 0}, unitSquare(), 2);
    return world.commit().added.size();
  });
  door("World::~World()", [](Scene& s) { const World ends(s.world); });
  door("World::World(const World&)", [](Scene& s) { s.world = World(s.world); });
  door("World::operator=(const World&)", [](Scene& s, bool isSelf) {
    const World& from = isSelf ? s.world : s.other;
    s.world = from;
  });
  door("World::World(World&&)", [](Scene& s) {
    World moved(std::move(s.world));
    s.world = World(moved);  // all that may be done to what was moved from
  });
  door("World::operator=(World&&)", [](Scene& s) {
    World next;
    next = std::move(s.other);
    s.other = std::move(next);
  });

  door("World::shape(span<const LocalPoint>)", [](Scene& s, const Points& p) { return s.world.shape(p); });
  door("World::shape(initializer_list<LocalPoint>)", [](Scene& s, const Points& p) {
    return byList(p, [&](std::initializer_list<LocalPoint> list) { return s.world.shape(list); });
  });
  door("World::shape(span<const FloatPoint>)", [](Scene& s, const Reals<float>& p) { return s.world.shape(p); });
  door("World::shape(span<const DoublePoint>)", [](Scene& s, const Reals<double>& p) { return s.world.shape(p); });
  door("World::shape(span<const vector<LocalPoint>>)",
       [](Scene& s, const std::vector<Points>& all) { return s.world.shape(all); });

  door("World::add(Cell, ShapeId, Block)",
       [](Scene& s, Cell c, ShapeId id, Block b) { return refusedIf(isOutOfRange(c), s.world.add(c, id, b)); });
  door("World::add(Cell, ShapeId, Block, span<PolygonHandle>)", [](Scene& s, Cell c, ShapeId id, Block b, Room room) {
    return withRoom(room, [&](auto handles) { return refusedIf(isOutOfRange(c), s.world.add(c, id, b, handles)); });
  });
  door("World::add(Cell, span<const LocalPoint>, Block)",
       [](Scene& s, Cell c, const Points& p, Block b) { return refusedIf(isOutOfRange(c), s.world.add(c, p, b)); });
  door("World::add(Cell, initializer_list<LocalPoint>, Block)", [](Scene& s, Cell c, const Points& p, Block b) {
    return byList(
        p, [&](std::initializer_list<LocalPoint> list) { return refusedIf(isOutOfRange(c), s.world.add(c, list, b)); });
  });
  door("World::add(Cell, span<const FloatPoint>, Block)", [](Scene& s, Cell c, const Reals<float>& p, Block b) {
    return refusedIf(isOutOfRange(c), s.world.add(c, p, b));
  });
  door("World::add(Cell, span<const DoublePoint>, Block)", [](Scene& s, Cell c, const Reals<double>& p, Block b) {
    return refusedIf(isOutOfRange(c), s.world.add(c, p, b));
  });
  door("World::addMany(span<const Placement>, span<PolygonHandle>)",
       [](Scene& s, const std::vector<Placement>& all, Room room) {
         const auto isBad = [&](const Placement& p) { return isOutOfRange(p.cell) || isUnknown(s, p.shape); };
         World fresh;  // where no mark and no segment makes it take the long way
         shapeOf(fresh, {unitSquare()});
         shapeOf(fresh, shapeNamed("two ramps"));
         const auto isOut = [](const Placement& p) { return isOutOfRange(p.cell); };
         static_cast<void>(refusedIf(std::ranges::any_of(all, isOut), fresh.addMany(all)));
         World(fresh).commit();
         return withRoom(room, [&](auto handles) {
           return refusedIf(std::ranges::any_of(all, isBad), s.world.addMany(all, handles));
         });
       });
  door(
      "World::remove(PolygonHandle)", [](Scene& s, PolygonHandle h) { return s.world.remove(h); },
      [](Scene& s, PolygonHandle h) { return !s.isAlive(h); });
  door("World::removeMany(span<const PolygonHandle>)", [](Scene& s, const std::vector<PolygonHandle>& all) {
    const bool isBad = !std::ranges::all_of(all, [&](PolygonHandle h) { return s.isAlive(h); });  // before they go
    return refusedIf(isBad, s.world.removeMany(all));
  });
  door(
      "World::replace(Cell, ShapeId, Block, span<PolygonHandle>)",
      [](Scene& s, Cell c, ShapeId id, Block b, Room room) {
        return withRoom(room, [&](auto handles) { return s.world.replace(c, id, b, handles); });
      },
      [](Scene& s, Cell c, ShapeId id, Block, Room) { return isOutOfRange(c) || isUnknown(s, id); });
  door("World::exchange(Cell, span<const PolygonHandle>, span<const NewPolygon>, span<PolygonHandle>)",
       [](Scene& s, Cell c, const std::vector<PolygonHandle>& gone, const std::vector<Points>& come, Block b,
          Room room) {
         std::vector<NewPolygon> added;
         for (const Points& p : come) added.push_back({p, b});
         return withRoom(room, [&](auto handles) { return s.world.exchange(c, gone, added, handles); });
       });
  door(
      "World::setBlock(PolygonHandle, Block)",
      [](Scene& s, PolygonHandle h, Block b) { return s.world.setBlock(h, b); },
      [](Scene& s, PolygonHandle h, Block) { return !s.isAlive(h); });
  door("World::fill(const CellRect&, ShapeId, Block, span<PolygonHandle>)",
       [](Scene& s, const CellRect& r, ShapeId id, Block b, Room room) {
         const bool isBad = !isEmpty(r) && (isOutOfRange(r.min) || isOutOfRange(r.max) || isUnknown(s, id));
         return withRoom(room, [&](auto handles) { return refusedIf(isBad, s.world.fill(r, id, b, handles)); });
       });
  door(
      "World::clear(const Rect&)", [](Scene& s, const CellRect& r) { return s.world.clear(r); },
      [](Scene&, const CellRect& r) { return !isEmpty(r) && (isOutOfRange(r.min) || isOutOfRange(r.max)); });
  door(
      "World::clear(Cell)", [](Scene& s, Cell c) { return s.world.clear(c); },
      [](Scene&, Cell c) { return isOutOfRange(c); });
  door("World::edit()", [](Scene& s, Cell c) {
    const Seen before = seenOf(s.world);
    {
      const Transaction group = s.world.edit();
      static_cast<void>(s.world.clear(c));
      static_cast<void>(s.world.add(c, s.shapes[0], 5));
    }
    EXPECT_EQ(before, seenOf(s.world));
  });
  door("Transaction::Transaction(World&)", [](Scene& s, Mark mark, bool commits) {
    Transaction outer(s.world), inner(s.world);
    static_cast<void>(s.world.rollBack(mark));
    if (commits) s.world.commit();
    inner.keep();
  });
  door("Transaction::~Transaction()", [](Scene& s, Mark mark) {
    Transaction group(s.world);
    static_cast<void>(s.world.add({0, 1}, s.shapes[0], 5));
    s.world.commit();
    static_cast<void>(s.world.forget(mark));
  });
  door("Transaction::keep()", [](Scene& s, Cell c) {
    Transaction group(s.world);
    static_cast<void>(s.world.add(c, s.shapes[0], 5));
    group.keep();
    group.keep();
  });
  door("World::commit()", [](Scene& s) { return s.world.commit().added.size(); });
  door("World::commit(const Executor&)", [](Scene& s, const Executor& executor, bool isFirst) {
    if (isFirst) s.world = World();
    if (isFirst) place(s.world, {3, 3}, unitSquare());
    return s.world.commit(executor).added.size();
  });
  door("World::mark()", [](Scene& s) { s.marks.push_back(s.world.mark()); });
  door("World::rollBack(Mark, Undone)",
       [](Scene& s, Mark mark, Undone undone) { return s.world.rollBack(mark, undone); });
  door("World::redo(Mark)", [](Scene& s, Mark mark, Mark from, bool edits) {
    static_cast<void>(s.world.rollBack(from, Undone::keep));
    if (edits) static_cast<void>(s.world.clear(Cell{0, 0}));
    const Seen before = seenOf(s.world);
    const bool done = s.world.redo(mark).has_value();
    EXPECT_TRUE(done || before == seenOf(s.world));
  });
  door("World::forget(Mark)", [](Scene& s, Mark mark) { return s.world.forget(mark); });
  door("World::unload(const CellRect&, const ChunkSink&)", [](Scene& s, const CellRect& r) {
    World copy = s.world;  // what is unloaded would be missing to all others
    std::vector<std::vector<std::byte>> chunks;
    const auto gone = copy.unload(
        r, [&](Cell, std::span<const std::byte> bytes) { chunks.emplace_back(bytes.begin(), bytes.end()); });
    const bool isBad = !isEmpty(r) && (isOutOfRange(r.min) || isOutOfRange(r.max));
    EXPECT_EQ(gone.has_value(), !isBad);
    EXPECT_EQ(gone.value_or(0), chunks.size());
    copy.commit();
    for (const auto& bytes : chunks) EXPECT_TRUE(copy.reload(bytes));
    copy.commit();
    EXPECT_TRUE(samePolygons(copy, s.world));
    return gone;
  });
  door("World::reload(span<const byte>)", [](Scene& s, const std::vector<std::byte>& file) {
    World copy = s.world;
    static_cast<void>(copy.reload(file));
    copy.commit();
  });
  door("World::reloadEmpty(const CellRect&)", [](Scene& s, const CellRect& r) { return s.world.reloadEmpty(r); });
  door("World::firstUnloaded(const CellRect&) const",
       [](Scene& s, const CellRect& r) { EXPECT_FALSE(s.world.firstUnloaded(r)); });
  door("World::forgetChunks(const CellRect&)", [](Scene& s, const CellRect& r, bool leaves) {
    if (leaves) s.world.commit();
    for (const Mark mark : s.marks)
      if (leaves) static_cast<void>(s.world.forget(mark));
    const std::uint64_t chunks = s.world.stats().chunks;
    const auto gone = s.world.forgetChunks(r);
    const bool isBad = !isEmpty(r) && (isOutOfRange(r.min) || isOutOfRange(r.max));
    EXPECT_TRUE(!isBad || !gone);
    EXPECT_EQ(s.world.stats().chunks, chunks - gone.value_or(0));
    return gone.value_or(0);
  });
  door("World::followCells(bool)", [](Scene& s, bool follows) { return s.world.followCells(follows); });
  door("World::load(span<const byte>, PreserveRelation)",
       [](Scene& s, const std::vector<std::byte>& bytes, const PreserveRelation& relation) {
         auto loaded = World::load(bytes, relation);
         if (loaded) s.other = std::move(*loaded);
       });
}

}  // namespace lgs::test
