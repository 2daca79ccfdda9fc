#include "json.h"

#include <array>

namespace lgs::tiled {
namespace {

struct Known {
  Sign kind;
  std::string_view sign;
  std::string_view what;
};

constexpr std::array kKnown{
    Known{Sign::text, "[gd_scene", "a Godot scene"},
    Known{Sign::text, "[gd_resource", "a Godot resource"},
    Known{Sign::text, "\x89PNG", "a PNG image, and no map"},
    Known{Sign::text, "\xFF\xD8\xFF", "a JPEG image, and no map"},
    Known{Sign::text, "GIF8", "a GIF image, and no map"},
    Known{Sign::text, "RIFF", "an image or a sound, and no map"},
    Known{Sign::text, "PK\x03\x04", "a ZIP archive: unpack it"},
    Known{Sign::text, "\x1F\x8B", "packed by gzip: unpack it"},
    Known{Sign::text, "%YAML", "a file of Unity or another program that writes YAML"},
    Known{Sign::text, "version https://git-lfs", "a pointer of Git LFS: fetch the file itself with 'git lfs pull'"},
    Known{Sign::text, "return {", "a Lua export: save the map as TMX or JSON"},
    Known{Sign::text, "(function(name,data)", "a JavaScript export: save the map as TMX or JSON"},
    Known{Sign::text, "lgs-trace", "a trace of lgs, and no map"},
    Known{Sign::text, "lgssnap", "a saved world of lgs, and no map"},
    Known{Sign::xml, "html", "a web page: download the file itself"},
    Known{Sign::xml, "svg", "an SVG image, and no map"},
    Known{Sign::xml, "ogmo", "an Ogmo project"},
    Known{Sign::xml, "OgmoProject", "an Ogmo project"},
    Known{Sign::xml, "level", "a level of Ogmo or another editor"},
    Known{Sign::xml, "objecttypes", "a list of Tiled's object types"},
    Known{Sign::json, "layerInstances", "one level of an LDtk project: import the project (.ldtk) that names it"},
    Known{Sign::json, "ogmoVersion", "an Ogmo project or level"},
    Known{Sign::json, "automappingRulesFile", "a Tiled project, which only lists folders: import its maps"},
    Known{Sign::json, "expandedProjectPaths", "a Tiled session: import a map"},
    Known{Sign::json, "frames", "an atlas of sprites, and no map"},
};

}  // namespace

std::string foreign(Sign kind, const std::function<bool(std::string_view sign)>& has) {
  for (const Known& one : kKnown)
    if (one.kind == kind && has(one.sign)) return isForeign(one.what);
  return {};
}

std::string isForeign(std::string_view what) {
  return concat("is ", what, ". What is read: maps of Tiled (TMX or JSON), worlds of Tiled and projects of LDtk");
}

}  // namespace lgs::tiled
