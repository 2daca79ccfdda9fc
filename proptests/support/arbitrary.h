// A type that says how any of its values come about, `static rc::Gen<T> arbitrary()`, is one that RapidCheck knows.
#pragma once

#include <rapidcheck.h>

#include <concepts>

namespace rc {

template <class T>
requires requires {
  { T::arbitrary() } -> std::same_as<Gen<T>>;
}
struct Arbitrary<T> {
  static Gen<T> arbitrary() { return T::arbitrary(); }
};

}  // namespace rc
