// A call as lines of a trace of version 4 (trace.h has the format).
#pragma once

#include "oracle/calls/call.h"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lgs::oracle {

using Words = std::span<const std::string_view>;

/// Its lines, without the last end of line; a group has one for each of its calls.
std::string printCall(const Call& call);

/// The word that its line begins with; of a brush `paint`, which may be `carve`.
std::string wordFor(Call::Kind kind);

/// What is wrong; empty if nothing is.
using Fault = std::string;

/// Reads a line; that of a group or of what is repeated begins it.
Fault readCall(Words words, Call& call);

/// A word as it may be shown.
std::string quote(std::string_view word);

/// `x y x y …` of local or world coordinates, after others. `of` is said after the number of a vertex.
Fault readPoints(std::span<const std::string_view> words, std::string_view of, std::vector<LocalPoint>& out);
Fault readPoints(std::span<const std::string_view> words, std::string_view of, std::vector<Point>& out);

/// The rings of a brush, `|` between them.
Fault readBrush(std::span<const std::string_view> words, BrushEdit& brush);

Fault readInteger(std::string_view word, std::string_view what, std::int64_t min, std::int64_t max, std::int64_t& out);

template <class Integer>
Fault readNumber(std::string_view word, std::string_view what, Integer min, Integer max, Integer& out) {
  std::int64_t read = 0;
  if (Fault fault = readInteger(word, what, min, max, read); !fault.empty()) return fault;
  out = static_cast<Integer>(read);
  return {};
}
template <class Integer>
Fault readAny(std::string_view word, std::string_view what, Integer& out) {
  return readNumber(word, what, std::numeric_limits<Integer>::min(), std::numeric_limits<Integer>::max(), out);
}

}  // namespace lgs::oracle
