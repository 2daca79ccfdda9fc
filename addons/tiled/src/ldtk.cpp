#include "ldtk.h"

#include "layers.h"

#include <algorithm>
#include <set>

namespace lgs::tiled {
namespace {

constexpr std::size_t kMaxLayerName = 255;  ///< of an IntGrid layer

/// What the project says of an IntGrid layer, for all levels.
struct IntGrid {
  std::uint64_t firstGid = 0;
  std::string name;
  double grid = 0;
  std::map<std::uint64_t, std::string> values;  // the names of those that are used or defined
};

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
    drawn_.writeTilesets(map_, valueOf_);
    if (worlds.size() > 1) setAttribute(map_, kLdtkWorldsAttribute, "1");
  }

 private:
  void readWorld(const JsonPlace& world, pugi::xml_node to);
  void readLevel(const JsonPlace& level, DoublePoint at, pugi::xml_node to);
  void readLayers(const JsonPlace& level, pugi::xml_node to);
  void readIntGrid(const JsonPlace& layer, pugi::xml_node to);
  void readEntities(const JsonPlace& layer, pugi::xml_node to);
  void readEntity(const JsonPlace& entity, pugi::xml_node to) const;
  void writeIntGrids();
  std::string nameOf(const IntGrid& grid, std::uint64_t value, const std::string& identifier);
  IntGrid* intGridOf(const JsonPlace& layer);
  DoublePoint pair(const JsonPlace& at) const;
  pugi::xml_node placeGroup(pugi::xml_node parent, const JsonPlace& from, DoublePoint offset) const;
  pugi::xml_node addLayer(pugi::xml_node parent, const char* kind, const JsonPlace& from) const;

  const JsonPlace& root_;
  pugi::xml_node map_;
  std::map<double, IntGrid> intGrids_;  // by the number of their definition
  const Definitions layers_{root_, "layers"}, entities_{root_, "entities"};
  std::map<std::string, std::uint64_t> valueOf_;  // by name
  DrawnLayers drawn_{root_};
};

void LdtkProject::readWorld(const JsonPlace& world, pugi::xml_node to) {
  const std::string layout = world.text("worldLayout");
  const bool inRow = layout == "LinearHorizontal", inColumn = layout == "LinearVertical";
  if (!layout.empty() && !inRow && !inColumn && layout != "Free" && layout != "GridVania") {
    return world["worldLayout"].fail("is " + layout + ", which is not known");
  }
  DoublePoint next, min, max;
  std::set<double> depths;
  for (const JsonPlace& level : world["levels"].objects()) {
    if (root_.failed()) return;
    const bool linear = inRow || inColumn;
    const std::optional<double> fallback = linear ? std::nullopt : std::optional(0.0);
    const DoublePoint size{level["pxWid"].number(fallback), level["pxHei"].number(fallback)};
    const DoublePoint at = linear ? next : DoublePoint{level["worldX"].number(), level["worldY"].number()};
    if (inRow) next.x += size.x;
    if (inColumn) next.y += size.y;
    min = depths.empty() ? at : DoublePoint{std::min(min.x, at.x), std::min(min.y, at.y)};
    const DoublePoint end{at.x + size.x, at.y + size.y};
    max = depths.empty() ? end : DoublePoint{std::max(max.x, end.x), std::max(max.y, end.y)};
    depths.insert(level["worldDepth"].number(0));
    readLevel(level, at, to);
  }
  if (depths.size() > 1) setAttribute(to, kLdtkDepthsAttribute, "1");
  setNumbers(
      to, {{kLdtkWidthAttribute, std::max(0.0, max.x - min.x)}, {kLdtkHeightAttribute, std::max(0.0, max.y - min.y)}});
}

