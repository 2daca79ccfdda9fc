// For tests: what there must be. Otherwise the test ends, by an exception that says what there is.
#pragma once

#include <optional>
#include <stdexcept>
#include <tl/expected.hpp>
#include <utility>

namespace lgs::test {

template <class T, class Error>
T must(tl::expected<T, Error> result) {
  if (result) return *std::move(result);
  if constexpr (requires { std::runtime_error(result.error()); })
    throw std::runtime_error(result.error());
  else
    throw std::runtime_error(message(result.error()));
}

template <class T>
T must(std::optional<T> result) {
  if (!result) throw std::runtime_error("there is nothing");
  return *std::move(result);
}

/// The error, where there must be one.
template <class T, class Error>
Error refusal(const tl::expected<T, Error>& result) {
  if (result) throw std::runtime_error("it is not refused");
  return result.error();
}

}  // namespace lgs::test
