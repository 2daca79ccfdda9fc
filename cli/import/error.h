// What the commands say when a map can not be read.
#pragma once

#include <lgs/tiled/import.h>

#include <string>

namespace lgs::cli {

/// A text that names the option by which a map may read a file, with the command for it.
std::string withCommands(std::string text, const std::string& map);

/// The error for whoever called the command on a map: its options instead of those of the library, and the command that
/// lets the map read what it names.
std::string complaint(tiled::ImportError error, const std::string& map);

}  // namespace lgs::cli
