// One import from its beginning to its end: the map's head, the layers tile by tile, then the carried parts, then the
// objects.
#include "import_one.h"

#include "block_numbers.h"
#include "map_objects.h"
#include "object_painter.h"
#include "placer.h"
#include "snapping_notes.h"
#include "tile_parts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace lgs::tiled {
namespace {

/// "left out, as asked: 34 uses of 'ladder'"; or nothing.
std::string leftOutAsAsked(const Report& report) {
  std::map<std::string, std::uint64_t> uses;
  for (const TileReport& tile : report.tiles) {
    if (tile.isLeftOut) uses[tile.className] += tile.uses;
  }
  std::string text;
  for (const auto& [name, count] : uses) {
    text += (text.empty() ? "left out, as asked: " : ", ") + std::to_string(count) + " uses of " + inQuotes(name);
  }
  return text;
}

class Import {
 public:
  Import(MapSource& source, ImportJob& job, std::optional<ImportError>& error)
      : options_(job.options),
        source_(source),
        names_(job.names),
        asked_(job.asked),
        error_(error),
        file_(*source.file),
        blocks_(options_),
        tilesLeft_(job.tilesLeft),
        placementsLeft_(job.placementsLeft),
        budget_(job.budget),
        placer_(budget_),
        objects_(source_, options_, budget_),
        painter_(budget_) {
    map_.report.file = file_.name();
  }

  tl::expected<ImportedMap, ImportError> run() {
    if (!failed()) readHead();
    if (!failed()) readLayers();
    for (const auto& [cell, entry] : carried_) {
      if (!failed()) place(cell, entry);
    }
    if (!failed()) placeObjects();
    if (failed()) return tl::unexpected(*error_);
    finishReport();
    return std::move(map_);
  }

 private:
  /// A part of a tile, ready to be placed in one layer.
  struct Placeable {
    Cell shift;
    Placer::EntryId entry;
  };
  struct CurrentLayer {
    std::uint32_t index = 0;
    std::int64_t columns = 0, rows = 0;  // the whole tiles of its offset
    DoublePoint rest;                    // the rest of the offset, pixels
    Properties properties;
    std::unordered_map<std::uint32_t, std::vector<Placeable>> ready;  // by tile number with flags
  };

  bool failed() const { return error_.has_value(); }
  void readHead();
  void readLayers();
  void readLayer(const Layer& layer, std::uint32_t index);
  void readObjects(const Layer& layer, std::uint32_t index);
  void placeObjects();
  bool spend(std::size_t placements);
  void place(Cell cell, Placer::EntryId entry);
  void checkBudget(pugi::xml_node node);
  void placeTile(CurrentLayer& layer, std::int64_t column, std::int64_t row, std::uint32_t gid);
  std::vector<Placeable> placeables(const CurrentLayer& layer, std::uint32_t gid);
  const TileParts& partsOf(const Tileset& tileset, std::uint32_t gid, const CurrentLayer& layer, TileReport& report);
  Block blockOf(const std::string& className, std::uint32_t layer);
  std::uint32_t reportOf(const Tileset& tileset, std::uint32_t number);
  void finishReport();

