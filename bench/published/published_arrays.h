// The article's "optimised C++": the published algorithm with "fixed-size arrays and bit-packed vertex representations"
// in the place of hash maps, "to eliminate allocations and hash computations" (section 5.1). That sentence is all that
// the article says of it. "Silent:" marks how the rest was filled in, always in favour of speed.
//
// Silent: how large the arrays are, and how a vertex finds its own. Here the world has a fixed number of cells, and
// each vertex is a corner of a cell, as in both worlds of the article's benchmark: so a vertex packed into 32 bits is
// its place in an array. Other vertices are refused. The 1:1 port (published.h) takes any.
#pragma once

#include "bench/published/published.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lgs::bench {

class PublishedArrays {
 public:
  using Packed = std::uint32_t;  ///< a vertex: x, and y in the upper half
  static constexpr Packed kNone = ~Packed{0};

  struct Segment {
    Packed start = kNone, end = kNone;
    Packed ghost1 = kNone, ghost2 = kNone;
    std::uint32_t cell = 0;
    Block ogBlock = 0;
  };

  PublishedArrays(std::int32_t width, std::int32_t height);

  /// Whether add() takes this polygon: each vertex is a corner.
  static bool takes(std::span<const Vec2> polygon);
  void add(Cell cell, std::span<const Vec2> polygon, Block block);
  void remove(Cell cell, std::span<const Vec2> polygon, Block block);
  void compute();

  static Vec2 unpacked(Packed v) { return {static_cast<float>(v & 0xffff), static_cast<float>(v >> 16)}; }
  template <class Visit>
  void forEachSegment(Visit&& visit) const {
    for (std::size_t at = 0; at < manifold_.size(); ++at)
      for (const Index k : manifold_[at])
        if (cornerOf(pool_[k].start) == at) visit(pool_[k]);
  }

 private:
  using Index = std::uint32_t;  ///< of a segment in the pool

  /// A list in a fixed array.
  template <std::size_t N>
  class Few {
   public:
    void push_back(Index k) { items_[count_++] = k; }
    void erase(Index k) {
      for (std::uint32_t at = 0; at < count_; ++at)
        if (items_[at] == k) items_[at--] = items_[--count_];
    }
    void clear() { count_ = 0; }
    const Index* begin() const { return items_.data(); }
    const Index* end() const { return items_.data() + count_; }
    std::uint32_t size() const { return count_; }
    Index operator[](std::size_t at) const { return items_[at]; }

   private:
    std::uint32_t count_ = 0;
    std::array<Index, N> items_;
  };

  /// The places that are dirty, each once.
  struct Dirty {
    std::vector<std::uint8_t> is;
    std::vector<std::uint32_t> places;
    void insert(std::uint32_t place) {
      if (is[place] == 0) places.push_back(place);
      is[place] = 1;
    }
    void clear() {
      for (const std::uint32_t place : places) is[place] = 0;
      places.clear();
    }
  };

  // One polygon in a cell: so each of the two cells at a side has one edge there, and at a corner meet at most two
  // segments of each of four sides and one diagonal of each of four cells.
  struct Boundary {
    Few<2> segs, resolved;
  };

  std::uint32_t cornerOf(Packed v) const { return (v >> 16) * (width_ + 1) + (v & 0xffff); }
  /// Sides along x first, then those along y. Negative for an interior edge.
  std::int64_t sideOf(Packed start, Packed end) const;
  Index make(const Segment& segment);
  void insertIntoManifold(Index k);
  void removeFromManifold(Index k);
  void removeResolved(Boundary& boundary);
  void resolve(Boundary& boundary);
  void assignGhostVertices(std::uint32_t corner);

  std::uint32_t width_, height_;
  std::vector<Segment> pool_;
  std::vector<Index> free_;
  std::vector<Boundary> boundaries_;
  std::vector<Few<12>> manifold_;  ///< by corner
  Dirty dirtySides_, dirtyCorners_;
};

}  // namespace lgs::bench
