// The references as a service: it reads the lines that an engine under the harness reads, and answers what a perfect
// engine would.
#include "cli/inputs.h"
#include "oracle/check/answers.h"
#include "oracle/check/reference_engine.h"

#include <fmt/format.h>
#include <cstdio>
#include <iostream>
#include <memory>

namespace lgs::cli {
namespace {

using namespace oracle;

// A bad line is answered where its sender looks for answers. The exit status tells of it too, to those who do not read.
Status serve(const CheckOptions& options) {
  ReferenceEngine engine(options.naive, options.cgal);
  Answers answers(engine);
  Status status = Status::fine;
  std::string line;
  for (std::size_t number = 1; std::getline(std::cin, line); ++number) {
    const Answer answer = answers.take(line);
    if (answer.isOfBadLine) status = Status::badInput;
    fmt::print("{}", answer.text);
    if (answer.failure) {
      fmt::print(stderr, "MISMATCH at line {}: {}\n", number, answer.failure->text);
      return Status::mismatch;
    }
    std::fflush(stdout);
  }
  return std::ferror(stdin) == 0 ? status : complain("standard input: cannot read");
}

constexpr const char* kOracleHelp =
    "It reads edits from the standard input, line by line, and writes what the laws demand. It speaks the\n"
    "protocol of engines (lgs check --help), and is the perfect engine:\n"
    "  it reads                           it writes\n"
    "  lgs-engine 1                       lgs-engine 1 oracle CAPABILITY ...; there is no need to ask\n"
    "  reset                              nothing: the world is empty now, as it is at the beginning\n"
    "  preserve B1 B2                     nothing; only before the first edit of a world\n"
    "  add NAME I J BLOCK X Y X Y ...     nothing\n"
    "  remove NAME                        nothing\n"
    "  commit                             'refused NAME REASON' for each edit since the last commit that must\n"
    "                                     be refused; the whole outline, 'segment ...' each; then 'end'\n"
    "  a bad line                         'error LINE: what is wrong, and what to do', at once; nothing has\n"
    "                                     changed, and the next line is read\n"
    "Edits are the lines of traces but for their first one, segments those of dumps. Comments (#) are skipped.\n"
    "Each answer is flushed. REASON is one of: too few vertices, capacity, outside the cell, repeated vertex,\n"
    "zero area, clockwise, self-intersecting, overlap, name in use, unknown name.\n\n"
    "At the end of the input the exit status is 0, or 2 if there was a bad line. If the references disagree,\n"
    "it says so on the standard error and ends with status 1.\n\n"
    "Examples: printf 'add a 0 0 1  0 0, 1 0, 1 1\\ncommit\\n' | lgs oracle\n"
    "          lgs check --engine 'lgs oracle' --edits 2000";

}  // namespace

void addOracle(CLI::App& app, Action& chosen) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App& command = *app.add_subcommand("oracle", "Answer edits, line by line, with what the references demand");
  addOracleOption(command, *options)
      ->description(
          "Which references answer: CGAL's exact union of all polygons,\n"
          "which knows no preserve relation; the naive one, which follows\n"
          "the laws word by word, and is quick; or both (the default): the\n"
          "naive one answers, and is compared with CGAL's union");
  command.footer(kOracleHelp);
  command.callback([options, &chosen] { chosen = [options] { return serve(*options); }; });
}

}  // namespace lgs::cli
