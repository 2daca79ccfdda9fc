// A Tiled map as a trace.
#pragma once

#include "oracle/trace/trace.h"

#include <fmt/format.h>
#include <lgs/tiled/import.h>

namespace lgs::cli {

/// One `add` for each polygon, and a commit. Names tell the cell: "c12_-3_1" is the first polygon in cell (12, -3).
inline oracle::Trace traceOf(const tiled::ImportedMap& map) {
  oracle::Trace trace;
  Cell cell;
  int count = 0;
  for (const tiled::MapPolygon& p : map.placements) {  // sorted by cell
    count = count == 0 || p.cell != cell ? 1 : count + 1;
    cell = p.cell;
    trace.calls.push_back(
        oracle::Call::add(fmt::format("c{}_{}_{}", cell.i, cell.j, count), {cell, p.block, map.shapes[p.shape]}));
  }
  trace.calls.push_back(oracle::Call::commit());
  return trace;
}

}  // namespace lgs::cli
