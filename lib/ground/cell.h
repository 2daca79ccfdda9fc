// What a cell holds, in one word where that is enough.
//
// The word of a cell is its content and the serial given out last, as long as it has at most one polygon, that polygon
// was placed last, and at most 255 were ever placed there. Otherwise the word refers to a *list* in the arena of lists:
//
//   content << 8 | how many polygons;  the serial given out last;  a serial and a block for each polygon, by slot
#pragma once

#include "ground/catalogue.h"

#include <lgs/world.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace lgs::detail {

/// The polygons of one cell have serial numbers, from 1 on, none used twice. A segment has 28 bits for one.
#ifdef LGS_HANDLES_IN_53_BITS
inline constexpr std::uint32_t kMaxSerial = (1u << 23) - 1;
#else
inline constexpr std::uint32_t kMaxSerial = (1u << 28) - 1;
#endif

/// A polygon in a cell.
struct Placed {
  std::uint32_t serial = 0;
  Block block = 0;
};

/// The word of a cell. A cell that never held anything has 0.
using CellWord = std::uint32_t;
inline constexpr CellWord kListBit = 1u << 31;  ///< the rest refers to a list
inline constexpr unsigned kLowBits = 8;         ///< below the content, in a word and in a list
inline constexpr std::uint32_t kLowMask = (1u << kLowBits) - 1;
static_assert(kMaxPolygonsPerCell <= kLowMask && kMaxContent < kListBit >> kLowBits);

constexpr bool isListed(CellWord word) { return (word & kListBit) != 0; }
constexpr CellWord wordOf(ContentId content, std::uint32_t low) { return content << kLowBits | low; }
/// Whether a word has a polygon, whose block its chunk keeps.
constexpr bool hasSole(CellWord word) { return word > kLowMask && word < kListBit; }
/// Whether a word is enough for these polygons.
constexpr bool fitsWord(std::uint32_t lastSerial, std::span<const Placed> polygons) {
  return lastSerial <= kLowMask && (polygons.empty() || (polygons.size() == 1 && polygons[0].serial == lastSerial));
}

/// What a word stands for. Valid until the cell changes.
class Held {
 public:
  Held() = default;
  /// The block is that of the only polygon, if the word has one; `list` is null, unless the word refers to it.
  Held(CellWord word, Block block, const std::uint32_t* list) : word_(word), block_(block), list_(list) {}

  ContentId content() const { return (list_ ? list_[0] : word_) >> kLowBits; }
  std::uint32_t lastSerial() const { return list_ ? list_[1] : word_ & kLowMask; }
  /// How many polygons there are.
  std::uint32_t size() const { return list_ ? list_[0] & kLowMask : word_ > kLowMask; }
  Placed operator[](std::size_t slot) const {
    return list_ ? Placed{list_[2 + 2 * slot], list_[3 + 2 * slot]} : Placed{word_ & kLowMask, block_};
  }
  /// The list, if there is one.
  std::span<const std::uint32_t> list() const { return {list_, 2 + 2 * size()}; }

 private:
  CellWord word_ = 0;
  Block block_ = 0;
  const std::uint32_t* list_ = nullptr;
};

}  // namespace lgs::detail
