// Lists of calls (oracle/calls) as arguments of laws, and worlds to make them in. RapidCheck makes a list small by
// leaving calls out, and by simpler calls.
#pragma once

#include "oracle/calls/draw.h"
#include "oracle/trace/call_model.h"
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

/// Some of their numbers are the ends of what there is, or mean something inside. Marks and loads are among them.
struct HostileCalls : Calls {
  static rc::Gen<HostileCalls> arbitrary();
};

/// One that is made of parts: of many, or in the place of what stands there.
struct CallOfParts {
  Call call;
  static rc::Gen<CallOfParts> arbitrary();
};
void showValue(const CallOfParts& call, std::ostream& out);

/// A call of one kind.
Call drawOne(oracle::Random& choices, Call::Kind kind);

void makeAll(Caller& caller, const Calls& calls);

/// A world in the middle of its life.
Caller grown(const Setting& setting, const Calls& calls);

/// All that calls gave and showed, refusals apart.
struct Story {
  std::vector<oracle::Outcome> outcomes;
  std::vector<Snapshot> snapshots;  ///< after each commit
  friend bool operator==(const Story&, const Story&) = default;
};

/// Makes the calls in a new world. Fails the running case when one of them, or a commit, is not as the model and the
/// laws say (oracle/check/call_check.h). What must be refused may be left out.
Story storyOf(const Calls& calls, const Setting& setting, bool triesRefused = true);

}  // namespace lgs::test
