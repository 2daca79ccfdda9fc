#include "ldtk.h"

#include "layers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace lgs::tiled {
namespace {

constexpr std::uint64_t kSetSize = 1 << 20;  // how many tile numbers each tileset of the document has
constexpr std::uint64_t kMaxSets = 0x7F;     // of IntGrid layers, and as many of drawn ones; above are flags
constexpr std::size_t kMaxLayerName = 255;   // of an IntGrid layer

/// What a project says of its layers, entities or tilesets, for all levels, by the numbers that name them.
std::map<double, JsonPlace> definitions(const JsonPlace& root, const char* kind) {
  std::map<double, JsonPlace> result;
  for (const JsonPlace& one : root["defs"][kind].objects()) result.emplace(one["uid"].number(0), one);
  return result;
}

/// A tileset of the document: the values of an IntGrid layer, or the tiles that are drawn from one of the project's.
struct TileSet {
  std::uint64_t firstGid = 0;
  std::string layer;
  double grid = 0, tile = 0;                   // the sides of a cell and of a tile
  std::map<std::uint64_t, std::string> tiles;  // that are used or defined; the names of values
};
using TileSets = std::map<std::pair<double, double>, TileSet>;  // by the numbers of layer and tileset

class LdtkProject {
 public:
  LdtkProject(const JsonPlace& root, pugi::xml_node map) : root_(root), map_(map) {}

  void read() {
    const std::vector<JsonPlace> worlds = root_["worlds"].objects();
    if (worlds.empty() && root_["levels"].isMissing()) root_["levels"].fail("is missing");
    if (worlds.empty()) readWorld(root_, map_);
    for (const JsonPlace& world : worlds) {
      readWorld(world, worlds.size() == 1 ? map_ : placeGroup(map_, world, {}));
    }
    writeIntGrids();
    writeDrawn();
  }

 private:
  void readWorld(const JsonPlace& world, pugi::xml_node to) {
    const std::string layout = world.text("worldLayout");
    const bool inRow = layout == "LinearHorizontal", inColumn = layout == "LinearVertical";
    if (!layout.empty() && !inRow && !inColumn && layout != "Free" && layout != "GridVania") {
      return world["worldLayout"].fail("is " + layout + ", which is not known");
    }
    DoublePoint next, min{kInfinite, kInfinite}, max{-kInfinite, -kInfinite};
    std::set<double> depths;
    for (const JsonPlace& level : world["levels"].objects()) {
      if (root_.failed()) return;
      const std::optional<double> fallback = inRow || inColumn ? std::nullopt : std::optional(0.0);
      const DoublePoint size{level["pxWid"].number(fallback), level["pxHei"].number(fallback)};
      const DoublePoint at = fallback ? DoublePoint{level["worldX"].number(), level["worldY"].number()} : next;
      if (inRow) next.x += size.x;
      if (inColumn) next.y += size.y;
      min = {std::min(min.x, at.x), std::min(min.y, at.y)};
      max = {std::max(max.x, at.x + size.x), std::max(max.y, at.y + size.y)};
      depths.insert(level["worldDepth"].number(0));
      readLevel(level, at, to);
    }
    if (depths.size() > 1) setAttribute(to, kLdtkDepthsAttribute, "1");
    setNumbers(to, {{kLdtkWidthAttribute, std::max(0.0, max.x - min.x)},
                    {kLdtkHeightAttribute, std::max(0.0, max.y - min.y)}});
  }

  /// A level may have a file of its own.
  void readLevel(const JsonPlace& level, DoublePoint at, pugi::xml_node to) {
    const pugi::xml_node group = placeGroup(to, level, at);
    const std::string named = level.text("externalRelPath");
    if (!level["layerInstances"].isMissing() || named.empty()) return readLayers(level, group);
    const bool isLevel = named.ends_with(".ldtkl") || named.ends_with(".json");
    if (!isLevel || named.starts_with('/')) return level.fail("its file should be a .ldtkl in its project");
    const std::string path = pathBeside(root_.file->name(), named);
    const auto text = root_.file->reader()(path);
    if (!text) return level.fail("its file " + path + " cannot be read: " + text.error());
    const auto json = parseJson(*text, false);
    if (!json) {
      const std::string line = json.error().line > 0 ? concat(":", json.error().line) : "";
      return level.fail(concat("its file ", path, line, " ", json.error().what));
    }
    readLayers({&*json, concat(level.path, " (", path, ")"), level.file}, group);
  }

