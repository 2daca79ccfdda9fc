// What the commands say when a map can not be read.
#pragma once

#include <lgs/tiled/import.h>

#include <string>

namespace lgs::cli {

/// The error for whoever called the command on a map: its options instead of those of the library, and the command that
/// lets the map read what it names.
std::string complaint(tiled::ImportError error, const std::string& map);

}  // namespace lgs::cli
