// Doors of the hashes of the ground. What is told to a copy may be made up: then its sums mean nothing, but the same
// told backwards leads back.
#include "door.h"
#include "followed.h"

#include "oracle/views/ground_hashes.h"

#include <lgs/unloaded.h>

#include <algorithm>

namespace lgs::test {
namespace {

constexpr CellRect kEverywhere{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

/// Changes of cells that a view may be told: the last ones once more, and what a stranger made up.
struct ToldCells {
  int which = 0;
};

/// Keeps what spans lead to.
struct MadeUp {
  std::vector<PlacedPolygon> before, now;
  std::vector<CellChange> changes;
};

MadeUp madeUp(const Followed& f, ToldCells told) {
  static const std::vector<LocalPoint> square = unitSquare(), none, huge(5'000, LocalPoint{kLeast, kMost});
  MadeUp made;
  const auto in = [&](Cell cell) { made.changes.push_back({cell, made.before, made.now}); };
  made.before = {{{}, 1, square}};
  switch (told.which) {
    case 0:
      made.changes.assign(f.world.cellChanges().begin(), f.world.cellChanges().end());
      break;
    case 1:
      break;
    case 2:  // what never was goes
      in({0, 0});
      in({0, 0});
      break;
    case 3:
      made.now = {{{}, 0xffff'ffff, none}, {{}, 0, huge}};
      for (const Cell cell : {Cell{kLeast, kLeast}, Cell{kMost, kMost}, Cell{kMaxCell + 1, -kMaxCell - 1}}) in(cell);
      break;
    case 4:  // comes and goes at once
      made.now = made.before;
      in({kMaxCell, -kMaxCell});
      break;
    default:
      made.now = std::vector<PlacedPolygon>(3'000, PlacedPolygon{{}, 2, square});
      for (std::int32_t k = 0; k < 40; ++k) in({k * 1'000'003, -k * 999'983});
  }
  return made;
}

}  // namespace

LGS_VALUES(ToldCells, fmt::format("changes {} of cells", v.which), {0}, {1}, {2}, {3}, {4}, {5})

void addDoorsOfHashes(Doors& door) {
  door("GroundHashes::GroundHashes(const World&)", [](Scene& s, bool isOther) {
    const World& world = isOther ? s.other : s.world;  // with edits that are not committed
    EXPECT_EQ(oracle::faultOf(GroundHashes(world), world).value_or(""), "");
  });
  door("GroundHashes::update(span<const CellChange>)", [](Scene& s, ToldCells told) {
    const Followed& f = followedBy(s);
    GroundHashes copy = *f.hashes;
    const MadeUp made = madeUp(f, told);
    copy.update(made.changes);
    static_cast<void>(copy.whole());
    static_cast<void>(differences(copy, *f.hashes));
    static_cast<void>(copy.hashes(kEverywhere, 0));
    std::vector<CellChange> back;
    for (const CellChange& change : made.changes) back.push_back({change.cell, change.now, change.before});
    copy.update(back);
    EXPECT_EQ(differences(copy, *f.hashes).size(), 0U);
    EXPECT_EQ(oracle::faultOf(copy, f.world).value_or(""), "");
  });
  door("unloadedChunks(const World&)", [](Scene& s, bool isOther) {
    const World& world = isOther ? s.other : s.world;
    for (const CellRect& chunk : unloadedChunks(world)) EXPECT_EQ(world.firstUnloaded(chunk), chunk.min);
  });
  door("GroundHashes::set(Cell, uint64_t)", [](Scene& s, Cell chunk, std::uint64_t hash) {
    const Followed& f = followedBy(s);
    GroundHashes copy = *f.hashes;
    copy.set(chunk, hash);
    EXPECT_LE(differences(copy, *f.hashes).size(), 1U);
    EXPECT_LE(copy.hashes(kEverywhere).size(), f.hashes->hashes(kEverywhere).size() + 1);
  });
  door("GroundHashes::hash() const", [](Scene& s) {
    const Followed& f = followedBy(s);
    EXPECT_EQ(f.hashes->hash(), groundHash(f.world, kEverywhere));
  });
  door("GroundHashes::hashes(const CellRect&, int) const", [](Scene& s, const CellRect& rect, int level) {
    const Followed& f = followedBy(s);
    std::vector<HashedSquare> expected;
    const bool isLevel = level >= 0 && level <= GroundHashes::kTopLevel;
    const CellRect asked{{std::max(rect.min.i, -kMaxCell), std::max(rect.min.j, -kMaxCell)},
                         {std::min(rect.max.i, kMaxCell), std::min(rect.max.j, kMaxCell)}};
    if (isLevel && !isEmpty(asked)) expected = oracle::groundHashes(f.world, level);
    std::erase_if(expected, [&](const HashedSquare& q) {
      return q.cells.max.i < asked.min.i || q.cells.min.i > asked.max.i || q.cells.max.j < asked.min.j ||
             q.cells.min.j > asked.max.j;
    });
    EXPECT_EQ(f.hashes->hashes(rect, level), expected);
  });
  door("GroundHashes::whole() const", [](Scene& s) {
    const Followed& f = followedBy(s);
    EXPECT_EQ(f.hashes->whole().hash, f.hashes->hash());
    EXPECT_EQ(GroundHashes(World()).whole(), GroundHashes::square({0, 0}, 0));
  });
  door("GroundHashes::square(Cell, int)", [](Scene&, Cell cell, int level) {
    const HashedSquare square = GroundHashes::square(cell, level);
    EXPECT_TRUE(inRange(square.cells.min) && inRange(square.cells.max) && !isEmpty(square.cells));
    EXPECT_EQ(square.level, std::clamp(level, 0, GroundHashes::kTopLevel));
    EXPECT_TRUE(!inRange(cell) || contains(square.cells, cell));
  });
  door("GroundHashes::bytes() const", [](Scene& s) { return followedBy(s).hashes->bytes(); });
  door("differences(const GroundHashes&, const GroundHashes&)", [](Scene& s, bool isOther) {
    const Followed& f = followedBy(s);
    const GroundHashes none{World()}, ofOther{f.other};
    const std::vector<CellRect> cells = differences(isOther ? ofOther : none, *f.hashes);
    EXPECT_EQ(cells.empty(), f.hashes->hash() == (isOther ? ofOther : none).hash());
  });
  // A rectangle that is cut in two has the sum.
  door("groundHash(const World&, const CellRect&)", [](Scene& s, const CellRect& rect) {
    const std::uint64_t whole = groundHash(s.world, rect);
    if (isEmpty(rect)) {
      EXPECT_EQ(whole, 0U);
      return;
    }
    const auto middle =
        static_cast<std::int32_t>(rect.min.i + (std::int64_t{rect.max.i} - std::int64_t{rect.min.i}) / 2);
    std::uint64_t sum = groundHash(s.world, {rect.min, {middle, rect.max.j}});
    if (middle < rect.max.i) sum += groundHash(s.world, {{middle + 1, rect.min.j}, rect.max});
    EXPECT_EQ(sum, whole);
  });
}

}  // namespace lgs::test
