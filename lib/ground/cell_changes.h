// What a commit or a roll-back changed, cell by cell, as values. The vertices are copies: contents may be forgotten,
// and a world may be copied. Cells of chunks that leave memory and come back change, too, for followers.
#pragma once

#include "ground/ground.h"

#include <lgs/world.h>

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace lgs::detail {

class CellChanges {
 public:
  CellChanges() = default;
  CellChanges(const CellChanges& other)
      : changes_(other.changes_),
        polygons_(other.polygons_),
        vertices_(other.vertices_),
        wasLoaded_(other.wasLoaded_),
        left_(other.left_) {
    own();
  }
  CellChanges& operator=(const CellChanges&) = delete;
  ~CellChanges() = default;

  std::span<const CellChange> all() const { return changes_; }
  void clear();

  /// A chunk is about to leave: what it held at the last commit can be told later.
  void leaves(const Ground& ground, Journal::Moment commit, std::uint32_t chunk);
  /// A chunk has come back.
  void comesBack(std::uint32_t chunk) { wasLoaded_.emplace(chunk, false); }
  /// Which chunks have left or come back is reported no more.
  void forgetStreamed();

  /// Tells what is different between the ground as it was told last and as it is to be told now. The one is that of a
  /// commit, which the journal knows, the other the ground as it is: the world went from the former to the latter, or
  /// back; or both are that of the commit, and only what is loaded is another.
  enum class Way : std::uint8_t { forth, back, stay };
  void read(Ground& ground, Journal::Moment commit, Way way);

  std::uint64_t bytes() const;

 private:
  struct LeftPolygon {
    PolygonHandle handle;
    Block block = 0;
    std::vector<LocalPoint> vertices;
    std::uint32_t ref() const { return handle.cellRef; }
  };

  bool wasLoaded(const Ground& ground, std::uint32_t chunk) const;
  void readStreamed(const Ground& ground, Journal::Moment commit);
  std::size_t readLeft(std::size_t first, std::vector<PlacedPolygon>& out) const;
  void nameEach(const Ground& ground, std::span<const std::uint32_t> streamed);
  /// After the last one own() must be called. Until then the vertices must stay where they are.
  void add(Cell cell, std::span<const PlacedPolygon> before, std::span<const PlacedPolygon> now);
  /// Copies all vertices, and makes every span one of what is kept here.
  void own();

  std::vector<CellChange> changes_;
  std::vector<PlacedPolygon> polygons_;  ///< of each change those before and those of now, one behind the other
  std::vector<LocalPoint> vertices_;     ///< of each polygon, one behind the other
  std::unordered_map<std::uint32_t, bool> wasLoaded_;  ///< when it was told last; of chunks that were streamed since
  std::vector<LeftPolygon> left_;                      ///< of those that left, each cell's by handle
};

}  // namespace lgs::detail
