// What the adapters for Box2D share. It knows no Box2D. An EdgeSet has which edges a physics engine is to get for the
// segments of a World, in which chunk and with which ghosts; and after a commit, what is to change about them.
//
// The edges are a function of the world's segments and of the options. The edits that led there play no part.
//
//  1. Strips. Two segments follow each other if one is the successor of the other, and the other its predecessor. With
//     `merge`, segments make one strip if they follow each other straight on, in one chunk, with equal materials.
//     Without `merge`, each segment is a strip.
//  2. Edges. A strip that is at least `shortest` long is an edge. Shorter strips that follow each other are taken
//     together, from the first one on (from the least one if they go round in a ring). As soon as the distance from
//     the end of the last edge reaches `shortest`, all strips since then are *welded* into one straight edge. What
//     remains at the end is welded to the last of these edges. If there is none, or if that would make it too short,
//     the rest is *left out*: a gap shorter than `shortest`. No vertex ever moves.
//  3. Ghosts. The ghosts of an edge are the far ends of the edges before and after it, whatever is left out between
//     them. Under a preserve relation a link can lead one way only; there the ghost of the segment is that of the edge.
//     Where there is no link, there is no ghost.
//
// An edge belongs to the chunk of its first segment's cell. It ends in that chunk, too, unless it is welded.
//
// No function fails. Every function is noexcept: when memory runs out, or EdgeOptions::material throws, the program
// ends. Functions of edges and segments cost O(1), unless noted otherwise.
#pragma once

#include <lgs/box2d/frame.h>
#include <lgs/box2d/sync_error.h>
#include <lgs/world.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

namespace lgs::box2d {

/// A small dense number, good as an index. Zero is null. An id that an update reported as removed may name a new edge
/// from the next update on.
struct EdgeId {
  std::uint32_t value = 0;                                         ///< good as an index
  constexpr explicit operator bool() const { return value != 0; }  ///< whether it is not null
  friend constexpr auto operator<=>(EdgeId, EdgeId) = default;
};

/// A straight edge, with the solid on the left of start→end. It stands for one segment or for several that follow each
/// other.
struct Edge {
  SegmentId first;              ///< the first of its segments
  SegmentId last;               ///< the last of them; `first` if it stands for one
  std::uint32_t chunk = 0;      ///< number of the chunk; EdgeSet::chunk() returns where it is
  Block block = 0;              ///< of the first segment
  Point start;                  ///< that of the first segment, in lattice units
  Point end;                    ///< that of the last segment, in lattice units
  std::optional<Point> ghost1;  ///< the far end of the edge before it, if there is one
  std::optional<Point> ghost2;  ///< the far end of the edge after it, if there is one
  friend bool operator==(const Edge&, const Edge&) = default;
};

/// Where a segment is, with the solid on the left of start→end.
struct Line {
  Point start;  ///< in lattice units
  Point end;    ///< in lattice units
  friend bool operator==(const Line&, const Line&) = default;
};

/// A value outside its range is a mistake of the program: an assertion fails. With NDEBUG the behaviour is undefined.
struct EdgeOptions {
  std::int32_t chunkCells = 16;  ///< cells along the side of a chunk, 1 … 4,096
  std::int64_t shortest = 0;     ///< lattice units, 0 … 2^28
  bool merge = false;            ///< whether segments that go straight on become one edge
  /// Segments may be merged if this gives their blocks the same number. It must always give the same answer for a
  /// block. Empty: all segments may be merged.
  std::function<std::uint32_t(Block)> material = {};
};

/// What to do to a copy of the edges: first remove, then add, then relink. No id is in two lists.
struct EdgeChanges {
  std::vector<EdgeId> removed;   ///< edge() still returns what they were, until the next update
  std::vector<EdgeId> added;     ///< new edges
  std::vector<EdgeId> relinked;  ///< edges with the same ends as before and another ghost
  /// Of these: with a ghost in another direction, or nearer than `shortest`. To a physics engine that uses no more of a
  /// ghost than its direction, the others are as they were.
  std::vector<EdgeId> turned;
};

/// How many edges there are, and what became of the segments.
struct EdgeCounts {
  std::size_t edges = 0;     ///< live ones
  std::size_t segments = 0;  ///< of the world: the sum of the next four
  std::size_t single = 0;    ///< segments that are one edge each
  std::size_t merged = 0;    ///< segments in strips of several that are an edge
  std::size_t welded = 0;    ///< segments in welded edges
  std::size_t leftOut = 0;   ///< segments in no edge
  friend bool operator==(const EdgeCounts&, const EdgeCounts&) = default;
};

/// The edges for the segments of one world. The comment at the top of this file says which.
class EdgeSet {
 public:
  explicit EdgeSet(EdgeOptions options) noexcept;  ///< no edges: load() makes them

  /// Brings the edges up to date with a world, whatever they were before. Edges that the world has as well stay. The
  /// result is valid until the next load or update. Cost: O(segments).
  const EdgeChanges& load(const World& world) noexcept;

  /// The same with what a commit or roll-back of the loaded world reported. Call it after each of them, before the next
  /// edit. That nothing speaks against it (misfit()) is asserted. Cost: the number of changes, times the segments of
  /// the edges near them.
  const EdgeChanges& update(const World& world, const Changes& changes) noexcept;

  /// What speaks against an update with these changes, if anything does. Lists that name what is not there, since no
  /// world made them, are `notTheLast`; that they name all is not checked. Cost: O(changes).
  std::optional<SyncError> misfit(const World& world, const Changes& changes) const noexcept;

