// The attack: through every door with every hostile value of each argument, then with every two of them, then with
// random ones in random order. Whatever is refused has changed nothing; what the documents refuse is refused; and in
// the end the outline is that of the laws, worked out the slow way. The sanitizers look on.
#include "door.h"
#include "followed.h"

#include "oracle/check/isolated.h"
#include "oracle/trace/dump.h"
#include "proptests/support/law.h"
#include "proptests/support/outline_by_laws.h"
#include "proptests/support/scale.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <ostream>

namespace lgs::test {

/// One call: through which door, with which values.
struct Blow {
  std::size_t door = 0;
  Picks picks{};
};

/// One after the other, in one scene.
struct Blows {
  std::vector<Blow> list;
};
void showValue(const Blows& blows, std::ostream& out);

}  // namespace lgs::test

namespace rc {

template <>
struct Arbitrary<lgs::test::Blows> {
  static Gen<lgs::test::Blows> arbitrary() {
    using namespace lgs::test;
    const auto number = gen::resize(kNominalSize, gen::inRange<std::uint32_t>(0, 600));
    const auto picks = gen::container<Picks>(gen::oneOf(gen::just(0U), number));
    const auto door = gen::resize(kNominalSize, gen::inRange<std::size_t>(0, doors().size()));
    const auto blow = gen::map(gen::pair(door, picks), [](const std::pair<std::size_t, Picks>& drawn) {
      return Blow{drawn.first, drawn.second};
    });
    return gen::map(gen::container<std::vector<Blow>>(blow), [](std::vector<Blow>&& list) { return Blows{list}; });
  }
};

}  // namespace rc

namespace lgs::test {
namespace {

void strike(Scene& scene, const Blow& blow) {
  const Door& door = doors()[blow.door];
  scene.refresh();
  const bool mustBeRefused = door.mustBeRefused && door.mustBeRefused(scene, blow.picks);
  const Seen before = seenOf(scene.world), beforeC = seenOf(scene.c.get());
  const bool isRefused = door.isRefused(scene, blow.picks);
  if (door.mustBeRefused) {
    EXPECT_EQ(isRefused, mustBeRefused) << "the documents say so";
  }
  if (!isRefused) return;
  EXPECT_EQ(before, seenOf(scene.world)) << "it was refused, and has changed something";
  EXPECT_EQ(beforeC, seenOf(scene.c.get())) << "it was refused, and has changed something";
}

void strikeAll(const std::vector<Blow>& blows) {
  Scene scene;
  for (const Blow& blow : blows) {
    oracle::stillAlive();
    strike(scene, blow);
  }
  for (World* world : {&scene.world, &scene.other}) {
    if (world->preserveRelation()) continue;  // some contradict themselves
    world->commit();
    EXPECT_EQ(oracle::outlineOf(*world), outlineByLaws(*world, {}));
  }
  expectViewsAreRight(scene);
}

/// As they would be called one after the other: the names lead to what is there by then. They are called in a child, as
/// one of them may crash.
std::string inWords(const std::vector<Blow>& blows) {
  struct Text {
    std::size_t size = 0;
    char bytes[1 << 16] = {};
  };
  const oracle::Shared<Text> told;
  static_cast<void>(oracle::crashOf(
      [&] {
        Scene scene;
        for (const Blow& blow : blows) {
          scene.refresh();
          const Door& door = doors()[blow.door];
          const std::string line = fmt::format("{}: {}\n", door.name, door.told(scene, blow.picks));
          told->size += line.copy(told->bytes + told->size, std::size(told->bytes) - told->size);
          if (&blow == &blows.back()) return;
          static_cast<void>(failedExpectation([&] { static_cast<void>(door.isRefused(scene, blow.picks)); }));
        }
      },
      {.quiet = true}));
  return {told->bytes, told->size};
}

/// How many values each argument of a door has.
std::vector<std::uint32_t> countsOf(const Door& door) {
  Scene scene;
  std::vector<std::uint32_t> counts;
  for (const Kind& kind : door.arguments) counts.push_back(static_cast<std::uint32_t>(kind.count(scene)));
  return counts;
}

/// Each value of each argument, the others plain; for an argument alone, or for each two.
std::vector<Blow> singles() {
  std::vector<Blow> all;
  for (std::size_t door = 0; door < doors().size(); ++door) {
    all.push_back({door, {}});
    const auto counts = countsOf(doors()[door]);
    for (std::size_t a = 0; a < counts.size(); ++a) {
      for (std::uint32_t k = 1; k < counts[a]; ++k) {
        all.push_back({door, {}});
        all.back().picks[a] = k;
      }
    }
  }
  return all;
}

std::vector<Blow> pairs() {
  std::vector<Blow> all;
  for (std::size_t door = 0; door < doors().size(); ++door) {
    const auto counts = countsOf(doors()[door]);
    for (std::size_t b = 0; b < counts.size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        for (std::uint32_t k = 1; k < counts[a]; ++k)
          for (std::uint32_t m = 1; m < counts[b]; ++m) {
            all.push_back({door, {}});
            all.back().picks[a] = k;
            all.back().picks[b] = m;
          }
  }
  return all;
}

/// Every so many-th of them, each in a scene of its own, in a child process. After one that fails it goes on with the
/// next door.
void tryEach(const std::vector<Blow>& blows, std::size_t stride) {
  const oracle::Shared<std::size_t> at;
  std::size_t first = 0;
  while (first < blows.size()) {
    const auto crash = oracle::crashOf([&] {
      for (*at = first; *at < blows.size(); *at += stride) {
        oracle::stillAlive();
        const auto why = failedExpectation([&] { strikeAll({blows[*at]}); });
        if (!why) continue;
        std::fprintf(stderr, "%s", why->c_str());
        std::abort();
      }
    });
    if (!crash) break;
    ADD_FAILURE() << "call " << *at << " of " << blows.size() << " " << *crash << "\n" << inWords({blows[*at]});
    for (first = *at; first < blows.size() && blows[first].door == blows[*at].door;) first += stride;
  }
  testing::Test::RecordProperty("cases", std::to_string(blows.size() / stride));
}

TEST(Attack, EveryValueOfEveryArgument) { tryEach(singles(), 1); }

TEST(Attack, EveryTwoValues) { tryEach(pairs(), static_cast<std::size_t>(exhaustStride()) * 5 + 1); }

LGS_LAW(Attack, AnyValuesInAnyOrder, 1'500, (const Blows& blows)) { strikeAll(blows.list); }

}  // namespace

const std::vector<Door>& doors() {
  static const std::vector<Door> all = [] {
    Doors every;
    addDoorsOfValues(every);
    addDoorsOfWorlds(every);
    addDoorsOfReading(every);
    addDoorsOfBrushes(every);
    addDoorsOfC(every);
    addDoorsOfViews(every);
    addDoorsOfHashes(every);
    addDoorsOfViewsInC(every);
#ifdef LGS_HAS_BOX2D
    addDoorsOfBox2d(every);
#endif
    return std::move(every.all);
  }();
  return all;
}

void showValue(const Blows& blows, std::ostream& out) { out << inWords(blows.list); }

}  // namespace lgs::test
