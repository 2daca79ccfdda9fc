// A long journey through a world of many chunks, of which a window is in memory, with marks: law 14 at length. At
// LGS_TEST_SCALE=250 there are 10^5 chunks and 10^6 edits.
#include "proptests/support/must.h"
#include "proptests/support/scale.h"
#include "unloaded.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

constexpr std::int32_t kWindow = 6;   // chunks each way
constexpr int kEditsOfAWindow = 360;  // ten for each chunk

class Journey {
 public:
  explicit Journey(std::int32_t side) : side_(side) {
    for (World* world : {&part_, &whole_}) {
      oracle::Random turns(7);
      shapes_ = turnedShapes(*world, turns);
    }
    for (std::int32_t j = 0; j < side; ++j) {
      for (std::int32_t i = 0; i < side; ++i) {
        for (int k = 0; k < 3; ++k) {
          const Cell at = cellIn(i, j);
          const ShapeId shape = random_.pick(shapes_);
          for (World* world : {&part_, &whole_}) EXPECT_TRUE(world->replace(at, shape, 1));
        }
        EXPECT_TRUE((i < kWindow && j < kWindow) || part_.unload(chunkAt(i, j), shelf_.sink()));
      }
      commit();
    }
  }

  void visitAll() {
    for (std::int32_t row = 0; row + kWindow <= side_; row += kWindow) {
      for (std::int32_t k = 0; k + kWindow <= side_; k += kWindow) {
        moveTo({row / kWindow % 2 == 0 ? k : side_ - kWindow - k, row});
        for (int n = 0; n < kEditsOfAWindow; ++n) {
          edit();
          if (n % 20 == 19) commit();
          if (n % 40 == 10) mark();
          if (n % 90 == 50) rollBack();
        }
        if (++visits_ % 10 == 0) forgetMarks();
        if (::testing::Test::HasFailure()) return;
      }
    }
  }

  void expectTheSame() {
    forgetMarks();
    for (std::int32_t j = 0; j < side_; ++j)
      for (std::int32_t i = 0; i < side_; ++i)
        EXPECT_TRUE(!part_.firstUnloaded(chunkAt(i, j)) || shelf_.reload(part_, chunkAt(i, j).min));
    part_.commit();
    whole_.commit();
    EXPECT_TRUE(samePolygons(part_, whole_));
    for (std::int32_t j = 0; j < side_ && !::testing::Test::HasFailure(); ++j)
      for (std::int32_t i = 0; i < side_; ++i) expectTheSameIn(chunkAt(i, j));
  }

  std::uint64_t edits() const { return edits_; }
  std::uint64_t roundTrips() const { return wentBack_; }

 private:
  struct Marks {
    Mark part, whole;
  };

  Cell cellIn(std::int32_t ci, std::int32_t cj) {
    const auto place = [&] { return random_.chance(80) ? random_.below(2) * 31 : random_.below(32); };
    const std::int32_t i = place(), j = place();
    return {32 * ci + i, 32 * cj + j};
  }
  CellRect windowAt(Cell at) const {
    return {chunkAt(at.i, at.j).min, chunkAt(at.i + kWindow - 1, at.j + kWindow - 1).max};
  }

  void moveTo(Cell to) {
    if (to == window_) return;
    EXPECT_TRUE(part_.unload(windowAt(window_), shelf_.sink()));
    if (random_.chance(50))
      for (World* world : {&part_, &whole_}) world->commit();
    window_ = to;
    for (std::int32_t j = 0; j < kWindow; ++j)
      for (std::int32_t i = 0; i < kWindow; ++i) EXPECT_TRUE(shelf_.reload(part_, chunkAt(to.i + i, to.j + j).min));
  }

  void edit() {
    ++edits_;
    const Cell at = cellIn(window_.i + random_.below(kWindow), window_.j + random_.below(kWindow));
    const ShapeId shape = random_.pick(shapes_);
    const Block block = random_.below(3U);
    const bool clears = random_.chance(30);
    std::vector<PolygonHandle> made;
    for (World* world : {&part_, &whole_}) {
      if (clears) {
        EXPECT_TRUE(world->clear(at));
      } else {
        made.push_back(must(world->replace(at, shape, block)));
      }
    }
    if (!clears) {
      EXPECT_EQ(made[0], made[1]);
    }
  }

  void commit() {
    part_.commit();
    whole_.commit();
    expectTheSameIn(chunkAt(window_.i + random_.below(kWindow), window_.j + random_.below(kWindow)));
  }

  void expectTheSameIn(const CellRect& cells) const {
    EXPECT_EQ(seen(part_, part_.segments(cells), true), seen(whole_, whole_.segments(cells), true));
  }

  void mark() {
    marks_.push_back({part_.mark(), whole_.mark()});
    if (marks_.size() <= 12) return;
    const auto gone = marks_.begin() + static_cast<std::ptrdiff_t>(random_.below(marks_.size()));
    EXPECT_TRUE(part_.forget(gone->part));
    EXPECT_TRUE(whole_.forget(gone->whole));
    marks_.erase(gone);
  }

  void rollBack() {
    if (marks_.empty()) return;
    const std::size_t to = marks_.size() - 1 - std::min(marks_.size() - 1, std::size_t{random_.below(3U)});
    ++wentBack_;
    const Undone undone = random_.chance(50) ? Undone::keep : Undone::drop;
    EXPECT_TRUE(part_.rollBack(marks_[to].part, undone));
    EXPECT_TRUE(whole_.rollBack(marks_[to].whole, undone));
    if (random_.chance(50)) commit();
    if (undone == Undone::keep && to + 1 < marks_.size() && random_.chance(50)) {
      const Cell here = window_;
      moveTo({here.i == 0 ? kWindow : here.i - 1, here.j});  // redo survives it
      if (random_.chance(50)) commit();
      EXPECT_TRUE(part_.redo(marks_[to + 1].part));
      EXPECT_TRUE(whole_.redo(marks_[to + 1].whole));
      marks_.resize(to + 2);
      if (random_.chance(50)) commit();
      moveTo(here);
      return;
    }
    marks_.resize(to + 1);
  }

  void forgetMarks() {
    for (const Marks& m : marks_) {
      EXPECT_TRUE(part_.forget(m.part));
      EXPECT_TRUE(whole_.forget(m.whole));
    }
    marks_.clear();
  }

  std::int32_t side_;
  World part_, whole_;
  std::vector<ShapeId> shapes_;
  oracle::Random random_{39};
  Shelf shelf_;
  Cell window_{0, 0};
  std::vector<Marks> marks_;
  std::uint64_t edits_ = 0, wentBack_ = 0;
  int visits_ = 0;
};

TEST(UnloadedSoak, AJourneyThroughManyChunksLosesNothing) {
  const auto chunks = static_cast<double>(scaled(400));
  const std::int32_t side = std::max(2, static_cast<std::int32_t>(std::sqrt(chunks)) / kWindow + 1) * kWindow;
  Journey journey(side);
  journey.visitAll();
  journey.expectTheSame();
  std::printf("%d chunks, %llu edits, rolled back %llu times\n", side * side,
              static_cast<unsigned long long>(journey.edits()), static_cast<unsigned long long>(journey.roundTrips()));
}

}  // namespace
}  // namespace lgs::test
