#include "cli/engine.h"
#include "cli/inputs.h"
#include "oracle/check/report.h"
#include "oracle/draw/draw.h"
#include "oracle/generate/generator.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/model.h"
#include "oracle/trace/plain_edits.h"
#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace lgs::cli {

using namespace oracle;

namespace {

struct ReplayArguments {
  std::vector<std::string> worlds;  ///< files, and folders of traces
  std::string trace;                ///< the one that is played
  bool check = false;
  CheckOptions checkOptions;
  EngineArguments engine;
  std::string dump;
  std::string svg;
  std::string html;
  std::string save;
};

// Saves a world, or complains.
Status save(const World& world, const std::string& path) {
  std::string bytes;
  const auto done = world.save([&bytes](std::span<const std::byte> piece) {
    bytes.append(reinterpret_cast<const char*>(piece.data()), piece.size());
  });
  return done ? write(path, bytes) : complain(path + ": " + message(done.error()));
}

// Plays the trace to its end; says, dumps, saves and draws what comes out. If another engine has played it, its outline
// is shown.
Status showEnd(const ReplayArguments& arguments, const Trace& trace, const Engine* engine, bool draws, std::FILE* out) {
  Player player(trace.preserve);
  if (const auto done = play(trace, player); !done) return complain(message(done.error(), arguments.trace));
  const Outline outline = engine != nullptr ? engine->outline() : outlineOf(player.world());
  fmt::print(out, "{}", inWords(trace, player.world(), outline));
  Status status = Status::fine;
  if (!arguments.dump.empty()) status = write(arguments.dump, dump(outline));
  if (!arguments.save.empty()) status = worst(status, save(player.world(), arguments.save));
  if (!draws) return status;
  DrawOptions options;
  options.title = arguments.trace;
  return worst(status, write(arguments.svg, drawWorld(player.scene(), outline, options)));
}

Status check(const ReplayArguments& arguments, const Trace& trace, const CheckOptions& options, std::FILE* out) {
  CheckStats stats;
  const auto mismatch = checkTrace(trace, options, stats);
  if (!mismatch) return complain(message(mismatch.error(), arguments.trace));
  const bool draws = !arguments.svg.empty();
  const std::string& html = arguments.html;
  const Trace good = options.skipRefused ? withoutRefused(trace) : trace;
  if (!*mismatch) {
    fmt::print(out, "{}", inWords(stats));
    const Status status = showEnd(arguments, good, options.engine, draws, out);
    return html.empty() ? status : worst(status, write(html, page(good, arguments.trace)));
  }
  fmt::print(out, "MISMATCH {}: {}", arguments.trace, describe(**mismatch, trace));
  Status status = Status::mismatch;
  if (draws) status = worst(status, write(arguments.svg, draw(**mismatch)));  // instead of the end
  if (!html.empty()) status = worst(status, write(html, page(**mismatch, trace)));
  if (!arguments.dump.empty()) status = worst(status, showEnd(arguments, good, options.engine, false, out));
  return status;
}

Status runOne(const ReplayArguments& arguments) {
  const auto& [dump, svg, html, save] = std::tie(arguments.dump, arguments.svg, arguments.html, arguments.save);
  if (const Status bad = tryOutputs({dump, svg, html, save}); bad != Status::fine) return bad;
  const auto trace = readWorld(arguments.trace);
  if (!trace) return complain(trace.error());
  // A dump, a picture or a saved world may need the standard output; then the summary goes to the standard error.
  const bool isTaken = dump == "-" || svg == "-" || html == "-" || save == "-";
  std::FILE* const out = isTaken ? stderr : stdout;
  const bool draws = !svg.empty();
  if (!arguments.check) return showEnd(arguments, *trace, nullptr, draws, out);

  if (!arguments.engine.isGiven()) return check(arguments, *trace, arguments.checkOptions, out);
  const auto started = startEngine(arguments.engine);
  if (!started) return Status::badInput;
  Engine& engine = *started;
  introduce(engine, out);
  const Trace plain = engine.can().regions ? *trace : inPlainEdits(*trace);  // which every other engine understands
  if (const std::string why = whyNot(plain, engine.can()); !why.empty())
    return complain(fmt::format("{}: the engine can not have it: {}", arguments.trace, why));
  CheckOptions options = arguments.checkOptions;
  options.engine = &engine;
  options.skipRefused = engine.can().refuses;
  return finishEngine(engine, check(arguments, plain, options, out), out);
}

// A folder stands for its traces, in the order of their names.
tl::expected<std::vector<std::string>, std::string> filesOf(const std::vector<std::string>& worlds) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& world : worlds) {
    std::error_code ignored;  // reading it will say what is wrong
    if (!fs::is_directory(world, ignored)) {
      files.push_back(world);
      continue;
    }
    const std::vector<std::string> traces = tracesIn(world);
    if (traces.empty()) return tl::unexpected(world + ": there is no .trace in this folder");
    files.insert(files.end(), traces.begin(), traces.end());
  }
  return files;
}

