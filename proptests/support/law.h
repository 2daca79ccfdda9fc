// Laws, and what becomes of a case that breaks one. A law is a function of its case:
//
//   LGS_LAW(History, OrderOfEditsDoesNotMatter, 2'000, (const GoodTrace& trace, Chance chance)) {
//     expectSame(outlineAfter(trace), outlineAfter(reordered(trace, chance)));
//   }
//
// RapidCheck makes the cases (from the rc::Arbitrary of each argument's type; 2,000 of them, times LGS_TEST_SCALE) and
// makes one that fails small. A case fails by an expectation of GoogleTest's, an assertion of RapidCheck's, or
// failIf(). Cases run in a child process (isolated.h), so one that crashes or hangs fails like any other; what a body
// finds out beyond that it must keep in oracle::Shared values. It draws nothing itself: that would not be made small.
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace lgs::test {

/// One case of a law.
struct Case {
  std::function<void()> run;
  std::function<std::string()> told;  ///< for whoever reads the failure; may save files
};

/// How many cases, and where they begin: equal efforts make equal cases.
struct Effort {
  std::int64_t cases = 0;
  std::uint64_t seed = 0;
};

/// So many at scale 1, from LGS_TEST_SEED and the name of the running test.
Effort effortOf(std::int64_t cases);

/// Tries cases until one fails: what is wrong, the smallest case found, and the command that runs it again. A case that
/// fails only after those before it is told as it is, and says so.
std::optional<std::string> falsified(const Effort& effort, const rc::Gen<Case>& cases);

/// Fails the case that is running, if there is something to complain about; unless something holds.
void failIf(const std::optional<std::string>& complaint);
void failUnless(bool holds, const char* complaint);

/// Keeps a text of the case that is running, for when it fails, or crashes later on. Called only if it will be read.
void keep(const std::function<std::string()>& text);

/// Of the case that is being told.
struct Told {
  std::string why;                ///< it fails
  std::vector<std::string> kept;  ///< by keep()
};
const Told& told();

/// What the first expectation (EXPECT_…, ASSERT_…) says that fails in `work`, if one does. The test that is running
/// does not fail by it.
std::optional<std::string> failedExpectation(const std::function<void()>& work);

/// The start of the names of all files that a failure of the running test is saved to: absolute, and its own.
std::string fileBase();

/// Fails the running test with the first case that fails, if there is one.
void check(const Effort& effort, const rc::Gen<Case>& cases);

/// An argument of a law. The type is forgotten so that RapidCheck's templates are compiled for each type of argument,
/// and not again for each law.
struct Argument {
  std::shared_ptr<const void> value;
  std::function<std::string()> told;
};
using Arguments = std::vector<Argument>;

template <class T>
rc::Gen<Argument> argument(rc::Gen<T> values) {
  return rc::gen::map(std::move(values), [](T&& drawn) {
    const auto value = std::make_shared<const T>(std::move(drawn));
    return Argument{value, [value] { return rc::toString(*value) + '\n'; }};
  });
}

/// The cases of a law whose arguments these generators make.
rc::Gen<Case> casesOf(std::function<void(const Arguments&)> law, const std::vector<rc::Gen<Argument>>& arguments);

template <class... Args>
rc::Gen<Case> casesOf(std::function<void(Args...)> law, rc::Gen<std::decay_t<Args>>... arguments) {
  const auto call = [law = std::move(law)]<std::size_t... I>(const Arguments& drawn, std::index_sequence<I...>) {
    law(*static_cast<const std::decay_t<Args>*>(drawn[I].value.get())...);
  };
  return casesOf([call](const Arguments& drawn) { call(drawn, std::index_sequence_for<Args...>()); },
                 {argument(std::move(arguments))...});
}

template <class... Args>
rc::Gen<Case> casesOf(std::function<void(Args...)> law) {
  return casesOf(std::move(law), rc::gen::arbitrary<std::decay_t<Args>>()...);
}

/// Fails the running test with the first case that a law does not hold for. `law` is a function or a lambda; its
/// arguments are arbitrary where no generators are given.
template <class Law, class... Ts>
void forAll(const Effort& effort, Law law, rc::Gen<Ts>... arguments) {
  check(effort, casesOf(std::function{std::move(law)}, std::move(arguments)...));
}

template <class Law, class... Ts>
void forAll(std::int64_t cases, Law law, rc::Gen<Ts>... arguments) {
  forAll(effortOf(cases), std::move(law), std::move(arguments)...);
}

}  // namespace lgs::test

/// A test of GoogleTest's that holds a law for all cases.
#define LGS_LAW(Suite, Name, cases, Arguments)                      \
  static void Suite##Name Arguments;                                \
  TEST(Suite, Name) { ::lgs::test::forAll((cases), &Suite##Name); } \
  static void Suite##Name Arguments
