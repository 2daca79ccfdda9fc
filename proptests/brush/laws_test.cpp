// Laws 8 to 11: what a brush leaves of the ground. The checker measures each stroke: that it is rounded by a unit at most
// (law 8), that what it does not reach stays or is told as bent (law 9), that it leaves no seam (law 10), that it is not
// refused (law 11), and that its result tells what happened.
#include "proptests/brush/strokes.h"
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

LGS_LAW(Brush, StrokesKeepTheLaws, 600, (const TraceOfStrokes& trace)) { expectNoMismatch(trace, {.naive = false}); }

}  // namespace
}  // namespace lgs::test
