// Tiled maps (TMX, TSX) as polygons in cells, ready for lgs::World.
//
//   auto map = lgs::tiled::importMap("level1.tmx");
//   if (!map) { puts(lgs::tiled::message(map.error()).c_str()); return; }
//   for (const auto& p : map->placements) world.add(p.cell, map->shapes[p.shape], p.block);
//   world.commit();
//   puts(lgs::tiled::toText(map->report).c_str());
//
// WHAT IS READ. Orthogonal maps, finite or infinite; tilesets inside the map or in TSX files; layers as CSV, base64
// (plain, zlib, gzip, zstd) or <tile> elements, in groups or not; flipped and rotated tiles; the collision shapes of
// each tile (Tiled's "Tile Collision Editor"): rectangles and polygons, with offsets and rotation. Ellipses and
// capsules become polygons of kCurveVertices vertices. Points, polylines, texts, tile objects and templates have no
// area or are not supported: left out, and the report says so. Hidden layers and objects count like visible ones.
// Object layers and image layers are passed over.
//
// WHERE THINGS LAND. One tile of the map's grid is one cell. y is turned up: the tile in column c and row r of the map
// is cell (c, -1 - r), for finite and infinite maps alike. So the top edge of row 0 is y = 0, and a map that grows
// keeps its cells. A tile whose image is larger than the grid stands on its cell's lower left corner, as Tiled draws
// it. Layer offsets (with those of their groups) move by whole tiles and by the rest; the rest makes polygons reach out
// of their cells, see below.
//
// HAND-DRAWN SHAPES. A coordinate that misses a line of the grid by at most `Options::tolerance` pixels is put on it (a
// vertex near a corner in both axes lands on the corner); then every coordinate is rounded once, to the lattice. What
// still reaches out of its cell is cut along the grid and carried into the neighbouring cells, or cut off, as
// `Options::outside` says.
//
// OVERLAPS. Polygons of one cell must not overlap, so what is placed first stays and what comes later loses the part
// that is covered already. First come the polygons in their own cells, layers in the map's order (bottom to top), then
// the carried parts. Along slanted edges such a cut is rounded: the result may miss what was drawn by a few lattice units
// (of 65,536 a cell). Where rounding spoils a part altogether, which takes slanted outlines that cross in one cell, it is
// left out, and the report says so.
//
// What comes out is exact and complete: every placement is simple, counter-clockwise, in its cell, disjoint from the
// others of its cell, and within World's limits per cell. So World::add accepts them all.
//
// No function throws (short of running out of memory); the library is usable with -fno-exceptions -fno-rtti.
// Cost: linear in the number of tiles; each combination of tiles that meet in a cell is worked out once.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::tiled {

/// Vertices of the polygon that stands for an ellipse; it is inscribed, so it errs inwards, by 0.5% of the radius.
/// A capsule gets two more.
inline constexpr int kCurveVertices = 32;

/// A polygon that has a vertex further than this from its cell, in cells, is left out.
inline constexpr int kMaxReach = 64;

/// A polygon with more vertices than this is left out.
inline constexpr std::size_t kMaxObjectVertices = 1'024;

/// What happens to a part of a polygon that reaches out of its cell.
enum class Outside : std::uint8_t {
  carry,  ///< it becomes a polygon of the cell that it lies in
  clip,   ///< it is cut off
};

/// Where a polygon's block comes from.
enum class BlockFrom : std::uint8_t {
  one,        ///< every polygon gets block 1
  tileClass,  ///< the class ("type" before Tiled 1.9) of the collision object, or if it has none that of its tile
  layer,      ///< the path of the layer, "Group/Layer"
};

struct Options {
  double tolerance = 1.0;  ///< pixels, 0 or more; never more than a quarter of a tile is used
  Outside outside = Outside::carry;
  bool solidWithoutShapes = false;  ///< true: a tile without any collision object is a full square; false: it is empty
  BlockFrom blockFrom = BlockFrom::one;

  /// Numbers for names of classes or layers. A name that is not here gets the least unused number from 1 up, in the
  /// order in which names are first met (layers in map order; in a layer by rows from the top). No class is the name "".
  /// Unused with BlockFrom::one.
  std::map<std::string, Block> blocks;

  /// Layers to import: names or paths ("Group/Layer") of layers or groups. Empty: all tile layers. A name that fits no
  /// layer is an error.
  std::vector<std::string> layers;

