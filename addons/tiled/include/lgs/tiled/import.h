// Maps of Tiled and LDtk as polygons in cells, ready for lgs::World.
//
//   const auto map = lgs::tiled::importMap("level1.tmx");
//   if (!map) return puts(lgs::tiled::message(map.error()).c_str());
//   for (const auto& p : map->placements) world.add(p.cell, map->shapes[p.shape], p.block);
//
// The content of a file says what it is, not its name. docs/maps.md is the manual: what is taken as solid, where it lands,
// what snaps, what is left out and what an import may cost.
//
// WHAT COMES OUT. Every placement is simple, counter-clockwise, inside its cell, disjoint from the others of its cell,
// and within World's limits for a cell. So World::add accepts all of them. What is placed first stays: first the polygons
// of tiles in their own cells, layer by layer from the bottom to the top, then their parts in other cells, then the
// objects in the map's order. Where edges cross the grid or each other the rounding is that of a brush (lgs/brush.h).
//
// ERRORS. An error is a value. Maps need not be trusted: SECURITY.md. When memory runs out std::bad_alloc comes, and
// nothing is leaked; only where objects are painted the brushes end the program, as they always do then.
//
// COST. Linear in the number of tiles, and in that of the cells that objects reach; a brush takes some 0.2 ms for each
// combination of tiles that lie on each other.
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

/// A polygon with more vertices than this is left out; so is an outline that crosses itself more often, and what crosses
/// what is in a cell already.
inline constexpr std::size_t kMaxObjectVertices = 1'024, kMaxCrossings = 1'024;

/// What each byte that is read adds to Options::maxWork and Options::maxObjectCells.
inline constexpr std::size_t kWorkPerByte = 1'024, kObjectCellsPerByte = 256;

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
/// that of each tileset, template, map or level: its name in the map, appended to the map's folder. One of your own can
/// serve files from memory; then an import touches no file.
///
/// Maps are untrusted, and so are the names in them: docs/maps.md, "Untrusted maps", says which a reader is asked for. A
/// reader of a server's disk must not follow links out of the folder, nor open what is no regular file, as it may block;
/// readerBelow() is such a reader. What it throws comes out of importMap(), and nothing is leaked; so it is with a
/// FolderLister.
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

/// The folder of the project that a map belongs to: docs/maps.md, "Untrusted maps".
std::string projectFolder(const std::string& map);

/// The same from the disk: with readFile for the map and, with Options::filesAnywhere, for all files; otherwise with
/// readerBelow for what the map names. A file whose name differs by upper and lower case alone will do, with a note.
tl::expected<ImportedMap, ImportError> importMap(const std::string& path, const Options& options = {});

}  // namespace lgs::tiled
