#include "cli/engine.h"

#include "oracle/check/failure.h"
#include "oracle/check/shell.h"
#include "oracle/engine/process_engine.h"
#include "oracle/engine/serve.h"
#include "oracle/engine/table_engine.h"

#include <fmt/format.h>

namespace lgs::cli {

using namespace oracle;

namespace {

// An empty word is a variable of a script that is not set. To check this library's engine then would be a surprise.
const CLI::Validator kGiven([](const std::string& text) { return std::string(text.empty() ? "it is empty" : ""); }, "");

}  // namespace

std::string EngineArguments::print() const {
  if (!isGiven()) return "";
  std::string text =
      file.empty() ? fmt::format(" --engine {}", shellWord(command)) : fmt::format(" --engine-so {}", shellPath(file));
  if (timeout) text += fmt::format(" --engine-timeout {}", *timeout);
  return assumed ? text + fmt::format(" --assume {}", shellWord(oracle::print(*assumed))) : text;
}

void EngineArguments::prepare() {
  if (!isGiven() && (timeout || assumed)) throw CLI::RequiredError("--engine or --engine-so");
  if (file.empty()) return;
  auto engine = TableEngine::load(file);
  if (!engine) throw CLI::ValidationError("--engine-so", engine.error());
  loaded = std::move(*engine);
  if (assumed) loaded->assume(*assumed);
}

void addEngineOptions(CLI::App& command, EngineArguments& arguments, CLI::Option* needed) {
  CLI::Option* const engine =
      command
          .add_option("--engine", arguments.command,
                      "Check another engine instead of this library's: a command for\n/bin/sh that speaks the protocol")
          ->check(kGiven)
          ->option_text("COMMAND");
  CLI::Option* const file =
      command
          .add_option("--engine-so", arguments.file, "The same for a shared object that exports what lgs_engine.h says")
          ->check(kGiven)
          ->option_text("FILE.so")
          ->excludes(engine);
  for (CLI::Option* const option : {engine, file})
    if (needed != nullptr) option->needs(needed);
  addReal(
      command, "--engine-timeout", [&arguments](double seconds) { arguments.timeout = seconds; }, {0.01, 3'600},
      "Seconds that an answer of the engine may take; default 10")
      ->option_text("SECONDS");
  command
      .add_option_function<std::string>(
          "--assume",
          [&arguments](const std::string& words) {
            auto can = parseCapabilities(words);
            if (!can) throw CLI::ValidationError("--assume", can.error());
            arguments.assumed = *can;
          },
          "What the engine can do, whatever it says: words of the protocol")
      ->option_text("'WORD ...'");
  command.add_flag("--verbose", arguments.verbose, "Show the engine's comments and its own log")
      ->needs(engine)
      ->option_text(" ");
}

std::unique_ptr<Engine> startEngine(const EngineArguments& arguments) {
  const auto program = arguments.loaded ? serving(arguments.loaded) : shell(arguments.command);
  auto engine = ProcessEngine::start({program, std::chrono::duration<double>(arguments.patience()), arguments.verbose});
  if (!engine) {
    fmt::print(stderr, "lgs: there is no engine to check: {}", inWords(engine.error()));
    return nullptr;
  }
  if (arguments.assumed) (*engine)->assume(*arguments.assumed);
  return std::move(*engine);
}

void introduce(const Engine& engine, std::FILE* out) {
  fmt::print(out, "engine     {}: {} are compared\nworlds     {}\n", engine.name(), comparedInWords(engine.can()),
             worldsInWords(engine.can()));
  std::fflush(out);
}

Status tell(const Failure& failure, std::FILE* out) {
  fmt::print(out, "MISMATCH {}", inWords(failure));
  return Status::mismatch;
}

Status finishEngine(Engine& engine, Status status, std::FILE* out) {
  const auto failure = engine.finish();
  return failure ? worst(status, tell(*failure, out)) : status;
}

const char* const kEngineHelp =
    "AN ENGINE OF YOUR OWN (--engine) is a program that reads edits and writes outlines, line by line:\n"
    "  it reads                           it writes\n"
    "  lgs-engine 1                       lgs-engine 1 NAME [CAPABILITY ...]\n"
    "  reset                              nothing: the world is empty now\n"
    "  preserve B1 B2                     nothing; only right after reset\n"
    "  add NAME I J BLOCK X Y X Y ...     nothing; coordinates are exact decimals\n"
    "  remove NAME                        nothing\n"
    "  paint BLOCK fill|replace X Y ... | X Y ..., carve X Y ...   nothing; only to engines with regions\n"
    "  commit                             'refused NAME REASON' for each refused edit; the whole outline as lines\n"
    "                                     of a dump, in any order; 'island X Y AREA2' for each island; then 'end'\n"
    "                                     (or what changed: '- ID', '+ ID segment ...', '~ ID segment ...')\n"
    "  the end of its input               nothing, and ends with status 0\n"
    "It flushes after each answer. Lines that begin with # are comments. Capabilities say what it can, and only\n"
    "that is sent to it:\n"
    "  ghosts, blocks     it puts these out          several    several polygons a cell\n"
    "  slants             edges of any direction     preserve   a preserve relation\n"
    "  refuses            it refuses bad edits       squares    (only) whole squares\n"
    "  islands            it names islands           merged     it joins collinear neighbours\n"
    "  delta              it reports what changed    time       it prints 'time NANOSECONDS', for lgs bench\n"
    "  lattice=N          (only) coordinates in 1/N cell        cells=N  (only) cells within ±N\n"
    "  regions            (only) strokes of brushes             round=N  regions may be N units off\n"
    "Which edits it refuses is compared, not its reasons; and its outline. A wrong line, a late answer, an end or\n"
    "a crash is a mismatch like any other.";

}  // namespace lgs::cli
