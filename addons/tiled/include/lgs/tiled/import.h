// Maps of Tiled and LDtk as polygons in cells, ready for lgs::World.
//
//   auto map = lgs::tiled::importMap("level1.tmx");
//   if (!map) { puts(lgs::tiled::message(map.error()).c_str()); return; }
//   for (const auto& p : map->placements) {
//     const auto handle = world.add(p.cell, map->shapes[p.shape], p.block);
//     if (handle) tiles[*handle] = p.tile;  // a hit names the polygon, and so the tile; saved worlds keep handles
//   }
//   world.commit();
//   puts(lgs::tiled::toText(map->report).c_str());
//
// WHAT IS READ. Tiled's orthogonal maps, tilesets and templates in XML and in JSON, and its worlds; LDtk projects from
// 0.8 on. The content of a file says what it is, not its name. Each tile brings the collision shapes that were drawn in
// Tiled's "Tile Collision Editor"; ellipses and capsules become polygons of kCurveVertices vertices. Object layers hold
// the same shapes, of any size, and tile objects, which bring the shapes of their tile. In an LDtk project each cell of
// an IntGrid layer is a full square, unless its value is 0; the entities of one kind in a layer are an object layer,
// "Level/Layer/Entity", whose class is the entity layer and whose properties are their tags, numbered from 1 in it.
// What has no area or is not supported is left out, and the report names it. docs/maps.md has more.
//
// WHERE THINGS LAND. One tile of the map's grid is one cell. y points up: the tile in column c and row r of the map is
// cell (c, -1 - r). So the top edge of row 0 is y = 0, and cells keep their numbers when the map grows. This holds for
// finite and infinite maps alike. If a tile's image is larger than the grid, its lower left corner is that of its cell,
// as Tiled draws it. The offset of a layer includes those of its groups, and of its map in a world or of its level. The
// whole tiles in it move the layer by as many cells. The rest makes the layer's polygons reach out of their cells.
//
// HAND-DRAWN SHAPES. Each coordinate that misses a grid line by at most `Options::tolerance` pixels moves onto the
// line, then it is rounded once, to the nearest lattice unit. If that brought sides of a shape onto each other, none of
// its vertices snaps, and the report says so. An outline may cross itself: inside is what Tiled fills. Shapes are cut
// along the grid; what lies of a tile's shapes in other cells goes there, or is dropped, as `Options::outside` says.
// Where edges cross the grid or each other the rounding is that of a brush (lgs/brush.h), at most one lattice unit.
//
// OVERLAPS. What is placed first stays, and what comes later loses the part that is covered already: first the polygons
// in their own cells, layer by layer from the bottom to the top, then the carried parts, then the objects of object
// layers in the map's order. Where slanted outlines cross in a cell both get the same vertex, and the result misses
// what was drawn by at most a lattice unit. What is narrower than some units is dropped.
//
// WHAT COMES OUT. Every placement is simple, counter-clockwise, inside its cell, disjoint from the others of its cell,
// and within World's limits for a cell. So World::add accepts all of them.
//
// ERRORS. An error is a value. When memory runs out std::bad_alloc comes, and nothing is leaked; only where objects are
// painted the brushes end the program, as they always do then. Maps need not be trusted: sizes are checked before
// memory is taken, work is counted and refused before it is done, and nothing recurses without a limit.
//
// COST. Linear in the number of tiles, and in that of the cells that objects reach. Polygons are compared once for each
// combination of tiles that meet in a cell. A combination of polygons that lie on each other takes a brush some 0.2 ms.
// Whatever is in the files, an import takes work and memory in proportion to their bytes, beyond the limits of Options.
#pragma once

