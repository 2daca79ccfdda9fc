// Maps for the tests of what is taken by itself and what is offered.
#pragma once

#include "meant_maps.h"

namespace lgs::tiled {

inline const std::string kFull = "bbbbbbbb/bbbbbbbb/bbbbbbbb/bbbbbbbb", kHills = "......../..aa..../aaaa..aa/aaaaaaaa";
inline const std::string kRim = "aaaaaaaa/a......a/a......a/aaaaaaaa",
                         kPlatforms = "......../.aaa..../....aaa./........";

inline std::string textOf(const std::string& layers, const std::string& tileset = "") {
  return "<map orientation='orthogonal' width='8' height='4' tilewidth='16' tileheight='16'>" +
         meant::mapOf(tileset, layers) + "</map>";
}

inline ImportedMap import(const std::string& layers, const Options& options = {}, const std::string& tileset = "") {
  return mustImportFiles({{"maps/test.tmx", textOf(layers, tileset)}}, options);
}

/// "--layer A --solid" of each offer.
inline std::vector<std::string> offersOf(const ImportedMap& map) {
  std::vector<std::string> result;
  for (const Suggestion& suggestion : map.report.suggestions) {
    std::string words;
    for (const std::string& argument : suggestion.arguments) words += (words.empty() ? "" : " ") + argument;
    result.push_back(words);
  }
  return result;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace lgs::tiled
