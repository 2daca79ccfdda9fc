// The report and the error as text.
#include "words.h"

#include "text/words.h"

#include <lgs/tiled/import.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::size_t kMostNamed = 12;

/// Adds a line. Names in it come from files: what would end it, or do something else to a terminal, becomes a blank.
template <class... Parts>
void line(std::string& out, const Parts&... parts) {
  out += text::withoutControls(concat(parts...)) + "\n";
}

/// How many columns a text takes in a terminal. Bytes that continue a UTF-8 character take none.
std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(std::string text, std::size_t width) {
  return text.append(width - std::min(width, columns(text)), ' ');
}

std::string tileName(const TileReport& tile) { return concat(tile.tileset, " #", tile.id); }

/// Where a note holds; `layer` is empty if that is clear.
std::string where(const Note& note, const std::string& layer) {
  if (note.places == 0) return {};
  return concat(" (", counted(note.places, "place"), layer.empty() ? "" : " in layer " + layer, ", first in cell ",
                note.cell.i, ", ", note.cell.j, ")");
}

/// "set #4 'lava', 2 uses in layer Ground"
std::string heading(const TileReport& tile, const Report& report) {
  std::string layers;
  for (const std::uint32_t layer : tile.layers) layers += (layers.empty() ? " " : ", ") + report.layers[layer].path;
  if (!layers.empty()) layers.insert(0, tile.layers.size() == 1 ? " in layer" : " in layers");
  return concat(tileName(tile), tile.className.empty() ? "" : " '" + tile.className + "'", ", ",
                counted(tile.uses, "use"), layers);
}

/// "level.tmx: 184 polygons, 30 % of the map: tile layer Ground: its name says 'ground'; IN PART: …"
void appendSummary(const Report& report, const std::string& command, std::string& out) {
  const double cells = report.infinite ? 0 : static_cast<double>(report.width) * report.height;
  std::string text = "nothing in it is solid";
  if (report.polygons > 0) text = concat(counted(report.polygons, "polygon"), " (", report.shapes, " distinct)");
  if (report.polygons > 0 && cells > 0)
    text += concat(", ", std::lround(100 * static_cast<double>(report.cells) / cells), " % of the map");
  for (const auto& [before, what] : {std::pair(": ", report.choice),
                                     {"; IN PART: ", report.partial},
                                     {"; also there: ", report.also},
                                     {"; left out as deadly or passable: ", report.leftOut}})
    if (!what.empty()) text += before + what;
  line(out, report.file, ": ", text);
  for (const Suggestion& suggestion : report.suggestions) {
    std::string words = command;
    for (const std::string& argument : suggestion.arguments) words += " " + shellWord(argument);
    line(out, "  or:", command.empty() ? "" : " ", words, "  (", counted(suggestion.polygons, "polygon"), ": ",
         suggestion.text, ")");
  }
}

void appendHead(const Report& report, std::string& out) {
  line(out, "  ", report.width, "×", report.height, " tiles of ", report.tileWidth, "×", report.tileHeight, " px",
       report.infinite ? ", infinite" : "", "; polygons in ", counted(report.cells, "cell"));
  std::size_t width = 0;
  for (const LayerReport& layer : report.layers) width = std::max(width, columns(layer.path));
  for (const LayerReport& layer : report.layers) {
    const bool ofObjects = layer.kind == LayerKind::objects;
    const std::string holds = ofObjects ? counted(layer.objects, "object") : counted(layer.tiles, "tile");
    line(out, "  layer ", padded(layer.path, width), "  ",
         layer.imported ? holds + (layer.note.empty() ? "" : "; ")
                        : "passed over" + (ofObjects ? ", " + holds : "") + ": ",
         layer.note);
  }
  width = report.blocks.empty() ? 0 : std::to_string(report.blocks.back().block).size();
  for (const BlockReport& block : report.blocks)
    line(out, "  block ", padded(std::to_string(block.block), width), "  ", counted(block.polygons, "polygon"),
         block.name.empty() ? "" : "  " + block.name);
  for (const std::string& note : report.notes) line(out, "  note: ", note);
}

/// Those notes of the kinds from first to last. Objects of which the same is to be said share a line. `layerOf` names
/// the layer of a note, or is empty if that is clear.
template <class LayerOf>
std::string linesOf(const std::vector<Note>& notes, NoteKind first, NoteKind last, const LayerOf& layerOf) {
  std::vector<std::pair<std::string, std::vector<std::string>>> lines;
  std::map<std::string, std::size_t> places;
  for (const Note& note : notes) {
    if (note.kind < first || note.kind > last) continue;
    const std::string text = note.text + where(note, layerOf(note));
    const auto [at, isNew] = places.try_emplace(text, lines.size());
    if (isNew) lines.push_back({text, {}});
    lines[at->second].second.push_back(std::to_string(note.object));
  }
  std::string out;
  for (const auto& [text, objects] : lines) {
    const bool isOne = objects.size() == 1;
    line(out, isOne ? "    object " : "    objects ", listed(objects, kMostNamed), isOne ? ": " : ", each: ", text);
  }
  return out;
}

void appendNotes(const Report& report, const char* title, NoteKind first, NoteKind last, std::string& out) {
  std::string all;
  const auto add = [&](const std::string& heading, const std::string& lines) {
    if (!lines.empty()) line(all, "  ", heading);
    all += lines;
  };
  for (const LayerReport& layer : report.layers)
    add("layer " + layer.path, linesOf(layer.notes, first, last, [](const Note&) { return ""; }));
  for (const TileReport& tile : report.tiles) {
    const auto layerOf = [&](const Note& note) { return tile.layers.size() > 1 ? report.layers[note.layer].path : ""; };
    add(heading(tile, report), linesOf(tile.notes, first, last, layerOf));
  }
  if (!all.empty()) out += concat("\n", title, "\n", all);
}

void appendShapeless(const Report& report, bool solid, const char* title, std::string& out) {
  std::vector<std::string> shapeless;
  std::uint64_t uses = 0;
  for (const TileReport& tile : report.tiles) {
    if (tile.hasShapes || tile.isLeftOut || tile.isSolid != solid) continue;
    shapeless.push_back(tileName(tile));
    uses += tile.uses;
  }
  if (shapeless.empty()) return;
  out += concat("\n", title, ": ", counted(shapeless.size(), "tile"), ", ", counted(uses, "use"), "\n");
  line(out, "  ", listed(shapeless, kMostNamed));
}

}  // namespace

std::string toText(const Report& report, const std::string& command) {
  std::string out;
  appendSummary(report, command, out);
  appendHead(report, out);
  appendNotes(report, "Left out:", NoteKind::leftOut, NoteKind::leftOut, out);
  appendNotes(report, "Changed on the way in:", NoteKind::carried, NoteKind::snapped, out);
  appendNotes(report, "Worth a look:", NoteKind::takenBack, NoteKind::hidden, out);
  appendShapeless(report, true, "Full squares, as asked", out);
  appendShapeless(report, false, "Without collision shapes", out);
  return out;
}

std::string shellWord(std::string_view argument) { return text::shellWord(argument); }

std::string message(const ImportError& error) {
  std::string out = error.file.empty() ? "the map" : error.file;
  if (error.line > 0) out += concat(":", error.line);
  out += concat(": ", error.element, error.element.empty() ? "" : " ", error.what);
  if (!error.option.empty()) out += " (Options::" + error.option + ")";
  return text::withoutControls(out);
}

}  // namespace lgs::tiled
