// A world that is cut into regions: whatever the cutting, the order of commits and their grouping, the segments of all
// regions together are those of one world, with their links by rank and id (examples/regions).
#include "oracle/trace/model.h"
#include "proptests/halo/cuttings.h"
#include "proptests/halo/ranks.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

using oracle::Call;
using oracle::Random;

/// The edits that regions can play: the cells of the others belong to nobody.
oracle::Trace inRangeOnly(oracle::Trace trace) {
  std::erase_if(trace.calls, [](const Call& edit) { return !inRange(edit.polygon().cell); });
  return trace;
}

/// One world and the ranks, which get the same edits. A trace's names name nothing here: regions know polygons by their
/// vertices.
class Twins {
 public:
  Twins(const oracle::Trace& trace, const regions::Cutting& cutting, std::uint64_t seed)
      : world_(oracle::relationOf(trace.preserve)), ranks_(cutting, oracle::relationOf(trace.preserve)), seed_(seed) {}

  void play(const Call& edit, Random& random) {
    if (edit.kind == Call::Kind::add) {
      const auto& [cell, block, vertices] = edit.polygon();
      if (alive_.contains(edit.name())) return;
      const auto handle = world_.add(cell, vertices, block);
      refused_ += handle ? 0U : 1U;
      if (handle) alive_[edit.name()] = {*handle, edit.polygon()};
      propose({regions::Edit::Kind::add, cell, block, vertices});
    } else if (const auto found = alive_.find(edit.name()); found != alive_.end()) {
      const auto [handle, polygon] = found->second;
      const bool isLast = world_.polygons(polygon.cell).size() == 1;
      failUnless(world_.remove(handle).has_value(), "the one world refuses a remove");
      if (isLast && random.chance(50))
        propose({regions::Edit::Kind::clear, polygon.cell, 0, {}});
      else
        propose({regions::Edit::Kind::remove, polygon.cell, 0, polygon.vertices});
      alive_.erase(found);
    }
  }

  /// The edits of a cell come from one rank, whoever owns it. So they arrive in their order.
  void propose(const regions::Edit& edit) {
    Random from(seed_ ^ static_cast<std::uint64_t>(std::int64_t{edit.cell.i} * 31 + edit.cell.j));
    ranks_.propose(from.below(ranks_.size()), edit);
  }

  /// All ranks and the one world come to the end of a round. If all commits happened here, they list the same changes.
  void meet(bool together, Random& random) {
    Listed listed;
    copy_.update(world_, world_.commit(), listed);
    ranks_.finish(random);
    failUnless(ranks_.refused() == refused_, "other edits are refused");
    failUnless(ranks_.rows() == rowsOf(world_), "the regions' segments are not those of one world");
    failUnless(!together || ranks_.listed() == listed, "the regions list other changes than one world");
    ranks_.forgetListed();
  }

  Ranks& ranks() { return ranks_; }

 private:
  World world_;
  Copy copy_;
  Ranks ranks_;
  std::uint64_t seed_;
  std::uint64_t refused_ = 0;
  std::map<std::string, std::pair<PolygonHandle, oracle::ScenePolygon>> alive_;
};

void playInRegions(const oracle::Trace& trace, Chance chance) {
  if (isEmpty(boundsOf(trace))) return;
  Twins twins(trace, randomCutting(boundsOf(trace), chance), chance.next());
  const bool together = chance.chance(30);
  for (const Call& edit : trace.calls) {
    if (edit.kind == Call::Kind::commit)
      twins.meet(together, chance);
    else
      twins.play(edit, chance);
    while (!together && chance.chance(60)) twins.ranks().step(chance);
  }
  twins.meet(together, chance);
}

LGS_LAW(Halo, RegionsGiveTheSegmentsOfOneWorld, 1'000, (const AnyTrace& trace, Chance chance)) {
  playInRegions(inRangeOnly(trace), chance);
}

/// By hand: a full block, and its owner's neighbour across a corner alone. The link at that corner turns from one solid
/// to the other, so it leads across the border.
TEST(Halo, ALinkLeadsAcrossACorner) {
  const regions::Cutting cutting{{{0, 0}, {0, 0}}, {{1, 1}, {1, 1}}};
  Ranks ranks(cutting, {});
  Random random(1);
  const auto add = [](Cell cell) {
    return regions::Edit{regions::Edit::Kind::add, cell, 1, {kUnitSquare.begin(), kUnitSquare.end()}};
  };
  ranks.propose(1, add({0, 0}));
  ranks.propose(0, add({1, 1}));
  ranks.finish(random);
  const Rows rows = ranks.rows();
  ASSERT_EQ(rows.size(), 8U);
  const Key right{{U, 0}, {U, U}};
  const Key bottom{{U, U}, {2 * U, U}};
  EXPECT_EQ(rows.at(right).successor, bottom);
  EXPECT_EQ(rows.at(bottom).predecessor, right);
}

/// A polygon takes the place of an equal one: nothing about its neighbours' ghosts changes, but the segment has another
/// id, which they must hear of.
TEST(Halo, ALinkFollowsANewOwner) {
  const regions::Cutting cutting{{{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}};
  Ranks ranks(cutting, {});
  Random random(1);
  const std::vector<LocalPoint> square(kUnitSquare.begin(), kUnitSquare.end());
  for (const Cell cell : {Cell{0, 0}, Cell{1, 0}}) ranks.propose(0, {regions::Edit::Kind::add, cell, 1, square});
  ranks.finish(random);
  ASSERT_EQ(ranks.rows().size(), 6U);
  ranks.forgetListed();
  ranks.propose(1, {regions::Edit::Kind::remove, {1, 0}, 0, square});
  ranks.propose(1, {regions::Edit::Kind::add, {1, 0}, 1, square});
  ranks.finish(random);
  EXPECT_EQ(ranks.rows().size(), 6U);
  EXPECT_EQ(ranks.listed().size(), 6U);  // three removed, three added, none relinked
}

TEST(Halo, ARefusedEditIsToldToNobody) {
  const regions::Cutting cutting{{{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}};
  regions::Region region(cutting, 0);
  regions::Outbox out(2);
  const regions::Edit add{regions::Edit::Kind::add, {0, 0}, 1, {kUnitSquare.begin(), kUnitSquare.end()}};
  ASSERT_TRUE(region.decide(add, out));
  EXPECT_EQ(regions::readEdits(out[1]).size(), 1U);
  EXPECT_EQ(region.decide(add, out).error().code, ErrorCode::overlap);
  EXPECT_EQ(regions::readEdits(out[1]).size(), 1U);
}

TEST(Halo, ACuttingForSoManyRanksHasAllCellsOnce) {
  const CellRect cells{{-7, 3}, {12, 29}};
  for (int ranks = 1; ranks <= 9; ++ranks) {
    const regions::Cutting cutting = regions::cutInto(cells, ranks);
    ASSERT_EQ(cutting.size(), static_cast<std::size_t>(ranks));
    std::size_t covered = 0;
    for (const CellRect& piece : cutting) {
      const std::size_t size = cellsOf(piece).size();
      EXPECT_GE(2 * size * static_cast<std::size_t>(ranks), cellsOf(cells).size());
      covered += size;
    }
    EXPECT_EQ(covered, cellsOf(cells).size());
    for (const Cell cell : cellsOf(cells)) EXPECT_TRUE(regions::ownerOf(cutting, cell));
  }
}

}  // namespace
}  // namespace lgs::test
