// Law 14 needs a whole world beside one whose chunks leave memory.
#pragma once

#include "proptests/support/worlds.h"

#include <lgs/loops.h>

#include <cstddef>
#include <set>

namespace lgs::test {

/// Of a chunk by its place, in chunks.
inline CellRect chunkAt(std::int32_t ci, std::int32_t cj) { return {{32 * ci, 32 * cj}, {32 * ci + 31, 32 * cj + 31}}; }

/// So many chunks in a row, full of squares.
World rowOfChunks(std::int32_t chunks);

/// The bytes of chunks, by their lower-left cells, as a game would keep them: the newest last.
class Shelf {
 public:
  ChunkSink sink() {
    return [this](Cell corner, std::span<const std::byte> bytes) {
      chunks_[corner].emplace_back(bytes.begin(), bytes.end());
    };
  }
  /// Brings a chunk back from the newest bytes that fit.
  bool reload(World& world, Cell corner) const {
    const auto found = chunks_.find(corner);
    if (found == chunks_.end()) return false;
    for (auto bytes = found->second.rbegin(); bytes != found->second.rend(); ++bytes)
      if (const auto done = world.reload(*bytes); done) return *done == corner;
    return false;
  }
  const std::vector<std::byte>& newest(Cell corner) const { return chunks_.at(corner).back(); }

 private:
  std::map<Cell, std::vector<std::vector<std::byte>>> chunks_;
};

inline constexpr CellRect kEverywhere{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

/// A segment by what it is, without the names of one world; a handle is such a name where chunks are forgotten.
struct Seen {
  Point start, end;
  Block block = 0;
  Cell cell;
  std::optional<Point> ghost1, ghost2;
  PolygonHandle polygon;
  friend auto operator<=>(const Seen&, const Seen&) = default;
};

Seen seen(const Segment& segment, bool withHandle);
std::multiset<Seen> seen(const World& world, const std::vector<SegmentId>& ids, bool withHandles);

/// What the days may have in them.
struct WithOut {
  bool marks = false;
  bool forgets = false;  ///< then handles differ
  bool preserves = false;
};

/// Edits cells near the borders of 4×4 chunks, in a world that unloads chunks and in one that does not.
class BesideTheWhole {
 public:
  BesideTheWhole(oracle::Random choices, WithOut with);
  void step();
  void commit();
  void bringAllBack();

 private:
  using Polygons = std::map<Cell, std::vector<PolygonFields>>;
  struct Marks {
    Mark part, whole;
    std::set<Cell> loaded;
  };

  std::int32_t coordinate();
  Cell cell();
  CellRect someChunks();
  bool isLoaded(Cell cell) const { return !part_.firstUnloaded({cell, cell}); }
  void edit();
  void editNowhere(Cell cell);
  void turn();
  void goBack();
  void forget();
  static std::vector<Cell> corners();
  std::multiset<Seen> seenIn(const std::set<Cell>& chunks, const World& world, std::vector<SegmentId> ids) const;
  std::set<Cell> loadedChunks() const;
  void expectSameOutline();
  void expectSameGround();
  void expectSameAnswers();
  void follow(const Changes& changes);
  void followCells();
  void expectSameLoops(const Changes& changes);
  Polygons polygonsOf(const World& world) const;

  oracle::Random choices_;
  WithOut with_;
  World part_, whole_;
  std::vector<ShapeId> shapes_;
  Shelf shelf_;
  std::set<Cell> loaded_;  ///< chunks, as of the last commit
  std::map<SegmentId, Segment> copy_;
  std::optional<Loops> loops_;  ///< of the part, unless something is preserved
  Polygons told_;
  bool follows_ = false;
  std::vector<Marks> marks_, ahead_;
};

}  // namespace lgs::test