  const Options& options_;
  MapSource& source_;
  LayerNames& names_;
  AskedNames& asked_;
  std::optional<ImportError>& error_;
  const XmlFile& file_;
  BlockNumbers blocks_;
  std::size_t& tilesLeft_;
  std::size_t& placementsLeft_;
  Budget& budget_;
  PixelGrid grid_;
  std::map<std::tuple<std::uint32_t, double, double, bool>, TileParts> parts_;  // by gid, offset, full square or not
  std::unordered_map<std::uint32_t, std::uint32_t> reportIndex_;                // by tile number
  std::vector<std::pair<Cell, Placer::EntryId>> carried_;
  std::uint64_t strayTiles_ = 0;  // of no tileset
  Placer placer_;
  MapObjects objects_;
  ObjectPainter painter_;
  std::vector<Layer> layers_;
  ImportedMap map_;
};

void Import::readHead() {
  constexpr std::int64_t kMaxSide = 1 << 28, kMaxPixels = 1 << 16;
  const auto root = file_.root();
  if (!(options_.tolerance >= 0 && std::isfinite(options_.tolerance))) {
    return file_.fail({}, "the tolerance should be 0 or more", "tolerance");
  }
  if (!(options_.polylineThickness >= 0 && std::isfinite(options_.polylineThickness))) {
    return file_.fail({}, "the thickness of polylines should be 0 or more", "polylineThickness");
  }
  Report& report = map_.report;
  report.width = static_cast<int>(file_.integer(root, "width", 0, 0, kMaxSide));
  report.height = static_cast<int>(file_.integer(root, "height", 0, 0, kMaxSide));
  report.tileWidth = static_cast<int>(file_.integer(root, "tilewidth", std::nullopt, 1, kMaxPixels));
  report.tileHeight = static_cast<int>(file_.integer(root, "tileheight", std::nullopt, 1, kMaxPixels));
  report.infinite = root.attribute("infinite").as_bool();
  const double width = report.tileWidth, height = report.tileHeight;
  grid_ = {{width, height}, {std::min(options_.tolerance, width / 4), std::min(options_.tolerance, height / 4)}};
  report.tolerance = std::max(grid_.tolerance.x, grid_.tolerance.y);
}

void Import::readLayers() {
  layers_ = listLayers(file_, options_, source_.place, names_);
  for (const Layer& layer : layers_) {
    const auto index = static_cast<std::uint32_t>(map_.report.layers.size());
    LayerReport& report = map_.report.layers.emplace_back();
    report = {layer.path, layer.wanted, 0, layer.remark, layer.kind};
    asked_.see(layer);
    for (const auto node : layer.node.children("object")) report.objects += !node.empty();
    if (!layer.wanted || failed()) continue;
    layer.kind == LayerKind::objects ? readObjects(layer, index) : readLayer(layer, index);
  }
}

void Import::readObjects(const Layer& layer, std::uint32_t index) {
  for (const MapShape& shape : objects_.read(layer)) {
    asked_.see(shape.object);
    const Placer::Entry entry{0, blockOf(shape.object.className, index), kNoTile, shape.object.id, index};
    if (!painter_.paint(shape, grid_, entry, map_.report.layers[index])) break;
  }
  checkBudget(layer.node);
}

/// Placer and painter do no work that the budget has no steps for. Then the import fails here.
void Import::checkBudget(pugi::xml_node node) {
  if (budget_.isOutOfCells()) {
    file_.fail(node, "its shapes are larger than the limit for a map of this size", "maxObjectCells");
  } else if (budget_.isOutOfWork()) {
    file_.fail(node, "its shapes meet so often that they take more work than the limit for a map of this size",
               "maxWork");
  }
}

void Import::place(Cell cell, Placer::EntryId entry) {
  placer_.place(cell, entry);
  if (budget_.isOutOfWork()) checkBudget(file_.root());
}

void Import::placeObjects() {
  Polygon lastRing;
  Placer::Entry last;
  Placer::EntryId id = 0;
  painter_.visit([&](Cell cell, const Polygon& ring, Placer::Entry entry) {
    if (failed() || !spend(1)) return;
    entry.shape = last.shape;
    if (ring != lastRing || entry != last) {  // the cells inside an object are all alike
      entry.shape = placer_.shape(ring);
      id = placer_.entry(entry);
      lastRing = ring;
      last = entry;
    }
    place(cell, id);
  });
}

bool Import::spend(std::size_t placements) {
  const bool enough = placements <= placementsLeft_;
  if (!enough) file_.fail(file_.root(), "the map has more polygons than the limit", "maxPlacements");
  placementsLeft_ -= enough ? placements : 0;
  return enough;
}

Block Import::blockOf(const std::string& className, std::uint32_t layer) {
  if (options_.blockFrom == BlockFrom::one) return 1;
  return blocks_.of(options_.blockFrom == BlockFrom::layer ? layers_[layer].pathInMap : className);
}

void Import::readLayer(const Layer& layer, std::uint32_t index) {
  const auto whole = [](double offset, double tile) { return std::round(offset / tile); };
  const double columns = whole(layer.offset.x, grid_.tile.x), rows = whole(layer.offset.y, grid_.tile.y);
  constexpr double kMost = 1 << 27;  // together with the largest place of a chunk it stays below kMaxCell
  if (!(std::fabs(columns) <= kMost && std::fabs(rows) <= kMost)) {
    return file_.fail(layer.node, "its offset is too large");
  }
  CurrentLayer current{index,
                       static_cast<std::int64_t>(columns),
                       static_cast<std::int64_t>(rows),
                       {layer.offset.x - columns * grid_.tile.x, layer.offset.y - rows * grid_.tile.y},
                       propertiesOf(layer),
                       {}};
  LayerReport& report = map_.report.layers[index];
  if (current.rest.x != 0 || current.rest.y != 0) {
    report.note = "shifted by " + pixels(current.rest.x) + ", " + pixels(current.rest.y) +
                  " against the grid: its polygons reach out of their cells";
  }
  readTiles(file_, layer, tilesLeft_, [&](std::int64_t column, std::int64_t row, std::uint32_t gid) {
    ++report.tiles;
    placeTile(current, column + current.columns, row + current.rows, gid);
  });
}

void Import::placeTile(CurrentLayer& layer, std::int64_t column, std::int64_t row, std::uint32_t gid) {
  const std::uint32_t number = tileNumber(gid);
  const Tileset* tileset = source_.tilesets.of(number);
  if (!tileset) {
    ++strayTiles_;
    return;
  }
  const std::uint32_t reportIndex = reportOf(*tileset, number);
  ++map_.report.tiles[reportIndex].uses;
  auto ready = layer.ready.find(gid);
  if (ready == layer.ready.end()) {
    ready = layer.ready.emplace(gid, placeables(layer, gid)).first;
    checkBudget(layers_[layer.index].node);
    if (failed()) return;
    std::vector<std::uint32_t>& layers = map_.report.tiles[reportIndex].layers;
    if (layers.empty() || layers.back() != layer.index) layers.push_back(layer.index);  // not for each way to flip it
  }
  if (!spend(ready->second.size())) return;
  for (const Placeable& part : ready->second) {
    const Cell cell{static_cast<std::int32_t>(column + part.shift.i),
                    static_cast<std::int32_t>(-1 - row + part.shift.j)};
    if (part.shift == Cell{}) {
      place(cell, part.entry);
    } else {
      carried_.push_back({cell, part.entry});
    }
  }
}

std::vector<Import::Placeable> Import::placeables(const CurrentLayer& layer, std::uint32_t gid) {
  const std::uint32_t number = tileNumber(gid);
  const std::uint32_t tile = reportIndex_[number];
  std::vector<Placeable> result;
  for (const TilePart& part : partsOf(*source_.tilesets.of(number), gid, layer, map_.report.tiles[tile]).parts) {
    const Placer::Entry entry{placer_.shape(part.part.ring), blockOf(part.className, layer.index), tile, part.object,
                              layer.index};
    result.push_back({part.part.shift, placer_.entry(entry)});
  }
  return result;
}

const TileParts& Import::partsOf(const Tileset& tileset, std::uint32_t gid, const CurrentLayer& layer,
                                 TileReport& report) {
  const std::uint32_t number = tileNumber(gid) - tileset.firstGid;
  static const TileParts kNone;
  if (!budget_.tile(tileset, number)) return kNone;
  Tile tile = tileAt(tileset, number);
  const bool solid = isSolidAsAsked(tile, layer.properties, options_);
  report.isSolid = report.isSolid || solid;
  const auto [at, isNew] = parts_.try_emplace({gid, layer.rest.x, layer.rest.y, solid});
  if (!isNew) return at->second;
  if (solid) tile.objects.push_back(fullSquare(tile));
  ImageFrame frame{tile.size, flipsOf(gid), {1, 1}, {tileset.offset.x + layer.rest.x, tileset.offset.y + layer.rest.y}};
  if (tileset.fitToGrid) frame.scaleTo(grid_.tile);
  at->second = tileParts(tile, frame, grid_, options_, budget_);
  if (report.notes.empty()) report.notes = at->second.notes;  // the same tile flipped another way has the same notes
  return at->second;
}

std::uint32_t Import::reportOf(const Tileset& tileset, std::uint32_t number) {
  std::vector<TileReport>& tiles = map_.report.tiles;
  const auto [at, isNew] = reportIndex_.emplace(number, static_cast<std::uint32_t>(tiles.size()));
  if (isNew) {
    TileReport& report = tiles.emplace_back();
    report.tileset = tileset.name;
    report.id = number - tileset.firstGid;
    const auto tile = tileset.tiles.find(report.id);
    if (tile != tileset.tiles.end()) {
      report.className = tile->second.className;
      report.isLeftOut = tiled::isLeftOut(tile->second, options_);
      report.hasShapes = !report.isLeftOut && !tile->second.objects.empty();
    }
  }
  return at->second;
}

void Import::finishReport() {
  placer_.finish(map_);
  for (const Tileset& tileset : source_.tilesets.all()) asked_.see(tileset);
  for (const auto& [origin, tileset] : source_.tilesetsOfTemplates) asked_.see(tileset);
  Report& report = map_.report;
  for (const Tileset& tileset : source_.tilesets.all()) {
    if (!tileset.missing.empty()) report.partial += (report.partial.empty() ? "" : "; ") + tileset.missing;
  }
  if (const std::string left = leftOutAsAsked(report); !left.empty()) report.notes.push_back(left);
  if (strayTiles_ > 0) report.notes.push_back(std::to_string(strayTiles_) + " tiles belong to no tileset of the map");
  const auto sort = [](std::vector<Note>& notes) {
    std::stable_sort(notes.begin(), notes.end(), [](const Note& a, const Note& b) {
      return std::pair(a.kind, a.object) < std::pair(b.kind, b.object);
    });
  };
  for (TileReport& tile : report.tiles) sort(tile.notes);
  for (LayerReport& layer : report.layers) sort(layer.notes);
  blocks_.report(map_);
}

}  // namespace

tl::expected<ImportedMap, ImportError> importOne(MapSource& source, ImportJob& job, std::optional<ImportError>& error) {
  return Import(source, job, error).run();
}

}  // namespace lgs::tiled
