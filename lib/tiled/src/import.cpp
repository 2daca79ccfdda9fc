// One import from its beginning to its end: the map's head, the tilesets, the layers tile by tile, then the carried
// parts.
#include <lgs/tiled/import.h>

#include "block_numbers.h"
#include "layers.h"
#include "placer.h"
#include "tile_parts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::uint32_t kHorizontal = 0x8000'0000, kVertical = 0x4000'0000, kDiagonal = 0x2000'0000;
constexpr std::uint32_t kFlags = 0xF000'0000;  // and the one that only hexagonal maps use

class Import {
 public:
  Import(const std::string& path, const Options& options, const FileReader& reader)
      : options_(options),
        reader_(reader),
        file_(path, reader, "map", error_),
        blocks_(options),
        tilesLeft_(options.maxTiles),
        placementsLeft_(options.maxPlacements) {
    map_.report.file = path;
  }

  tl::expected<ImportedMap, ImportError> run() {
    if (!failed()) readHead();
    if (!failed()) readTilesets();
    if (!failed()) readLayers();
    for (const auto& [cell, entry] : carried_) {
      if (!failed()) placer_.place(cell, entry);
    }
    if (failed()) return tl::unexpected(std::move(*error_));
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
    std::int64_t columns = 0, rows = 0;                               // the whole tiles of its offset
    DoublePoint rest;                                                 // the rest of the offset, pixels
    std::unordered_map<std::uint32_t, std::vector<Placeable>> ready;  // by tile number with flags
  };

  bool failed() const { return error_.has_value(); }
  void readHead();
  void readTilesets();
  void readLayers();
  void readLayer(const Layer& layer, std::uint32_t index);
  void placeTile(CurrentLayer& layer, std::int64_t column, std::int64_t row, std::uint32_t gid);
  std::vector<Placeable> placeables(const CurrentLayer& layer, std::uint32_t gid);
  const TileParts& partsOf(const Tileset& tileset, std::uint32_t gid, DoublePoint rest, TileReport& report);
  const Tileset* tilesetOf(std::uint32_t number) const;
  std::uint32_t reportOf(const Tileset& tileset, std::uint32_t number);
  void finishReport();
  void reportBlocks();

  const Options& options_;
  const FileReader& reader_;
  std::optional<ImportError> error_;
  XmlFile file_;
  BlockNumbers blocks_;
  std::size_t tilesLeft_;
  std::size_t placementsLeft_;
  PixelGrid grid_;
  std::vector<Tileset> tilesets_;                                         // by firstGid
  std::map<std::tuple<std::uint32_t, double, double>, TileParts> parts_;  // by tile number with flags, and offset
  std::unordered_map<std::uint32_t, std::uint32_t> reportIndex_;          // by tile number
  std::vector<std::pair<Cell, Placer::EntryId>> carried_;
  std::uint64_t strayTiles_ = 0;  // of no tileset
  Placer placer_;
  ImportedMap map_;
};