/// A level may have a file of its own.
void LdtkProject::readLevel(const JsonPlace& level, DoublePoint at, pugi::xml_node to) {
  const pugi::xml_node group = placeGroup(to, level, at);
  const std::string named = level.text("externalRelPath");
  if (!level["layerInstances"].isMissing() || named.empty()) return readLayers(level, group);
  const bool isLevel = named.ends_with(".ldtkl") || named.ends_with(".json");
  if (!isLevel || named.starts_with('/')) return level.fail("its file should be a .ldtkl in its project");
  const std::string path = pathBeside(root_.file->name, named);
  const auto text = root_.file->reader(path);
  if (!text) return level.fail("its file " + path + " cannot be read: " + text.error());
  const auto json = parseJson(*text, false);
  if (!json) {
    const std::string line = json.error().line > 0 ? concat(":", json.error().line) : "";
    return level.fail(concat("its file ", path, line, " ", json.error().what));
  }
  readLayers({&*json, concat(level.path, " (", path, ")"), level.file}, group);
}

/// LDtk lists the uppermost layer first, Tiled the lowest.
void LdtkProject::readLayers(const JsonPlace& level, pugi::xml_node to) {
  if (level["layerInstances"].isMissing()) return level["layerInstances"].fail("is missing");
  const std::vector<JsonPlace> layers = level["layerInstances"].objects();
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    const std::string type = layer->text("__type");
    if (type == "IntGrid") {
      readIntGrid(*layer, to);
    } else if (type == "Entities") {
      readEntities(*layer, to);
    } else if (type == "Tiles" || type == "AutoLayer") {
      drawn_.read(*layer, addLayer(to, "layer", *layer));
    } else {
      (*layer)["__type"].fail("should be IntGrid, Entities, Tiles or AutoLayer");
    }
  }
}

void LdtkProject::readIntGrid(const JsonPlace& layer, pugi::xml_node to) {
  const JsonPlace csv = layer["intGridCsv"];
  if (!csv.value->is_array()) {
    return csv.fail("is missing: the project is of LDtk " + root_.text("jsonVersion") +
                    ", and should be saved with LDtk 1.0 or later");
  }
  IntGrid* const grid = intGridOf(layer);
  if (!grid) return;
  const pugi::xml_node node = addLayer(to, "layer", layer);
  for (const auto& [name, key] :
       {std::pair(kLdtkGridAttribute, "__gridSize"), std::pair("width", "__cWid"), std::pair("height", "__cHei")})
    setNumbers(node, {{name, layer[key].number()}});
  const pugi::xml_node data = addElement(node, "data", csv);
  setAttribute(data, "encoding", "csv");
  std::string list;
  std::uint64_t last = 0;
  for (const Json& value : *csv.value) {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= kLdtkSetSize) {
      return csv.fail(concat("should hold whole numbers from 0 to ", kLdtkSetSize - 1));
    }
    const auto number = value.get<std::uint64_t>();
    if (number != last && number != 0) grid->values.try_emplace(number, "");
    last = number;
    list += concat(list.empty() ? "" : ",", number == 0 ? 0 : grid->firstGid + number);
  }
  data.text() = list.c_str();
}

IntGrid* LdtkProject::intGridOf(const JsonPlace& layer) {
  const double uid = layer["layerDefUid"].number();
  const auto [at, isNew] = intGrids_.try_emplace(uid);
  IntGrid& grid = at->second;
  if (!isNew) return &grid;
  if (intGrids_.size() > kMaxLdtkSets) {
    layer.fail(concat("is one IntGrid layer too many: there may be ", kMaxLdtkSets));
    return nullptr;
  }
  grid.firstGid = intGrids_.size() * kLdtkSetSize;
  grid.name = layer.text("__identifier");
  if (grid.name.size() > kMaxLayerName) {  // the names of its values may have it, each one anew
    layer["__identifier"].fail(concat("should have at most ", kMaxLayerName, " bytes"));
    return nullptr;
  }
  grid.grid = layer["__gridSize"].number();
  for (const JsonPlace& value : layers_[uid]["intGridValues"].objects()) {
    const double number = value["value"].number(0);
    if (number >= 1 && number < kLdtkSetSize)
      grid.values.emplace(static_cast<std::uint64_t>(number), value.text("identifier"));
  }
  return &grid;
}