  /// LDtk lists the uppermost layer first, Tiled the lowest.
  void readLayers(const JsonPlace& level, pugi::xml_node to) {
    if (level["layerInstances"].isMissing()) return level["layerInstances"].fail("is missing");
    const std::vector<JsonPlace> layers = level["layerInstances"].objects();
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
      const std::string type = layer->text("__type");
      if (type == "IntGrid") {
        readIntGrid(*layer, to);
      } else if (type == "Entities") {
        readEntities(*layer, to);
      } else if (type == "Tiles" || type == "AutoLayer") {
        readDrawn(*layer, addLayer(to, "layer", *layer));
      } else {
        (*layer)["__type"].fail("should be IntGrid, Entities, Tiles or AutoLayer");
      }
    }
  }

  void readIntGrid(const JsonPlace& layer, pugi::xml_node to) {
    const JsonPlace csv = layer["intGridCsv"];
    if (!csv.value->is_array()) {
      return csv.fail("is missing: the project is of LDtk " + root_.text("jsonVersion") +
                      ", and should be saved with LDtk 1.0 or later");
    }
    TileSet* const set = setOf(intGrids_, 0, layer, 0);
    if (!set) return layer.fail(concat("is one IntGrid layer too many: there may be ", kMaxSets));
    if (set->layer.size() > kMaxLayerName)  // the names of its values may have it, each one anew
      return layer["__identifier"].fail(concat("should have at most ", kMaxLayerName, " bytes"));
    const double side = layer["__gridSize"].number();
    if (!(side >= 1 && side <= kMaxCellPixels && side == std::floor(side)))
      return layer["__gridSize"].fail(concat("should be a whole number from 1 to ", kMaxCellPixels));
    const pugi::xml_node node = addLayer(to, "layer", layer);
    setNumbers(node, {{kLdtkGridAttribute, side}, {"width", layer["__cWid"].number()}});
    setNumbers(node, {{"height", layer["__cHei"].number()}});
    const pugi::xml_node data = addElement(node, "data", csv);
    setAttribute(data, "encoding", "csv");
    std::string list;
    std::uint64_t last = 0;
    for (const Json& value : *csv.value) {
      if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= kSetSize) {
        return csv.fail(concat("should hold whole numbers from 0 to ", kSetSize - 1));
      }
      const auto number = value.get<std::uint64_t>();
      if (number != last && number != 0) set->tiles.try_emplace(number);
      last = number;
      list += concat(list.empty() ? "" : ",", number == 0 ? 0 : set->firstGid + number);
    }
    data.text() = list.c_str();
  }

  /// The tileset of a layer; null if there are too many.
  static TileSet* setOf(TileSets& sets, std::uint64_t before, const JsonPlace& layer, double tileset) {
    const double side = layer["__gridSize"].number(0);
    const auto [at, isNew] = sets.try_emplace({layer["layerDefUid"].number(0), tileset});
    if (isNew) at->second = {(before + sets.size()) * kSetSize, layer.text("__identifier"), side, side, {}};
    if (sets.size() <= kMaxSets) return &at->second;
    sets.erase(at);
    return nullptr;
  }

  /// A layer of tiles. Theirs may be of another size than its cells: the upper left corners coincide.
  void readDrawn(const JsonPlace& layer, pugi::xml_node to) {
    const double side = layer["__gridSize"].number(0), tileset = layer["__tilesetDefUid"].number(0);
    setAttribute(to, kDrawnAttribute, "1");
    setNumbers(to,
               {{kLdtkGridAttribute, side}, {"width", 0}, {"height", 0}});  // each tile is a chunk: some share a cell
    const pugi::xml_node data = addElement(to, "data", layer);
    setAttribute(data, "encoding", "csv");
    TileSet* const set = setOf(drawn_, kMaxSets, layer, tileset);
    if (!set) return setAttribute(to, kRemarkAttribute, "one layer of tiles too many: they are left out");
    set->tile = in(tilesets_, tileset)["tileGridSize"].number(side);
    std::set<std::tuple<double, double, double>> known;
    std::uint64_t astray = 0;
    for (const char* list : {"gridTiles", "autoLayerTiles"}) {
      for (const JsonPlace& tile : layer[list].objects()) {
        const DoublePoint at = pair(tile["px"]);
        const double id = tile["t"].number(), column = at.x / side, row = at.y / side;
        if (!(id >= 0 && id < kSetSize && id == std::floor(id)))
          return tile["t"].fail(concat("should be a whole number from 0 to ", kSetSize - 1));
        if (column != std::floor(column) || row != std::floor(row)) {
          ++astray;
        } else if (known.insert({column, row, id}).second) {
          const auto number = static_cast<std::uint64_t>(id);
          set->tiles.try_emplace(number);
          const pugi::xml_node chunk = addElement(data, "chunk", tile);
          setNumbers(chunk, {{"x", column}, {"y", row}, {"width", 1}, {"height", 1}});
          chunk.text() = std::to_string(set->firstGid + number).c_str();
        }
      }
    }
    if (astray > 0) setAttribute(to, kRemarkAttribute, concat(astray, " tiles beside the grid are left out"));
  }

  /// The entities of one kind are an object layer, so that they can be chosen by their name.
  void readEntities(const JsonPlace& layer, pugi::xml_node to) {
    const pugi::xml_node group = addElement(to, "group", layer);
    setAttribute(group, "name", layer.text("__identifier"));
    std::map<std::string, pugi::xml_node> byKind;
    std::uint64_t count = 0;
    for (const JsonPlace& entity : layer["entityInstances"].objects()) {
      const std::string kind = entity.text("__identifier");
      pugi::xml_node& list = byKind[kind];
      if (!list) {
        list = addLayer(group, "objectgroup", layer);
        list.attribute("name") = kind.c_str();
        setAttribute(list, "class", layer.text("__identifier"));
        setAttribute(list, kThingsAttribute, "1");
        for (const JsonPlace& tag : entity["__tags"].elements()) {
          if (tag.value->is_string()) addProperty(list, tag.value->get_ref<const std::string&>(), true);
        }
      }
      const pugi::xml_node object = addElement(list, "object", entity);
      setAttribute(object, "id", std::to_string(++count));
      readEntity(entity, object);
    }
  }

  void readEntity(const JsonPlace& entity, pugi::xml_node to) const {
    const DoublePoint at = pair(entity["px"]), size{entity["width"].number(), entity["height"].number()};
    const DoublePoint pivot = entity["__pivot"].isMissing() ? DoublePoint{} : pair(entity["__pivot"]);
    setAttribute(to, "type", entity.text("__identifier"));
    setNumbers(to,
               {{"x", at.x - pivot.x * size.x}, {"y", at.y - pivot.y * size.y}, {"width", size.x}, {"height", size.y}});
    if (in(entities_, entity["defUid"].number(0)).text("renderMode") == "Ellipse") to.append_child("ellipse");
    for (const JsonPlace& field : entity["fieldInstances"].objects()) {
      addProperty(to, field.text("__identifier"), *field["__value"].value);
    }
  }

  pugi::xml_node writeTileset(const TileSet& set) {
    pugi::xml_node node = map_.append_child("tileset");
    setAttribute(node, "name", set.layer);
    setAttribute(node, "firstgid", std::to_string(set.firstGid));
    setNumbers(node, {{"tilewidth", set.tile}, {"tileheight", set.tile}});
    setNumbers(node.append_child("tileoffset"), {{"y", set.tile - set.grid}});
    return node;
  }

  static pugi::xml_node writeTile(pugi::xml_node tileset, std::uint64_t id, const std::string& className) {
    const pugi::xml_node tile = tileset.append_child("tile");
    setAttribute(tile, "id", std::to_string(id));
    setAttribute(tile, "class", className);
    return tile;
  }

  void writeIntGrids() {
    for (auto& [key, set] : intGrids_) {
      for (const JsonPlace& value : in(layers_, key.first)["intGridValues"].objects()) {
        const double number = value["value"].number(0);
        if (!(number >= 1 && number < kSetSize)) continue;
        std::string& name = set.tiles[static_cast<std::uint64_t>(number)];
        if (name.empty()) name = value.text("identifier");
      }
      const pugi::xml_node node = writeTileset(set);
      for (const auto& [value, identifier] : set.tiles) {
        pugi::xml_node tile = writeTile(node, value, nameOf(set.layer, value, identifier));
        setNumbers(tile.append_child("objectgroup").append_child("object"),
                   {{"width", set.grid}, {"height", set.grid}});
      }
    }
  }

  /// The class of all tiles is their layer. A tile has its tags as properties.
  void writeDrawn() {
    for (const auto& [key, set] : drawn_) {
      std::string name = set.layer;
      while (valueOf_.contains(name)) name.insert(0, set.layer + ".");
      const pugi::xml_node node = writeTileset(set);
      setAttribute(node, kDrawnAttribute, name);
      std::map<double, pugi::xml_node> tiles;
      for (const auto& [id, none] : set.tiles) tiles[static_cast<double>(id)] = writeTile(node, id, name);
      for (const JsonPlace& tag : in(tilesets_, key.second)["enumTags"].objects()) {
        for (const JsonPlace& id : tag["tileIds"].elements()) {
          const auto tile = tiles.find(id.number());
          if (tile != tiles.end()) addProperty(tile->second, tag.text("enumValueId"), true);
        }
      }
    }
  }

  /// The name of a value, or its number. If another value has that name, the layer's name stands before it; if that is
  /// taken, too, the number behind it.
  std::string nameOf(const std::string& layer, std::uint64_t value, const std::string& identifier) {
    const std::string number = std::to_string(value);
    const auto isTaken = [&](const std::string& name) {
      return valueOf_.try_emplace(name, value).first->second != value;
    };
    std::string name = identifier.empty() ? number : identifier;
    if (isTaken(name)) name.insert(0, layer + ".");
    while (isTaken(name)) name += "." + number;
    return name;
  }

  /// A definition; null if there is none.
  JsonPlace in(const std::map<double, JsonPlace>& all, double number) const {
    const auto found = all.find(number);
    return found == all.end() ? root_[""] : found->second;
  }

  DoublePoint pair(const JsonPlace& at) const {
    const std::vector<JsonPlace> both = at.elements();
    if (both.size() == 2) return {both[0].number(), both[1].number()};
    at.fail("should be two numbers");
    return {};
  }

  /// A group that is no more than a place for what is in it.
  pugi::xml_node placeGroup(pugi::xml_node parent, const JsonPlace& from, DoublePoint offset) const {
    const pugi::xml_node group = addElement(parent, "group", from);
    setAttribute(group, "name", from.text("identifier"));
    setAttribute(group, kPlaceAttribute, "1");
    setNumbers(group, {{"offsetx", offset.x}, {"offsety", offset.y}});
    return group;
  }

  pugi::xml_node addLayer(pugi::xml_node parent, const char* kind, const JsonPlace& from) const {
    const pugi::xml_node node = addElement(parent, kind, from);
    setAttribute(node, "name", from.text("__identifier"));
    setNumbers(node,
               {{"offsetx", from["__pxTotalOffsetX"].number(0)}, {"offsety", from["__pxTotalOffsetY"].number(0)}});
    if (!from["visible"].isMissing()) setAttribute(node, "visible", from.is("visible") ? "1" : "0");
    const JsonPlace definition = in(layers_, from["layerDefUid"].number(0));
    setNumbers(node, {{"parallaxx", 1 - definition["parallaxFactorX"].number(0)},
                      {"parallaxy", 1 - definition["parallaxFactorY"].number(0)}});
    return node;
  }

  const JsonPlace& root_;
  pugi::xml_node map_;
  TileSets intGrids_, drawn_;
  const std::map<double, JsonPlace> layers_ = definitions(root_, "layers"), entities_ = definitions(root_, "entities"),
                                    tilesets_ = definitions(root_, "tilesets");
  std::map<std::string, std::uint64_t> valueOf_;  // by name
};

}  // namespace

bool isLdtkProject(const JsonPlace& root) {
  const bool hasLevels = !root["levels"].isMissing() || !root["worlds"].isMissing();
  return hasLevels && (root["__header__"].text("app") == "LDtk" || !root["jsonVersion"].isMissing());
}

void readLdtk(const JsonPlace& root, pugi::xml_document& document) {
  const pugi::xml_node map = addElement(document.root(), "map", root);
  setAttribute(map, kLdtkAttribute, root.text("jsonVersion"));
  setNumbers(map, {{kLdtkGridAttribute, root["defaultGridSize"].number(16)}});
  LdtkProject(root, map).read();
}

}  // namespace lgs::tiled
