// Random traces as arguments of laws: degenerate on purpose (oracle/generate), made small by the project's own
// shrinker, which knows what an edit is, and told with the files that the trace and its picture were saved to.
#pragma once

#include "oracle/calls/random.h"
#include "oracle/trace/trace.h"
#include "proptests/support/arbitrary.h"

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>

namespace lgs::test {

/// All kinds of calls, those among them that must be refused; in some cases a preserve relation.
struct AnyTrace : oracle::Trace {
  static rc::Gen<AnyTrace> arbitrary();
};

/// The same, with strokes of brushes among them.
struct TraceOfStrokes : oracle::Trace {
  static rc::Gen<TraceOfStrokes> arbitrary();
};

/// Every edit is good.
struct GoodTrace : oracle::Trace {
  static rc::Gen<GoodTrace> arbitrary();
};

/// Every edit is good, and nothing is preserved.
struct PlainTrace : oracle::Trace {
  static rc::Gen<PlainTrace> arbitrary();
};

/// A source of chance of a law's own, the same each time that a case is tried. It becomes simple where everything goes
/// as it comes.
struct Chance : oracle::Random {
  explicit Chance(std::uint64_t s) : Random(s), seed(s) {}
  Chance() : Random(asItComes()) {}
  std::optional<std::uint64_t> seed;
  static rc::Gen<Chance> arbitrary();
};
void showValue(const Chance& chance, std::ostream& out);

/// Whether every edit is good.
bool isGood(const oracle::Trace& trace);

/// The adds of all that a trace leaves standing, by name.
std::map<std::string, oracle::Call> survivors(const oracle::Trace& trace);

/// The cells that it adds to. Empty if there are none.
CellRect boundsOf(const oracle::Trace& trace);

/// The trace with its lower left cell at this one.
oracle::Trace movedTo(oracle::Trace trace, Cell target);

/// Traces that `make` makes for a size, which is 0 to 100, with a source of chance. They are made no smaller than
/// `mayBe` allows.
rc::Gen<oracle::Trace> traces(const std::function<oracle::Trace(int size, oracle::Random random)>& make,
                              const std::function<bool(const oracle::Trace&)>& mayBe = isGood);

}  // namespace lgs::test

namespace lgs::oracle {

/// Prints the trace, saves it and its picture, and says how to look at it: at another one that the law kept (law.h), if
/// a replay of this one shows nothing.
void showValue(const Trace& trace, std::ostream& out);

}  // namespace lgs::oracle
