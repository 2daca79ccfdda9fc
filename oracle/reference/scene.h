// A scene: the placed polygons of a world at one moment, as plain values. The references compute from scenes. They
// share nothing with the engine but the value types of <lgs/lattice.h> and <lgs/ids.h>.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace lgs::oracle {

/// A polygon in its cell: counter-clockwise, simple, inside the closed cell, interior disjoint from the others'.
struct ScenePolygon {
  Cell cell;
  Block block = 0;
  std::vector<LocalPoint> vertices;
  friend bool operator==(const ScenePolygon&, const ScenePolygon&) = default;
};

/// A symmetric relation on blocks, as a list of pairs. Empty by default.
class PreservePairs {
 public:
  void add(Block a, Block b);  ///< once is enough for both directions; a pair already there is ignored
  bool operator()(Block a, Block b) const;
  bool empty() const { return pairs_.empty(); }
  const std::set<std::pair<Block, Block>>& pairs() const { return pairs_; }  ///< the smaller block first
  friend bool operator==(const PreservePairs&, const PreservePairs&) = default;

 private:
  std::set<std::pair<Block, Block>> pairs_;
};

struct Scene {
  std::vector<ScenePolygon> polygons;
  PreservePairs preserve;
};

/// A partition of a scene's blocks: within one material every overlap is cancelled, between two none is.
struct Materials {
  std::uint32_t count = 0;                                ///< materials are numbered from 0
  std::vector<std::pair<Block, std::uint32_t>> ofBlocks;  ///< every block of the scene with its material, sorted
  std::uint32_t of(Block block) const;                    ///< the block must be one of the scene's
};

/// The scene's materials, or nothing if its preserve relation does not partition the blocks. It does if "not preserved"
/// is an equivalence relation on the blocks of the scene's polygons. (With `preserve(1, 2)` alone it is one in a world
/// of blocks 1 and 2, but not once there is a block 3, which belongs with both.)
std::optional<Materials> materials(const Scene& scene);

}  // namespace lgs::oracle
