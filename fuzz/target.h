// What is fuzzed: each target is one function from bytes to a finding, or none. The drivers know nothing else of it.
#pragma once

#include "oracle/check/checker.h"
#include "oracle/generate/generator.h"
#include "oracle/trace/trace.h"
#include "targets.h"  // which CMake makes

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lgs::fuzz {

using Bytes = std::span<const std::uint8_t>;
using oracle::kRecord;

struct Finding {
  std::string text;                               ///< what is wrong; whole lines
  std::optional<oracle::Mismatch> mismatch = {};  ///< of the trace that `traceOf` makes of the input
};

struct Target {
  const char* name;
  const char* about;

  /// Runs an input; counts what was done.
  std::optional<Finding> (*check)(Bytes input, oracle::CheckStats& stats);

  /// The edits of an input, for a picture and for shrinking. Empty where an input is none.
  oracle::Trace (*traceOf)(Bytes input);

  /// Runs edits. Null if the target is not about edits.
  std::optional<Finding> (*checkTrace)(const oracle::Trace& trace, oracle::CheckStats& stats);

  /// What an input that is text is made of. None: an input is a header and records of 16 bytes.
  std::span<const std::string_view> words = {};

  /// Why an input has no edits. Null if any bytes can have some.
  std::string (*whyEmpty)(Bytes input) = nullptr;
};

#define LGS_FUZZ_TARGET_OF(name) extern const Target name;
LGS_FUZZ_TARGETS(LGS_FUZZ_TARGET_OF)  // kEdits, kPolygons, …: CMakeLists.txt has the list
#undef LGS_FUZZ_TARGET_OF

inline std::string_view textOf(Bytes input) { return {reinterpret_cast<const char*>(input.data()), input.size()}; }

}  // namespace lgs::fuzz
