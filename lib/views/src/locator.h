// Which island a polygon, or a hole, belongs to: a ray to the west meets the outline. If that is an outer loop, it is
// the answer. If it is a hole, that hole belongs to the same island, and the search goes on from its westernmost
// vertex. The ray runs half a unit above a row of lattice points, so it never meets a vertex.
//
// A ray that comes to an unloaded chunk, or to a chain that leads into one, ends there: the null loop.
//
// A locator remembers where holes led to, and what the last ray of each row came to. So many rays that follow each other
// cost little more than the longest one. It lives no longer than the loops stay as they are.
#pragma once

#include <lgs/loops.h>

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace lgs::detail {

class Locator {
 public:
  Locator(const World& outline, const Loops& loops) : outline_(outline), loops_(loops) {}

  /// The outer loop of the island of a polygon, which stands in the outline's world since its last commit. Of another one
  /// it is any loop, or null. Null, if it hangs together with ground in an unloaded chunk, unless its outer loop runs
  /// around that chunk.
  LoopId ofPolygon(Cell cell, std::span<const LocalPoint> vertices);

  /// The outer loop of the island of a loop: itself, if it is one.
  LoopId ofLoop(LoopId loop);

 private:
  /// Where an edge crosses the row half a unit above y: in its cell, as a fraction.
  struct Crossing {
    std::int64_t y = 0;
    std::int32_t i = 0;
    std::int64_t numerator = 0, denominator = 1;
    std::strong_ordering operator<=>(const Crossing& c) const {
      if (const auto order = i <=> c.i; order != 0) return order;
      return numerator * c.denominator <=> c.numerator * denominator;
    }
    bool operator==(const Crossing& c) const { return (*this <=> c) == 0; }
  };

  static std::optional<Crossing> crossing(std::int64_t y, Cell cell, Point start, Point end);
  LoopId throughHoles(LoopId loop, std::vector<LoopId>& passed);
  LoopId leftWestOf(const Crossing& from);
  std::optional<Crossing> wallWestOf(const LoopFacts& hole) const;
  std::int32_t lastUnloaded(std::int32_t first, std::int32_t last, std::int32_t j) const;

  /// Cells that a ray went all through, and the loop through which it left the island then.
  struct Passage {
    std::int32_t first = 0, last = -1;
    LoopId loop;
  };
  using Numbers = std::unordered_map<std::uint64_t, std::uint32_t>;

  const World& outline_;
  const Loops& loops_;
  Numbers outers_;  ///< the outer loop of a hole, by LoopId
  Numbers rows_;    ///< the last ray's place in passages_, by Crossing::y
  std::vector<Passage> passages_;
};

}  // namespace lgs::detail
