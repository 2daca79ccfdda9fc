// The contents of the cells, each worked out once for all cells with the same polygons.
#pragma once

#include "content.h"

#include <lgs/world.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace lgs::pieces {

/// A polygon, read from its least vertex on.
Ring canonicalRing(std::span<const LocalPoint> vertices);

/// The polygons of a cell whatever their handles and blocks: canonical rings in order.
using Key = std::vector<Ring>;
Key keyOf(std::span<const PlacedPolygon> polygons);

using ContentId = std::uint32_t;
inline constexpr ContentId kEmpty = 0;  ///< the content of a cell without polygons: always there

/// A copy shares the contents, which never change.
class Catalogue {
 public:
  explicit Catalogue(std::size_t maxVertices);

  /// The content of one more cell. Worked out if no cell has it.
  ContentId use(Key key);
  /// One cell fewer has this content. It is forgotten with the last one.
  void release(ContentId id);

  const std::shared_ptr<const Content>& content(ContentId id) const { return entries_[id].content; }
  std::size_t maxVertices() const { return maxVertices_; }
  std::size_t size() const { return index_.size() + 1; }
  std::uint64_t workedOut() const { return workedOut_; }

 private:
  struct Entry {
    Key key;
    std::uint64_t hash = 0;
    std::shared_ptr<const Content> content;
    std::uint64_t users = 0;
  };

  std::size_t maxVertices_;
  std::vector<Entry> entries_;
  std::vector<ContentId> free_;
  std::unordered_multimap<std::uint64_t, ContentId> index_;  ///< by the hash of the key
  std::uint64_t workedOut_ = 0;
};

}  // namespace lgs::pieces
