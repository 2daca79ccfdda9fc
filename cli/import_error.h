// What the commands say when a map can not be read.
#pragma once

#include <lgs/tiled/import.h>

#include <string>

namespace lgs::cli {

/// The error for whoever called a command: its options instead of those of the library. `before` stands before their
/// names, for a command that does not have them.
std::string complaint(tiled::ImportError error, const std::string& before = {});

}  // namespace lgs::cli
