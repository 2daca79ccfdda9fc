#include "visits.h"

namespace {

std::uint64_t count = 0;

}  // namespace

// Called at the beginning of each basic block of the library. The name is the compilers' own.
// NOLINTNEXTLINE(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp,readability-identifier-naming)
extern "C" void __sanitizer_cov_trace_pc();
extern "C" void __sanitizer_cov_trace_pc() { ++count; }

std::uint64_t lgs::cost_test::visits() { return count; }
