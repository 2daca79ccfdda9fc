// A world as bytes, and a world from bytes.
#pragma once

#include "ground/ground.h"
#include "outline/outline.h"

#include <lgs/snapshot.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::detail {

void save(const Ground& ground, const Outline& outline, const ByteSink& sink);

/// One chunk of the ground, by itself.
std::vector<std::byte> saveChunk(const Ground& ground, const Chunk& chunk);
/// The checksum at the end of bytes that were saved.
std::uint32_t checksumOf(std::span<const std::byte> bytes);
/// The chunk that was saved comes back, and is not committed. If there is an error, nothing has changed.
tl::expected<Cell, SnapshotError> loadChunk(std::span<const std::byte> bytes, Ground& ground);

/// Fills what is new. If there is an error, what is filled means nothing.
std::optional<SnapshotError> load(std::span<const std::byte> bytes, Ground& ground, Outline& outline);

}  // namespace lgs::detail