  /// The World::version() that the edges are up to date with.
  std::uint64_t version() const noexcept { return version_; }

  /// The edge of a live id, or of one that the last update removed. For the null id, and for one that never was, an
  /// edge of no segment.
  const Edge& edge(EdgeId id) const noexcept { return slots_[id.value < slots_.size() ? id.value : 0].edge; }
  /// The edge that stands for a segment; null if the segment is left out or is no live segment.
  EdgeId edgeOf(SegmentId segment) const noexcept;
  /// Where a segment was at the last load or update; nothing if it was not alive then. So between a commit and its
  /// update this returns what the commit took away.
  std::optional<Line> lineOf(SegmentId segment) const noexcept;
  /// The highest SegmentId::value that lineOf() may know, and maybe a higher one.
  std::uint32_t maxSegmentId() const noexcept {
    return records_.empty() ? 0 : static_cast<std::uint32_t>(records_.size() - 1);
  }
  /// All live edges, in increasing order. Cost: O(edges).
  std::vector<EdgeId> edges() const noexcept;
  /// Where the chunk with a number is. Numbers run from 0 to chunkCount() - 1: one for each chunk that has an edge. A
  /// chunk that loses its last edge keeps its number until the next load or update; then another one may get it. (0, 0)
  /// for any other number.
  Chunk chunk(std::uint32_t number) const noexcept { return number < chunks_.size() ? chunks_[number] : Chunk{}; }
  std::size_t chunkCount() const noexcept { return chunks_.size(); }  ///< how many there are, or were at a time
  EdgeCounts counts() const noexcept;                                 ///< as of the last load or update
  const EdgeOptions& options() const noexcept { return options_; }    ///< those that it was made with

 private:
  enum class Fate : std::uint8_t { dead, pending, single, merged, welded, leftOut };
  enum class Way : bool { before, after };  // against the direction of the segments, and along it
  struct Record {                           // of a segment
    std::uint32_t edge = 0;
    std::uint32_t predecessor = 0;  // when it was last looked at; if the segment goes, those two are to be looked at
    std::uint32_t successor = 0;
    std::uint32_t renewed = 0;  // number of an update
    std::uint32_t read = 0;     // where it is in reads_, if it is there
    Fate fate = Fate::dead;
    Line line;
  };
  struct Slot {  // of an edge; the last four are numbers of updates
    Edge edge;
    bool live = false;
    std::uint32_t retired = 0;
    std::uint32_t kept = 0;
    std::uint32_t linked = 0;
    std::uint32_t made = 0;
  };
  struct Strip {  // indices into group_
    std::size_t first;
    std::size_t last;
  };

  void begin(const World& world);
  const EdgeChanges& renewAll();
  void seed(SegmentId id);
  void seedAround(SegmentId id);
  void seedLinks(const Record& record);
  void seedAll(const Changes& changes);
  void setFate(Record& record, Fate fate);
  void admit(SegmentId id);
  void retire(std::uint32_t edge);
  void removeRetired();

  const Segment* find(SegmentId id);
  const Segment& read(SegmentId id) { return *find(id); }
  void forgetReads();
  const Segment* neighbour(const Segment& s, Way way);
  bool straight(const Segment& a, const Segment& b) const;
  const Segment& stripEnd(const Segment& from, Way way);
  bool isShort(Point from, Point to) const;
  bool isTurned(const std::optional<Point>& before, const std::optional<Point>& now, Point end) const;

  void renew(SegmentId id);
  void gather(SegmentId id);
  void gatherStrip(const Segment& first);
  void startRingAtLeast();
  void weld();
  bool isEdge(std::uint32_t number, const Segment& head, Point end) const;
  std::uint32_t newSlot();
  void place(std::size_t first, std::size_t last, Fate fate);
  void relinkNearest(SegmentId from, Way way);
  void relink(std::uint32_t edge);
  std::optional<Point> ghostOf(std::uint32_t edge, Way way);
  std::uint32_t chunkNumber(Cell cell);

  EdgeOptions options_;
  const World* world_ = nullptr;  // during an update
  std::uint64_t version_ = 0;
  std::uint32_t update_ = 0;     // number of the update
  std::vector<Record> records_;  // by SegmentId
  std::vector<Slot> slots_;      // by EdgeId
  std::vector<std::uint32_t> free_;
  std::vector<Chunk> chunks_;              // by number
  std::vector<std::uint32_t> edgesIn_;     // by number of the chunk
  std::vector<std::uint32_t> emptied_;     // numbers of chunks that the update left without edges
  std::vector<std::uint32_t> freeChunks_;  // numbers
  std::unordered_map<std::uint64_t, std::uint32_t> chunkNumbers_;
  std::size_t fates_[6] = {};
  EdgeChanges changes_;
  // Of the update. They are members so that their memory is used again.
  std::vector<std::vector<Segment>> reads_;  // segments that were read, by pages, so that they stay where they are
  std::size_t readCount_ = 0;                // how many of reads_ are valid; the rest is memory that is used again
  std::vector<SegmentId> seeds_;             // segments to look at
  std::vector<std::uint32_t> retired_;       // edges that go unless they are placed again
  std::vector<std::uint32_t> placed_;        // edges that were placed
  std::vector<const Segment*> group_;        // the strips that are being worked on
  std::vector<Strip> strips_;
  std::vector<std::pair<SegmentId, SegmentId>> ends_;  // the first and last segment of each group
};

}  // namespace lgs::box2d
