// A world as bytes, and a world from bytes.
#pragma once

#include "ground/ground.h"
#include "outline/outline.h"

#include <lgs/snapshot.h>

#include <cstddef>
#include <optional>
#include <span>

namespace lgs::detail {

void save(const Ground& ground, const Outline& outline, const ByteSink& sink);

/// Fills what is new. If there is an error, what is filled means nothing.
std::optional<SnapshotError> load(std::span<const std::byte> bytes, Ground& ground, Outline& outline);

}  // namespace lgs::detail
