// The interned polygons, cell contents and shapes of a world. Cell contents repeat: a content is validated and worked
// out once, and a cell stores its number.
#pragma once

#include "content.h"
#include "hash_index.h"

#include <lgs/error.h>
#include <lgs/ids.h>

#include <map>
#include <memory>
#include <span>
#include <vector>

namespace lgs::detail {

using PolygonId = std::uint32_t;
using ContentId = std::uint32_t;
inline constexpr ContentId kEmptyContent = 0;
inline constexpr ContentId kMaxContent = (1u << 23) - 1;  ///< a cell's word has 23 bits for it

/// A content with its name: the polygons in order of id, which is the order of slots, and the pairs kept apart.
struct InternedContent : Content {
  std::vector<PolygonId> polygons;
  std::vector<std::pair<Slot, Slot>> preserved;
  std::uint64_t hash = 0;
};

/// The content of a shape of one polygon. Both fields have one type, as Microsoft's compiler packs no others.
struct SoleContent {
  std::uint32_t id : 24 = kEmptyContent;
  std::uint32_t facts : 8 = 0;
};
static_assert(sizeof(SoleContent) == 4);

struct InternedShape {
  ContentId content = kEmptyContent;  ///< with nothing preserved
  std::vector<PolygonId> polygons;    ///< in the order given
};

class Catalogue {
 public:
  Catalogue();

  const InternedContent& content(ContentId id) const { return *contents_[id]; }
  /// The most interior half-edges that meet in a rim vertex of a content, of all that there ever were.
  std::uint32_t widestFan() const { return widestFan_; }
  Facts facts(ContentId id) const { return uses_[id].facts; }
  PolygonView vertices(PolygonId id) const { return polygons_[id]->vertices; }
  /// Valid until the next shape is made; null for an id that is none of ours.
  const InternedShape* shape(ShapeId id) const {
    const std::size_t index = id.value - std::size_t{1};
    return index < shapes_.size() ? &shapes_[index] : nullptr;
  }

  /// Empty for a shape of several polygons, and for an id that is none of ours.
  const SoleContent& soleContent(ShapeId id) const { return soles_[id.value < soles_.size() ? id.value : 0]; }

  /// The polygon with these vertices, validated if it is new.
  Expected<PolygonId> internPolygon(PolygonView vertices);
  /// The content of a cell with only this polygon.
  Expected<ContentId> internSole(PolygonId polygon);
  Expected<ShapeId> internShape(std::span<const PolygonId> polygons);

  /// The content with these polygons, in increasing order of id; those marked in `known` are already known to be
  /// disjoint from each other. An overlap is reported without saying of which: see meet().
  Expected<ContentId> internContent(std::span<const PolygonId> polygons, std::span<const std::uint8_t> known,
                                    std::span<const std::pair<Slot, Slot>> preserved);

  bool meet(PolygonId a, PolygonId b) const { return interiorsMeet(vertices(a), vertices(b)); }

  void use(ContentId id) {
    if (uses_[id].users != kForever) acquire(uses_[id].users);
  }
  void release(ContentId id) {
    if (uses_[id].users != kForever) drop(uses_[id].users);
  }

  /// Forgets the contents and polygons that nothing uses, once they are many. Amortised O(1) for each that was made.
  void collect();

  std::uint64_t contentCount() const { return contents_.size() - 1 - freeContents_.size(); }
  std::uint64_t shapeCount() const { return shapes_.size(); }
  /// Forgets the shapes made last, down to a count. Their contents stay, as what is worked out once.
  void forgetShapes(std::uint64_t count);
  /// Numbers beyond those of all contents and polygons.
  std::size_t contentLimit() const { return contents_.size(); }
  std::size_t polygonLimit() const { return polygons_.size(); }
  std::uint64_t bytes() const;

 private:
  struct InternedPolygon {
    std::vector<LocalPoint> vertices;
    std::uint64_t hash = 0;
    std::uint32_t users = 0;  ///< contents
    ContentId sole = kEmptyContent;
  };

  /// What edits ask of a content, apart from the rest so that they touch little memory.
  struct Use {
    std::uint32_t users = 0;  ///< cells; a content without users may be forgotten
    Facts facts = 0;          ///< as in the content
  };

  /// Users of a content that a shape has. It is never forgotten, so the quick way of an edit need not count its cells.
  static constexpr std::uint32_t kForever = 0xffff'ffff;

  /// Says which of these polygons is to blame: the first that overlaps one before it.
  Error overlapAmong(std::span<const PolygonId> polygons) const;
  void acquire(std::uint32_t& users) { unused_ -= users++ == 0; }
  void drop(std::uint32_t& users) { unused_ += --users == 0; }
  void forgetContent(ContentId id);
  void forgetPolygon(PolygonId id);

  std::vector<std::unique_ptr<InternedPolygon>> polygons_;
  std::vector<std::unique_ptr<InternedContent>> contents_;
  std::vector<Use> uses_;  ///< by content
  std::vector<InternedShape> shapes_;
  std::vector<SoleContent> soles_{SoleContent{}};  ///< by shape: see soleContent()
  std::map<std::vector<PolygonId>, ShapeId> shapeIndex_;
  HashIndex polygonIndex_;
  HashIndex contentIndex_;
  std::vector<PolygonId> freePolygons_;
  std::vector<ContentId> freeContents_;
  std::uint32_t widestFan_ = 0;
  std::size_t unused_ = 0;  ///< contents and polygons without users
};

}  // namespace lgs::detail
