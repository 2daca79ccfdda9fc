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

/// Unloads the chunks around a cell in range, sees that they are gone, and brings them back, in an order that `chance`
/// decides. There is no commit in between, so no segment may come or go.
std::optional<std::string> unloadAndReload(World& world, Cell cell, std::uint64_t chance);

}  // namespace lgs::oracle
