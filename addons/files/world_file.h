// A world in a file, chunk by chunk: so that a game saves what changed, and loads what it comes near to.
//
//   auto file = world_file::WorldFile::open("cave.lgsw");       // made, if it is not there
//   if (const auto done = file->save(world, hashes, cells); !done) …  // what differs from the file: all, or nothing
//   if (const auto done = file->load(world, cells); !done) …          // the ground of these chunks
//
// The container is SQLite: it writes a change as a whole whenever the program or the machine stops, other programs can
// read the file, and it comes with Debian. A chunk is a row: its place, its hash (<lgs/hashes.h>), which is the
// checksum, and its polygons and blocks. Handles are not in it: a loaded chunk has new ones. World::save() keeps them.
#pragma once

#include "addons/sync/ground.h"

#include <lgs/hashes.h>
#include <lgs/world.h>
#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

struct sqlite3;

namespace world_file {

/// What went wrong, in words.
using Done = tl::expected<void, std::string>;

/// A chunk of 32×32 cells in a file, by its lower-left cell.
struct Stored {
  lgs::Cell corner;
  std::uint64_t hash = 0;
  std::size_t bytes = 0;
  bool isGood = true;  ///< of check(): whether the bytes are those of ground with this hash
};

class WorldFile {
 public:
  static constexpr int kVersion = 1;  ///< of the format; a file of another one is refused, with both named

  /// A file that is not there, or is empty, is made. Refused: an empty path, and what is no such file, or cannot be
  /// opened. Waits for other programs only to make it.
  static tl::expected<WorldFile, std::string> open(const std::filesystem::path& path);

  /// Writes the chunks that have a cell of a rectangle and whose hashes are not those in the file. When it returns they
  /// are there, whatever happens then; or none of them is, and the reason is returned. Unloaded chunks stay in the file
  /// as they are. Forgotten ones (World::forgetChunks()) count as empty, and are removed: so keep to the rectangle that
  /// is in memory. No edit may be pending, and `hashes` are those of the world, as of its last commit: of a chunk that
  /// is to be written others are refused. Cost: in proportion to the chunks that differ, and to those there are in the
  /// rectangle.
  [[nodiscard]] Done save(const lgs::World& world, const lgs::GroundHashes& hashes, const lgs::CellRect& cells);

  /// Puts the ground of the chunks that have a cell of a rectangle in the place of what stands there: all of them or
  /// none. The next commit reports it. A damaged chunk is refused, and so is one that is unloaded.
  [[nodiscard]] Done load(lgs::World& world, const lgs::CellRect& cells) const;

  /// All chunks, by column, then by row; or why they cannot be read.
  tl::expected<std::vector<Stored>, std::string> chunks() const;
  /// The same, each read and compared with its hash; and what SQLite says of its file, where that is not "ok".
  std::vector<Stored> check(std::string& complaint) const;
  /// Removes the chunks that are damaged: the file can be read then. Returns how many.
  tl::expected<std::size_t, std::string> repair();

 private:
  struct Close {
    void operator()(sqlite3* file) const;
  };
  explicit WorldFile(std::unique_ptr<sqlite3, Close> file) : file_(std::move(file)) {}

  std::unique_ptr<sqlite3, Close> file_;
};

}  // namespace world_file
