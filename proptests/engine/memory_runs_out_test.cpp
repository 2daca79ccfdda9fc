// When memory runs out the program ends (world.h): whichever allocation of whichever call fails. Each is tried in a
// process of its own, until the call has all that it asks for.
#include "proptests/laws/allocations.h"

#include <lgs/world.h>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <functional>
#include <new>
#include <span>
#include <string>
#include <vector>

namespace lgs::test {
namespace {

struct Door {
  std::string name;
  std::function<void(World&, Mark)> call;
};

constexpr CellRect kRect{{-1, -1}, {3, 2}};

/// Some ground, a mark, ground that is not committed.
World someWorld(Mark& mark) {
  World world;
  const ShapeId square = world.shape(kUnitSquare).value();
  EXPECT_TRUE(world.fill(kRect, square, 1));
  world.commit();
  mark = world.checkpoint();
  EXPECT_TRUE(world.clear(Cell{1, 1}));
  world.commit();
  EXPECT_TRUE(world.add({1, 1}, {{0, 0}, {9, 0}, {0, 9}}, 2));
  return world;
}

const std::vector<Door>& doors() {
  static const auto ignore = [](const auto&) {};
  static const std::vector<LocalPoint> kNew{{20, 20}, {900, 30}, {40, 800}, {30, 300}};
  static const std::vector<Door> all{
      {"shape", [](World& w, Mark) { ignore(w.shape(kNew)); }},
      {"add",
       [](World& w, Mark) {
         ignore(w.add({99, 99}, kNew, 3));
       }},
      {"add beside",
       [](World& w, Mark) {
         ignore(w.add({1, 1}, kNew, 3));
       }},
      {"exchange",
       [](World& w, Mark) {
         const NewPolygon added{kNew, 3};
         ignore(w.exchange({1, 1}, {}, {&added, 1}));
       }},
      {"addMany",
       [](World& w, Mark) {
         constexpr std::array<Placement, 3> many{
             {{{70, 0}, ShapeId{1}, 1}, {{0, 70}, ShapeId{1}, 2}, {{1, 1}, ShapeId{1}, 2}}};
         ignore(w.addMany(many));
       }},
      {"fill",
       [](World& w, Mark) {
         ignore(w.fill({{40, 40}, {70, 41}}, ShapeId{1}, 4));
       }},
      {"clear", [](World& w, Mark) { ignore(w.clear(kRect)); }},
      {"commit", [](World& w, Mark) { ignore(w.commit()); }},
      {"checkpoint", [](World& w, Mark) { ignore(w.checkpoint()); }},
      {"rollBack", [](World& w, Mark mark) { ignore(w.rollBack(mark)); }},
      {"forget", [](World& w, Mark mark) { ignore(w.forget(mark)); }},
      {"copy", [](World& w, Mark) { ignore(World(w)); }},
      {"save and load",
       [](World& w, Mark) {
         w.commit();
         std::vector<std::byte> bytes;
         ignore(
             w.save([&](std::span<const std::byte> piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); }));
         ignore(World::load(bytes));
       }},
      {"loops", [](World& w, Mark) { ignore(w.loops(Collinear::merge)); }},
      {"at",
       [](World& w, Mark) {
         ignore(w.at({5, 5}));
       }},
  };
  return all;
}

enum class End : std::uint8_t { done, aborted, otherwise };

/// What becomes of a process in which the allocation of this number is refused, and all after it.
End endOf(const Door& door, std::uint64_t number) {
  Mark mark;
  World world = someWorld(mark);
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGABRT, SIG_DFL);
    static_cast<void>(std::freopen("/dev/null", "w", stderr));  // what std::terminate() says
    memoryRunsOutAfter(number);
    try {
      door.call(world, mark);
    } catch (const std::bad_alloc&) {
      _exit(1);  // a game that goes on has a world half changed
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return End::done;
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT ? End::aborted : End::otherwise;
}

class MemoryRunsOut : public testing::TestWithParam<std::size_t> {};

TEST_P(MemoryRunsOut, AndTheProgramEnds) {
  const Door& door = doors()[GetParam()];
  std::uint64_t number = 0;
  for (;; ++number) {
    const End end = endOf(door, number);
    if (end == End::done) break;
    ASSERT_EQ(end, End::aborted) << door.name << ", allocation " << number;
    ASSERT_LT(number, 2'000U);
  }
  RecordProperty("allocations", static_cast<int>(number));
}

INSTANTIATE_TEST_SUITE_P(Doors, MemoryRunsOut, testing::Range(std::size_t{0}, doors().size()));

}  // namespace
}  // namespace lgs::test