Status run(ReplayArguments arguments) {
  const auto files = filesOf(arguments.worlds);
  if (!files) return complain(files.error());
  const bool isOne = files->size() == 1;
  if (!isOne && !(arguments.dump + arguments.svg + arguments.html + arguments.save).empty())
    return complain("lgs replay: --dump, --svg, --html and --save take one trace, not " +
                    std::to_string(files->size()));
  Status status = Status::fine;
  std::size_t fine = 0;
  for (const std::string& file : *files) {
    arguments.trace = file;
    if (!isOne) fmt::print("{}: ", file);
    std::fflush(stdout);
    const Status one = runOne(arguments);
    fine += one == Status::fine ? 1 : 0;
    status = worst(status, one);
  }
  if (!isOne) fmt::print("{} of {} traces are fine\n", fine, files->size());
  return status;
}

constexpr const char* kReplayHelp =
    "A trace is a list of edits:\n"
    "  lgs-trace 1\n"
    "  add floor 0 0 7  0 0  1 0  1 0.5  0 0.5    # name, cell i j, block, then x y in cells\n"
    "  add ramp  1 0 7  0 0  1 0  0 0.5\n"
    "  commit\n"
    "  remove floor\n"
    "The end of the file commits what is pending. If the first line is lgs-trace 2, brushes may edit as well:\n"
    "  carve 0.2 0.2  1.8 0.2  1 1.5              # a region in cells of the world; | begins its next ring\n"
    "  paint 7 fill  0 0  2 0  1 1                # a block, and fill or replace\n"
    "What a brush changes has no name any more.\n\n"
    "A line of a dump is: segment <start> <end> <ghost1> <ghost2> <block>. Each of the four points is two\n"
    "numbers, in lattice units of 1/65536 cell; a ghost that is missing is - -.\n\n"
    "With --engine the edits are played by that engine, and its outlines are compared (lgs check --help).\n\n"
    "Example: lgs replay world.trace --check --dump - --svg world.svg\n"
    "         lgs replay world.trace --check --html world.html";

}  // namespace

void addReplay(CLI::App& app, Action& chosen) {
  const auto arguments = std::make_shared<ReplayArguments>();
  CLI::App& command = *app.add_subcommand("replay", "Play a trace, a list of edits; check, dump or draw the result");
  command
      .add_option(
          "TRACE...", arguments->worlds,
          "Files in the trace format, maps (.tmx, .tmj, .json, .world,\n.ldtk), saved worlds (.lgs), or folders of "
          "traces")
      ->required()
      ->option_text("(required)");
  CLI::Option* const check =
      command.add_flag("--check", arguments->check,
                       "Compare with the references after every commit; on a mismatch\nsay what differs, and where");
  addOracleOption(command, arguments->checkOptions)->needs(check);
  command
      .add_flag("--views", arguments->checkOptions.views,
                "Follow the world with views of loops, islands, pieces and hashes, as\n"
                "lgs check --views does")
      ->needs(check);
  addEngineOptions(command, arguments->engine, check);
  command.add_option("--dump", arguments->dump, "Write the segments after the last commit; - is stdout")
      ->option_text("FILE");
  command.add_option("--svg", arguments->svg, "Draw the world, or the mismatch if there is one; - is stdout")
      ->option_text("FILE");
  command
      .add_option("--html", arguments->html,
                  "Write a page that steps through the edits, for a browser: both\noutlines, their links, and the "
                  "mismatch if there is one; - is\nstdout")
      ->option_text("FILE")
      ->needs(check);
  command.add_option("--save", arguments->save, "Save the world after the last commit, for World::load(); - is stdout")
      ->option_text("FILE.lgs");
  command.footer(kReplayHelp);
  command.callback([arguments, &chosen] {
    arguments->engine.prepare();
    if (arguments->checkOptions.views && arguments->engine.isGiven())
      throw CLI::ExcludesError("--views", "--engine and --engine-so");
    chosen = [arguments] { return run(*arguments); };
  });
}

}  // namespace lgs::cli
