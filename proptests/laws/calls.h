// Lists of calls (oracle/calls) as arguments of laws, and worlds to make them in. RapidCheck makes a list small by
// leaving calls out, and by simpler calls.
#pragma once

#include "oracle/calls/caller.h"
#include "oracle/calls/draw.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/call_model.h"
#include "proptests/support/outline_by_laws.h"
#include "proptests/support/worlds.h"

#include <rapidcheck.h>

#include <iosfwd>
#include <vector>

namespace lgs::test {

using oracle::Call;
using oracle::Caller;
using oracle::choicesFrom;

/// Where the cells of calls lie, and what is preserved there.
struct Setting {
  Cell corner;
  oracle::PreservePairs preserve;

  Caller start() const { return Caller(World(oracle::relationOf(preserve)), corner); }
};
void showValue(const Setting& setting, std::ostream& out);

/// Edits, groups and commits.
struct Calls {
  std::vector<Call> list;
};
void showValue(const Calls& calls, std::ostream& out);

/// Marks among them, in some.
struct CallsAndMarks : Calls {};

/// The world is saved and loaded among them, too.
struct AnyCalls : Calls {};

/// Some of their numbers are the ends of what there is, or mean something inside. Marks and loads are among them.
struct HostileCalls : Calls {};

/// One that is made of parts: of many, or in the place of what stands there.
struct CallOfParts {
  Call call;
};
void showValue(const CallOfParts& call, std::ostream& out);

/// A call of one kind.
Call drawOne(oracle::Choices& choices, Call::Kind kind);

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

namespace rc {

template <>
struct Arbitrary<lgs::test::Setting> {
  static Gen<lgs::test::Setting> arbitrary();
};
template <>
struct Arbitrary<lgs::test::Calls> {
  static Gen<lgs::test::Calls> arbitrary();
};
template <>
struct Arbitrary<lgs::test::CallsAndMarks> {
  static Gen<lgs::test::CallsAndMarks> arbitrary();
};
template <>
struct Arbitrary<lgs::test::AnyCalls> {
  static Gen<lgs::test::AnyCalls> arbitrary();
};
template <>
struct Arbitrary<lgs::test::HostileCalls> {
  static Gen<lgs::test::HostileCalls> arbitrary();
};
template <>
struct Arbitrary<lgs::test::CallOfParts> {
  static Gen<lgs::test::CallOfParts> arbitrary();
};

}  // namespace rc