void Import::readHead() {
  constexpr std::int64_t kMaxSide = 1 << 28, kMaxPixels = 1 << 16;
  const auto root = file_.root();
  const std::string_view orientation = root.attribute("orientation").value();
  if (!orientation.empty() && orientation != "orthogonal") {
    return file_.fail(root, "the map is " + std::string(orientation) + ": only orthogonal maps have square cells");
  }
  if (!(options_.tolerance >= 0 && std::isfinite(options_.tolerance))) {
    return file_.fail({}, "Options::tolerance should be 0 or more");
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

void Import::readTilesets() {
  for (const auto node : file_.root().children("tileset")) {
    tilesets_.push_back(readTileset(file_, node, reader_, error_));
    if (failed()) return;
    for (std::size_t i = 0; i + 1 < tilesets_.size(); ++i) {
      if (tilesets_[i].firstGid == tilesets_.back().firstGid) {
        return file_.fail(node, "has the same firstgid as the tileset '" + tilesets_[i].name + "'");
      }
    }
  }
  std::sort(tilesets_.begin(), tilesets_.end(),
            [](const Tileset& a, const Tileset& b) { return a.firstGid < b.firstGid; });
}

void Import::readLayers() {
  const std::vector<Layer> layers = listLayers(file_, options_.layers);
  for (const Layer& layer : layers) {
    map_.report.layers.push_back({layer.path, layer.wanted, 0, layer.remark});
    if (layer.wanted && !failed()) readLayer(layer, static_cast<std::uint32_t>(map_.report.layers.size() - 1));
  }
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
  const std::uint32_t number = gid & ~kFlags;
  const Tileset* tileset = tilesetOf(number);
  if (!tileset) {
    ++strayTiles_;
    return;
  }
  const std::uint32_t reportIndex = reportOf(*tileset, number);
  ++map_.report.tiles[reportIndex].uses;
  auto ready = layer.ready.find(gid);
  if (ready == layer.ready.end()) ready = layer.ready.emplace(gid, placeables(layer, gid)).first;
  if (ready->second.size() > placementsLeft_) {
    return file_.fail(file_.root(), "the map has more polygons than the limit (Options::maxPlacements)");
  }
  placementsLeft_ -= ready->second.size();
  for (const Placeable& part : ready->second) {
    const Cell cell{static_cast<std::int32_t>(column + part.shift.i),
                    static_cast<std::int32_t>(-1 - row + part.shift.j)};
    if (part.shift == Cell{}) {
      placer_.place(cell, part.entry);
    } else {
      carried_.push_back({cell, part.entry});
    }
  }
}

std::vector<Import::Placeable> Import::placeables(const CurrentLayer& layer, std::uint32_t gid) {
  const std::uint32_t number = gid & ~kFlags;
  const std::uint32_t tile = reportIndex_[number];
  std::vector<Placeable> result;
  for (const TilePart& part : partsOf(*tilesetOf(number), gid, layer.rest, map_.report.tiles[tile]).parts) {
    Placer::Entry entry{placer_.shape(part.part.ring), 1, tile, part.object, layer.index};
    if (options_.blockFrom == BlockFrom::tileClass) entry.block = blocks_.of(part.className);
    if (options_.blockFrom == BlockFrom::layer) entry.block = blocks_.of(map_.report.layers[layer.index].path);
    result.push_back({part.part.shift, placer_.entry(entry)});
  }
  return result;
}

const TileParts& Import::partsOf(const Tileset& tileset, std::uint32_t gid, DoublePoint rest, TileReport& report) {
  const auto [at, isNew] = parts_.try_emplace({gid, rest.x, rest.y});
  if (!isNew) return at->second;
  const auto found = tileset.tiles.find((gid & ~kFlags) - tileset.firstGid);
  Tile tile = found == tileset.tiles.end() ? Tile{} : found->second;
  if (tile.size.x == 0 || tile.size.y == 0) tile.size = tileset.tileSize;
  if (tile.objects.empty() && options_.solidWithoutShapes) tile.objects.emplace_back().size = tile.size;
  ImageFrame frame{tile.size,
                   {(gid & kHorizontal) != 0, (gid & kVertical) != 0, (gid & kDiagonal) != 0},
                   {1, 1},
                   {tileset.offset.x + rest.x, tileset.offset.y + rest.y}};
  if (tileset.fitToGrid) {
    const DoublePoint box = frame.flips.diagonal ? DoublePoint{tile.size.y, tile.size.x} : tile.size;
    frame.scale = {grid_.tile.x / box.x, grid_.tile.y / box.y};
  }
  at->second = tileParts(tile, frame, grid_, options_);
  if (report.notes.empty()) report.notes = at->second.notes;  // the same tile flipped another way has the same notes
  return at->second;
}

const Tileset* Import::tilesetOf(std::uint32_t number) const {
  const auto next = std::upper_bound(tilesets_.begin(), tilesets_.end(), number,
                                     [](std::uint32_t n, const Tileset& t) { return n < t.firstGid; });
  if (next == tilesets_.begin()) return nullptr;
  const Tileset& tileset = *(next - 1);
  return tileset.tileCount == 0 || number - tileset.firstGid < tileset.tileCount ? &tileset : nullptr;
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
      report.hasShapes = !tile->second.objects.empty();
    }
  }
  return at->second;
}

void Import::finishReport() {
  placer_.finish(map_);
  Report& report = map_.report;
  if (strayTiles_ > 0) report.notes.push_back(std::to_string(strayTiles_) + " tiles belong to no tileset of the map");
  for (TileReport& tile : report.tiles) {
    std::stable_sort(tile.notes.begin(), tile.notes.end(), [](const Note& a, const Note& b) {
      return std::pair(a.kind, a.object) < std::pair(b.kind, b.object);
    });
  }
  reportBlocks();
}

void Import::reportBlocks() {
  Report& report = map_.report;
  map_.blocks = blocks_.all();
  const auto listed = [](std::string& names, const std::string& name) {
    names += (names.empty() ? "" : ", ") + (name.empty() ? "(no class)" : name);
  };
  if (std::string names; !blocks_.asTheyCame().empty()) {
    for (const std::string& name : blocks_.asTheyCame()) listed(names, name);
    report.notes.push_back("blocks are numbered in the order of their first use: " + names +
                           ". An edit of the map may change the numbers. Choose them, or look them up by name");
  }
  std::map<Block, std::uint64_t> polygons;
  for (const Placement& placement : map_.placements) ++polygons[placement.block];
  for (const auto& [block, count] : polygons) {
    std::string names;
    for (const auto& [name, number] : blocks_.all()) {
      if (number == block) listed(names, name);
    }
    report.blocks.push_back({std::move(names), block, count});
  }
}

}  // namespace

std::optional<Block> ImportedMap::block(const std::string& name) const {
  const auto found = blocks.find(name);
  return found == blocks.end() ? std::nullopt : std::optional(found->second);
}

tl::expected<ImportedMap, ImportError> importMap(const std::string& path, const Options& options,
                                                 const FileReader& reader) {
  return Import(path, options, reader).run();
}

}  // namespace lgs::tiled
