// What all commands share: how they end, how they write, how they are set up. `lgs` has three; the others are programs of
// their own (kProgramsBeside), which it starts.
#pragma once

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace lgs::cli {

/// Exit statuses. They are fixed, because other programs read them.
enum class Status { fine = 0, mismatch = 1, badInput = 2, inPart = 3 };

/// The worse of two.
inline Status worst(Status a, Status b) { return std::max(a, b); }

/// Prints a complaint on the standard error.
Status complain(std::string_view text);

/// Writes a file ("-" is the standard output), or complains.
Status write(const std::string& path, std::string_view content);

/// Flushes the standard output, at the end of a process. If output was lost, to a full disk say, `fine` becomes
/// `badInput`; a mismatch stays one.
Status flushed(Status status);

/// Complains if an output can not be written, or if more than one is the standard output. Empty paths do not count:
/// nobody asked for these outputs.
Status tryOutputs(std::initializer_list<std::string> paths);

/// Adds an option that takes a whole number in decimal digits. CLI11's own conversion reads "010" as eight, cuts large
/// numbers to the largest, and does not say what is wrong.
struct WholeRange {
  std::uint64_t min = 0;
  std::uint64_t max = std::numeric_limits<std::uint64_t>::max();
};
CLI::Option* addWholeNumber(CLI::App& command, const std::string& name, std::function<void(std::uint64_t)> set,
                            WholeRange range, const std::string& description);

/// The same for a real number in decimal digits. What is no number, and nan, is in no range.
struct RealRange {
  double min = 0;
  double max = 0;
};
CLI::Option* addReal(CLI::App& command, const std::string& name, std::function<void(double)> set, RealRange range,
                     const std::string& description);

/// A real number in a range; if it is none, an error of the option `name`.
double readReal(const std::string& name, const std::string& text, RealRange range);

/// Each adds a subcommand. If that is chosen, and its arguments are good, it stores what is to be done in `chosen`.
using Action = std::function<Status()>;
void addReplay(CLI::App& app, Action& chosen);
void addCheck(CLI::App& app, Action& chosen);
void addOracle(CLI::App& app, Action& chosen);
void addImport(CLI::App& app, Action& chosen);
void addBench(CLI::App& app, Action& chosen);
void addRide(CLI::App& app, Action& chosen);

/// A program beside lgs: `lgs NAME` starts `lgs-NAME`, with the same arguments.
struct ProgramBeside {
  const char* name;
  const char* job;
};
inline constexpr std::array<ProgramBeside, 3> kProgramsBeside{{
    {"import", "Turn the collision shapes of a Tiled or LDtk map into a trace"},
    {"bench", "Time the engine, the published algorithm and five polygon libraries"},
    {"ride", "Let a body ride over a world in Box2D 2.4, with and without ghosts"},
}};

/// Where the program lies: in the folder of this one, or in one of PATH. The error says which target builds it.
tl::expected<std::string, std::string> programBeside(std::string_view name);

/// Parses the arguments, runs what is chosen, and gives the exit status of the process.
int runCommand(CLI::App& app, const Action& chosen, int argc, const char* const* argv);

/// The whole of a program `lgs-NAME`, whose one subcommand `add` adds.
int runProgram(int argc, const char* const* argv, void (*add)(CLI::App& app, Action& chosen));

}  // namespace lgs::cli
