#include "foreign.h"

#include <array>

namespace lgs::tiled {
namespace {

struct Known {
  std::string_view sign;
  std::string_view what;
};

/// The row whose sign fits.
template <std::size_t n, class Fits>
std::string firstKnown(const std::array<Known, n>& table, Fits&& fits) {
  for (const Known& known : table) {
    if (fits(known.sign)) return std::string(known.what);
  }
  return {};
}

}  // namespace

std::string foreignText(std::string_view text) {
  using namespace std::string_view_literals;
  constexpr std::array kBeginnings{
      Known{"[gd_scene"sv, "a Godot scene"sv},
      Known{"[gd_resource"sv, "a Godot resource"sv},
      Known{"\x89PNG"sv, "a PNG image, and no map"sv},
      Known{"\xFF\xD8\xFF"sv, "a JPEG image, and no map"sv},
      Known{"GIF8"sv, "a GIF image, and no map"sv},
      Known{"RIFF"sv, "an image or a sound, and no map"sv},
      Known{"PK\x03\x04"sv, "a ZIP archive: unpack it"sv},
      Known{"\x1F\x8B"sv, "packed by gzip: unpack it"sv},
      Known{"%YAML"sv, "a file of Unity or another program that writes YAML"sv},
      Known{"version https://git-lfs"sv, "a pointer of Git LFS: fetch the file itself with 'git lfs pull'"sv},
      Known{"return {"sv, "a Lua export: save the map as TMX or JSON"sv},
      Known{"(function(name,data)"sv, "a JavaScript export: save the map as TMX or JSON"sv},
      Known{"lgs-trace"sv, "a trace of lgs, and no map"sv},
      Known{"lgssnap"sv, "a saved world of lgs, and no map"sv},
  };
  if (text.empty()) return "empty";
  return firstKnown(kBeginnings, [&](std::string_view sign) { return text.starts_with(sign); });
}

std::string foreignXml(std::string_view rootName) {
  constexpr std::array kRoots{
      Known{"html", "a web page: download the file itself"},
      Known{"svg", "an SVG image, and no map"},
      Known{"ogmo", "an Ogmo project"},
      Known{"OgmoProject", "an Ogmo project"},
      Known{"level", "a level of Ogmo or another editor"},
      Known{"objecttypes", "a list of Tiled's object types"},
  };
  return firstKnown(kRoots, [&](std::string_view sign) { return rootName == sign; });
}

std::string foreignJson(const Json& root) {
  constexpr std::array kKeys{
      Known{"layerInstances", "one level of an LDtk project: import the project (.ldtk) that names it"},
      Known{"ogmoVersion", "an Ogmo project or level"},
      Known{"automappingRulesFile", "a Tiled project, which only lists folders: import its maps"},
      Known{"expandedProjectPaths", "a Tiled session: import a map"},
      Known{"frames", "an atlas of sprites, and no map"},
  };
  return firstKnown(kKeys, [&](std::string_view sign) { return root.is_object() && root.contains(sign); });
}

std::string isForeign(const std::string& what) {
  return "is " + what + ". What is read: maps of Tiled (TMX or JSON), worlds of Tiled and projects of LDtk";
}

}  // namespace lgs::tiled
