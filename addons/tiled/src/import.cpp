// One pass over the maps of an import. Each map brings its layers tile by tile, then the parts that were carried out of
// their cells, then its objects; what an earlier one has placed stays.
#include "asked_names.h"
#include "map_source.h"
#include "parts.h"
#include "placer.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace lgs::tiled {
namespace {

class Import {
 public:
  Import(const XmlFile& file, const Maps& maps, const Options& options, Budget& budget)
      : options_(options), first_(file), maps_(maps), budget_(budget) {
    map_.report.file = file.name();
  }

  tl::expected<ImportedMap, ImportError> run() {
    checkOptions();
    for (const auto& map : maps_) {
      if (!failed()) readMap(*map);
    }
    if (!failed()) names_.tiles.checkAll(first_, "tile", map_.report.layers);
    if (!failed()) names_.objects.checkAll(first_, "object", map_.report.layers);
    if (!failed()) placer_.finish(map_);
    if (!failed()) checkBudget(first_.root());
    if (failed()) return tl::unexpected(*first_.error());
    finish();
    return std::move(map_);
  }

 private:
  /// A tile, flipped in one way, ready to be placed in one layer.
  struct Ready {
    std::uint32_t report = 0;  // its index
    std::vector<std::pair<Cell, Placer::EntryId>> parts = {};
  };
  struct CurrentLayer {
    const Layer& layer;
    std::uint32_t index = 0;
    std::int64_t columns = 0, rows = 0;  // the whole tiles of its offset
    DoublePoint rest;                    // the rest of the offset, pixels
    Properties properties;
    std::unordered_map<std::uint32_t, Ready> ready = {};  // by tile number with flags
  };

  bool failed() const { return first_.failed(); }
  const XmlFile& file() const { return *source_->file; }

  void checkOptions() {
    const auto check = [&](double value, const char* what, const char* option) {
      if (!(value >= 0 && std::isfinite(value))) first_.fail({}, concat("the ", what, " should be 0 or more"), option);
    };
    check(options_.tolerance, "tolerance", "tolerance");
    check(options_.polylineThickness, "thickness of polylines", "polylineThickness");
  }

  void readMap(MapSource& source) {
    source_ = &source;
    carried_.clear();
    readHead();
    if (failed()) return;
    const std::vector<Layer> layers = listLayers(file(), options_, source.place, names_);
    const auto first = static_cast<std::uint32_t>(map_.report.layers.size());
    for (const Layer& layer : layers) {
      const auto objects = layer.node.children("object");
      const auto count = static_cast<std::uint64_t>(std::distance(objects.begin(), objects.end()));
      map_.report.layers.push_back({layer.path, layer.wanted, 0, layer.remark, layer.kind, count, {}, layer.pathInMap});
      asked_.see(layer);
    }
    const auto read = [&](LayerKind kind, auto&& readLayer) {
      for (std::uint32_t k = 0; k < layers.size(); ++k) {
        if (!failed() && layers[k].wanted && layers[k].kind == kind) readLayer(layers[k], first + k);
      }
    };
    read(LayerKind::tiles, [&](const Layer& layer, std::uint32_t index) { readTileLayer(layer, index); });
    for (const auto& [cell, entry] : carried_) placer_.place(cell, entry);
    read(LayerKind::objects, [&](const Layer& layer, std::uint32_t index) { readObjectLayer(layer, index); });
  }

  void readHead() {
    constexpr std::int64_t kMaxSide = 1 << 28, kMaxPixels = 1 << 16;
    const auto root = file().root();
    const auto number = [&](const char* name, std::optional<std::int64_t> fallback, std::int64_t min,
                            std::int64_t max) {
      return static_cast<int>(file().integer(root, name, fallback, min, max));
    };
    const int width = number("width", 0, 0, kMaxSide), height = number("height", 0, 0, kMaxSide);
    const int tileWidth = number("tilewidth", {}, 1, kMaxPixels), tileHeight = number("tileheight", {}, 1, kMaxPixels);
    Report& report = map_.report;
    const bool isFirst = source_ == maps_.front().get();
    if (!isFirst && (tileWidth != report.tileWidth || tileHeight != report.tileHeight)) {
      return first_.fail(source_->place.entry,
                         source_->place.file +
                             " has tiles of another size than the maps before it. One tile becomes one "
                             "cell of the world, so all must have the same");
    }
    report.tileWidth = tileWidth;
    report.tileHeight = tileHeight;
    report.infinite = report.infinite || root.attribute("infinite").as_bool();
    const DoublePoint tile{static_cast<double>(tileWidth), static_cast<double>(tileHeight)};
    grid_ = {tile, {std::min(options_.tolerance, tile.x / 4), std::min(options_.tolerance, tile.y / 4)}};
    report.tolerance = std::max(grid_.tolerance.x, grid_.tolerance.y);
    const DoublePoint at{source_->place.offset.x / tile.x, source_->place.offset.y / tile.y};
    min_ = {std::min(min_.x, at.x), std::min(min_.y, at.y)};
    max_ = {std::max(max_.x, at.x + width), std::max(max_.y, at.y + height)};
  }

