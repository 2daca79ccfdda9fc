// What the commands of lgs take: a world from a file, and which references compare.
#pragma once

#include "cli/command.h"
#include "oracle/check/checker.h"
#include "oracle/trace/trace.h"

#include <string>
#include <vector>

namespace lgs::cli {

/// Reads a trace; the polygons of a saved world if the name ends in ".lgs"; or a map of Tiled or LDtk (by its name, ".tmx",
/// ".tmj", ".json", ".world", ".ldtk", or as it begins), which `lgs import` turns into a trace, with no options. The error
/// is a whole complaint, "FILE:LINE: …".
tl::expected<oracle::Trace, std::string> readWorld(const std::string& path);

/// The traces in a folder, in the order of their names.
std::vector<std::string> tracesIn(const std::string& folder);

/// Adds --oracle to a command; it sets `naive` and `cgal`.
CLI::Option* addOracleOption(CLI::App& command, oracle::CheckOptions& options);

}  // namespace lgs::cli
