// Mismatches of an engine that are known: a list that people keep beside their engine. One is told from another by its
// kind (finding.h) and its smallest trace, wherever that lies and whichever way it is turned.
#pragma once

#include "oracle/trace/trace.h"

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::oracle {

struct KnownMismatch {
  std::string kind;
  Trace trace;
};

/// Equal for mismatches of one kind whose traces differ in the place, in a turn or a mirroring, in names, in the
/// vertices that polygons begin with, or in the order of adds that follow one another.
std::string identityOf(const KnownMismatch& mismatch);

/// Reads a list: before each trace stands a line `known KIND`. The error is "LINE: what is wrong".
tl::expected<std::vector<KnownMismatch>, std::string> parseKnown(std::string_view text);

/// The text that parseKnown() reads back, in the order of kinds and sizes.
std::string printKnown(std::vector<KnownMismatch> known);

}  // namespace lgs::oracle
