// What the commands say when a map can not be read.
#pragma once

#include <lgs/tiled/import.h>

#include <string>

namespace lgs::cli {

/// The error for whoever called the command: its options instead of those of the library.
std::string complaint(tiled::ImportError error);

}  // namespace lgs::cli
