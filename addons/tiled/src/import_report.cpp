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

/// Names come from files. What would end a line, or do something else to a terminal, becomes a blank.
void makePlain(std::string& name) { name = text::withoutControls(name); }

void makePlain(std::vector<Note>& notes) {
  for (Note& note : notes) makePlain(note.text);
}

Report withPlainNames(Report report) {
  for (std::string* text : {&report.file, &report.choice, &report.partial, &report.also, &report.leftOut})
    makePlain(*text);
  for (LayerReport& layer : report.layers) {
    makePlain(layer.path);
    makePlain(layer.note);
    makePlain(layer.notes);
  }
  for (BlockReport& block : report.blocks) makePlain(block.name);
  for (TileReport& tile : report.tiles) {
    makePlain(tile.tileset);
    makePlain(tile.className);
    makePlain(tile.notes);
  }
  for (std::string& note : report.notes) makePlain(note);
  for (Suggestion& suggestion : report.suggestions) makePlain(suggestion.text);
  return report;
}

std::string numbered(std::uint64_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// How many columns a text takes in a terminal. Bytes that continue a UTF-8 character take none.
std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(std::string text, std::size_t width) {
  if (const std::size_t taken = columns(text); taken < width) text.append(width - taken, ' ');
  return text;
}

std::string tileName(const TileReport& tile) { return tile.tileset + " #" + std::to_string(tile.id); }

/// Where a note holds; `layer` is empty if that is clear.
std::string where(const Note& note, const std::string& layer) {
  if (note.places == 0) return {};
  return " (" + numbered(note.places, "place", "places") + (layer.empty() ? "" : " in layer " + layer) +
         ", first in cell " + std::to_string(note.cell.i) + ", " + std::to_string(note.cell.j) + ")";
}

/// "set #4 'lava', 2 uses in layer Ground"
std::string heading(const TileReport& tile, const Report& report) {
  std::string text = tileName(tile) + (tile.className.empty() ? "" : " '" + tile.className + "'") + ", " +
                     numbered(tile.uses, "use", "uses");
  for (std::size_t k = 0; k < tile.layers.size(); ++k) {
    text += (k > 0                     ? ", "
             : tile.layers.size() == 1 ? " in layer "
                                       : " in layers ") +
            report.layers[tile.layers[k]].path;
  }
  return text;
}

/// "level.tmx: 184 polygons, 30 % of the map: tile layer Ground: its name says 'ground'; IN PART: …"
void appendSummary(const Report& report, const std::string& command, std::string& out) {
  out += report.file + ": ";
  if (report.polygons == 0) {
    out += "nothing in it is solid";
  } else {
    const double cells = report.infinite ? 0 : static_cast<double>(report.width) * report.height;
    out += numbered(report.polygons, "polygon", "polygons") + " (" + std::to_string(report.shapes) + " distinct)";
    if (cells > 0)
      out += ", " + std::to_string(std::lround(100 * static_cast<double>(report.cells) / cells)) + " % of the map";
  }
  if (!report.choice.empty()) out += ": " + report.choice;
  if (!report.partial.empty()) out += "; IN PART: " + report.partial;
  if (!report.also.empty()) out += "; also there: " + report.also;
  if (!report.leftOut.empty()) out += "; left out as deadly or passable: " + report.leftOut;
  out += "\n";
  for (const Suggestion& suggestion : report.suggestions) {
    out += "  or:" + (command.empty() ? "" : " " + command);
    for (const std::string& argument : suggestion.arguments) out += " " + shellWord(argument);
    out += "  (" + numbered(suggestion.polygons, "polygon", "polygons") + ": " + suggestion.text + ")\n";
  }
}

void appendHead(const Report& report, std::string& out) {
  out += "  " + std::to_string(report.width) + "×" + std::to_string(report.height) + " tiles of " +
         std::to_string(report.tileWidth) + "×" + std::to_string(report.tileHeight) + " px" +
         (report.infinite ? ", infinite" : "") + "; polygons in " + numbered(report.cells, "cell", "cells") + "\n";
  std::size_t width = 0;
  for (const LayerReport& layer : report.layers) width = std::max(width, columns(layer.path));
  for (const LayerReport& layer : report.layers) {
    out += "  layer " + padded(layer.path, width) + "  ";
    const bool ofObjects = layer.kind == LayerKind::objects;
    const std::string holds =
        ofObjects ? numbered(layer.objects, "object", "objects") : numbered(layer.tiles, "tile", "tiles");
    if (layer.imported) out += holds + (layer.note.empty() ? "" : "; ");
    if (!layer.imported) out += "passed over" + (ofObjects ? ", " + holds : "") + ": ";
    out += layer.note + "\n";
  }
  width = 0;
  for (const BlockReport& block : report.blocks) width = std::max(width, std::to_string(block.block).size());
  for (const BlockReport& block : report.blocks) {
    out += "  block " + padded(std::to_string(block.block), width) + "  " +
           numbered(block.polygons, "polygon", "polygons");
    out += (block.name.empty() ? "" : "  " + block.name) + "\n";
  }
  for (const std::string& note : report.notes) out += "  note: " + note + "\n";
}

/// The wanted notes. Objects of which the same is to be said share a line. `layerOf` names the layer of a note, or is
/// empty if that is clear.
template <class Wanted, class LayerOf>
std::string linesOf(const std::vector<Note>& notes, const Wanted& wanted, const LayerOf& layerOf) {
  std::vector<std::pair<std::string, std::vector<std::string>>> lines;
  std::map<std::string, std::size_t> places;
  for (const Note& note : notes) {
    if (!wanted(note.kind)) continue;
    const std::string text = note.text + where(note, layerOf(note));
    const auto [at, isNew] = places.try_emplace(text, lines.size());
    if (isNew) lines.push_back({text, {}});
    lines[at->second].second.push_back(std::to_string(note.object));
  }
  std::string out;
  for (const auto& [text, objects] : lines) {
    const bool isOne = objects.size() == 1;
    out += (isOne ? "    object " : "    objects ") + listed(objects, kMostNamed) + (isOne ? ": " : ", each: ") + text +
           "\n";
  }
  return out;
}

template <class Wanted>
void appendNotes(const Report& report, const std::string& title, const Wanted& wanted, std::string& out) {
  std::string all;
  const auto add = [&](const std::string& heading, const std::string& lines) {
    if (!lines.empty()) all += "  " + heading + "\n" + lines;
  };
  for (const LayerReport& layer : report.layers)
    add("layer " + layer.path, linesOf(layer.notes, wanted, [](const Note&) { return ""; }));
  for (const TileReport& tile : report.tiles) {
    const auto layerOf = [&](const Note& note) { return tile.layers.size() > 1 ? report.layers[note.layer].path : ""; };
    add(heading(tile, report), linesOf(tile.notes, wanted, layerOf));
  }
  if (!all.empty()) out += "\n" + title + "\n" + all;
}

void appendShapeless(const Report& report, bool solid, const std::string& title, std::string& out) {
  std::vector<std::string> shapeless;
  std::uint64_t uses = 0;
  for (const TileReport& tile : report.tiles) {
    if (tile.hasShapes || tile.isLeftOut || tile.isSolid != solid) continue;
    shapeless.push_back(tileName(tile));
    uses += tile.uses;
  }
  if (shapeless.empty()) return;
  out += "\n" + title + ": " + numbered(shapeless.size(), "tile", "tiles") + ", " + numbered(uses, "use", "uses") +
         "\n  " + listed(shapeless, kMostNamed) + "\n";
}

}  // namespace

