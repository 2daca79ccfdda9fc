#include "followed.h"

#include "oracle/views/ground_hashes.h"
#include "oracle/views/island_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace lgs::test {
namespace {

bool isAnchored(Block block, Cell /*cell*/) { return isBedrock(block); }
std::int32_t isAnchoredInC(void* /*user*/, lgs_block block, lgs_cell /*cell*/) { return isBedrock(block) ? 1 : 0; }

/// What is known of an island, without names.
using Facts = std::tuple<std::int64_t, std::int64_t, std::int64_t, std::uint64_t, std::uint32_t, std::uint64_t>;

std::vector<Facts> islandsOf(const Islands& islands) {
  std::vector<Facts> all;
  for (const IslandId id : islands.all()) {
    const IslandFacts f = *islands.island(id);
    all.emplace_back(f.outer.west.x, f.outer.west.y, f.outer.doubleArea.high, f.outer.doubleArea.low, f.outer.segments,
                     f.anchors);
  }
  std::ranges::sort(all);
  return all;
}

std::vector<lgs_island_id> idsIn(const lgs_islands* islands) {
  std::size_t count = 0;
  static_cast<void>(lgs_islands_ids(islands, LGS_ALL, nullptr, 0, &count));
  std::vector<lgs_island_id> ids(count);
  EXPECT_EQ(lgs_islands_ids(islands, LGS_ALL, ids.data(), count, nullptr), LGS_OK);
  return ids;
}

std::vector<Facts> islandsOf(const lgs_islands* islands) {
  std::vector<Facts> all;
  for (const lgs_island_id id : idsIn(islands)) {
    lgs_island f{};
    EXPECT_EQ(lgs_islands_get(islands, id, &f), LGS_OK);
    all.emplace_back(f.outer.west.x, f.outer.west.y, f.outer.double_area_high, f.outer.double_area_low,
                     f.outer.segments, f.anchors);
  }
  std::ranges::sort(all);
  return all;
}

/// The cells that hold polygons, and those above them.
std::vector<Cell> cellsToAsk(const World& world) {
  std::vector<Cell> cells;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon&) {
    cells.push_back(cell);
    if (cell.j < kMaxCell) cells.push_back({cell.i, cell.j + 1});
  });
  return cells;
}

void expectRight(const Followed& f) {
  const auto expectNone = [](const std::optional<std::string>& fault) { EXPECT_EQ(fault.value_or(""), ""); };
  if (f.loops->version() == f.world.version()) expectNone(oracle::LoopCheck().begin(f.world, *f.loops));
  if (f.islands->loops().version() == f.world.version())
    expectNone(oracle::IslandCheck(isAnchored).begin(f.world, *f.islands));
  expectNone(oracle::faultOf(*f.hashes, f.world));
  const Pieces fresh(f.world);
  for (const Cell cell : cellsToAsk(f.world)) {
    EXPECT_EQ(f.pieces->solidPieces(cell).size(), fresh.solidPieces(cell).size());
    EXPECT_EQ(f.pieces->freePieces(cell).size(), fresh.freePieces(cell).size());
  }
}

World copyOf(const lgs_world* world) {
  std::vector<std::byte> bytes;
  const lgs_write_fn keep = [](void* user, const std::uint8_t* data, std::size_t size) {
    auto& all = *static_cast<std::vector<std::byte>*>(user);
    for (const std::uint8_t byte : std::span(data, size)) all.push_back(std::byte{byte});
  };
  EXPECT_EQ(lgs_save(world, keep, &bytes, nullptr), LGS_OK);
  return World::load(bytes).value();
}

void expectRight(const FollowedC& f) {
  const World world = copyOf(f.world.get());
  EXPECT_EQ(islandsOf(f.islands.get()), islandsOf(Islands(world, isAnchored)));
  for (const int level : {0, 1, 14}) {
    std::vector<lgs_hashed_square> squares(64);
    std::size_t count = 0;
    const lgs_cell_rect all{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};
    EXPECT_EQ(lgs_hashes_in(f.hashes.get(), all, level, squares.data(), squares.size(), &count), LGS_OK);
    const std::vector<HashedSquare> expected = oracle::groundHashes(world, level);
    ASSERT_EQ(count, expected.size());
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(squares[k].hash, expected[k].hash);
  }
  const Pieces fresh(world);
  for (const Cell cell : cellsToAsk(world)) {
    std::size_t solid = 0, free = 0;
    EXPECT_EQ(lgs_pieces_count(f.pieces.get(), {cell.i, cell.j}, LGS_SOLID, &solid), LGS_OK);
    EXPECT_EQ(lgs_pieces_count(f.pieces.get(), {cell.i, cell.j}, LGS_FREE, &free), LGS_OK);
    EXPECT_EQ(solid, fresh.solidPieces(cell).size());
    EXPECT_EQ(free, fresh.freePieces(cell).size());
  }
}

}  // namespace