/// The entities of one kind are an object layer, so that they can be chosen by their name.
void LdtkProject::readEntities(const JsonPlace& layer, pugi::xml_node to) {
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

void LdtkProject::readEntity(const JsonPlace& entity, pugi::xml_node to) const {
  const DoublePoint at = pair(entity["px"]), size{entity["width"].number(), entity["height"].number()};
  const DoublePoint pivot = entity["__pivot"].isMissing() ? DoublePoint{} : pair(entity["__pivot"]);
  setAttribute(to, "type", entity.text("__identifier"));
  setNumbers(to, {{"x", at.x - pivot.x * size.x}, {"y", at.y - pivot.y * size.y}});
  setNumbers(to, {{"width", size.x}, {"height", size.y}});
  if (entities_[entity["defUid"].number(0)].text("renderMode") == "Ellipse") to.append_child("ellipse");
  for (const JsonPlace& field : entity["fieldInstances"].objects()) {
    addProperty(to, field.text("__identifier"), *field["__value"].value);
  }
}

void LdtkProject::writeIntGrids() {
  for (auto& [uid, grid] : intGrids_) {
    pugi::xml_node set = addTileset(map_, grid.name, grid.firstGid, grid.grid);
    for (auto& [value, identifier] : grid.values) {
      pugi::xml_node tile = set.append_child("tile");
      setAttribute(tile, "id", std::to_string(value));
      setAttribute(tile, "class", nameOf(grid, value, identifier));
      pugi::xml_node square = tile.append_child("objectgroup").append_child("object");
      setNumbers(square, {{"width", grid.grid}, {"height", grid.grid}});
    }
  }
}

/// The name of a value, or its number. If another value has that name, the layer's name stands before it; if that is
/// taken, too, the number behind it.
std::string LdtkProject::nameOf(const IntGrid& grid, std::uint64_t value, const std::string& identifier) {
  const std::string number = std::to_string(value);
  const auto isTaken = [&](const std::string& name) {
    return valueOf_.try_emplace(name, value).first->second != value;
  };
  std::string name = identifier.empty() ? number : identifier;
  if (isTaken(name)) name.insert(0, grid.name + ".");
  while (isTaken(name)) name += "." + number;
  return name;
}

DoublePoint LdtkProject::pair(const JsonPlace& at) const {
  const std::vector<JsonPlace> both = at.elements();
  if (both.size() == 2) return {both[0].number(), both[1].number()};
  at.fail("should be two numbers");
  return {};
}

/// A group that is no more than a place for what is in it.
pugi::xml_node LdtkProject::placeGroup(pugi::xml_node parent, const JsonPlace& from, DoublePoint offset) const {
  const pugi::xml_node group = addElement(parent, "group", from);
  setAttribute(group, "name", from.text("identifier"));
  setAttribute(group, kPlaceAttribute, "1");
  setNumbers(group, {{"offsetx", offset.x}, {"offsety", offset.y}});
  return group;
}

pugi::xml_node LdtkProject::addLayer(pugi::xml_node parent, const char* kind, const JsonPlace& from) const {
  const pugi::xml_node node = addElement(parent, kind, from);
  setAttribute(node, "name", from.text("__identifier"));
  setNumbers(node, {{"offsetx", from["__pxTotalOffsetX"].number(0)}, {"offsety", from["__pxTotalOffsetY"].number(0)}});
  if (!from["visible"].isMissing()) setAttribute(node, "visible", from.is("visible") ? "1" : "0");
  const JsonPlace& definition = layers_[from["layerDefUid"].number(0)];
  setNumbers(node, {{"parallaxx", 1 - definition["parallaxFactorX"].number(0)},
                    {"parallaxy", 1 - definition["parallaxFactorY"].number(0)}});
  return node;
}

}  // namespace

pugi::xml_node addTileset(pugi::xml_node map, const std::string& name, std::uint64_t firstGid, double side) {
  const pugi::xml_node set = map.append_child("tileset");
  setAttribute(set, "name", name);
  setAttribute(set, "firstgid", std::to_string(firstGid));
  setNumbers(set, {{"tilewidth", side}, {"tileheight", side}});
  return set;
}

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
