// What comes out of many maps, as a table.
#pragma once

#include "cli/command.h"

#include <lgs/tiled/import.h>

#include <string>
#include <vector>

namespace lgs::cli {

/// Imports all maps in some folders and below them, and prints what comes of each and how many there are of each kind.
/// A folder may also be a map.
Status survey(const std::vector<std::string>& folders, const tiled::Options& options);

}  // namespace lgs::cli
