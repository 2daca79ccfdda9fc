// Law 15: the views of loops, islands, pieces and hashes are, after each commit and after going back or forward, what a
// look at the whole world gives; and what they say has changed is what differs.
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

LGS_LAW(Views, AreTheirRecompute, 600, (const AnyTrace& trace)) {
  expectNoMismatch(trace, {.naive = false, .cgal = false, .views = true});
}

}  // namespace
}  // namespace lgs::test
