// The published algorithm, "An Algorithm for Local Grid Segmentation", as its article gives it: the same five maps, the
// same two phases, float vertices, `atan2`. It is here to be compared with: what it gets wrong is shown in
// docs/departures.md, and its time is the baseline of the bench. Nothing else builds on it.
//
// Names and order follow the article's pseudo-code, so that the two can be read side by side. A comment that begins
// with "Silent:" marks what the article leaves open, and what was chosen: always what serves it best.
#pragma once

#include <lgs/ids.h>
#include <lgs/lattice.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace lgs::oracle {

/// World coordinates, one unit a cell.
struct Vec2 {
  float x = 0;
  float y = 0;
};

/// The article's `Seg`.
struct PublishedSegment {
  Vec2 start;
  Vec2 end;
  std::optional<Vec2> ghost1;
  std::optional<Vec2> ghost2;
  std::uint64_t cellHash = 0;
  Block ogBlock = 0;
};

class Published {
 public:
  using ShouldPreserve = std::function<bool(Block, Block)>;

  /// Silent: nothing is said of an empty callback; it preserves nothing.
  explicit Published(ShouldPreserve shouldPreserve = {}) : shouldPreserve_(std::move(shouldPreserve)) {}

  /// Section 4.1. The polygon is counter-clockwise and lies in its cell; nothing is checked.
  void add(Cell cell, std::span<const Vec2> polygon, Block block);
  /// Section 4.2. Takes away a polygon that was added like this.
  void remove(Cell cell, std::span<const Vec2> polygon, Block block);
  /// Section 4.3.
  void compute();

  /// Every segment of `vertexManifold` once, in no order to rely on.
  std::vector<PublishedSegment> segments() const;
  /// The same without a copy; for the bench.
  template <class Visit>
  void forEachSegment(Visit&& visit) const {
    for (const auto& [vertexHash, segments] : vertexManifold_)
      for (const PublishedSegment* seg : segments)
        if (hash(seg->start) == vertexHash) visit(*seg);
  }

 private:
  using Hash = std::uint64_t;
  /// A 64-bit key spread over the table: identity, as std::hash is, would put whole rows of cells into one bucket.
  struct Spread {
    std::size_t operator()(Hash key) const { return key * 0x9e3779b97f4a7c15ULL >> 20; }
  };
  using Segments = std::vector<PublishedSegment*>;
  using SegmentMap = std::unordered_map<Hash, Segments, Spread>;
  using HashSet = std::unordered_set<Hash, Spread>;

  static Hash hash(Vec2 vertex);
  static Hash hash(Cell cell);

  /// Which map an edge belongs to, and under which cell.
  struct Place {
    SegmentMap* boundary = nullptr;  ///< null for an interior edge
    SegmentMap* resolved = nullptr;
    HashSet* dirty = nullptr;
    Hash cell = 0;
  };
  Place placeOf(Cell cell, Vec2 start, Vec2 end);

  PublishedSegment* make(const PublishedSegment& segment);
  void drop(PublishedSegment* segment) { free_.push_back(segment); }
  void insertIntoManifold(PublishedSegment* segment);
  void removeFromManifold(PublishedSegment* segment);
  void removeResolved(SegmentMap& resolved, Hash boundaryHash);
  void resolveBoundary(const SegmentMap& boundary, SegmentMap& resolved, Hash boundaryHash, float Vec2::*axis);
  void assignGhostVertices(Hash vertexHash);

  ShouldPreserve shouldPreserve_;
  SegmentMap vertexManifold_;
  SegmentMap horizontalBoundarySegs_, verticalBoundarySegs_;
  SegmentMap resolvedHorizontal_, resolvedVertical_;
  HashSet dirtyHorizontal_, dirtyVertical_, dirtyVertices_;

  // Silent: where the segments live. The original's are objects of a garbage-collected heap; these are pooled, which is
  // the quickest that does not change the algorithm.
  std::deque<PublishedSegment> pool_;
  Segments free_;
  struct Candidate {
    float val;
    bool forward;  ///< the article's DOWN, or LEFT: along increasing coordinates
    int delta;
  };
  std::vector<Candidate> candidates_;  // working memory
  Segments outgoing_, incoming_;
};

}  // namespace lgs::oracle