  std::size_t maxTiles = std::size_t{1} << 24;       ///< tiles of all layers together, empty ones included
  std::size_t maxPlacements = std::size_t{1} << 24;  ///< polygons placed
};

/// Why a map could not be read. What can be left out without spoiling the rest is no error but a note in the report.
struct ImportError {
  std::string file;     ///< the TMX or TSX file
  int line = 0;         ///< from 1; 0 if no line is to blame
  std::string element;  ///< e.g. "<layer> 'Ground'"; may be empty
  std::string what;     ///< what is wrong and what to do
};

/// "FILE:LINE: element: what is wrong"
std::string message(const ImportError& error);

/// One polygon in a cell.
struct Placement {
  Cell cell;
  Block block = 1;
  std::uint32_t shape = 0;   ///< index in ImportedMap::shapes
  std::uint32_t tile = 0;    ///< index in Report::tiles
  std::uint32_t object = 0;  ///< id of the collision object; 0 for a square from Options::solidWithoutShapes
  std::uint32_t layer = 0;   ///< index in Report::layers
};

/// In the order in which a reader cares.
enum class NoteKind : std::uint8_t {
  leftOut,       ///< the object, or a part of it, is not in the result
  clipped,       ///< a part that reached out of the cell was cut off
  carried,       ///< a part that reached out of the cell went into a neighbour
  trimmed,       ///< a part lay on solid that was there before, and was taken away
  approximated,  ///< a curve became a polygon
  snapped,       ///< coordinates were put on the grid
  nearMiss,      ///< a vertex on the grid misses a corner by a little more than the tolerance; it was not moved
};

/// Something that happened to one collision object of a tile.
struct Note {
  NoteKind kind{};
  std::uint32_t object = 0;  ///< id of the collision object
  double pixels = 0;         ///< snapped: the furthest move; carried, clipped: the furthest reach; nearMiss: the miss
  std::uint64_t places = 0;  ///< trimmed, and leftOut where it depends on the place: how often; otherwise 0
  Cell cell;                 ///< the first of these places
  std::string text;          ///< the note in words, without the object's number
};

/// A tile that the map uses, whichever way flipped.
struct TileReport {
  std::string tileset;   ///< its name
  std::uint32_t id = 0;  ///< local id in the tileset
  std::string className;
  std::uint64_t uses = 0;
  bool hasShapes = false;   ///< whether it has any collision object
  std::vector<Note> notes;  ///< sorted by kind, then object
};

struct LayerReport {
  std::string path;  ///< "Group/Layer"
  bool imported = false;
  std::uint64_t tiles = 0;  ///< tiles that are not empty
  std::string note;         ///< why it was passed over, or what is special; may be empty
};

struct BlockReport {
  std::string name;  ///< class or layer path; empty: tiles without class, or everything
  Block block = 1;
  std::uint64_t polygons = 0;
};

struct Report {
  std::string file;
  int width = 0;  ///< of the map, in tiles, as its file says
  int height = 0;
  int tileWidth = 0;  ///< of the grid, in pixels
  int tileHeight = 0;
  bool infinite = false;
  double tolerance = 0;     ///< as used, pixels
  std::uint64_t cells = 0;  ///< that hold a polygon
  std::uint64_t polygons = 0;
  std::uint64_t shapes = 0;  ///< distinct ones
  std::vector<LayerReport> layers;
  std::vector<BlockReport> blocks;  ///< those used, by number
  std::vector<TileReport> tiles;    ///< those used, in order of first use
  std::vector<std::string> notes;   ///< about the map as a whole
};

/// The report for a terminal: what came in, what was left out, what was changed, tile by tile.
std::string toText(const Report& report);

struct ImportedMap {
  std::vector<std::vector<LocalPoint>> shapes;  ///< distinct polygons; World::shape() each once, then place the ids
  std::vector<Placement> placements;            ///< sorted by cell (j, then i), then in order of precedence
  Report report;
};

/// Hands over a file's content, or says why not. Called with the map's path and then with the paths of its tilesets,
/// made relative to the map's folder. With one that reads from memory an import touches no file.
using FileReader = std::function<tl::expected<std::string, std::string>(const std::string& path)>;

/// Reads a file from the disk, up to 1 GiB.
tl::expected<std::string, std::string> readFile(const std::string& path);

/// Reads a map. Safe on hostile input: sizes are checked before memory is taken, nothing recurses without a limit.
tl::expected<ImportedMap, ImportError> importMap(const std::string& path, const Options& options = {},
                                                 const FileReader& reader = readFile);

}  // namespace lgs::tiled
