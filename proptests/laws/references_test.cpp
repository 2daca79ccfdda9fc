// All laws at once: the engine against the references, after every commit of random cases. All that the checker of
// `lgs check` compares: naive reference, CGAL's union, change lists on a mirror, refusals, history. The bulk
// (bulk_test.cpp) holds the same on many more cases.
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

LGS_LAW(References, AgreeWithTheEngineAfterEveryCommit, 2'000, (const AnyTrace& trace)) {
  expectNoMismatch(trace, {.skipRefused = true});
}

}  // namespace
}  // namespace lgs::test
