// The lgs command.
#include "cli/command.h"

#include <fmt/format.h>
#include <cstdio>
#include <exception>

namespace lgs::cli {
namespace {

// What is wrong with a command of this name; empty if it exists. CLI11 would only say that a subcommand is required.
std::string faultOf(const CLI::App& app, const std::string& name) {
  std::string known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == name) return {};
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  return fmt::format("'{}' is no command; there are {}", name, known);
}

Status parseAndRun(CLI::App& app, const Action& chosen, int argc, char** argv) {
  if (argc > 1 && argv[1][0] != '-') {
    if (const std::string fault = faultOf(app, argv[1]); !fault.empty()) return complain(fault);
  }
  try {
    app.parse(argc, argv);
    return chosen();
  } catch (const CLI::ParseError& error) {
    // CLI11 has a status of its own for each kind of bad usage. Help and version have 0.
    return app.exit(error) == 0 ? Status::fine : Status::badInput;
  }
}

Status run(int argc, char** argv) {
  CLI::App app(
      "LocalGridSeg keeps the outline of a grid of polygons up to date, edit by edit: its segments, with the ghost\n"
      "vertices that a physics engine needs. A game links the library. This command plays edits, checks the engine,\n"
      "imports maps, draws and times.",
      "lgs");
  app.set_version_flag("--version", "lgs " LGS_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  app.footer(
      "Exit status: 0 fine, 1 a mismatch was found, 2 bad input or usage.\n"
      "More about a command: lgs COMMAND --help");
  Action chosen;
  addReplay(app, chosen);
  addCheck(app, chosen);
  addOracle(app, chosen);
  addImport(app, chosen);
  addBench(app, chosen);
#ifdef LGS_HAS_RIDE
  addRide(app, chosen);
#endif
  return flushed(parseAndRun(app, chosen, argc, argv));
}

}  // namespace
}  // namespace lgs::cli

int main(int argc, char** argv) {
  try {
    return static_cast<int>(lgs::cli::run(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lgs: %s\n", error.what());
    return static_cast<int>(lgs::cli::Status::badInput);
  }
}
