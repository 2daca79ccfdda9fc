// Small maps of the project's own drawing, by the conventions that makers of maps have, with what is meant to be solid.
#pragma once

#include "maps.h"

namespace lgs::tiled::meant {

/// A map of 8×4 tiles of 16 px, and its solid cells, as a picture: rows with "/" between them, "." for what is free.
struct MeantMap {
  const char* name;
  std::string content;
  std::string solid;
};

/// A tile layer. Letters are tiles of the tileset; "a" is its first.
inline std::string tiles(const std::string& name, const std::string& picture, const std::string& property = "",
                         const std::string& type = "") {
  std::string csv;
  for (const char c : picture) {
    if (c == '/') continue;
    csv += (csv.empty() ? "" : ",") + std::to_string(c == '.' ? 0 : c - 'a' + 1);
  }
  const std::string list = property.empty() ? "" : tiled::property(property, "true");
  return "<layer name='" + name + "' class='" + type + "' width='8' height='4'>" + list + "<data encoding='csv'>" +
         csv + "</data></layer>\n";
}

/// An object layer.
inline std::string objects(const std::string& name, const std::string& all, const std::string& property = "") {
  const std::string list = property.empty() ? "" : tiled::property(property, "true");
  return "<objectgroup name='" + name + "'>" + list + all + "</objectgroup>\n";
}

inline std::string at(double x, double y) {
  return "x='" + std::to_string(static_cast<int>(16 * x)) + "' y='" + std::to_string(static_cast<int>(16 * y)) + "'";
}

/// Objects, in tiles.
inline std::string box(double x, double y, double width, double height, const std::string& words = "") {
  return "<object id='1' " + words + " " + at(x, y) + " width='" + std::to_string(static_cast<int>(16 * width)) +
         "' height='" + std::to_string(static_cast<int>(16 * height)) + "'/>";
}
inline std::string spot(double x, double y, const std::string& words = "") {
  return "<object id='2' " + words + " " + at(x, y) + "><point/></object>";
}
inline std::string figure(double x, double y) {  // a tile object
  return "<object id='3' gid='5' " + at(x, y) + " width='16' height='16'/>";
}
inline std::string line(double x, double y, double width) {
  return "<object id='4' " + at(x, y) + "><polyline points='0,0 " + std::to_string(static_cast<int>(16 * width)) +
         ",0'/></object>";
}

/// What is in a tile.
inline std::string tile(char letter, const std::string& content, const std::string& type = "") {
  return "<tile id='" + std::to_string(letter - 'a') + "' class='" + type + "'>" + content + "</tile>";
}
inline const std::string kShape = "<objectgroup><object id='1' width='16' height='16'/></objectgroup>";

/// A map with a tileset in which these tiles are more than pictures.
inline std::string mapOf(const std::string& tilesetContent, const std::string& layers) {
  return "<tileset firstgid='1' name='set' tilewidth='16' tileheight='16'>" + tilesetContent + "</tileset>\n" + layers;
}

/// All of them.
std::vector<MeantMap> meantMaps();

}  // namespace lgs::tiled::meant
