// The objects of object layers: which outlines they have on the map.
#pragma once

#include "budget.h"
#include "map_source.h"

namespace lgs::tiled {

/// One shape of an object. A tile object can have several.
struct MapShape {
  CollisionObject object;            ///< its id, its kind, and the class that decides on its block
  std::vector<DoublePoint> outline;  ///< pixels from the map's upper left corner, y up; empty for Kind::unsupported
};

class MapObjects {
 public:
  MapObjects(MapSource& source, const Options& options, Budget& budget)
      : source_(source), map_(*source.file), options_(options), budget_(budget) {}

  /// All shapes of an object layer, in the file's order; those for which the budget is enough.
  std::vector<MapShape> read(const Layer& layer);

 private:
  void readTileObject(const CollisionObject& object, std::vector<MapShape>& shapes);
  const Tileset* tilesetOf(const CollisionObject& object);

  MapSource& source_;
  const XmlFile& map_;
  const Options& options_;
  Budget& budget_;
};

}  // namespace lgs::tiled
