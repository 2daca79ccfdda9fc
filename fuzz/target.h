// What is fuzzed: each target is one function from bytes to a finding, or none. The drivers know nothing else of it.
#pragma once

#include "oracle/calls/random.h"
#include "oracle/check/checker.h"
#include "oracle/generate/generator.h"
#include "oracle/trace/trace.h"

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

extern const Target kEdits;     // edits.cpp
extern const Target kPolygons;  // edits.cpp
extern const Target kViews;     // edits.cpp
extern const Target kTrace;     // trace_text.cpp
extern const Target kSnapshot;  // snapshot.cpp
extern const Target kBrush;     // brush.cpp
extern const Target kCalls;     // calls.cpp
extern const Target kTiled;     // tiled.cpp
#ifdef LGS_FUZZ_BOX2D
extern const Target kBox2d;  // box2d.cpp
#endif

/// A record as the seed of random choices.
inline oracle::Random seededBy(Bytes record) {
  std::uint64_t seed = 0;
  for (const std::uint8_t byte : record) seed = seed * 257 + byte;
  return oracle::Random(seed);
}

inline std::string_view textOf(Bytes input) { return {reinterpret_cast<const char*>(input.data()), input.size()}; }

}  // namespace lgs::fuzz