  void readObjectLayer(const Layer& layer, std::uint32_t index) {
    std::vector<Note>& notes = map_.report.layers[index].notes;
    const std::string ofLayer = classOf(layer.node);
    const auto place = [&](const CollisionObject& object, const std::vector<Outline>& outlines) {
      asked_.see(object);
      const Block block = blockOf(object.className.empty() ? ofLayer : object.className, layer);
      bool isSolid = false;
      constexpr double kMost = 1 << 28;  // cells from the map's corner; below kMaxCell
      cutObject(object, outlines, grid_, kMost, budget_, notes, [&](Cell cell, const Polygon& ring) {
        if (!failed() && spend(1))
          placer_.place(cell, placer_.entry({{}, block, placer_.shape(ring), kNoTile, object.id, index}));
        isSolid = true;
      });
      map_.report.layers[index].solid += isSolid;
    };
    readObjects(*source_, layer, options_, budget_, place);
    checkBudget(layer.node);
  }

  /// Nothing is done that the budget has no steps for. Then the import fails here.
  void checkBudget(pugi::xml_node node) {
    if (budget_.isOutOfCells()) {
      file().fail(node, "its shapes are larger than the limit for a map of this size", "maxObjectCells");
    } else if (budget_.isOutOfWork()) {
      file().fail(node, "its shapes meet so often that they take more work than the limit for a map of this size",
                  "maxWork");
    }
  }

  bool spend(std::size_t placements) {
    const bool enough = placements <= budget_.placements;
    if (!enough) file().fail(file().root(), "the map has more polygons than the limit", "maxPlacements");
    budget_.placements -= enough ? placements : 0;
    return enough;
  }

  Block blockOf(const std::string& className, const Layer& layer) {
    if (options_.blockFrom == BlockFrom::one) return 1;
    return blocks_.of(options_.blockFrom == BlockFrom::layer ? layer.pathInMap : className);
  }

  void readTileLayer(const Layer& layer, std::uint32_t index) {
    const double columns = std::round(layer.offset.x / grid_.tile.x), rows = std::round(layer.offset.y / grid_.tile.y);
    constexpr double kMost = 1 << 27;  // together with the largest place of a chunk it stays below kMaxCell
    if (!(std::fabs(columns) <= kMost && std::fabs(rows) <= kMost)) {
      return file().fail(layer.node, "its offset is too large");
    }
    CurrentLayer current{layer,
                         index,
                         static_cast<std::int64_t>(columns),
                         static_cast<std::int64_t>(rows),
                         {layer.offset.x - columns * grid_.tile.x, layer.offset.y - rows * grid_.tile.y},
                         propertiesOf(layer)};
    LayerReport& report = map_.report.layers[index];
    if (current.rest.x != 0 || current.rest.y != 0) {
      report.note = concat("shifted by ", pixels(current.rest.x), ", ", pixels(current.rest.y),
                           " against the grid: its polygons reach out of their cells");
    }
    readTiles(file(), layer, budget_.tiles, [&](std::int64_t column, std::int64_t row, std::uint32_t gid) {
      ++report.tiles;
      placeTile(current, column + current.columns, row + current.rows, gid);
    });
  }

  void placeTile(CurrentLayer& layer, std::int64_t column, std::int64_t row, std::uint32_t gid) {
    auto ready = layer.ready.find(gid);
    if (ready == layer.ready.end()) {
      const Tileset* const tileset = tilesetOf(source_->tilesets, tileNumber(gid));
      strayTiles_ += tileset == nullptr;
      if (!tileset) return;
      ready = layer.ready.emplace(gid, readyTile(layer, *tileset, gid)).first;
      checkBudget(layer.layer.node);
      if (failed()) return;
    }
    ++map_.report.tiles[ready->second.report].uses;
    if (!spend(ready->second.parts.size())) return;
    map_.report.layers[layer.index].solid += !ready->second.parts.empty();
    for (const auto& [shift, entry] : ready->second.parts) {
      const Cell cell{static_cast<std::int32_t>(column + shift.i), static_cast<std::int32_t>(-1 - row + shift.j)};
      shift == Cell{} ? placer_.place(cell, entry) : carried_.push_back({cell, entry});
    }
  }