#include <lgs/tiled/report.h>

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::tiled {

/// An ellipse becomes an inscribed polygon of this many vertices, a capsule one with two more. Such a polygon lies
/// inside the curve, by up to 0.5 % of the radius.
inline constexpr int kCurveVertices = 32;

/// A polygon of a tile is left out if a vertex is further than this many cells from the lower left corner of its cell,
/// on either axis. An object of an object layer may be kMaxRegionCells wide and high (lgs/brush.h).
inline constexpr int kMaxReach = 64;

/// A polygon with more vertices than this is left out.
inline constexpr std::size_t kMaxObjectVertices = 1'024;

/// So is an outline that crosses itself more often, and what crosses what is in a cell already.
inline constexpr std::size_t kMaxCrossings = 1'024;

/// What each byte that is read adds to Options::maxWork.
inline constexpr std::size_t kWorkPerByte = 1'024;
/// What each byte that is read adds to Options::maxObjectCells.
inline constexpr std::size_t kObjectCellsPerByte = 256;

/// A layer whose path has more bytes than this is an error.
inline constexpr std::size_t kMaxPathLength = 4'096;

/// What happens to the part of a polygon that lies outside its cell.
enum class Outside : std::uint8_t {
  carry,  ///< it becomes a polygon of the cell that it lies in
  clip,   ///< it is dropped
};

/// Where a polygon's block comes from.
enum class BlockFrom : std::uint8_t {
  one,        ///< every polygon gets block 1; but in an LDtk project a cell gets its value, and each kind of entity a
              ///< separate block, as with tileClass, whose names are those of values and entities
  tileClass,  ///< the class of the collision object ("type" before Tiled 1.9); if it has none, that of its tile or, in
              ///< an object layer, of its layer
  name,       ///< the name of the collision object; if it has none, as tileClass
  layer,      ///< the path of the layer, "Group/Layer", without that of its map in a world or of its level
};

/// What a tile is by the code of a game, which its maps do not say.
struct TileShape {
  std::vector<DoublePoint> outline;  ///< in tiles, from the tile's lower left corner, y up; empty: it is not solid
  bool oneWay = false;               ///< the outline is an open polyline, for Options::polylineThickness
};

/// Shapes by the name of the tileset ("" for any) and the number of the tile in it, from 0.
using TileTable = std::map<std::string, std::map<std::uint32_t, TileShape>>;

/// Reads a table as docs/maps.md, "Tiles by their numbers", describes it. The error is "LINE: what is wrong".
tl::expected<TileTable, std::string> parseTileTable(std::string_view text);

/// What to import, and how. The defaults suit most maps.
///
/// Without solidWithoutShapes, solidIf, objects and tiles the map itself decides what is solid, by the strongest
/// evidence that there is in it: 1. shapes of tiles, and layers, classes and properties that say collision, all
/// together; 2. those that say ground or wall; 3. the only tile layer, if it is half empty. What is deadly or passable
/// is left out. docs/maps.md, "What is taken without options", has the words. Report::choice says what was taken. The
/// next best choice is tried as well, so that takes twice as long. `layers` narrows where that is looked for. With any
/// of the four nothing is chosen: they hold, and so do the shapes of tiles.
struct Options {
  double tolerance = 1.0;            ///< pixels, finite, 0 or more; at most a quarter of a tile is used
  Outside outside = Outside::carry;  ///< what happens to what reaches out of its cell
  bool solidWithoutShapes = false;   ///< a tile without any collision object is a full square (true) or empty (false)

  /// Properties, "NAME" or "NAME=VALUE". A tile without any collision object is a full square if it or its layer has
  /// one of them. "NAME" alone takes any value but "false" and "0". A tile has its class as a property "class", and a
  /// layer its path as "layer". Unless `objects` names some, objects that have such a property are taken from any
  /// object layer. The report names those properties that nothing has, names and values alike.
  std::vector<std::string> solidIf = {};

  TileTable tiles = {};  ///< shapes of tiles by their numbers; they replace those in the tileset

  /// What is not solid: classes of tiles and values of IntGrid layers, classes and names of shapes and objects, names
  /// of layers, and properties of all of these, as "NAME=VALUE".
  std::vector<std::string> leaveOut = {};

  BlockFrom blockFrom = BlockFrom::one;  ///< where blocks come from

  /// The block for each class, object's name or layer; unused with BlockFrom::one. "" stands for no class. Other names
  /// get the least unused numbers from 1 up, in the order in which the import meets them: first tile layers in the
  /// map's order, and in a layer tiles by rows from the top, then objects. Such numbers may change with an edit of the
  /// map, and the report warns of them. A game that knows a class gives it a number here, or asks for it:
  /// ImportedMap::block("ice").
  std::map<std::string, Block> blocks = {};

  /// Tile layers to import: names or paths ("Group/Layer") of layers or groups; in worlds and LDtk projects also of
  /// maps or levels, and paths may begin with them or not. Empty means all tile layers. A name that fits none is an
  /// error.
  std::vector<std::string> layers = {};

  /// Object layers to import: names or paths of layers or groups, or classes or names of objects, which then are taken
  /// from any layer; an empty list takes none. A name that fits none is an error. Without a list, all are taken whose
  /// name, class or property says that they are solid. If `layers` has names, they must also be in a group that it
  /// names.
  std::optional<std::vector<std::string>> objects = {};

  bool visibleOnly = false;  ///< hidden layers and objects, and what is in hidden groups, are left out

  /// Pixels, finite, 0 or more. If more, each segment of an open polyline becomes a polygon: what lies up to so many
  /// pixels below it, or right of it if it is steeper than 45°.
  double polylineThickness = 0;

  /// The folder in which, or below which, the files lie that the map names. Empty: the map's folder; or, if importMap()
  /// reads from the disk, the project's: projectFolder(). Nothing is read by a name that leads out of it, by
  /// an absolute one or one without the extension of its kind: a tileset is then as one that is missing, and a map or
  /// level is an error. So are symbolic links out of it on the disk. Errors quote no text
  /// of files other than the map's own: an untrusted map could name private files.
  std::string filesIn = {};

  /// The map is trusted: the files that it names may lie anywhere that the reader reads, and have any name.
  bool filesAnywhere = false;

  /// A map of a world that cannot be read is an error. Otherwise the report names it, and the others are imported.
  bool allMaps = false;

  /// Limits. A map that goes beyond one of them is an error.
  std::size_t maxTiles = std::size_t{1} << 24;       ///< of the imported layers together, with the empty ones
  std::size_t maxPlacements = std::size_t{1} << 24;  ///< polygons before overlaps are taken away
  std::size_t maxBytes = std::size_t{1} << 27;       ///< of all files together; one that is read again counts again

  /// Limits of what is not to be seen from the number of tiles and polygons. Each byte that is read adds to them, so
  /// what a map costs is in proportion to its size: docs/maps.md, "What a map may cost".
  std::size_t maxObjectCells = std::size_t{1} << 20;  ///< cells of the bounding boxes of all shapes together
  std::size_t maxWork = std::size_t{1} << 28;         ///< steps: of outlines that meet, shape by shape, cell by cell
};

/// The options with the choice that a suggestion is.
Options chosen(Options options, const Suggestion& suggestion);

/// Why a map could not be read. If only a part is unusable, it is left out, and the report has a note instead.
struct ImportError {
  std::string file;         ///< the file that is to blame
  int line = 0;             ///< from 1; 0: no line is to blame
  std::string element;      ///< such as "<layer> 'Ground'", in JSON "layers/2 'Ground'"; may be empty
  std::string what;         ///< what is wrong and what to do
  std::string option = {};  ///< the field of Options that decides, such as "maxTiles"; may be empty
};

/// "FILE:LINE: element: what is wrong (Options::maxTiles)"
std::string message(const ImportError& error);

/// MapPolygon::tile for a polygon from an object layer.
inline constexpr std::uint32_t kNoTile = ~std::uint32_t{0};

/// One polygon in a cell.
struct MapPolygon {
  Cell cell;                 ///< where
  Block block = 1;           ///< what Options::blockFrom asks for
  std::uint32_t shape = 0;   ///< index in ImportedMap::shapes
  std::uint32_t tile = 0;    ///< index in Report::tiles, or kNoTile
  std::uint32_t object = 0;  ///< id of the collision object; 0 for a full square that Options asked for
  std::uint32_t layer = 0;   ///< index in Report::layers
};

/// What importMap() makes of a map.
struct ImportedMap {
  std::vector<std::vector<LocalPoint>> shapes;  ///< distinct polygons; for World::shape() or World::add()
  std::vector<MapPolygon> placements;           ///< sorted by cell (j, then i), and in a cell as they were placed
  std::map<std::string, Block> blocks;          ///< of all names in Options::blocks, and of those that the import met
  Report report;                                ///< what came in, and what was left out or changed

  /// The block of a class, or of a layer by its path; "" stands for no class. Nothing if the map does not use the name
  /// and Options::blocks does not have it; with BlockFrom::one there are no names.
  std::optional<Block> block(const std::string& name) const;
};

/// How a FileReader begins the reason why it has no such file.
inline constexpr std::string_view kNoSuchFile = "there is no such file";

/// Returns the content of a file, or says why it can not. importMap() calls it with the map's path, and then with the
/// path of each tileset, template, map or level: its name in the map, appended to the map's folder. A reader of your
/// own can serve files from memory; then an import touches no file.
///
/// Maps are untrusted, and so are the names in them. Without Options::filesAnywhere and Options::filesIn a reader
/// is asked only for the map's path and for paths that lie below the map's folder as they are written: without "..",
/// with slashes only. A reader of a server's disk must not follow links out of the folder, nor open what is no regular
/// file, as it may block; readerBelow() is such a reader. What a reader says of a file that it can not read becomes
/// part of the error. What it throws comes out of importMap(), and nothing is leaked; so it is with a FolderLister.
///
/// A reason that begins with kNoSuchFile says that the file is missing. A tileset that is missing loses its shapes and
/// properties, and a world its map; the report says so. Any other reason is an error of the import.
using FileReader = std::function<tl::expected<std::string, std::string>(const std::string& path)>;

/// Returns the names of the files in a folder, without that of the folder, in any order; or says why it can not. Only a
/// world with patterns of file names needs it. importMap() calls it at most once, with the world's folder ("." if its
/// path has none), and sorts what comes back.
using FolderLister = std::function<tl::expected<std::vector<std::string>, std::string>(const std::string& folder)>;

/// Reads a regular file of at most 1 GiB from the disk. It never waits: a pipe or a device is an error.
tl::expected<std::string, std::string> readFile(const std::string& path);

/// A reader for regular files in a folder of the disk and below it, which may be absolute or not. Paths begin with the
/// folder, as it is given here. It follows symbolic links that stay below the folder, and no others.
FileReader readerBelow(const std::string& folder);

/// Lists a folder of the disk.
tl::expected<std::vector<std::string>, std::string> listFolder(const std::string& path);

/// Reads a map, world or LDtk project, and what it names. The first problem that spoils the map is the error. With a
/// reader and no lister, a world with patterns is an error.
tl::expected<ImportedMap, ImportError> importMap(const std::string& path, const Options& options,
                                                 const FileReader& reader, const FolderLister& lister = {});

/// The folder of the project that a map belongs to: the nearest one upwards that has a Tiled or LDtk project, a `.git`,
/// or what marks the root of a game's project, such as `package.json`, `project.godot` or a `.sln`. Without any it is
/// two folders above the map's. It is never above the home folder, and never the root of the disk.
std::string projectFolder(const std::string& map);

/// The same from the disk: with readFile for the map and, with Options::filesAnywhere, for all files; otherwise with
/// readerBelow for what the map names. A file whose name differs by upper and lower case alone will do, with a note.
tl::expected<ImportedMap, ImportError> importMap(const std::string& path, const Options& options = {});

}  // namespace lgs::tiled
