// What calls do, as removes and adds: for whoever knows no others.
#pragma once

#include "oracle/reference/scene.h"
#include "oracle/trace/trace.h"

#include <utility>
#include <vector>

namespace lgs::oracle {

/// The cells that a region may reach: those of its box.
CellRect cellsUnder(const BrushEdit& brush);

/// The ring and the vertex in it that lies in no cell, the first one; -1 and -1 if all lie in one.
std::pair<int, int> vertexInNoCell(const BrushEdit& brush);

/// Whether a region is refused: a vertex lies in no cell, or it is too wide or high.
bool isOutOfReach(const BrushEdit& brush);

/// For each call of a trace what it did: removes, then adds. Nothing for commits, and where it is refused. The engine
/// makes them, unless all are plain. What leaves memory stays where it is.
std::vector<std::vector<Call>> editsBy(const Trace& trace);

/// The same world by adds, removes and commits alone. What has no name there gets one that is not in the trace. What is
/// refused is left out, unless all are plain: then they stay as they are.
Trace inPlainEdits(const Trace& trace);

/// What stands when all of it was played by this library's engine.
Scene sceneOf(const Trace& trace);

}  // namespace lgs::oracle
