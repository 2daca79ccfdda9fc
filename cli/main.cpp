// The lgs command.
#include "cli/command.h"

#include <fmt/format.h>
#include <exception>

namespace lgs::oracle {
namespace {

// What is wrong with a command that there is not, of which CLI11 says only that a subcommand is missing.
std::string faultOf(const CLI::App& app, const std::string& name) {
  std::string known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == name) return {};
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  return fmt::format("'{}' is no command; there are {}", name, known);
}

Status parseAndRun(CLI::App& app, const Run& run, int argc, char** argv) {
  if (argc > 1 && argv[1][0] != '-') {
    if (const std::string fault = faultOf(app, argv[1]); !fault.empty()) return complain(fault);
  }
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::ParseError& error) {
    // Help and version are fine; every other status of CLI11's is bad usage.
    return app.exit(error) == 0 ? Status::fine : Status::badInput;
  } catch (const std::exception& error) {
    return complain(fmt::format("lgs: {}", error.what()));
  }
}

}  // namespace
}  // namespace lgs::oracle

int main(int argc, char** argv) {
  using namespace lgs::oracle;
  CLI::App app(
      "LocalGridSeg: boundary segments and ghost vertices of a grid of polygons, kept up to date at the cost of the "
      "edit.\n"
      "This command plays, checks, imports, draws and times; the library is what a game links.",
      "lgs");
  app.set_version_flag("--version", "lgs " LGS_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  app.footer(
      "Exit status: 0 fine, 1 a mismatch was found, 2 bad input or usage.\n"
      "More about a command: lgs COMMAND --help");
  Run run;
  addReplay(app, run);
  addCheck(app, run);
  addImport(app, run);
  addBench(app, run);
  addPublished(app, run);
#ifdef LGS_HAS_RIDE
  addRide(app, run);
#endif
  return static_cast<int>(flushed(parseAndRun(app, run, argc, argv)));
}
