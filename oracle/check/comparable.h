// What two outlines are compared by, if the engine does not put out all that the laws ask for.
#pragma once

#include "oracle/engine/capabilities.h"
#include "oracle/reference/outline.h"

namespace lgs::oracle {

/// The part of an outline that an engine can be held to, sorted: without ghosts, without blocks (all are 0), or joined.
///
/// Two segments are joined at a vertex if they lead on in one direction, nothing there leads off their line, and each
/// direction of the line has one segment that arrives and one that leaves. Their blocks must be the same, where blocks
/// are compared. A ghost that was the far end of a segment is the far end of what that has become.
Outline comparable(Outline outline, const Capabilities& can);

}  // namespace lgs::oracle
