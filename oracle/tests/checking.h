// What tests of the checker share.
#pragma once

#include "oracle/check/checker.h"
#include "proptests/support/worlds.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace lgs::oracle {

/// Adds a whole square.
inline Call square(const std::string& name, Cell cell, Block block = 1) {
  return Call::add(name, {cell, block, test::unitSquare()});
}

/// checkTrace(), where no edit may be bad.
inline std::optional<Mismatch> checked(const Trace& trace, const CheckOptions& options, CheckStats& stats) {
  auto result = checkTrace(trace, options, stats);
  if (!result) throw std::runtime_error(result.error().text);
  return *std::move(result);
}

}  // namespace lgs::oracle
