#include "cli/command.h"
#include "cli/imported.h"
#include "oracle/draw/draw.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <charconv>

namespace lgs::cli {
namespace {

struct ImportArguments {
  std::string map;
  std::string trace = "-";
  std::string report;
  std::string svg;
  tiled::Options options;
};

Status run(const ImportArguments& arguments) {
  const Status bad = tryOutputs({arguments.trace, arguments.report, arguments.svg});
  if (bad != Status::fine) return bad;
  const auto map = tiled::importMap(arguments.map, arguments.options);
  if (!map) return complain(tiled::message(map.error()));
  const oracle::Trace trace = traceOf(*map);
  Status status = write(arguments.trace, printTrace(trace));
  const std::string report = tiled::toText(map->report);
  if (!arguments.report.empty()) {
    status = worst(status, write(arguments.report, report));
  } else {
    fmt::print(arguments.trace == "-" ? stderr : stdout, "{}", report);
  }
  if (arguments.svg.empty()) return status;
  oracle::Player player(trace.preserve);
  if (const auto done = play(trace, player); !done) return complain(message(done.error(), arguments.map));
  oracle::DrawOptions options;
  options.title = arguments.map;
  const oracle::Outline outline = oracle::outlineOf(player.world());
  return worst(status, write(arguments.svg, drawWorld(player.scene(), outline, options)));
}

// Reads "water=7". Returns what is wrong with it, or nothing.
std::string readBlock(const std::string& text, std::map<std::string, Block>& blocks) {
  const std::size_t equals = text.rfind('=');
  Block block = 0;
  const char* const begin = text.data() + (equals == std::string::npos ? text.size() : equals + 1);
  const char* const end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(begin, end, block);
  if (begin == end || stop != end || status != std::errc()) return "'" + text + "' is not NAME=NUMBER";
  blocks[text.substr(0, equals)] = block;
  return {};
}

void addBlockOptions(CLI::App& command, tiled::Options& options) {
  command
      .add_option_function<std::string>(
          "--block",
          [&options](const std::string& from) {
            options.blockFrom = from == "class"   ? tiled::BlockFrom::tileClass
                                : from == "layer" ? tiled::BlockFrom::layer
                                                  : tiled::BlockFrom::one;
          },
          "Which block a shape gets: one gives block 1 to all (the default),\n"
          "class and layer give one block to each class of tiles, or layer")
      ->check(CLI::IsMember({"one", "class", "layer"}))
      ->option_text("one|class|layer");
  command
      .add_option_function<std::vector<std::string>>(
          "--number",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              if (const std::string fault = readBlock(text, options.blocks); !fault.empty()) {
                throw CLI::ValidationError("--number", fault);
              }
            }
          },
          "The block of a class or layer; the others get numbers in the\n"
          "order in which they occur. May be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME=NUMBER");
}

void addShapeOptions(CLI::App& command, tiled::Options& options) {
  command
      .add_option("--tolerance", options.tolerance,
                  "A vertex that misses the tile's rim or corner by up to this\nmany pixels is put on it; default 1")
      ->check(CLI::Range(0.0, 1e6))
      ->option_text("PX");
  command
      .add_option_function<std::string>(
          "--outside",
          [&options](const std::string& how) {
            options.outside = how == "clip" ? tiled::Outside::clip : tiled::Outside::carry;
          },
          "What reaches out of its tile is carried into the neighbouring\ncells (the default), or clipped")
      ->check(CLI::IsMember({"carry", "clip"}))
      ->option_text("carry|clip");
  command.add_option("--layer", options.layers, "Import only this layer or group. May be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME");
  command.add_flag("--solid", options.solidWithoutShapes,
                   "Import a tile without collision shapes as a full square;\notherwise it is empty");
}

}  // namespace

void addImport(CLI::App& app, Action& chosen) {
  const auto arguments = std::make_shared<ImportArguments>();
  CLI::App& command = *app.add_subcommand("import", "Turn the collision shapes of a Tiled map into a trace");
  command.add_option("MAP", arguments->map, "A Tiled map (.tmx); its tilesets are found by the paths in it")
      ->required()
      ->option_text("(required)");
  command.add_option("-o,--output", arguments->trace, "Where the trace goes; default stdout")->option_text("TRACE");
  command
      .add_option("--report", arguments->report,
                  "Where the report goes: what was snapped, clipped, carried or\n"
                  "left out; default stdout, or stderr if the trace is on stdout")
      ->option_text("FILE");
  command.add_option("--svg", arguments->svg, "Draw the imported world to this file")->option_text("FILE");
  addShapeOptions(command, arguments->options);
  addBlockOptions(command, arguments->options);
  command.footer(
      "The tile in column c and row r of the map becomes cell (c, -1 - r): y is up, and the map's top edge is y = "
      "0.\n\n"
      "Example: lgs import level.tmx -o level.trace --block class --number water=7 --svg level.svg");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run(*arguments); }; });
}

}  // namespace lgs::cli
