// The options of a terrain, and the materials of its blocks. Both are the same for every Box2D, except for what a
// Material is.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lgs::box2d {

/// What a sync does with bodies that new ground would overlap (law 13): dynamic bodies whose centre was free.
enum class OnOverlap : std::uint8_t {
  push,     ///< pushes them out, along a shortest path that crosses no edge of the old outline; or disables them. It
            ///< knows no other terrain: where two may touch take `disable`
  disable,  ///< disables them until they are free where they are, or until they can be pushed
  leave,    ///< leaves them: they fall through the ground
};

/// A value outside its range is a mistake of the program: an assertion fails. With NDEBUG the behaviour is undefined.
template <class Material>
struct BasicTerrainOptions {
  double cellSize = 1;  ///< metres; finite, at least 2e-6
  Cell origin = {};     ///< its lower left corner is (0, 0) of the physics world; best where most things happen
  std::int32_t chunkCells = 16;           ///< each square of so many cells by as many is a body, 1 … 4,096
  bool merge = false;                     ///< collinear neighbours of equal material in a chunk become one edge
  OnOverlap onOverlap = OnOverlap::push;  ///< what a sync does with bodies in new ground
  std::function<Material(Block)> material =
      {};  ///< called once for each block, and again after materialsChanged(); empty: the defaults for all blocks
};

/// The materials of the blocks, with numbers from 0 up. Equal materials have the same number.
template <class Material>
class Materials {
 public:
  /// `of` returns what a block is like, and is called once for each. If it is empty, all are like the default.
  explicit Materials(std::function<Material(Block)> of) : of_(std::move(of)) {}

  /// The number of a block's material. Calls the game's function when it first meets the block.
  std::uint32_t number(Block block) {
    const auto [entry, isNew] = numbers_.try_emplace(block);
    if (isNew) {
      const Material material = of_ ? of_(block) : Material{};
      const auto known = std::find(materials_.begin(), materials_.end(), material);
      entry->second = static_cast<std::uint32_t>(known - materials_.begin());
      if (known == materials_.end()) materials_.push_back(material);
    }
    return entry->second;
  }

  /// Forgets what it was given: the materials may have changed.
  void askAgain() {
    numbers_.clear();
    materials_.clear();
  }

  /// The material of a block. Valid until the next block is met.
  const Material& of(Block block) { return materials_[number(block)]; }

 private:
  std::function<Material(Block)> of_;
  std::vector<Material> materials_;  // by number
  std::unordered_map<Block, std::uint32_t> numbers_;
};

}  // namespace lgs::box2d