  Ready readyTile(const CurrentLayer& layer, const Tileset& tileset, std::uint32_t gid) {
    const std::uint32_t id = tileNumber(gid) - tileset.firstGid;
    Ready result{reportOf(tileset, id)};
    TileReport& report = map_.report.tiles[result.report];
    if (!budget_.tile(tileset, id)) return result;
    Tile tile = tileset.tile(id);
    report.isSolid |= squareAsAsked(tile, layer.properties, options_);
    if (report.layers.empty() || report.layers.back() != layer.index) report.layers.push_back(layer.index);
    ImageFrame frame{tile.size, gid, {1, 1}, {tileset.offset.x + layer.rest.x, tileset.offset.y + layer.rest.y}};
    if (tileset.fitToGrid) frame.scaleTo(grid_.tile);
    std::vector<Note> notes;
    cutTile(tile, frame, grid_, options_, budget_, notes,
            [&](Cell shift, const Polygon& ring, const CollisionObject& object) {
              const Block block = blockOf(object.className, layer.layer);
              const auto entry = placer_.entry({{}, block, placer_.shape(ring), result.report, object.id, layer.index});
              result.parts.push_back({shift, entry});
            });
    if (report.notes.empty()) report.notes = std::move(notes);  // flipped another way it has the same notes
    return result;
  }

  /// The report of a tile. Maps of a world may share it.
  std::uint32_t reportOf(const Tileset& tileset, std::uint32_t id) {
    const Tile& tile = tileset.tile(id);
    std::vector<TileReport>& tiles = map_.report.tiles;
    const auto next = static_cast<std::uint32_t>(tiles.size());
    const auto [at, isNew] = reports_.try_emplace({tileset.name, id, tile.className}, next);
    if (!isNew) return at->second;
    const bool isOut = isLeftOut(tile, options_);
    tiles.push_back({tileset.name, id, tile.className, 0, !isOut && !tile.objects.empty(), {}, false, isOut});
    return next;
  }

  void finish() {
    Report& report = map_.report;
    const auto side = [](double tiles) { return static_cast<int>(std::min(std::ceil(tiles), double{1 << 30})); };
    report.width = side(max_.x - min_.x);
    report.height = side(max_.y - min_.y);
    std::set<std::string> missing;
    for (const auto& map : maps_) {
      for (const Tileset& tileset : map->tilesets) {
        asked_.see(tileset);
        if (!tileset.missing.empty()) missing.insert(tileset.missing);
      }
      for (const auto& [origin, tileset] : map->tilesetsOfTemplates) asked_.see(tileset);
    }
    join(report.partial, listed({missing.begin(), missing.end()}));
    std::map<std::string, std::uint64_t> left;
    for (const TileReport& tile : report.tiles)
      if (tile.isLeftOut) left[tile.className] += tile.uses;
    std::string uses;
    for (const auto& [name, count] : left) join(uses, concat(count, " uses of ", inQuotes(name)), ", ");
    if (!uses.empty()) report.notes.push_back("left out, as asked: " + uses);
    if (strayTiles_ > 0) report.notes.push_back(concat(strayTiles_, " tiles belong to no tileset of the map"));
    const auto sort = [](std::vector<Note>& notes) {
      std::stable_sort(notes.begin(), notes.end(), [](const Note& a, const Note& b) {
        return std::pair(a.kind, a.object) < std::pair(b.kind, b.object);
      });
    };
    for (TileReport& tile : report.tiles) sort(tile.notes);
    for (LayerReport& layer : report.layers) sort(layer.notes);
    blocks_.report(map_);
    asked_.report(report);
  }

  const Options& options_;
  const XmlFile& first_;  // the map or the world
  const Maps& maps_;
  Budget& budget_;
  LayerNames names_{options_};
  AskedNames asked_{options_};
  BlockNumbers blocks_{options_};
  Placer placer_{budget_};
  ImportedMap map_;
  PixelGrid grid_;
  DoublePoint min_{kInfinite, kInfinite}, max_{-kInfinite, -kInfinite};                   // of the maps, in tiles
  std::map<std::tuple<std::string, std::uint32_t, std::string>, std::uint32_t> reports_;  // of tiles, by what they say
  std::uint64_t strayTiles_ = 0;                                                          // of no tileset

  // Of the map that is read.
  MapSource* source_ = nullptr;
  std::vector<std::pair<Cell, Placer::EntryId>> carried_;
};

}  // namespace

tl::expected<ImportedMap, ImportError> importMaps(const XmlFile& file, const Maps& maps, const Options& options,
                                                  Budget& budget) {
  return Import(file, maps, options, budget).run();
}

}  // namespace lgs::tiled
