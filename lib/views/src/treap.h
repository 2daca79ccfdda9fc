// Sequences of segments, each a treap (Aragon and Seidel: Randomized search trees, Algorithmica 16, 1996): a tree in
// the order of the sequence that is a heap by priorities. The priority of a segment is a scrambled id, so the same
// edits make the same trees everywhere. From a segment one climbs to its sequence. Every node has the sums of its
// subtree.
//
// A treap and no splay tree, since reading changes nothing: const calls are safe beside each other.
#pragma once

#include <lgs/int128.h>
#include <lgs/lattice.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace lgs::detail {

inline constexpr std::uint32_t kNoNode = 0;

struct LoopNode {
  std::uint32_t left = kNoNode;
  std::uint32_t right = kNoNode;
  std::uint32_t parent = kNoNode;
  std::uint32_t count = 0;     ///< of segments below, with this one; 0: no segment
  std::uint32_t loop = 0;      ///< of a root: the loop that it is of, or was of
  std::uint32_t isClosed = 0;  ///< of a root: whether its first segment follows the last one
  Point start;
  std::int32_t dx = 0;  ///< from the start to the end
  std::int32_t dy = 0;
  // Of the starts below.
  Int128 doubleArea;
  Point west{std::numeric_limits<std::int64_t>::max(), 0};  ///< the least by x, then y
  std::int64_t minY = std::numeric_limits<std::int64_t>::max();
  Point max{std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::min()};
};

/// A node is named by the id of its segment, and a sequence by its root.
class Treaps {
 public:
  /// Room for segments up to this id.
  void reserve(std::uint32_t maxId);
  LoopNode& operator[](std::uint32_t id) { return nodes_[id]; }
  const LoopNode& operator[](std::uint32_t id) const { return nodes_[id]; }
  bool has(std::uint32_t id) const { return id < nodes_.size() && nodes_[id].count != 0; }

  /// A sequence of one.
  void put(std::uint32_t id, Point start, Point end);
  /// Makes one sequence of segments that were put, in O(n).
  std::uint32_t build(std::span<const std::uint32_t> ids);
  /// Forgets a sequence of one.
  void drop(std::uint32_t id) { nodes_[id] = {}; }

  std::uint32_t root(std::uint32_t id) const;
  /// The first segment that starts at the westernmost vertex.
  std::uint32_t westernmost(std::uint32_t root) const;

  // These count what they visit. So they are not const, and never used to read.
  std::uint32_t climb(std::uint32_t id);  ///< to the root
  std::uint32_t first(std::uint32_t root);
  std::uint32_t last(std::uint32_t root);
  std::uint32_t next(std::uint32_t id);      ///< in the sequence; none after the last
  std::uint32_t previous(std::uint32_t id);  ///< in the sequence; none before the first

  std::uint32_t merge(std::uint32_t a, std::uint32_t b);
  struct Halves {
    std::uint32_t left, right;
  };
  /// Splits the sequence behind a segment.
  Halves splitAfter(std::uint32_t id);

  std::size_t size() const { return nodes_.size(); }
  std::uint64_t visited() const { return visited_; }

 private:
  void pull(std::uint32_t id);
  void pullUp(std::uint32_t id);

  std::vector<LoopNode> nodes_ = std::vector<LoopNode>(1);
  std::vector<std::uint32_t> spine_;  ///< working memory
  std::uint64_t visited_ = 0;
};

}  // namespace lgs::detail
