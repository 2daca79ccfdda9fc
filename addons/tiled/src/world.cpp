// The maps of a world, side by side. Each is imported by itself; then their polygons are placed again, all together.
#include "block_numbers.h"
#include "import_one.h"
#include "placer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lgs::tiled {
namespace {

class WorldImport {
 public:
  WorldImport(const XmlFile& file, const std::vector<std::unique_ptr<MapSource>>& maps, ImportJob& job,
              std::optional<ImportError>& error)
      : file_(file), maps_(maps), job_(job), error_(error), placer_(job.budget) {
    all_.report.file = file.name();
  }

  tl::expected<ImportedMap, ImportError> run() {
    for (const auto& map : maps_) {
      if (!file_.failed()) read(*map);
      isFirst_ = false;
    }
    if (file_.failed()) return tl::unexpected(*error_);
    finish();
    return std::move(all_);
  }

 private:
  void read(MapSource& source);
  void add(const ImportedMap& map);
  std::uint32_t addTile(const TileReport& tile);
  void measure(const Report& report, DoublePoint at);
  void tooMuchWork();
  void finish();

  const XmlFile& file_;
  const std::vector<std::unique_ptr<MapSource>>& maps_;
  ImportJob& job_;
  std::optional<ImportError>& error_;
  ImportedMap all_;
  Placer placer_;
  bool isFirst_ = true;                                                   // of the maps
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> tiles_;  // by tileset and number
  DoublePoint min_, max_;                                                 // of the maps, in tiles
};

void WorldImport::read(MapSource& source) {
  const auto map = importOne(source, job_, error_);
  if (!map) return;
  const Report& report = map->report;
  if (!isFirst_ && (report.tileWidth != all_.report.tileWidth || report.tileHeight != all_.report.tileHeight)) {
    return file_.fail(source.entry.node,
                      source.entry.name +
                          " has tiles of another size than the maps before it. One tile becomes one cell of "
                          "the world, so all must have the same");
  }
  if (isFirst_) {
    all_.report.tileWidth = report.tileWidth;
    all_.report.tileHeight = report.tileHeight;
    all_.report.tolerance = report.tolerance;
  }
  const DoublePoint at = source.entry.at;
  measure(report, {at.x / report.tileWidth, at.y / report.tileHeight});
  add(*map);
}

void WorldImport::measure(const Report& report, DoublePoint at) {
  const DoublePoint end{at.x + report.width, at.y + report.height};
  min_ = isFirst_ ? at : DoublePoint{std::min(min_.x, at.x), std::min(min_.y, at.y)};
  max_ = isFirst_ ? end : DoublePoint{std::max(max_.x, end.x), std::max(max_.y, end.y)};
}

/// Takes over a map: its layers, tiles and notes, and its polygons as far as nothing is in their way.
void WorldImport::add(const ImportedMap& map) {
  Report& report = all_.report;
  // Blocks are copied for each map, notes are compared.
  if (!job_.budget.work(1'000 + 100 * map.blocks.size() + 10 * report.notes.size() * map.report.notes.size())) {
    return tooMuchWork();
  }
  const auto firstLayer = static_cast<std::uint32_t>(report.layers.size());
  report.layers.insert(report.layers.end(), map.report.layers.begin(), map.report.layers.end());
  std::vector<std::uint32_t> tiles;
  for (TileReport tile : map.report.tiles) {
    for (std::uint32_t& layer : tile.layers) layer += firstLayer;
    for (Note& note : tile.notes) note.layer += firstLayer;
    tiles.push_back(addTile(tile));
  }
  for (const std::string& note : map.report.notes) {
    if (std::find(report.notes.begin(), report.notes.end(), note) == report.notes.end()) report.notes.push_back(note);
  }
  report.infinite = report.infinite || map.report.infinite;
  if (report.partial.find(map.report.partial) == std::string::npos)
    report.partial += (report.partial.empty() ? "" : "; ") + map.report.partial;
  std::vector<std::uint32_t> shapes;
  for (const std::vector<LocalPoint>& shape : map.shapes) {
    Polygon ring;
    for (const LocalPoint p : shape) ring.push_back({p.x, p.y});
    shapes.push_back(placer_.shape(ring));
  }
  for (const MapPolygon& p : map.placements) {
    const std::uint32_t tile = p.tile == kNoTile ? kNoTile : tiles[p.tile];
    placer_.place(p.cell, placer_.entry({shapes[p.shape], p.block, tile, p.object, firstLayer + p.layer}));
  }
  if (job_.budget.isOutOfWork()) tooMuchWork();
  job_.options.blocks = map.blocks;  // the maps that follow give a name the same number
}

void WorldImport::tooMuchWork() {
  file_.fail(file_.root(), "its maps take more work together than the limit for a world of this size", "maxWork");
}

/// The index of a tile in the report of the world. Maps may share it; then they say the same of it.
std::uint32_t WorldImport::addTile(const TileReport& tile) {
  std::vector<TileReport>& tiles = all_.report.tiles;
  const auto [at, isNew] = tiles_.try_emplace({tile.tileset, tile.id}, static_cast<std::uint32_t>(tiles.size()));
  if (isNew) {
    tiles.push_back(tile);
    return at->second;
  }
  TileReport& known = tiles[at->second];
  known.uses += tile.uses;
  known.layers.insert(known.layers.end(), tile.layers.begin(), tile.layers.end());
  known.isSolid = known.isSolid || tile.isSolid;
  for (const Note& note : tile.notes) {
    const auto same = std::find_if(known.notes.begin(), known.notes.end(), [&](const Note& other) {
      return other.object == note.object && other.text == note.text;
    });
    if (same == known.notes.end()) {
      known.notes.push_back(note);
    } else {
      same->places += note.places;
    }
  }
  return at->second;
}

void WorldImport::finish() {
  placer_.finish(all_);
  Report& report = all_.report;
  const auto side = [](double tiles) { return static_cast<int>(std::min(std::ceil(tiles), double{1 << 30})); };
  report.width = side(max_.x - min_.x);
  report.height = side(max_.y - min_.y);
  BlockNumbers(job_.options).report(all_);
}

}  // namespace

tl::expected<ImportedMap, ImportError> importWorld(const XmlFile& file,
                                                   const std::vector<std::unique_ptr<MapSource>>& maps, ImportJob& job,
                                                   std::optional<ImportError>& error) {
  return WorldImport(file, maps, job, error).run();
}

}  // namespace lgs::tiled
