// The references as a service: it reads the lines that an engine under the harness reads, and answers what a perfect
// engine would.
#include "cli/inputs.h"
#include "oracle/check/reference_engine.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/line.h"

#include <fmt/format.h>
#include <array>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

namespace lgs::cli {
namespace {

using namespace oracle;
using Words = std::vector<std::string_view>;

class Service {
 public:
  explicit Service(Engine& engine) : engine_(engine) { reset(); }

  /// Answers a line. Returns what is wrong with it, and what to do; then nothing has changed. Empty if it is good.
  std::string take(const std::string& line) {
    constexpr std::array<std::string_view, 4> kOfTraces{"preserve", "add", "remove", "commit"};
    const Words words = splitWords(line);
    if (words.empty()) return "";
    if (words[0] == "lgs-engine") return greet(words);
    if (words[0] == "reset") return words.size() == 1 ? reset() : "reset stands alone on its line";
    if (std::ranges::find(kOfTraces, words[0]) == kOfTraces.end())
      return "unknown word; a line starts with lgs-engine, reset, preserve, add, remove, commit or #";
    const ParsedTrace parsed = parseTrace("lgs-trace 1\n" + line);
    if (parsed.error) return parsed.error->text;
    if (words[0] == "preserve") return preserve(parsed.trace.preserve);
    for (const Call& edit : parsed.trace.calls) make(edit);
    return "";
  }

  /// Why there is no answer to the last line, if there is none.
  const std::optional<Failure>& failure() const { return failure_; }

 private:
  std::string greet(const Words& words) const {
    if (words != Words{"lgs-engine", "1"}) return "the greeting is 'lgs-engine 1'; this is the only version there is";
    fmt::print("lgs-engine 1 {} {}\n", engine_.name(), print(engine_.can()));
    return "";
  }

  std::string reset() {
    preserve_ = {};
    hasEdits_ = false;
    engine_.reset(preserve_);
    return "";
  }

  std::string preserve(const PreservePairs& more) {
    if (!engine_.can().preserve)
      return "CGAL alone can not judge a preserve relation; start lgs oracle with --oracle both or naive";
    if (hasEdits_) return "preserve must stand before the first edit; reset begins a new world";
    for (const auto& [a, b] : more.pairs()) preserve_.add(a, b);
    engine_.reset(preserve_);
    return "";
  }

  void make(const Call& edit) {
    hasEdits_ = true;
    if (edit.kind == Call::Kind::add) {
      engine_.add(edit.name(), edit.polygon());
    } else if (edit.kind == Call::Kind::remove) {
      engine_.remove(edit.name());
    } else {
      commit();
    }
  }

  void commit() {
    const auto refusals = engine_.commit();
    if (!refusals) {
      failure_ = refusals.error();
      return;
    }
    for (const auto& [name, reason] : *refusals) fmt::print("refused {} {}\n", name, reason);
    fmt::print("{}end\n", dump(engine_.outline()));
  }

  Engine& engine_;
  PreservePairs preserve_;
  bool hasEdits_ = false;  // or commits, since the reset
  std::optional<Failure> failure_;
};

// A bad line is answered where its sender looks for answers. The exit status tells of it too, to those who do not read.
Status serve(const CheckOptions& options) {
  ReferenceEngine engine(options.naive, options.cgal);
  Service service(engine);
  Status status = Status::fine;
  std::string line;
  for (std::size_t number = 1; std::getline(std::cin, line); ++number) {
    if (line.ends_with('\r')) line.pop_back();
    if (const std::string fault = service.take(line); !fault.empty()) {
      status = Status::badInput;
      fmt::print("error {}: {}\n", number, fault);
    }
    if (service.failure()) {
      fmt::print(stderr, "MISMATCH at line {}: {}\n", number, service.failure()->text);
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
