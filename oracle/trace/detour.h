// Detours of a world: what it does there, nobody may notice afterwards (law 12).
#pragma once

#include <lgs/world.h>
#include <cstdint>
#include <optional>
#include <string>

namespace lgs::oracle {

/// Edits the world wrongly near a cell in range, perhaps commits that, and goes back, once or twice. `chance` decides
/// what it does. Says what is wrong, if anything is.
std::optional<std::string> editAndGoBack(World& world, Cell cell, std::uint64_t chance);

/// Saves the world, and puts the one that is loaded in its place. It must have no uncommitted edits.
std::optional<std::string> saveAndLoad(World& world);

}  // namespace lgs::oracle
