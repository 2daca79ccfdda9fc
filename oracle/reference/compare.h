// Compares two outlines, and says in words what differs and where. A difference keeps both segments, so that it can be
// drawn.
#pragma once

#include "oracle/reference/outline.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lgs::oracle {

struct Difference {
  enum class Kind {
    missing,  ///< only `expected` is set
    extra,    ///< only `actual` is set
    ghost1,   ///< from here on both are set, with the same start and end
    ghost2,
    block,
    owner,
  };
  Kind kind;
  std::optional<OutlineSegment> expected;
  std::optional<OutlineSegment> actual;
  std::string note;  ///< what probably went wrong: "an overlap that should have been cancelled"; often empty

  const OutlineSegment& segment() const { return expected ? *expected : *actual; }
};

/// Every difference in segments, ghosts and blocks; empty if there is none. Missing and extra segments come first; then
/// by start, end and kind. Both outlines must be sorted (outline.h).
std::vector<Difference> compare(const Outline& expected, const Outline& actual);

/// The same, and differences in owners as well.
std::vector<Difference> compare(const OwnedOutline& expected, const OwnedOutline& actual);

/// One difference as a line without an end of line. Block 0, which engines without blocks put out, is not named.
std::string describe(const Difference& difference);

/// One line each; after the first `most`, "... and N more". Every line ends with an end of line.
std::string describe(const std::vector<Difference>& differences, std::size_t most = 10);

/// Which of a segment's links a reference knows.
struct KnownLinks {
  bool ghost1 = true;
  bool ghost2 = true;
  friend bool operator==(KnownLinks, KnownLinks) = default;
};

/// Returns `expected`, but each link that the reference does not know (known[k] for expected[k]) is copied from the
/// same segment of `actual`. Comparing or drawing the two then shows differences in known links only.
Outline withUnknownLinksOf(const Outline& actual, Outline expected, const std::vector<KnownLinks>& known);

}  // namespace lgs::oracle
