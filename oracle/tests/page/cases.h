// Pages to look at: traces with a planted wrong outline, with names that would break markup, at the ends of the world.
#pragma once

#include "oracle/page/page.h"
#include "oracle/trace/trace.h"

#include <string>
#include <vector>

namespace lgs::oracle::test {

struct PageCase {
  std::string name;
  Trace trace;
  PageOptions options;
};

/// An edge is not cut where a neighbour's corner touches it: a segment is missing, one is extra, two ghosts are wrong.
/// The last of four edits, in the second of two commits; then an edit that must be refused is left out.
PageCase uncutWall();

/// A trace without a mismatch, whose names, title and report are markup.
PageCase markup();

/// Two squares at opposite ends of the world. One has lost a segment.
PageCase endsOfTheWorld();

/// An edit that is refused though it is good: no outline differs, one segment is to blame.
PageCase wrongRefusal();

/// Far more edits than get a step, in far more cells than are shown.
PageCase longTrace();

/// A trace that makes the engine crash: there is one outline only.
PageCase crash();

std::vector<PageCase> pageCases();

}  // namespace lgs::oracle::test
