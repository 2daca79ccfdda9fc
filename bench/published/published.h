// The published algorithm, as its article "An Algorithm for Local Grid Segmentation" gives it: the same five maps, the
// same two phases, float vertices, `atan2`. The engine is compared with it: docs/internals/departures.md
// shows what it gets wrong, and its time is the baseline of the bench. Nothing else builds on it.
//
// Names and order follow the article's pseudo-code, so that the two can be read side by side. "Silent:" marks what the
// article leaves open. What was chosen there is always what is best for the algorithm.
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

namespace lgs::bench {

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

  /// What compute() does with its three sets at the end. The article clears them. For that std::unordered_set walks all
  /// the buckets that it ever had, so each edit pays for the first build of the world. New sets show what the algorithm
  /// itself costs.
  enum class Sets : std::uint8_t { cleared, renewed };

  /// Silent: what an empty callback means. Here it preserves nothing.
  explicit Published(ShouldPreserve shouldPreserve = {}, Sets sets = Sets::cleared)
      : shouldPreserve_(std::move(shouldPreserve)), sets_(sets) {}

  /// Section 4.1. The polygon must be counter-clockwise and lie in its cell. Nothing is checked.
  void add(Cell cell, std::span<const Vec2> polygon, Block block);
  /// Section 4.2. Removes a polygon that was added with the same arguments.
  void remove(Cell cell, std::span<const Vec2> polygon, Block block);
  /// Section 4.3.
  void compute();

  /// Visits every segment of `vertexManifold` once, in no particular order.
  template <class Visit>
  void forEachSegment(Visit&& visit) const {
    for (const auto& [vertexHash, segments] : vertexManifold_)
      for (const PublishedSegment* seg : segments)
        if (hash(seg->start) == vertexHash) visit(*seg);
  }

 private:
  using Hash = std::uint64_t;
  /// Spreads keys over the table. std::hash is the identity, which would put whole rows of cells into one bucket.
  struct Spread {
    std::size_t operator()(Hash key) const { return key * 0x9e3779b97f4a7c15ULL >> 20; }
  };
  using Segments = std::vector<PublishedSegment*>;
  using SegmentMap = std::unordered_map<Hash, Segments, Spread>;
  using HashSet = std::unordered_set<Hash, Spread>;

  static Hash hash(Vec2 vertex);
  static Hash hash(Cell cell);

  /// The map that an edge belongs to, and the cell that is its key there.
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
  Sets sets_;
  SegmentMap vertexManifold_;
  SegmentMap horizontalBoundarySegs_, verticalBoundarySegs_;
  SegmentMap resolvedHorizontal_, resolvedVertical_;
  HashSet dirtyHorizontal_, dirtyVertical_, dirtyVertices_;

  // Silent: where the segments live. The original's are objects of a garbage-collected heap. Here they are in a pool,
  // which is the quickest way that does not change the algorithm.
  std::deque<PublishedSegment> pool_;
  Segments free_;
  struct Candidate {
    float val;
    bool forward;  ///< along increasing coordinates; the article's DOWN, or LEFT
    int delta;
  };
  std::vector<Candidate> candidates_;  // working memory
  Segments outgoing_, incoming_;
};

}  // namespace lgs::bench
