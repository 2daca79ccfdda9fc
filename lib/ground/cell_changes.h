// What a commit or a roll-back changed, cell by cell, as values. The vertices are copies: contents may be forgotten,
// and a world may be copied.
#pragma once

#include "ground/ground.h"

#include <lgs/world.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lgs::detail {

class CellChanges {
 public:
  CellChanges() = default;
  CellChanges(const CellChanges& other) : changes_(other.changes_), polygons_(other.polygons_) { own(); }
  CellChanges& operator=(const CellChanges&) = delete;
  ~CellChanges() = default;

  std::span<const CellChange> all() const { return changes_; }

  void clear();
  /// What is different between a commit, which the journal knows, and the ground as it is. By a commit or by going forth
  /// the world went from the former to the latter; by going back, the other way. Of a chunk that is, or was, unloaded
  /// nothing is told.
  enum class Way : std::uint8_t { commit, back, forth };
  void read(const Ground& ground, Journal::Moment commit, Way way);

  std::uint64_t bytes() const;

 private:
  /// After the last one own() must be called. Until then the vertices must stay where they are.
  void add(Cell cell, std::span<const PlacedPolygon> before, std::span<const PlacedPolygon> now);
  /// Copies all vertices, and makes every span one of what is kept here.
  void own();

  std::vector<CellChange> changes_;
  std::vector<PlacedPolygon> polygons_;  ///< of each change those before and those of now, one behind the other
  std::vector<LocalPoint> vertices_;     ///< of each polygon, one behind the other
};

}  // namespace lgs::detail
