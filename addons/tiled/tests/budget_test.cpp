// What an import may cost: the budget by itself. addons/tiled/tests/cost/import_test.cpp counts what imports really do.
#include "maps.h"

#include "addons/tiled/src/budget.h"

namespace lgs::tiled {
namespace {

Options with(std::size_t bytes, std::size_t work, std::size_t cells) {
  Options options{.maxBytes = bytes, .maxObjectCells = cells, .maxWork = work};
  return options;
}

TEST(TiledBudget, NoLimitIsTooLarge) {
  constexpr std::size_t kMost = ~std::size_t{0};
  Budget budget(with(kMost, kMost, kMost));
  EXPECT_TRUE(budget.read(1'000));
  EXPECT_TRUE(budget.work(kMost / 2));
}

TEST(TiledBudget, EachByteAllowsForMore) {
  Budget budget(with(10, 5, 0));
  EXPECT_TRUE(budget.work(5));
  EXPECT_TRUE(budget.read(2));
  EXPECT_TRUE(budget.work(2 * kWorkPerByte));
  EXPECT_FALSE(budget.isOutOfWork());
  EXPECT_FALSE(budget.work(1));
  EXPECT_TRUE(budget.isOutOfWork());
  EXPECT_TRUE(budget.read(8));
  EXPECT_FALSE(budget.work(1)) << "once it is spent it stays so";
  EXPECT_FALSE(budget.read(1)) << "10 bytes were read";
}

/// The cells of a bounding box count once; each cell that an edge runs through costs what meets in it.
TEST(TiledBudget, AStroke) {
  constexpr std::int64_t kUnit = kUnitsPerCell;
  const Polygon box{{1, 1}, {3 * kUnit - 1, 1}, {3 * kUnit - 1, 3 * kUnit - 1}, {1, 3 * kUnit - 1}};
  Budget nine(with(0, 1'000'000, 9));
  EXPECT_TRUE(nine.stroke(box));
  EXPECT_FALSE(nine.isOutOfCells());
  Budget eight(with(0, 1'000'000, 8));
  EXPECT_FALSE(eight.stroke(box));
  EXPECT_TRUE(eight.isOutOfCells());
  // 12 edges in cells: 4 of the 8 cells along the rim have one edge in them, 4 have two.
  constexpr std::size_t kSteps = 12 * 100 + 8 * 4'500 + 32 * (4 * 1 + 4 * 4);
  for (const std::size_t less : {std::size_t{0}, std::size_t{1}}) {
    Budget exact(with(0, kSteps - less, 9));
    EXPECT_EQ(exact.stroke(box), less == 0);
  }
  const Polygon slanted{{0, 0}, {4 * kUnit, 2 * kUnit}, {0, 2 * kUnit - 1}};
  Budget some(with(0, 1'000'000, 8));
  EXPECT_TRUE(some.stroke(slanted));
}

TEST(TiledBudget, FilesTogether) {
  const std::string set = "<tileset tilewidth='32' tileheight='32'/>";
  const std::string map = mapXml("<tileset firstgid='1' source='a.tsx'/>" + csvLayer(1, 1, "0"));
  Options options{.maxBytes = set.size() + map.size()};
  EXPECT_TRUE(importFiles({{"maps/test.tmx", map}, {"maps/a.tsx", set}}, options));
  --options.maxBytes;
  EXPECT_EQ(message(importFiles({{"maps/test.tmx", map}, {"maps/a.tsx", set}}, options).error()),
            "maps/test.tmx:3: <tileset> 'a.tsx' the tileset's file maps/a.tsx cannot be read: the files of the map are "
            "larger "
            "together than the limit (Options::maxBytes)");
}

TEST(TiledBudget, PathsOfLayersAreLimited) {
  const auto group = [](std::size_t length) {
    return mapXml("<group name='" + std::string(length, 'g') + "'><group name='h'/></group>");
  };
  EXPECT_EQ(refusalOf(group(4'094)), "accepted");
  EXPECT_EQ(refusalOf(group(4'095)), "maps/test.tmx:3: <group> 'h' has a path of names that is longer than 4096 bytes");
}

}  // namespace
}  // namespace lgs::tiled
