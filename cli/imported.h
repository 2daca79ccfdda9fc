// A Tiled map as a trace.
#pragma once

#include "oracle/trace/trace.h"

#include <fmt/format.h>
#include <lgs/tiled/import.h>

namespace lgs::oracle {

/// One add for each polygon, named by its cell ("c12_-3_1" is the first in cell (12, -3)), and a commit.
inline Trace traceOf(const tiled::ImportedMap& map) {
  Trace trace;
  Cell cell;
  int count = 0;
  for (const tiled::Placement& p : map.placements) {  // sorted by cell
    count = count == 0 || p.cell != cell ? 1 : count + 1;
    cell = p.cell;
    trace.edits.push_back(
        Edit::add(fmt::format("c{}_{}_{}", cell.i, cell.j, count), {cell, p.block, map.shapes[p.shape]}));
  }
  trace.edits.push_back(Edit::commit());
  return trace;
}

}  // namespace lgs::oracle
