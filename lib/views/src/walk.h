// Walks through an island, from polygon to polygon.
#pragma once

#include <lgs/world.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace lgs::detail {

struct Standing {
  Cell cell;
  PlacedPolygon polygon;
};

/// What holds two polygons together.
enum class Contact : bool { point, edge };

/// The polygon whose edge a segment is a part of, as the world is now; nothing, if there is none.
std::optional<Standing> ownerOf(const World& world, const Segment& segment);

class Walk {
 public:
  /// All polygons that hang together with this one, by cell (j, then i) and handle. Valid until the next walk or edit.
  const std::vector<Standing>& from(const World& world, const Standing& start, Contact contact);

  /// How many polygons all walks have found.
  std::uint64_t walked() const { return walked_; }

 private:
  std::vector<Standing> found_;
  std::vector<PlacedPolygon> held_;
  std::uint64_t walked_ = 0;
};

}  // namespace lgs::detail
