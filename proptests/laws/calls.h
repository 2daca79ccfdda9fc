// Lists of calls (oracle/calls) as arguments of laws, and worlds to make them in. RapidCheck makes a list small by
// leaving calls out, and by simpler calls.
#pragma once

#include "oracle/calls/draw.h"
#include "oracle/trace/model.h"
#include "proptests/support/arbitrary.h"
#include "proptests/support/outline_by_laws.h"
#include "proptests/support/worlds.h"

#include <iosfwd>

namespace lgs::test {

using oracle::Call;
using oracle::Caller;

/// Where the cells of calls lie, and what is preserved there.
struct Setting {
  Cell corner;
  oracle::PreservePairs preserve;

  Caller start() const { return Caller(World(oracle::relationOf(preserve)), corner); }
  static rc::Gen<Setting> arbitrary();
};
void showValue(const Setting& setting, std::ostream& out);

/// Edits, groups and commits.
struct Calls {
  std::vector<Call> list;
  static rc::Gen<Calls> arbitrary();
};
void showValue(const Calls& calls, std::ostream& out);

/// Marks among them, in some.
struct CallsAndMarks : Calls {
  static rc::Gen<CallsAndMarks> arbitrary();
};

/// The world is saved and loaded among them, too.
struct AnyCalls : Calls {
  static rc::Gen<AnyCalls> arbitrary();
};

void makeAll(Caller& caller, const Calls& calls);

/// A world in the middle of its life.
Caller grown(const Setting& setting, const Calls& calls);

}  // namespace lgs::test
