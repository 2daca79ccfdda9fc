// The ground as bytes, and from bytes: the first part of a snapshot. docs/internals/snapshot.md has the format.
#pragma once

#include "ground/ground.h"
#include "storage/snapshot_bytes.h"

namespace lgs::detail {

/// Whether some numbers of chunks are free: the version of the snapshot says it.
bool hasFreeNumbers(const Ground& ground);

void save(const Ground& ground, SnapshotWriter& out);

/// One chunk of it, by itself.
void save(const Ground& ground, const Chunk& chunk, SnapshotWriter& out);

/// Fills a ground that is new. No byte is believed. All cells with polygons have changed then.
void load(Ground& ground, SnapshotReader& in, bool hasFreeNumbers);

/// The chunk that was saved comes back, unless reading fails: then nothing has changed. `checksum` is that of the
/// bytes: of a chunk that is unloaded they must be the last ones. Returns its lower-left cell.
Cell loadChunk(Ground& ground, SnapshotReader& in, std::uint32_t checksum);

}  // namespace lgs::detail
