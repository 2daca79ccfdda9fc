// An engine's answers as text, line by line.
#pragma once

#include "oracle/engine/delta.h"
#include "oracle/engine/engine.h"

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::oracle {

/// Words of an engine, fit to be printed: not many, and none that speak to a terminal.
std::string shortened(std::string_view words);

/// The first answer: "lgs-engine 1 NAME [CAPABILITY …]".
struct Hello {
  std::string name;
  Capabilities can;
};

/// Reads it; or says what is wrong.
tl::expected<Hello, std::string> parseHello(std::string_view line);

/// Reads the answer to a commit.
class AnswerReader {
 public:
  explicit AnswerReader(const Capabilities& can) : can_(can) {}

  /// Takes the next line. Whether the answer is complete with it; or what is wrong with the line.
  tl::expected<bool, std::string> take(std::string_view line);

  std::vector<RefusedEdit> refused;
  Outline outline;         ///< as it came
  NamedIslands islands;    ///< as they came
  SegmentChanges changes;  ///< as they came
  std::optional<std::chrono::nanoseconds> time;

 private:
  using Taken = tl::expected<bool, std::string>;
  Taken takeChange(char sign, std::string_view line);
  Taken takeSegment(std::string_view line, OutlineSegment& segment) const;

  Capabilities can_;
};

/// What is wrong with a segment of such an engine by itself, whatever the world; empty if nothing is.
std::string faultOf(const OutlineSegment& segment, const Capabilities& can);

/// Leaves of a segment what such an engine declares: the rest means nothing, whatever it puts out.
void keepDeclared(OutlineSegment& segment, const Capabilities& can);

}  // namespace lgs::oracle