std::string toText(const Report& report, const std::string& command) {
  const Report plain = withPlainNames(report);
  std::string out;
  appendSummary(plain, command, out);
  appendHead(plain, out);
  const auto missing = [](NoteKind kind) { return kind == NoteKind::leftOut || kind == NoteKind::clipped; };
  appendNotes(plain, "Left out or cut off:", missing, out);
  const auto unchanged = [](NoteKind kind) { return kind >= NoteKind::takenBack; };
  appendNotes(
      plain, "Changed on the way in:", [&](NoteKind kind) { return !missing(kind) && !unchanged(kind); }, out);
  appendNotes(plain, "Worth a look:", unchanged, out);
  appendShapeless(plain, true, "Full squares, as asked", out);
  appendShapeless(plain, false, "Without collision shapes", out);
  return out;
}

std::string shellWord(std::string_view argument) { return text::shellWord(argument); }

std::string message(const ImportError& error) {
  std::string out = error.file.empty() ? "the map" : error.file;
  if (error.line > 0) out += ":" + std::to_string(error.line);
  out += ": ";
  if (!error.element.empty()) out += error.element + " ";
  out += error.what;
  if (!error.option.empty()) out += " (Options::" + error.option + ")";
  makePlain(out);
  return out;
}

}  // namespace lgs::tiled
