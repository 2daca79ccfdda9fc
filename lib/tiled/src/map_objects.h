// The objects of object layers: which outlines they have on the map.
#pragma once

#include "budget.h"
#include "layers.h"
#include "tileset.h"

namespace lgs::tiled {

/// One shape of an object. A tile object can have several.
struct MapShape {
  CollisionObject object;            ///< its id, its kind, and the class that decides on its block
  std::vector<DoublePoint> outline;  ///< pixels from the map's upper left corner, y up; empty for Kind::unsupported
};

class MapObjects {
 public:
  MapObjects(const XmlFile& map, const FileReader& reader, const Tilesets& tilesets, Templates& templates,
             const Options& options, Budget& budget)
      : map_(map), reader_(reader), tilesets_(tilesets), templates_(templates), options_(options), budget_(budget) {}

  /// All shapes of an object layer, in the file's order; those for which the budget is enough.
  std::vector<MapShape> read(const Layer& layer);

  /// The tilesets of templates that were read.
  const std::map<Template*, Tileset>& tilesetsOfTemplates() const { return ofTemplates_; }

 private:
  void readTileObject(const CollisionObject& object, std::vector<MapShape>& shapes);
  const Tileset* tilesetOf(const CollisionObject& object);

  const XmlFile& map_;
  const FileReader& reader_;
  const Tilesets& tilesets_;
  Templates& templates_;
  const Options& options_;
  Budget& budget_;
  std::map<Template*, Tileset> ofTemplates_;
};

}  // namespace lgs::tiled
