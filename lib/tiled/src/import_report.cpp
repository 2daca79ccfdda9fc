// The report and the error as text.
#include <lgs/tiled/import.h>

#include <algorithm>

namespace lgs::tiled {
namespace {

std::string counted(std::uint64_t n, const char* one, const char* many) {
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

std::string where(const Note& note) {
  if (note.places == 0) return {};
  return " (" + counted(note.places, "place", "places") + ", first in cell " + std::to_string(note.cell.i) + ", " +
         std::to_string(note.cell.j) + ")";
}

void appendHead(const Report& report, std::string& out) {
  out += report.file + ": " + std::to_string(report.width) + "×" + std::to_string(report.height) + " tiles of " +
         std::to_string(report.tileWidth) + "×" + std::to_string(report.tileHeight) + " px" +
         (report.infinite ? ", infinite" : "") + "\n";
  out += "  " + counted(report.polygons, "polygon", "polygons") + " (" + std::to_string(report.shapes) +
         " distinct) in " + counted(report.cells, "cell", "cells") + "\n";
  std::size_t width = 0;
  for (const LayerReport& layer : report.layers) width = std::max(width, columns(layer.path));
  for (const LayerReport& layer : report.layers) {
    out += "  layer " + padded(layer.path, width) + "  ";
    if (layer.imported) out += counted(layer.tiles, "tile", "tiles");
    if (!layer.imported) out += "passed over: ";
    if (layer.imported && !layer.note.empty()) out += "; ";
    out += layer.note + "\n";
  }
  width = 0;
  for (const BlockReport& block : report.blocks) width = std::max(width, std::to_string(block.block).size());
  for (const BlockReport& block : report.blocks) {
    out +=
        "  block " + padded(std::to_string(block.block), width) + "  " + counted(block.polygons, "polygon", "polygons");
    out += (block.name.empty() ? "" : "  " + block.name) + "\n";
  }
  for (const std::string& note : report.notes) out += "  note: " + note + "\n";
}

template <class Wanted>
void appendNotes(const Report& report, const char* title, Wanted&& wanted, std::string& out) {
  bool titled = false;
  for (const TileReport& tile : report.tiles) {
    bool named = false;
    for (const Note& note : tile.notes) {
      if (!wanted(note.kind)) continue;
      if (!titled) out += std::string("\n") + title + "\n";
      if (!named) {
        out += "  " + tileName(tile) + (tile.className.empty() ? "" : " '" + tile.className + "'") + ", " +
               counted(tile.uses, "use", "uses") + "\n";
      }
      titled = named = true;
      out += "    object " + std::to_string(note.object) + ": " + note.text + where(note) + "\n";
    }
  }
}

void appendShapeless(const Report& report, std::string& out) {
  std::vector<const TileReport*> shapeless;
  std::uint64_t uses = 0;
  for (const TileReport& tile : report.tiles) {
    if (tile.hasShapes) continue;
    shapeless.push_back(&tile);
    uses += tile.uses;
  }
  if (shapeless.empty()) return;
  constexpr std::size_t kMostNamed = 12;
  out += "\nWithout collision shapes: " + counted(shapeless.size(), "tile", "tiles") + ", " +
         counted(uses, "use", "uses") + "\n ";
  for (std::size_t i = 0; i < std::min(kMostNamed, shapeless.size()); ++i) {
    out += (i == 0 ? " " : ", ") + tileName(*shapeless[i]);
  }
  if (shapeless.size() > kMostNamed) out += " and " + std::to_string(shapeless.size() - kMostNamed) + " more";
  out += "\n";
}

}  // namespace

std::string toText(const Report& report) {
  std::string out;
  appendHead(report, out);
  const auto missing = [](NoteKind kind) { return kind == NoteKind::leftOut || kind == NoteKind::clipped; };
  appendNotes(report, "Left out or cut off:", missing, out);
  appendNotes(
      report, "Changed on the way in:", [&](NoteKind kind) { return !missing(kind) && kind != NoteKind::nearMiss; },
      out);
  appendNotes(
      report, "Worth a look:", [](NoteKind kind) { return kind == NoteKind::nearMiss; }, out);
  appendShapeless(report, out);
  return out;
}

std::string message(const ImportError& error) {
  std::string out = error.file.empty() ? "the map" : error.file;
  if (error.line > 0) out += ":" + std::to_string(error.line);
  out += ": ";
  if (!error.element.empty()) out += error.element + " ";
  return out + error.what;
}

}  // namespace lgs::tiled
