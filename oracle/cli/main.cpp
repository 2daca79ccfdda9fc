// The lgs command.
#include "oracle/cli/command.h"

#include <fmt/format.h>
#include <exception>

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
  try {
    app.parse(argc, argv);
    return static_cast<int>(run());
  } catch (const CLI::ParseError& error) {
    // Help and version are fine; every other status of CLI11's is bad usage.
    return app.exit(error) == 0 ? static_cast<int>(Status::fine) : static_cast<int>(Status::badInput);
  } catch (const std::exception& error) {
    return static_cast<int>(complain(fmt::format("lgs: {}", error.what())));
  }
}
