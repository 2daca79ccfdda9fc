// The data of a page, as the script reads them. The numbers of points, polygons and segments are indices.
//
//   title, report, note      texts; the note says what is left out
//   expectedName, actualName what the two outlines are called
//   unitsPerCell             coordinates are lattice units of the world
//   preserve                 pairs of blocks
//   fills                    [block, colour]
//   points                   x, y, and the two in words
//   polygons                 name, cell, block, corners
//   segments                 start, end, ghost1, ghost2: points or null; block; owner: a polygon or null; place: words
//   steps                    the first one is the world in which the page begins
//     edit                   the line of the trace
//     number                 which edit of the trace it is, from 1; 0: none
//     note                   what is to be said of it; may be missing
//     added, removed         polygons
//     expected, actual       after a commit: segments; no `actual`: it is as expected
//     wrong                  true at the end of a trace that shows a mismatch
//     differences, more      kind; text; expected, actual: a segment or null; and how many are not listed
//     marked                 segments to point out
#pragma once

#include "oracle/page/page.h"
#include "oracle/page/tables.h"

namespace lgs::oracle::paging {

Json storyOf(const Trace& trace, const PageOptions& options);

}  // namespace lgs::oracle::paging
