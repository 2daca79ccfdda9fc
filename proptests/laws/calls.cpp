#include "calls.h"

#include "oracle/check/call_check.h"
#include "proptests/support/law.h"

#include <fmt/format.h>

#include <ostream>
#include <utility>

namespace lgs::test {
namespace {

using oracle::Habits;
using Kind = Call::Kind;

Habits only(std::initializer_list<Kind> kinds) {
  Habits habits;
  habits.weights = {};
  for (const Kind kind : kinds) habits.weights[static_cast<std::size_t>(kind)] = 1;
  return habits;
}

rc::Seq<Call> simplerCalls(const Call& call) { return rc::seq::fromContainer(simpler(call)); }

rc::Seq<std::vector<Call>> shorter(const std::vector<Call>& list) {
  return rc::seq::concat(rc::shrink::removeChunks(list),
                         rc::shrink::eachElement(list, [](const Call& call) { return simplerCalls(call); }));
}

/// Some have marks, if there are any at all: without marks an edit goes quicker ways.
rc::Gen<std::vector<Call>> lists(const Habits& plain, const Habits& marked) {
  return [=](rc::Random random, int size) {
    oracle::Choices choices = choicesFrom(random.next());
    const Habits& habits = choices.chance(40) ? marked : plain;
    std::vector<Call> list;
    for (int k = choices.below(size + 1); k > 0; --k) list.push_back(drawCall(choices, habits));
    return rc::shrinkable::shrinkRecur(std::move(list),
                                       [](const std::vector<Call>& longer) { return shorter(longer); });
  };
}

template <class List>
rc::Gen<List> listsOf(const Habits& plain, const Habits& marked) {
  return rc::gen::map(lists(plain, marked), [](std::vector<Call>&& list) {
    List calls;
    calls.list = std::move(list);
    return calls;
  });
}

}  // namespace

Call drawOne(oracle::Choices& choices, Kind kind) { return drawCall(choices, only({kind})); }

void makeAll(Caller& caller, const Calls& calls) {
  for (const Call& call : calls.list) caller.make(call);
}

Caller grown(const Setting& setting, const Calls& calls) {
  Caller caller = setting.start();
  makeAll(caller, calls);
  return caller;
}

Story storyOf(const Calls& calls, const Setting& setting, bool triesRefused) {
  Story story;
  oracle::CallCheck world(setting.corner, setting.preserve);
  world.triesRefused = triesRefused;
  world.afterAccepted = [&](const Call& call, const oracle::Outcome& outcome) {
    story.outcomes.push_back(outcome);
    if (call.kind == Kind::commit || call.kind == Kind::load) story.snapshots.push_back(snapshotOf(world.world(), {}));
  };
  for (const Call& call : calls.list) failIf(world.make(call));
  failIf(world.make(Call()));
  return story;
}

void showValue(const Setting& setting, std::ostream& out) {
  out << fmt::format("cells from ({}, {})", setting.corner.i, setting.corner.j);
  for (const auto& [a, b] : setting.preserve.pairs()) out << fmt::format(", preserve {} {}", a, b);
}

void showValue(const Calls& calls, std::ostream& out) {
  for (const Call& call : calls.list) out << inWords(call) << '\n';
}

void showValue(const CallOfParts& call, std::ostream& out) { out << inWords(call.call); }

}  // namespace lgs::test

namespace rc {

using namespace lgs;
using namespace lgs::test;
using lgs::oracle::Habits;

Gen<Setting> Arbitrary<Setting>::arbitrary() {
  // About the origin, across borders of chunks, at the ends of the world.
  const auto index = gen::element<std::int32_t>(0, -2, 30, -34, kMaxCell - 3, -kMaxCell);
  using Pair = std::pair<Block, Block>;
  const auto block = gen::resize(kNominalSize, gen::inRange<Block>(0, Habits().blocks));
  const auto pairs = gen::container<std::vector<Pair>>(gen::pair(block, block));
  return gen::map(gen::tuple(index, index, gen::oneOf(gen::just(std::vector<Pair>()), gen::scale(0.05, pairs))),
                  [](const std::tuple<std::int32_t, std::int32_t, std::vector<Pair>>& drawn) {
                    const auto& [i, j, preserved] = drawn;
                    Setting setting{{i, j}, {}};
                    for (const auto& [a, b] : preserved) setting.preserve.add(a, b);
                    return setting;
                  });
}

Gen<Calls> Arbitrary<Calls>::arbitrary() { return listsOf<Calls>(Habits(), Habits()); }
Gen<CallsAndMarks> Arbitrary<CallsAndMarks>::arbitrary() {
  return listsOf<CallsAndMarks>(Habits(), withMarks(Habits()));
}
Gen<AnyCalls> Arbitrary<AnyCalls>::arbitrary() {
  return listsOf<AnyCalls>(withLoads(Habits()), withLoads(withMarks(Habits())));
}

Gen<HostileCalls> Arbitrary<HostileCalls>::arbitrary() {
  Habits habits = withLoads(withMarks(Habits()));
  habits.hostilePercent = 10;
  Habits plain;
  plain.hostilePercent = 10;
  return listsOf<HostileCalls>(plain, habits);
}

Gen<CallOfParts> Arbitrary<CallOfParts>::arbitrary() {
  using enum Call::Kind;
  const Habits habits = only({addMany, removeMany, replace, exchange, exchange, fill, clear});
  return [=](Random random, int) {
    oracle::Choices choices = choicesFrom(random.next());
    return shrinkable::map(
        shrinkable::shrinkRecur(drawCall(choices, habits), [](const Call& call) { return simplerCalls(call); }),
        [](Call&& call) { return CallOfParts{std::move(call)}; });
  };
}

}  // namespace rc