Followed::Followed() {
  static_cast<void>(world.followCells(true));
  const ShapeId square = shapeOf(world, {unitSquare()});
  static_cast<void>(world.fill({{-2, -1}, {4, 1}}, square, 1));
  static_cast<void>(world.clear(Cell{0, 0}));
  static_cast<void>(world.fill({{1, 3}, {2, 3}}, square, 2));
  place(world, {2, 4}, ramp(), 3);
  world.commit();
  static_cast<void>(other.followCells(true));
  place(other, {5, 5}, ramp(), 4);
  world.commit();
  other.commit();
  loops.emplace(world);
  islands.emplace(world, isAnchored);
  pieces.emplace(world);
  hashes.emplace(world);
  early = world.commit();
  static_cast<void>(world.clear(Cell{2, 3}));
  follow(world.commit());
}

void Followed::follow(const Changes& changes) {
  static_cast<void>(loops->update(world, changes));
  static_cast<void>(islands->update(world, changes));
  static_cast<void>(pieces->update(world, changes));
  static_cast<void>(hashes->update(world, changes));
  last = changes;
}

Followed& followedBy(Scene& scene) {
  if (!scene.followed) scene.followed = std::make_shared<Followed>();
  return *scene.followed;
}

ListsOfC::ListsOfC(const lgs_changes& changes)
    : removed(changes.removed, changes.removed + changes.removed_count),
      added(changes.added, changes.added + changes.added_count),
      relinked(changes.relinked, changes.relinked + changes.relinked_count),
      before(changes.before),
      after(changes.after) {}

lgs_changes ListsOfC::asChanges() const {
  return {removed.data(), added.data(), relinked.data(), removed.size(), added.size(), relinked.size(), before, after};
}

FollowedC::FollowedC() {
  constexpr lgs_local_point corners[] = {{0, 0}, {U, 0}, {U, U}, {0, U}};
  for (CWorld* each : {&world, &other}) {
    lgs_world* made = nullptr;
    EXPECT_EQ(lgs_new(nullptr, &made), LGS_OK);
    each->reset(made);
    EXPECT_EQ(lgs_follow_cells(made, 1, nullptr), LGS_OK);
    EXPECT_EQ(lgs_shape(made, corners, 4, &square, nullptr), LGS_OK);
  }
  EXPECT_EQ(lgs_add(other.get(), {5, 5}, square, 4, nullptr, nullptr), LGS_OK);
  EXPECT_EQ(lgs_commit(other.get(), nullptr), LGS_OK);
  EXPECT_EQ(lgs_fill(world.get(), {{-2, -1}, {4, 1}}, square, 1, nullptr, nullptr), LGS_OK);
  EXPECT_EQ(lgs_clear(world.get(), {{0, 0}, {0, 0}}, nullptr, nullptr), LGS_OK);
  EXPECT_EQ(lgs_fill(world.get(), {{1, 2}, {2, 4}}, square, 2, nullptr, nullptr), LGS_OK);
  EXPECT_EQ(lgs_commit(world.get(), nullptr), LGS_OK);
  begin(isAnchoredInC);
  EXPECT_EQ(lgs_clear(world.get(), {{1, 2}, {2, 2}}, nullptr, nullptr), LGS_OK);
  commit();
  early = last;
  EXPECT_EQ(lgs_add(world.get(), {9, 9}, square, 7, nullptr, nullptr), LGS_OK);
  commit();
  lgs_body* taken = nullptr;
  EXPECT_EQ(lgs_take(world.get(), islands.get(), anIsland(), &taken, nullptr), LGS_OK);
  body.reset(taken);
  commit();
}

void FollowedC::begin(lgs_anchor_fn isAnchor) {
  lgs_islands* ofIslands = nullptr;
  lgs_pieces* ofPieces = nullptr;
  lgs_hashes* ofHashes = nullptr;
  EXPECT_EQ(lgs_islands_new(world.get(), isAnchor, nullptr, &ofIslands), LGS_OK);
  EXPECT_EQ(lgs_pieces_new(world.get(), 8, &ofPieces), LGS_OK);
  EXPECT_EQ(lgs_hashes_new(world.get(), &ofHashes), LGS_OK);
  islands.reset(ofIslands);
  pieces.reset(ofPieces);
  hashes.reset(ofHashes);
}

void FollowedC::commit() {
  lgs_changes changes{};
  EXPECT_EQ(lgs_commit(world.get(), &changes), LGS_OK);
  EXPECT_EQ(lgs_islands_update(islands.get(), world.get(), &changes), LGS_OK);
  EXPECT_EQ(lgs_pieces_update(pieces.get(), world.get(), &changes, nullptr, nullptr), LGS_OK);
  EXPECT_EQ(lgs_hashes_update(hashes.get(), world.get(), &changes), LGS_OK);
  last = ListsOfC(changes);
}

lgs_island_id FollowedC::anIsland() const {
  const std::vector<lgs_island_id> ids = idsIn(islands.get());
  return ids.empty() ? lgs_island_id{} : ids.back();
}

FollowedC& followedInCBy(Scene& scene) {
  if (!scene.followedInC) scene.followedInC = std::make_shared<FollowedC>();
  return *scene.followedInC;
}

void expectViewsAreRight(const Scene& scene) {
  if (scene.followed) expectRight(*scene.followed);
  if (scene.followedInC) expectRight(*scene.followedInC);
}

}  // namespace lgs::test
