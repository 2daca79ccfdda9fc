// RapidCheck as a maker of cases and no more. Its public check() prints and decides for itself; here cases run in child
// processes and are told in another way. What drives that is in `rc::detail`, which may change with any version: so it
// is used in rapid.cpp alone.
#pragma once

#include "proptests/support/law.h"

namespace lgs::test::rapid {

/// Has RapidCheck try the cases, up to the first of which `holds` says no. If it `shrinks`, it then makes that one
/// small: it tries simpler ones, and goes on from each that does not hold either.
void tryCases(const Effort& effort, const rc::Gen<Case>& cases, bool shrinks,
              const std::function<bool(const Case&)>& holds);

/// What an assertion of RapidCheck's, or fail(), says that fails in `work`.
std::optional<std::string> failedAssertion(const std::function<void()>& work);
[[noreturn]] void fail(const std::string& text);

}  // namespace lgs::test::rapid
