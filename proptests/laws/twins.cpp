#include "twins.h"

#include "oracle/reference/naive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <type_traits>

namespace lgs::test {
namespace {

using oracle::Random;

constexpr std::int32_t kSide = 4;
constexpr Block kBlocks = 3;

Cell someCell(Random& random) { return {30 + random.below(kSide), -2 + random.below(kSide)}; }

}  // namespace

AnyEdit randomEdit(const World& world, Random& random) {
  using Make = AnyEdit::Kind;
  AnyEdit edit;
  edit.cell = someCell(random);
  edit.block = 1 + random.below(kBlocks);
  edit.shape = {1 + random.below(static_cast<std::uint32_t>(world.stats().shapes + 1))};
  edit.polygons = random.pick(oracle::degenerateShapes()).polygons;
  for (LocalPolygon& polygon : edit.polygons) polygon = oracle::turned(polygon, static_cast<int>(edit.block));
  const std::vector<PlacedPolygon> there = world.polygons(edit.cell);
  edit.polygon = there.empty() ? PolygonHandle{random.below(3000U), 1 + random.below(3U)} : random.pick(there).handle;
  edit.cells = {edit.cell, {edit.cell.i + random.below(3), edit.cell.j + random.below(3)}};
  const int what = random.below(100);
  edit.kind = what < 4    ? Make::shape
              : what < 24 ? Make::add
              : what < 36 ? Make::addPolygon
              : what < 56 ? Make::remove
              : what < 64 ? Make::replace
              : what < 70 ? Make::setBlock
              : what < 75 ? Make::fill
              : what < 78 ? Make::clear
                          : Make::commit;
  if (random.chance(1)) edit.cell = {kMaxCell - random.below(3), kMaxCell};  // a chunk of its own
  return edit;
}

namespace {

template <class T>
Outcome outcomeOf(const Expected<T>& result) {
  if (!result) return result.error().code;
  if constexpr (std::is_void_v<T>)
    return std::uint64_t{0};
  else
    return *result;
}

}  // namespace

Outcome makeEdit(World& world, const AnyEdit& edit) {
  switch (edit.kind) {
    case AnyEdit::Kind::shape:
      return outcomeOf(world.shape(edit.polygons));
    case AnyEdit::Kind::add:
      return outcomeOf(world.add(edit.cell, edit.shape, edit.block));
    case AnyEdit::Kind::addPolygon:
      return outcomeOf(world.add(edit.cell, std::span<const LocalPoint>(edit.polygons[0]), edit.block));
    case AnyEdit::Kind::remove:
      return outcomeOf(world.remove(edit.polygon));
    case AnyEdit::Kind::replace:
      return outcomeOf(world.replace(edit.cell, edit.shape, edit.block));
    case AnyEdit::Kind::setBlock:
      return outcomeOf(world.setBlock(edit.polygon, edit.block));
    case AnyEdit::Kind::fill:
      return outcomeOf(world.fill(edit.cells, edit.shape, edit.block));
    case AnyEdit::Kind::clear:
      return outcomeOf(world.clear(edit.cells));
    case AnyEdit::Kind::commit:
      break;
  }
  return copyOf(world.commit());
}

PreserveRelation relation(bool preserves) {
  if (!preserves) return {};
  return [](Block a, Block b) { return a != b; };
}

World grown(bool preserves, const Seeds& seeds) {
  World world(relation(preserves));
  shapeOf(world, {unitSquare()});
  makeAll(world, seeds);
  return world;
}

oracle::Outline outlineByLaws(const World& world, bool preserves) {
  oracle::Scene scene;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    scene.polygons.push_back({cell, p.block, LocalPolygon(p.vertices.begin(), p.vertices.end())});
  });
  if (preserves)
    for (Block a = 1; a <= kBlocks; ++a)
      for (Block b = a + 1; b <= kBlocks; ++b) scene.preserve.add(a, b);
  return oracle::NaiveReference()(scene).outline;
}

void makeAll(World& world, const Seeds& seeds) {
  for (const std::uint32_t seed : seeds) {
    Random random(seed);
    makeEdit(world, randomEdit(world, random));
  }
}

void expectNoDifference(World& stayed, World& left, const Seeds& seeds) {
  for (const std::uint32_t seed : seeds) {
    Random random(seed);
    const AnyEdit edit = randomEdit(stayed, random);
    const Outcome one = makeEdit(stayed, edit), other = makeEdit(left, edit);
    ASSERT_EQ(one, other) << "an edit of kind " << static_cast<int>(edit.kind);
  }
  EXPECT_EQ(copyOf(stayed.commit()), copyOf(left.commit()));
  EXPECT_EQ(snapshotOf(stayed, {}), snapshotOf(left, {}));
  EXPECT_TRUE(samePolygons(stayed, left));
  EXPECT_TRUE(saved(stayed) == saved(left)) << "saved, they are different bytes";
}

Follower::Follower(const World& world) {
  for (const SegmentId id : world.segments()) segments_[id] = fieldsOf(*world.segment(id));
}

void Follower::follow(const World& world, const Changes& changes) {
  for (const SegmentId id : changes.removed) EXPECT_EQ(segments_.erase(id), 1U) << "removed: " << id.value;
  for (const SegmentId id : changes.added) EXPECT_TRUE(segments_.emplace(id, SegmentFields{}).second) << id.value;
  for (const auto* ids : {&changes.added, &changes.relinked})
    for (const SegmentId id : *ids) segments_.at(id) = fieldsOf(*world.segment(id));
}

// The lists do not tell the ids of predecessor and successor: a link may go to another segment with the same end.
bool Follower::agrees(const World& world) const {
  const auto told = [](SegmentFields fields) {
    fields.predecessor = fields.successor = {};
    return fields;
  };
  const std::vector<SegmentId> ids = world.segments();
  if (ids.size() != segments_.size()) return false;
  return std::all_of(ids.begin(), ids.end(), [&](SegmentId id) {
    const auto found = segments_.find(id);
    return found != segments_.end() && told(found->second) == told(fieldsOf(*world.segment(id)));
  });
}

std::vector<std::byte> saved(const World& world) {
  std::vector<std::byte> bytes;
  const auto done =
      world.save([&](std::span<const std::byte> piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); });
  EXPECT_TRUE(done);
  return bytes;
}

}  // namespace lgs::test
