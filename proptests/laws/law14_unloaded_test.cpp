// Law 14, unloaded is not gone: a world whose chunks leave memory and come back beside one that is whole. What is
// loaded must show, answer and report what it does in the whole world.
#include "proptests/support/law.h"
#include "unloaded.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

/// A day of edits, commits, marks and chunks that go and come.
void live(std::uint64_t seed, WithOut with, int steps) {
  BesideTheWhole worlds(oracle::Random(seed), with);
  for (int k = 0; k < steps && !::testing::Test::HasFailure(); ++k) worlds.step();
  worlds.commit();
  worlds.bringAllBack();
  worlds.commit();
}

LGS_LAW(Unloaded, IsNotGone, 100, (std::uint64_t seed)) { live(seed, {}, 60); }

LGS_LAW(Unloaded, MarksGoBackAcrossIt, 100, (std::uint64_t seed)) { live(seed, {.marks = true}, 80); }

LGS_LAW(Unloaded, PlacesAreForgottenAndComeBack, 80, (std::uint64_t seed)) { live(seed, {.forgets = true}, 80); }

LGS_LAW(Unloaded, UnderAPreserveRelation, 80, (std::uint64_t seed)) {
  live(seed, {.marks = true, .preserves = true}, 60);
}

}  // namespace
}  // namespace lgs::test
