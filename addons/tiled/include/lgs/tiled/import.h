// Maps of Tiled and LDtk as polygons in cells, ready for lgs::World.
//
//   const auto map = lgs::tiled::importMap("level1.tmx");
//   if (!map) return puts(lgs::tiled::message(map.error()).c_str());
//   for (const auto& p : map->placements) world.add(p.cell, map->shapes[p.shape], p.block);
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
// cell (c, -1 - r), in finite and infinite maps alike. A tile whose image is larger than the grid has its lower left
// corner in that of its cell, as Tiled draws it. The offset of a layer includes those of its groups, and of its map in a
// world or of its level. The whole tiles in it move the layer by as many cells. The rest makes the layer's polygons
// reach out of their cells.
//
// HAND-DRAWN SHAPES. Each coordinate that misses a grid line by at most `Options::tolerance` pixels moves onto the
// line, then it is rounded once, to the nearest lattice unit. If that brought sides of a simple shape onto each other,
// none of its vertices snaps, and the report has a note. An outline may cross itself: inside is what Tiled fills. Shapes
// are cut along the grid; what lies of a tile's shapes in other cells goes there. Where edges cross the grid or each
// other the rounding is that of a brush (lgs/brush.h), at most one lattice unit.
//
// OVERLAPS. What is placed first stays, and what comes later loses the part that is covered already: first the polygons
// in their own cells, layer by layer from the bottom to the top, then the parts in other cells, then the objects of
// object layers in the map's order. What is narrower than some units is dropped.
//
// WHAT COMES OUT. Every placement is simple, counter-clockwise, inside its cell, disjoint from the others of its cell,
// and within World's limits for a cell. So World::add accepts all of them.
//
// ERRORS. An error is a value. When memory runs out std::bad_alloc comes, and nothing is leaked; only where objects are
// painted the brushes end the program, as they always do then. Maps need not be trusted: sizes are checked before
// memory is taken, work is counted and refused before it is done, and nothing recurses without a limit.
//
// COST. Linear in the number of tiles, and in that of the cells that objects reach. Polygons are compared once for each
// combination of tiles that meet in a cell; one of polygons that lie on each other takes a brush some 0.2 ms. Whatever
// is in the files, an import takes work and memory in proportion to their bytes, beyond the limits of Options.
#pragma once

#include <lgs/tiled/report.h>

#include <functional>
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

/// Reads a table as docs/maps.md, "Tiles by their numbers", describes it. Refused: a bad line, as "LINE: what is wrong".
tl::expected<TileTable, std::string> parseTileTable(std::string_view text);

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
  Block block = 1;           ///< what Options::blockFrom requests
  std::uint32_t shape = 0;   ///< index in ImportedMap::shapes
  std::uint32_t tile = 0;    ///< index in Report::tiles, or kNoTile
  std::uint32_t object = 0;  ///< id of the collision object; 0 for a full square that Options requested
  std::uint32_t layer = 0;   ///< index in Report::layers

  friend auto operator<=>(const MapPolygon&, const MapPolygon&) = default;
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

/// Returns the content of a file, or the reason why it can not. importMap() calls it with the map's path, and then with
/// the path of each tileset, template, map or level: its name in the map, appended to the map's folder. A reader of
/// your own can serve files from memory; then an import touches no file.
///
/// Maps are untrusted, and so are the names in them. Without Options::filesAnywhere and Options::filesIn a reader
/// is called only for the map's path and for paths that lie below the map's folder as they are written: without "..",
/// with slashes only. A reader of a server's disk must not follow links out of the folder, nor open what is no regular
/// file, as it may block; readerBelow() is such a reader. The reason that a reader returns becomes part of the
/// error. What it throws comes out of importMap(), and nothing is leaked; so it is with a FolderLister.
///
/// A reason that begins with kNoSuchFile means that the file is missing. A tileset that is missing loses its shapes and
/// properties, and a world its map; the report has a note. Any other reason is an error of the import.
using FileReader = std::function<tl::expected<std::string, std::string>(const std::string& path)>;

/// Returns the names of the files in a folder, without that of the folder, in any order; or the reason why not. Only a
/// world with patterns of file names needs it. importMap() calls it at most once, with the world's folder ("." if its
/// path has none), and sorts what comes back.
using FolderLister = std::function<tl::expected<std::vector<std::string>, std::string>(const std::string& folder)>;

/// Reads a regular file of at most 1 GiB from the disk, and returns its content. It never waits. Refused: all else, such
/// as a pipe or a device.
tl::expected<std::string, std::string> readFile(const std::string& path);

/// A reader for regular files in a folder of the disk and below it, which may be absolute or not. Paths begin with the
/// folder, as it is given here. It follows symbolic links that stay below the folder, and no others.
FileReader readerBelow(const std::string& folder);

/// Returns the names of the files in a folder of the disk. Refused: what is none, or may not be read.
tl::expected<std::vector<std::string>, std::string> listFolder(const std::string& path);

/// Reads a map, world or LDtk project, and what it names. Returns the polygons and the report. Refused: the first
/// problem that spoils the map is the error. With a reader and no lister, a world with patterns is refused.
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
