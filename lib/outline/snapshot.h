// The outline as bytes, and from bytes: the second part of a snapshot, after the ground. It has the ids of the
// segments, which depend on history. All else about them follows from the ground.
#pragma once

#include "outline/outline.h"
#include "storage/snapshot_bytes.h"

namespace lgs::detail {

void save(const Ground& ground, const Outline& outline, SnapshotWriter& out);

/// Fills an outline that is new, of a ground that was loaded. No byte is believed. If reading has failed, nothing is
/// done.
void load(const Ground& ground, Outline& outline, SnapshotReader& in);

}  // namespace lgs::detail
