// The lgs command: replay, check and oracle. `lgs import`, `bench` and `ride` are programs of their own, which it starts.
#include "cli/command.h"

#include <fmt/format.h>
#include <unistd.h>
#include <cstdio>
#include <cstring>

namespace lgs::cli {
namespace {

// Becomes the program `lgs-NAME`. It comes back only if there is none.
Status become(const ProgramBeside& beside, char** arguments) {
  const auto program = programBeside(beside.name);
  if (!program) return complain("lgs: " + program.error());
  execv(program->c_str(), arguments);
  return complain(fmt::format("lgs: {} can not be started", *program));
}

// What is wrong with a command of this name; empty if it exists. CLI11 would only say that a subcommand is required.
std::string faultOf(const CLI::App& app, const std::string& name) {
  std::string known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == name) return {};
    known += command->get_name() + ", ";
  }
  for (const ProgramBeside& beside : kProgramsBeside) known += std::string(beside.name) + ", ";
  known.resize(known.size() - 2);
  return fmt::format("'{}' is no command; there are {}", name, known);
}

std::string footer() {
  std::string text = "Programs beside it, which lgs starts if they are built:\n";
  for (const auto& [name, job] : kProgramsBeside) text += fmt::format("  {:<32}{}\n", name, job);
  return text +
         "\nExit status: 0 fine, 1 a mismatch was found, 2 bad input or usage.\n"
         "More about a command: lgs COMMAND --help";
}

int run(int argc, char** argv) {
  CLI::App app(
      "LocalGridSeg keeps the outline of a grid of polygons up to date, edit by edit: its segments, with the ghost\n"
      "vertices that a physics engine needs. A game links the library. This command plays edits and checks engines,\n"
      "this library's or yours.",
      "lgs");
  app.set_version_flag("--version", "lgs " LGS_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  app.footer(footer());
  Action chosen;
  addReplay(app, chosen);
  addCheck(app, chosen);
  addOracle(app, chosen);
  if (argc > 1 && argv[1][0] != '-') {
    for (const ProgramBeside& beside : kProgramsBeside)
      if (std::strcmp(argv[1], beside.name) == 0) return static_cast<int>(become(beside, argv + 1));
    if (const std::string fault = faultOf(app, argv[1]); !fault.empty()) return static_cast<int>(complain(fault));
  }
  return runCommand(app, chosen, argc, argv);
}

}  // namespace
}  // namespace lgs::cli

int main(int argc, char** argv) { return lgs::cli::run(argc, argv); }
