// What the subcommands of `lgs` share: how they are set up, how they end, how they read and write.
#pragma once

#include "oracle/check/checker.h"
#include "oracle/trace/trace.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace lgs::oracle {

/// Exit statuses: fixed, other programs read them.
enum class Status { fine = 0, mismatch = 1, badInput = 2 };

/// Prints a complaint on the standard error.
Status complain(std::string_view text);

/// Writes a file ("-" is the standard output); complains if that does not work.
Status write(const std::string& path, std::string_view content);

/// Output that was lost, to a full disk say, is no success; but a mismatch remains one. To be asked at the end of a
/// process.
Status flushed(Status status);

/// Complains if one of a command's outputs can not be written, or more than one is the standard output. An empty path
/// is an output that nobody asked for.
Status tryOutputs(std::initializer_list<std::string> paths);

/// The worse of two.
inline Status worst(Status a, Status b) { return std::max(a, b); }

/// Reads a trace, or imports a Tiled map with the importer's defaults if the name ends in ".tmx". The error is a whole
/// complaint, "FILE:LINE: …".
tl::expected<Trace, std::string> readWorld(const std::string& path);

/// Adds an option that takes a whole number in decimal digits. CLI11's own conversion reads "010" as eight, saturates,
/// and has no words for what is wrong.
struct WholeRange {
  std::uint64_t min = 0;
  std::uint64_t max = std::numeric_limits<std::uint64_t>::max();
};
CLI::Option* addWholeNumber(CLI::App& command, const std::string& name, std::function<void(std::uint64_t)> set,
                            WholeRange range, const std::string& description);

/// Adds --oracle to a command; it sets `naive` and `cgal`.
CLI::Option* addOracleOption(CLI::App& command, CheckOptions& options);

/// Adds a subcommand; `run` is called if it is the one chosen and its arguments are good.
using Run = std::function<Status()>;
void addReplay(CLI::App& app, Run& run);
void addCheck(CLI::App& app, Run& run);
void addImport(CLI::App& app, Run& run);
void addBench(CLI::App& app, Run& run);
void addPublished(CLI::App& app, Run& run);
void addRide(CLI::App& app, Run& run);  ///< where Box2D 2.4 is there

}  // namespace lgs::oracle
