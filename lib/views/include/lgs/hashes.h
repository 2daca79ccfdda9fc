// Hashes of the ground, kept up to date at the cost of the edit: whether two worlds hold the same, and where they
// differ. So two ends of a line find out with a few numbers what one of them missed (docs/sync.md).
//
//   if (const auto done = world.followCells(true); !done) return refused(done.error());
//   lgs::GroundHashes hashes(world);       // reads all polygons once
//   if (!hashes.update(world, world.commit()))   // after each commit(), rollBack() and redo()
//     hashes = lgs::GroundHashes(world);         // one was missed
//   if (hashes.hash() != theirs) …         // then some square differs: compare those of the next level
//
// What a hash is:
//
//  1. A polygon has one of 64 bits, of its cell, its block and its vertices, read from the least one on (by x, then by
//     y). Start with h = 0 and take over one word after the other, h = mix(h xor word): i · 2^32 + j of the cell, each
//     in 32 bits of two's complement; block · 2^32 + number of vertices; then for each vertex x · 2^32 + y. `mix` is
//     fmix64, the finaliser of MurmurHash3 (Appleby, in the public domain).
//  2. Some ground has the sum of the hashes of its polygons, modulo 2^64. Where there is none it is 0.
//
// So it follows from the polygons and blocks alone: not from handles, nor from what was edited before, nor from the
// machine or the version of this library. It agrees with samePolygons(): equal ground has equal hashes. Ground that
// differs by chance has equal hashes once in 2^64. Such ground can be made up: these hashes find faults, and keep no
// liar out.
//
// Ground is divided into squares. One of level 0 is a chunk of 32×32 cells; one of level k + 1 are 4×4 of level k. The
// only one of level kTopLevel is the world. The square of level k with the origin reaches (4^k − 1) / 3 chunks to the
// left and below: so around the origin no border of a large one gets in the way.
//
// A GroundHashes is one value with one owner. A copy of a world goes on with a copy of its hashes. Calls that are const
// are safe beside each other. All functions are noexcept: when memory runs out the program ends.
#pragma once

#include <lgs/world.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lgs {

/// A square of cells and its hash. The comment at the top of this file says which there are.
struct HashedSquare {
  int level = 0;           ///< 0 … GroundHashes::kTopLevel
  CellRect cells;          ///< its cells, as far as they are in range
  std::uint64_t hash = 0;  ///< of what is in it
  friend constexpr bool operator==(const HashedSquare&, const HashedSquare&) = default;
};

/// The hashes of a world. The comment at the top of this file says how they are kept up to date.
class GroundHashes {
 public:
  static constexpr int kTopLevel = 14;            ///< of the square with all cells
  static constexpr std::int32_t kChunkSide = 32;  ///< cells along a square of level 0

  /// Reads all polygons of a world, which has no edits that are not committed. Cost: in proportion to its polygons and
  /// vertices.
  explicit GroundHashes(const World& world) noexcept;
  ~GroundHashes() noexcept = default;
  GroundHashes(const GroundHashes& other) noexcept = default;             ///< cost: in proportion to its squares
  GroundHashes& operator=(const GroundHashes& other) noexcept = default;  ///< the same
  GroundHashes(GroundHashes&&) noexcept = default;
  GroundHashes& operator=(GroundHashes&&) noexcept = default;

  /// Takes over what the world's last commit, roll-back or redo changed. False, and nothing changes, if
  /// `changes` are not those of it, or do not lead from the version that was seen last, as one was missed, or if the
  /// world does not follow its cells: then begin again. Cost: in proportion to the polygons and vertices of the changed
  /// cells. A search for the worst commit found some 180 basic blocks for each vertex and cell; a test holds it below
  /// 400. It looks at no other cell.
  [[nodiscard]] bool update(const World& world, const Changes& changes) noexcept;

  /// The same of some cells alone, whichever they are: nothing is checked. For code that keeps hashes of ground that is
  /// not in memory, and uses no other form.
  void update(std::span<const CellChange> changes) noexcept;

  /// From now on the hash of a chunk, by any cell of it in range, is this one: for code that keeps hashes of ground
  /// that is not in memory, or finds that it came back as something else. Cost: O(1).
  void set(Cell chunk, std::uint64_t hash) noexcept;

  /// That of the whole world. Cost: O(1).
  std::uint64_t hash() const noexcept;

  /// The squares of a level that have a cell of a rectangle, and whose hash is not 0: four by four as those of the next
  /// level have them, by rows. With a level out of range there are none. Cost: in proportion to the squares found, of
  /// this level and those above.
  std::vector<HashedSquare> hashes(const CellRect& cells, int level = 0) const noexcept;

  /// The least square that all ground lies in; in an empty world the chunk of the origin. Cost: O(1).
  HashedSquare whole() const noexcept;

  /// The chunks whose ground differs, in the order of hashes(): their cells. Cost: in proportion to these, as it looks
  /// into a square only if its hashes differ.
  friend std::vector<CellRect> differences(const GroundHashes& a, const GroundHashes& b) noexcept;

  /// The square of a level that has a cell, or the cell in range that is nearest to it; the hash is 0.
  static HashedSquare square(Cell cell, int level) noexcept;

  std::uint64_t bytes() const noexcept;  ///< allocated, with spare capacity

 private:
  /// A square above level 0: its 16 parts, by rows.
  struct Node {
    std::array<std::uint64_t, 16> hash{};
    std::array<std::uint32_t, 16> below{};  ///< their nodes; kNothing for chunks, and where nothing is
  };
  static constexpr std::uint32_t kNothing = 0, kWorld = 1;  ///< the first two nodes: one that stays empty, and the root
  /// A square as they are gone through.
  struct Place {
    std::uint32_t x = 0, y = 0;  ///< of its lower-left chunk, counted from the corner of the world's square
    int level = 0;
    Place part(std::size_t k) const;
    HashedSquare withHash(std::uint64_t hash) const;
  };
  static Place placeOf(Cell cell, int level);

  void add(Cell cell, const PlacedPolygon& polygon, bool comes);
  void add(Cell cell, std::uint64_t hash);
  bool addTo(std::uint32_t node, int level, const Place& chunk, std::uint64_t hash);
  std::uint32_t newNode();
  void collect(std::uint32_t node, std::uint64_t hash, const Place& at, const std::array<Place, 2>& corners, int level,
               std::vector<HashedSquare>& out) const;
  static void collect(const GroundHashes& a, std::uint32_t nodeOfA, const GroundHashes& b, std::uint32_t nodeOfB,
                      const Place& at, std::vector<CellRect>& out);

  std::uint64_t hash_ = 0;
  std::uint64_t version_ = 0;  ///< of the world, as of the last update
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> free_;  ///< nodes that are not in the tree
};

std::vector<CellRect> differences(const GroundHashes& a, const GroundHashes& b) noexcept;

/// The hash of the polygons in a rectangle of cells, computed from nothing, after all edits, committed or not: for
/// parts of a chunk, of which no hash is kept. Cost: that of World::forEachPolygon(), and the vertices there.
std::uint64_t groundHash(const World& world, const CellRect& cells) noexcept;

}  // namespace lgs
