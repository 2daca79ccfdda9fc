#include "calls.h"

#include "oracle/trace/call_text.h"
#include "proptests/support/law.h"

#include <fmt/format.h>

#include <ostream>

namespace lgs::test {

using Kind = Call::Kind;

namespace {

using oracle::Habits;

rc::Seq<Call> simplerCalls(const Call& call) { return rc::seq::fromContainer(simpler(call)); }

rc::Seq<std::vector<Call>> shorter(const std::vector<Call>& list) {
  return rc::seq::concat(rc::shrink::removeChunks(list),
                         rc::shrink::eachElement(list, [](const Call& call) { return simplerCalls(call); }));
}

/// Some have marks, if there are any at all: without marks an edit goes quicker ways.
rc::Gen<std::vector<Call>> lists(const Habits& plain, const Habits& marked) {
  return [=](rc::Random random, int size) {
    oracle::Random choices(random.next());
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

void makeAll(Caller& caller, const Calls& calls) {
  for (const Call& call : calls.list) caller.make(call);
}

Caller grown(const Setting& setting, const Calls& calls) {
  Caller caller = setting.start();
  makeAll(caller, calls);
  return caller;
}

void showValue(const Setting& setting, std::ostream& out) {
  out << fmt::format("cells from ({}, {})", setting.corner.i, setting.corner.j);
  for (const auto& [a, b] : setting.preserve.pairs()) out << fmt::format(", preserve {} {}", a, b);
}

void showValue(const Calls& calls, std::ostream& out) {
  for (const Call& call : calls.list) out << printCall(call) << '\n';
}

rc::Gen<Setting> Setting::arbitrary() {
  // About the origin, across borders of chunks, at the ends of the world.
  const auto index = rc::gen::element<std::int32_t>(0, -2, 30, -34, kMaxCell - 3, -kMaxCell);
  using Pair = std::pair<Block, Block>;
  const auto block = rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Block>(0, Habits().blocks));
  const auto pairs = rc::gen::container<std::vector<Pair>>(rc::gen::pair(block, block));
  return rc::gen::map(
      rc::gen::tuple(index, index, rc::gen::oneOf(rc::gen::just(std::vector<Pair>()), rc::gen::scale(0.05, pairs))),
      [](const std::tuple<std::int32_t, std::int32_t, std::vector<Pair>>& drawn) {
        const auto& [i, j, preserved] = drawn;
        Setting setting{{i, j}, {}};
        for (const auto& [a, b] : preserved) setting.preserve.add(a, b);
        return setting;
      });
}

rc::Gen<Calls> Calls::arbitrary() { return listsOf<Calls>(Habits(), Habits()); }
rc::Gen<CallsAndMarks> CallsAndMarks::arbitrary() { return listsOf<CallsAndMarks>(Habits(), withMarks(Habits())); }
rc::Gen<AnyCalls> AnyCalls::arbitrary() {
  return listsOf<AnyCalls>(withLoads(Habits()), withLoads(withMarks(Habits())));
}

}  // namespace lgs::test
