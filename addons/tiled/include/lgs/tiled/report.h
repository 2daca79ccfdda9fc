// What an import reports: what came in, what was taken without options and why, and what was left out or changed.
#pragma once

#include <lgs/tiled/options.h>

#include <string_view>

namespace lgs::tiled {

/// The kinds of notes, those that matter most first.
enum class NoteKind : std::uint8_t {
  leftOut,       ///< the object, or a part of it, is not in the result
  carried,       ///< a part that reached out of the cell went into a neighbouring cell
  trimmed,       ///< a part lay on a polygon that was there before, and was taken away
  approximated,  ///< a curve became a polygon
  snapped,       ///< coordinates moved onto grid lines
  takenBack,     ///< no coordinate moved onto a grid line: sides of the outline would have met there
  nearMiss,      ///< a vertex on a grid line misses a corner by little more than the tolerance, and was not moved
  hidden,        ///< the object is hidden, and was taken all the same
};

/// Something that happened to one collision object of a tile, or to one object of an object layer.
struct Note {
  NoteKind kind{};           ///< what happened
  std::uint32_t object = 0;  ///< id of the collision object
  double pixels = 0;         ///< snapped, takenBack: the furthest move; carried: the furthest reach; nearMiss: the miss
  std::uint64_t places = 0;  ///< in how many cells; 0 for notes that hold wherever the tile is used
  Cell cell;                 ///< the first of these cells, by rows from the lowest
  std::string text;          ///< the note in words, without the object's number
  std::uint32_t layer = 0;   ///< of the cells, if there are places: index in Report::layers
};

/// A tile that the map uses. Flipped and rotated ones count as the same tile.
struct TileReport {
  std::string tileset;      ///< name
  std::uint32_t id = 0;     ///< in the tileset, from 0
  std::string className;    ///< as BlockFrom::tileClass has it; may be empty
  std::uint64_t uses = 0;   ///< how often the imported layers show it
  bool hasShapes = false;   ///< whether it has any collision object
  std::vector<Note> notes;  ///< sorted by kind, then object
  bool isSolid = false;     ///< it has no shapes, and is a full square as Options requested, at least in one layer
  bool isLeftOut = false;   ///< as Options::leaveOut requested
  std::vector<std::uint32_t> layers = {};  ///< in which it is used: indices in Report::layers
};

/// What a layer holds.
enum class LayerKind : std::uint8_t { tiles, objects, image };

/// A layer of the map, whether it was taken or not.
struct LayerReport {
  std::string path;                   ///< "Group/Layer"; before it the name of the map in a world, or of the level
  bool imported = false;              ///< whether it was taken
  std::uint64_t tiles = 0;            ///< tiles that are not empty
  std::string note;                   ///< why it was taken or passed over, or what is special about it; may be empty
  LayerKind kind = LayerKind::tiles;  ///< what it holds
  std::uint64_t objects = 0;          ///< of an object layer
  std::vector<Note> notes = {};       ///< of its objects; sorted by kind, then object
  std::string name = {};              ///< its path, without that of its map or level
  std::uint64_t solid = 0;            ///< its tiles or objects that have an area, before overlaps are taken away
};

/// A block that the import used.
struct BlockReport {
  std::string name;  ///< of the class or the path of the layer, several with commas; empty with BlockFrom::one
  Block block = 1;   ///< the number
  std::uint64_t polygons = 0;  ///< placements with this block
};

/// Something in a map that could be taken instead of what was. It was tried.
struct Suggestion {
  std::string text;                    ///< "tile layer Ground, 34 % of the map: its name says 'ground'"
  std::vector<std::string> arguments;  ///< of `lgs import` that choose it: "--objects", "Boxes"
  std::uint64_t polygons = 0;          ///< how many it gives, more than none
  Options options = {};                ///< those of the import, with this choice
};

/// How many suggestions there are at most, and so how often a map is imported for them.
inline constexpr std::size_t kMaxSuggestions = 12;

/// An argument as a shell takes it: in quotes if it has to be. Names come from files, so control characters have
/// escapes.
std::string shellWord(std::string_view argument);

/// What came in, and what was left out or changed: toText() writes it.
struct Report {
  std::string file;                 ///< the map
  int width = 0;                    ///< of the map, tiles; what its file says
  int height = 0;                   ///< of the map, tiles
  int tileWidth = 0;                ///< of the grid, in pixels
  int tileHeight = 0;               ///< of the grid, in pixels
  bool infinite = false;            ///< whether the map has no size
  double tolerance = 0;             ///< pixels, as used
  std::uint64_t cells = 0;          ///< that hold a polygon
  std::uint64_t polygons = 0;       ///< placements
  std::uint64_t shapes = 0;         ///< distinct polygons
  std::vector<LayerReport> layers;  ///< all of the map, in its order
  std::vector<BlockReport> blocks;  ///< that are used, by number
  std::vector<TileReport> tiles;    ///< that are used, in the order of their first use
  std::vector<std::string> notes;   ///< about the map as a whole

  /// Of a map that decides what is solid, as no options do.
  std::string choice;   ///< what was taken and why, with the arguments for it; empty if nothing was
  std::string partial;  ///< what says that it is solid and was not taken, or is missing, or was requested and is
                        ///< not there; empty if all was taken
  std::string also;     ///< what else could be solid: weaker evidence than what was taken
  std::string leftOut;  ///< what was left out as it is deadly or passable: classes, names, layers, with their number
  std::vector<Suggestion> suggestions;  ///< what could be taken instead and gives something else, the likeliest first
};

/// The report for a terminal: what was taken and why; the suggestions, each with its arguments after `command`; what came
/// in, what was left out and what was changed, tile by tile. Control characters in names become blanks.
std::string toText(const Report& report, const std::string& command = {});

}  // namespace lgs::tiled
