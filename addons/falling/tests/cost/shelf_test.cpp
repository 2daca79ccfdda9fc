// What a Ground costs with many chunks on its shelf: a window, a save, a load and an undo take twice as much with twice
// as many, and not four times.
#include "visits.h"

#include <lgs/ground.h>

#include <gtest/gtest.h>

#include <functional>

namespace lgs::cost_test {
namespace {

constexpr CellRect kHere{{0, 0}, {31, 31}};

/// So many chunks on a side, of which one is in memory.
class Shelved {
 public:
  explicit Shelved(std::int32_t side, AtEdge atEdge) : side_(side), ground_(options(atEdge)) {
    EXPECT_TRUE(ground_.edit([&](World& world) -> Expected<void> {
      const ShapeId square = world.shape(kUnitSquare).value();
      for (std::int32_t j = 0; j < side; ++j)
        for (std::int32_t i = 0; i < side; ++i)
          if (const auto done = world.add({32 * i + 5, 32 * j}, square, 1); !done) return tl::unexpected(done.error());
      return {};
    }));
    ground_.forgetUndo();
    EXPECT_TRUE(ground_.window(kHere));
  }
  std::uint64_t costOfWindows() {
    return visitsOf([&] {
      EXPECT_TRUE(ground_.window({{0, 0}, {32 * side_ - 1, 32 * side_ - 1}}));
      EXPECT_TRUE(ground_.window(kHere));
    });
  }
  std::uint64_t costOfSave() {
    return visitsOf(
        [&] { EXPECT_TRUE(ground_.save([&](auto more) { saved_.insert(saved_.end(), more.begin(), more.end()); })); });
  }
  std::uint64_t costOfLoad() {
    return visitsOf([&] { EXPECT_TRUE(ground_.load(saved_) && ground_.window(kHere)); });
  }
  std::uint64_t costOfUndo() {
    EXPECT_TRUE(ground_.place({9, 9}, kUnitSquare, 1));
    return visitsOf([&] { EXPECT_TRUE(ground_.undo() && ground_.redo()); });
  }
  /// With nothing to come or go but one chunk.
  std::uint64_t costOfAStep() {
    return visitsOf([&] { EXPECT_TRUE(ground_.window({{0, 0}, {32, 31}}) && ground_.window(kHere)); });
  }

 private:
  static GroundOptions options(AtEdge atEdge) {
    return {.isAnchor = [](Block, Cell) { return true; }, .atEdge = atEdge};
  }
  std::int32_t side_;
  lgs::Ground<> ground_;
  std::vector<std::byte> saved_;
};

class CostOfShelf : public testing::TestWithParam<AtEdge> {
 protected:
  static void expectInProportion(const std::function<std::uint64_t(Shelved&)>& cost) {
    Shelved few(16, GetParam()), many(32, GetParam());
    const std::uint64_t once = cost(few), fourTimes = cost(many);
    EXPECT_LE(10 * fourTimes, 48 * once) << static_cast<double>(fourTimes) / static_cast<double>(once)
                                         << " times as much for four times as many";
  }
};

TEST_P(CostOfShelf, OfAWindowOverAllIsInProportion) { expectInProportion(&Shelved::costOfWindows); }
TEST_P(CostOfShelf, OfAWindowThatMovesByAChunkIsAtMostInProportion) { expectInProportion(&Shelved::costOfAStep); }
TEST_P(CostOfShelf, OfASaveIsInProportion) { expectInProportion(&Shelved::costOfSave); }
TEST_P(CostOfShelf, OfALoadIsInProportion) {
  expectInProportion([](Shelved& shelved) {
    shelved.costOfSave();
    return shelved.costOfLoad();
  });
}
TEST_P(CostOfShelf, OfAnUndoIsAtMostInProportion) { expectInProportion(&Shelved::costOfUndo); }

INSTANTIATE_TEST_SUITE_P(CostOfShelf, CostOfShelf, testing::Values(AtEdge::holds, AtEdge::open));

}  // namespace
}  // namespace lgs::cost_test
