// What there is in the maps of an import: what each layer holds and says, and which properties of tiles say something.
#pragma once

#include "map_source.h"

namespace lgs::tiled {

/// Of all layers of one kind and name, in all maps of a world or levels of a project.
struct LayerFacts {
  std::string name;  ///< its path, without that of its map or level
  LayerKind kind{};
  Saying saying;         ///< of its name, class or a property
  std::string why;       ///< in words
  bool isDrawn = false;  ///< of LDtk, and only drawn
  Uses uses;             ///< of its name; isPassable also if a property says so

  std::uint64_t tiles = 0;     ///< that are not empty
  std::uint64_t shaped = 0;    ///< of these, with shapes of their own
  std::uint64_t bare = 0;      ///< of these, without shapes, so that they could be full squares
  std::uint64_t ruled = 0;     ///< of the bare ones, with a property that says something
  std::uint64_t passable = 0;  ///< of these, or of the objects, deadly or passable
  std::uint64_t cells = 0;     ///< of its rectangle
  std::uint64_t side = 0;      ///< of LDtk, of a cell, pixels

  std::uint64_t objects = 0;                         ///< that can have an area
  std::uint64_t figures = 0;                         ///< of these, tile objects
  std::uint64_t bareFigures = 0;                     ///< of these, those whose tile has no shapes
  std::uint64_t named = 0;                           ///< of these, with a name or class: things rather than ground
  std::uint64_t silent = 0;                          ///< of these, those whose name and class say nothing
  std::uint64_t lines = 0;                           ///< open polylines
  std::map<std::string, Saying> classes = {};        ///< classes and names of objects that say something
  std::map<std::string, std::uint64_t> values = {};  ///< of an IntGrid layer: how many cells have a value, by its name

  /// Whether some of its objects are called a wall or the like, and others something else: then it holds things of all
  /// kinds, also if it is called "Obstacles". Of one that is called "Walls" all are parts.
  bool isMixed() const { return !classes.empty() && silent > 0 && saying.says != Says::ground; }

  /// How much of its rectangle it fills, from 0 to 1.
  double share() const { return cells == 0 ? 0 : static_cast<double>(tiles) / static_cast<double>(cells); }
};

/// Of a property of tiles that says something.
struct RuleFacts {
  Saying saying;
  bool isOfShaped = false;    ///< tiles with shapes have it as well, or a layer has it
  std::uint64_t uses = 0;     ///< tiles without shapes, in layers, that have it
  std::uint64_t objects = 0;  ///< objects without names that have it
};

/// Of what is deadly or passable, and would be taken.
struct PassableFacts {
  std::uint64_t uses = 0;   ///< tiles, shapes or objects
  bool isLayer = false;     ///< a tile layer
  bool areSquares = false;  ///< tiles without shapes: they would be taken as squares alone
};

struct Facts {
  std::vector<LayerFacts> layers;          ///< tile layers and object layers that are wanted, in the order of the maps
  std::map<std::string, RuleFacts> rules;  ///< by "NAME" or "NAME=VALUE", as Options::solidIf has them
  std::map<std::string, PassableFacts> passable;  ///< by what Options::leaveOut takes
  bool isLdtk = false;
};

/// Takes the census of all layers that the options want. A problem goes into the map's file.
Facts census(const Maps& maps, const Options& options);

}  // namespace lgs::tiled
