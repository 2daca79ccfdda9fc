// A page that steps through a trace, edit by edit, and shows what went wrong at its end: one HTML file for a browser.
// Nothing is outside of the file, and it needs no network.
//
// The page is made without the engine, so it can show a trace that makes the engine crash. Up to the last commit the
// outline is the naive reference's; whoever has checked the trace knows that the engine's was the same. At the end it
// is what the caller gives.
//
// Of a trace with more than 1,000 edits the page shows the cells around the end, and of their edits the last 1,000 one
// by one. It says so.
#pragma once

#include "oracle/reference/outline.h"
#include "oracle/trace/trace.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace lgs::oracle {

/// What went wrong at the end of a trace.
struct PageEnd {
  std::size_t edits = 0;     ///< how many edits of the trace had been played
  bool committed = true;     ///< false: the last edit is to blame, and there was no commit after it
  std::size_t polygons = 0;  ///< in the scene that was compared. If the world has more, the outlines are a part of its
  Outline expected;          ///< sorted, as compare.h needs it
  Outline actual;            ///< sorted
  Outline marked;            ///< segments to point out, if neither outline shows what is wrong
};

struct PageOptions {
  std::string title;   ///< any text, UTF-8
  std::string report;  ///< what went wrong, in words; whole lines; may be empty
  std::string expectedName = "expected";
  std::string actualName = "actual";  ///< empty: there is no other outline than the expected one
  std::optional<PageEnd> end;         ///< nothing: all went well, and the page shows the whole trace

  /// What of an outline is compared, if not all of it: the outlines of all steps are shown so, as those of the end are.
  std::function<Outline(Outline)> asCompared = {};
};

/// Text from anywhere: what is no UTF-8 becomes a sign that says so, and control characters become blanks,
/// but for the end of a line.
std::string readable(std::string_view any);

/// Such text for an HTML element.
std::string inElement(std::string_view any);

std::string writePage(const Trace& trace, const PageOptions& options);

}  // namespace lgs::oracle
