// All laws at once (oracle/check/laws/list.h), after every commit of random calls of all kinds: what `lgs check` holds.
// The bulk (bulk_test.cpp) holds the same on many more cases.
#include "proptests/support/law.h"
#include "proptests/support/played.h"
#include "proptests/support/traces.h"

#include <gtest/gtest.h>

namespace lgs::test {
namespace {

LGS_LAW(References, AgreeWithTheEngineAfterEveryCommit, 2'000, (const AnyTrace& trace)) { expectNoMismatch(trace); }

}  // namespace
}  // namespace lgs::test
