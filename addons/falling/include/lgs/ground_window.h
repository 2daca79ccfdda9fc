// Which part of a Ground is in memory, and the land that is made there.
#pragma once

#include <lgs/ground_parts.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace lgs {

/// The cells of the chunk that a cell is in, as far as they are in range.
[[nodiscard]] CellRect chunkAround(Cell cell);

/// The lower-left cells of the chunks with a cell of a rectangle, and of those one chunk further.
[[nodiscard]] std::vector<Cell> chunksAround(const CellRect& cells);
/// The least rectangle around two.
[[nodiscard]] CellRect boxOf(const CellRect& a, const CellRect& b);
/// All chunks out of a rectangle of whole chunks leave memory.
void unloadOutside(World& world, const CellRect& chunks, const Shelf& shelf) noexcept;
/// Those in it come back, at most so many, from which those are taken off that did; false where some are still away, as
/// the shelf did not give one or there are more.
[[nodiscard]] bool reloadInside(World& world, const CellRect& chunks, const Shelf& shelf, std::size_t& most) noexcept;

namespace detail {

/// What is to be done before an edit that makes the land of a chunk.
using BeforeLand = std::function<void(const CellRect& chunk)>;

class GroundWindow {
 public:
  /// The options must outlive it and stay where they are.
  explicit GroundWindow(const GroundOptions& options) : options_(options) {}

  const CellRect& cells() const { return window_; }  ///< of whole chunks
  bool isWhole() const { return isWhole_; }          ///< whether nothing is to come or go
  /// Whether land that would hold what is in memory may not be made yet, after a load.
  bool mayLackLand() const { return mayLackLand_; }

  /// Whether it has the chunks around these cells from now on, and some are to come or to go.
  bool moveTo(const CellRect& cells);
  /// Brings in and takes out what may be at once. New land is made after the mark `now`.
  void stream(World& world, std::int64_t now, const BeforeLand& beforeLand);
  /// After a load.
  void restart(std::span<const Cell> land);

  // --- Land

  /// The lower left cell of the first chunk of these cells of which the land is not made yet.
  std::optional<Cell> firstWithoutLand(const CellRect& cells) const;
  std::vector<Cell> land() const { return {made_.begin(), made_.end()}; }  ///< chunks whose land was made
  /// An undo to a mark took away land that was made since; at that time nothing was dug there. Whether there was some.
  bool remakeLand(World& world, std::int64_t now, const BeforeLand& beforeLand);
  /// Whether land was made after the mark at which the world is.
  bool hasNew(std::int64_t now) const { return !new_.empty() && new_.back().second == now; }
  void keepNew(std::int64_t now);           ///< what was made after a mark is there at that mark
  void forgetBefore(std::int64_t oldest) {  ///< undo does not go back to what is before this mark
    std::erase_if(new_, [&](const auto& land) { return land.second < oldest; });
  }

 private:
  bool makeLand(World& world, std::int64_t now, const BeforeLand& beforeLand, std::size_t& most);
  bool make(World& world, Cell corner, std::int64_t now, const BeforeLand& beforeLand);
  bool unload(World& world, std::size_t& most);

  const GroundOptions& options_;
  CellRect window_{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};
  CellRect leaving_ = window_;  // what is in memory and not in the window is in it
  bool isWhole_ = false;
  bool mayLackLand_ = false;
  std::set<Cell> made_;
  std::vector<std::pair<Cell, std::int64_t>> new_;  // of these, which an undo may take away, and after which mark
};

}  // namespace detail
}  // namespace lgs
