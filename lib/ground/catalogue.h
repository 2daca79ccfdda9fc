// The polygons, contents and shapes of a world. Contents repeat from cell to cell. So each is validated and worked out
// once, and a cell stores its number.
#pragma once

#include "ground/content.h"
#include "storage/hash_index.h"

#include <lgs/error.h>
#include <lgs/ids.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace lgs::detail {

using ContentId = std::uint32_t;
inline constexpr ContentId kEmptyContent = 0;
inline constexpr ContentId kMaxContent = (1u << 23) - 1;  ///< a cell's word has 23 bits for it

/// The content of a shape is never forgotten, so the cells that have it are not counted.
struct InternedShape {
  ContentId content = kEmptyContent;  ///< with nothing preserved
  Facts facts = 0;                    ///< of the content
  bool isSole = false;                ///< whether it has one polygon
  std::vector<PolygonId> polygons;    ///< in the order given
};

class Catalogue {
 public:
  Catalogue();

  const Content& content(ContentId id) const { return *contents_[id]; }
  /// How many interior half-edges meet at most in one vertex on the rim, in all contents that there ever were.
  std::uint32_t widestFan() const { return widestFan_; }
  Facts facts(ContentId id) const { return uses_[id].facts; }
  PolygonView vertices(PolygonId id) const {
    assert(id < polygons_.size());
    return polygons_[id].vertices;
  }
  /// The content with this polygon alone; kEmptyContent if there is none.
  ContentId sole(PolygonId id) const { return polygons_[id].sole; }
  /// Valid until the next shape is made. Without polygons if the id is none of ours.
  const InternedShape& shape(ShapeId id) const { return shapes_[id.value < shapes_.size() ? id.value : 0]; }

  /// The polygon with these vertices. It is validated if it is new.
  Expected<PolygonId> internPolygon(PolygonView vertices);
  Expected<ShapeId> internShape(std::span<const PolygonId> polygons);

  /// The content with these polygons, which are in increasing order. Those marked in `known` are known to be disjoint
  /// from each other. A refusal for an overlap does not say which polygons are to blame: ask overlap().
  Expected<ContentId> internContent(std::span<const PolygonId> polygons, std::span<const std::uint8_t> known,
                                    std::span<const std::pair<Slot, Slot>> preserved);

  bool overlap(PolygonId a, PolygonId b) const { return interiorsMeet(vertices(a), vertices(b)); }

  /// How many cells use a content; nothing if they are not counted.
  std::optional<std::uint32_t> users(ContentId id) const {
    return uses_[id].users == kForever ? std::nullopt : std::optional(uses_[id].users);
  }
  void use(ContentId id) {
    if (uses_[id].users != kForever) acquire(uses_[id].users);
  }
  void release(ContentId id) {
    if (uses_[id].users != kForever) drop(uses_[id].users);
  }

  /// Once many contents and polygons have no users, forgets them. Cost: O(1) for each that was made, amortised.
  void collect();

  /// For tests of the limit: so many contents count as made, and are not there.
  void passOver(std::size_t contents) {
    contents_.resize(contents_.size() + contents);
    uses_.resize(contents_.size(), {.users = kForever});
  }

  std::uint64_t contentCount() const { return contents_.size() - 1 - freeContents_.size(); }
  std::uint64_t shapeCount() const { return shapes_.size() - 1; }
  /// Takes the shape made last away. Its content stays, as it is worked out already.
  InternedShape takeShape();
  /// Puts back the one taken away last.
  void putShape(InternedShape shape);
  /// One more than the greatest number of a content.
  std::size_t contentLimit() const { return contents_.size(); }
  std::uint64_t bytes() const;

 private:
  struct InternedPolygon {
    std::vector<LocalPoint> vertices;
    std::uint64_t hash = 0;
    std::uint32_t users = 0;         ///< contents
    ContentId sole = kEmptyContent;  ///< the content with it alone
  };

  /// What edits ask of a content. It stands apart from the rest, so that they touch little memory.
  struct Use {
    std::uint32_t users = 0;  ///< cells, or kForever; a content without users may be forgotten
    Facts facts = 0;          ///< as in the content
  };

  /// The users of a content that a shape has. Shapes are never forgotten, so the cells of such a content are not
  /// counted: that saves the usual edit a look-up.
  static constexpr std::uint32_t kForever = 0xffff'ffff;

  /// Blames the first of these polygons that overlaps one before it.
  Error overlapAmong(std::span<const PolygonId> polygons) const;
  void acquire(std::uint32_t& users) { unused_ -= users++ == 0; }
  void drop(std::uint32_t& users) {
    assert(users != 0);
    unused_ += --users == 0;
  }
  void forgetContent(ContentId id);
  void forgetPolygon(PolygonId id);

  std::vector<InternedPolygon> polygons_{InternedPolygon{}};  ///< by PolygonId, whose 0 names none
  std::vector<std::shared_ptr<const Content>> contents_;      ///< null if it is forgotten
  std::vector<Use> uses_;                                     ///< by content
  std::vector<InternedShape> shapes_{InternedShape{}};        ///< by ShapeId, whose 0 names none
  std::uint64_t seed_ = anySeed(this);                        ///< what hashes begin with
  HashIndex polygonIndex_, contentIndex_, shapeIndex_;
  PolygonId lastPolygon_ = 0;  ///< found last: neighbours are often alike
  std::vector<PolygonId> freePolygons_;
  std::vector<ContentId> freeContents_;
  std::uint32_t widestFan_ = 0;
  std::size_t unused_ = 0;  ///< contents and polygons without users
  ContentBuilder builder_;
  std::vector<PolygonView> views_;  ///< working memory
};

}  // namespace lgs::detail
