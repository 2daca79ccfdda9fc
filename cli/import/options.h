// The options of an import.
#pragma once

#include "cli/command.h"

#include <lgs/tiled/import.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace lgs::cli {

/// Adds them in a group of their own.
void addImportOptions(CLI::App& command, tiled::Options& options);

/// The options that were given, as a shell takes them: " --layer Ground --solid".
std::string importArguments(const CLI::App& command, std::span<const std::string_view> without = {});

/// Options that a hint leaves out, as it has its own: those that choose what is solid.
inline constexpr std::array<std::string_view, 8> kNotInHints{
    "--layer", "--solid", "--solid-if", "--objects", "--no-objects", "--not", "--visible", "--polyline-thickness"};

/// The arguments of a suggestion, likewise: "--layer Ground --solid".
std::string argumentsOf(const tiled::Suggestion& suggestion);

/// The first lines of a report: what was taken, and the suggestions.
std::string summaryOf(const std::string& report);

}  // namespace lgs::cli
