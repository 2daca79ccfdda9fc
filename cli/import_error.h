// What the commands say when a map can not be read.
#pragma once

#include <lgs/tiled/import.h>

#include <string>

namespace lgs::cli {

/// The error for whoever called a command on a map: its options instead of those of the library, and the command that
/// lets the map read what it names. `before` stands before options, for a command that does not have them.
std::string complaint(tiled::ImportError error, const std::string& map, const std::string& before = {});

}  // namespace lgs::cli
