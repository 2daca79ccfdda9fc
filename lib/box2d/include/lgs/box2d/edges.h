// What the adapters for Box2D share, and no Box2D in it: which edges a physics engine is to be given for the segments of
// a World, in which chunk, with which ghosts, and what a commit changes about them.
//
// The edges are a function of the world's segments and the options, never of how they came about:
//
//  1. Strips. With `merge`, segments that follow each other straight on, in one chunk and of equal material, are one
//     strip. Without it, each segment is one. (Two segments follow each other where they are successor and predecessor
//     of each other.)
//  2. Short strips. A strip that is at least `shortest` long is an edge. Strips shorter than that which follow each other
//     are taken together, from the first one on (in a ring of nothing else, from its least one): as soon as the distance
//     from where the last edge ended reaches `shortest`, the strips since then are *welded* into one straight edge. What
//     remains at the end is *left out*: a gap shorter than `shortest`. No vertex ever moves.
//  3. Ghosts. The ghosts of an edge are the far ends of the edges before and after it, whatever is left out between them;
//     where the links are not mutual (under a preserve relation) they are the segment's own; where there is none, none.
//
// An edge belongs to the chunk of its first segment's cell, and ends in it unless it is welded.
#pragma once

#include <lgs/box2d/frame.h>
#include <lgs/world.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

namespace lgs::box2d {

/// A small dense number, good as an index. An id that was removed may name a new edge after the next update. Zero is null.
struct EdgeId {
  std::uint32_t value = 0;
  constexpr explicit operator bool() const { return value != 0; }
  friend constexpr auto operator<=>(EdgeId, EdgeId) = default;
};

struct Edge {
  SegmentId first;  ///< of the segments that it stands for; the others follow it as successors
  SegmentId last;
  std::uint32_t chunk = 0;  ///< a dense number; EdgeSet::chunk() says which
  Block block = 0;          ///< of the first segment
  Point start;
  Point end;
  std::optional<Point> ghost1;
  std::optional<Point> ghost2;
  friend bool operator==(const Edge&, const Edge&) = default;
};

/// The ranges are asserted, and not looked at where NDEBUG leaves assertions out.
struct EdgeOptions {
  std::int32_t chunkCells = 16;  ///< cells along the side of a chunk, 1 … 4,096
  std::int64_t shortest = 0;     ///< lattice units, 0 … 2^28
  bool merge = false;
  std::function<std::uint32_t(Block)> material =
      {};  ///< equal numbers: may be merged. Must be pure. Empty: all are equal
};

/// What to do to a copy of the edges. No id is in two lists.
struct EdgeChanges {
  std::vector<EdgeId> removed;   ///< edge() still says what they were, until the next update
  std::vector<EdgeId> added;     ///< to be made after the removed ones are gone
  std::vector<EdgeId> relinked;  ///< same ends, another ghost
};

struct EdgeCounts {
  std::size_t edges = 0;
  std::size_t segments = 0;  ///< of the world; the sum of the next four
  std::size_t single = 0;    ///< segments that are an edge each
  std::size_t merged = 0;    ///< segments in edges of several, straight
  std::size_t welded = 0;    ///< short segments in edges that weld them together
  std::size_t leftOut = 0;   ///< short segments in no edge
  friend bool operator==(const EdgeCounts&, const EdgeCounts&) = default;
};

class EdgeSet {
 public:
  explicit EdgeSet(EdgeOptions options);

  /// Takes over all segments of a world; to be called once, before any update.
  const EdgeChanges& load(const World& world);

  /// Brings the edges up to date with what a commit of that world reported. To be called after each commit, before the
  /// next edit. Cost: in proportion to the changes, times the segments of an edge. Valid until the next update.
  const EdgeChanges& update(const World& world, const Changes& changes);

  const Edge& edge(EdgeId id) const { return slots_[id.value].edge; }  ///< of a live id, or one just removed
  EdgeId edgeOf(SegmentId segment) const;                              ///< null if left out, or no live segment
  std::vector<EdgeId> edges() const;                                   ///< all live ones, in increasing order
  Chunk chunk(std::uint32_t number) const { return chunks_[number]; }
  std::size_t chunkCount() const { return chunks_.size(); }  ///< that ever had an edge
  EdgeCounts counts() const;
  const EdgeOptions& options() const { return options_; }

 private:
  enum class Fate : std::uint8_t { dead, pending, single, merged, welded, leftOut };
  struct Record {  // of a segment
    std::uint32_t edge = 0;
    std::uint32_t predecessor = 0;  // as of when it was last looked at: those to look at when it goes
    std::uint32_t successor = 0;
    std::uint32_t renewed = 0;  // in which update
    Fate fate = Fate::dead;
  };
  struct Slot {
    Edge edge;
    bool live = false;
    std::uint32_t retired = 0;  // in which update
    std::uint32_t kept = 0;
    std::uint32_t linked = 0;
    std::uint32_t made = 0;
  };
  struct Strip {
    std::size_t first;  // indices into group_
    std::size_t last;
  };

  void seed(SegmentId id);
  void seedLinks(const Record& record);
  void setFate(Record& record, Fate fate);
  void retire(std::uint32_t edge);

  Segment read(SegmentId id) const { return *world_->segment(id); }
  std::optional<Segment> before(const Segment& s) const;  // where the link is mutual
  std::optional<Segment> after(const Segment& s) const;
  bool straight(const Segment& a, const Segment& b) const;
  Segment stripBegin(Segment s) const;
  Segment stripEnd(Segment s) const;
  bool isShort(Point from, Point to) const;

  void renew(SegmentId id);
  void gather(SegmentId id);
  void gatherStrip(const Segment& first);
  void startRingAtLeast();
  void weld();
  void place(std::size_t first, std::size_t last, Fate fate);
  void relinkAround(SegmentId first, SegmentId last);
  void relink(std::uint32_t edge);
  std::optional<Point> ghost1Of(std::uint32_t edge) const;
  std::optional<Point> ghost2Of(std::uint32_t edge) const;
  std::uint32_t chunkNumber(Cell cell);

  EdgeOptions options_;
  const World* world_ = nullptr;  // during an update
  std::uint32_t update_ = 0;
  std::vector<Record> records_;  // by SegmentId
  std::vector<Slot> slots_;      // by EdgeId
  std::vector<std::uint32_t> free_;
  std::vector<Chunk> chunks_;
  std::unordered_map<std::uint64_t, std::uint32_t> chunkNumbers_;
  std::size_t fates_[6] = {};
  EdgeChanges changes_;
  // Scratch, kept for its memory.
  std::vector<SegmentId> seeds_;
  std::vector<std::uint32_t> retired_;
  std::vector<Segment> group_;
  std::vector<Strip> strips_;
  std::vector<std::uint32_t> placed_;
  std::vector<std::pair<SegmentId, SegmentId>> ends_;  // of the groups renewed
};

}  // namespace lgs::box2d
