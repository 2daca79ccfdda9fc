// Ranks in one process: regions of a world, and the messages between them, which take their time.
#pragma once

#include "examples/regions/region.h"
#include "oracle/calls/random.h"
#include "proptests/support/law.h"

#include <lgs/world.h>

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

namespace lgs::test {

/// A segment by what does not depend on ids.
struct Row {
  Block block = 0;
  Cell cell;
  std::vector<LocalPoint> polygon;
  std::optional<Point> ghost1, ghost2;
  friend bool operator==(const Row&, const Row&) = default;
};

/// Start and end.
using Key = std::pair<Point, Point>;

/// A row, and the segments before and after it.
struct LinkedRow {
  Row row;
  std::optional<Key> predecessor, successor;
  friend bool operator==(const LinkedRow&, const LinkedRow&) = default;
};
using Rows = std::map<Key, LinkedRow>;

/// What changed, by ends; of all commits of a round.
enum class Change : std::uint8_t { removed, added, relinked };
using Listed = std::multiset<std::tuple<Change, Key>>;

/// Some segments by id, kept up to date by lists of changes alone.
class Copy {
 public:
  /// Fails the case that is running, if the lists do not fit.
  template <class Lists>
  void update(const World& world, const Lists& lists, Listed& listed);
  const std::map<SegmentId, std::pair<Key, Row>>& rows() const { return rows_; }

 private:
  std::map<SegmentId, std::pair<Key, Row>> rows_;
};

/// All segments of a world.
Rows rowsOf(const World& world);

class Ranks {
 public:
  Ranks(const regions::Cutting& cutting, const PreserveRelation& preserve);

  /// A rank wants an edit: it sends it to the owner of the cell.
  void propose(std::size_t from, const regions::Edit& edit);

  /// One thing happens: a message arrives somewhere, or a rank commits.
  void step(oracle::Random& random);

  /// All messages arrive, and all ranks commit and hear of it: in any order.
  void finish(oracle::Random& random);

  /// The own segments of all ranks. Fails the case that is running, if a segment is in two ranks, if a link does not
  /// lead to a segment of the rank that it names, or if what the lists of changes gave is something else.
  Rows rows() const;

  std::size_t size() const { return regions_.size(); }
  std::uint64_t refused() const { return refused_; }
  const Listed& listed() const { return listed_; }  ///< since the last call of forgetListed()
  void forgetListed() { listed_.clear(); }

 private:
  enum class Kind : std::uint8_t { proposals, edits, names };
  struct Letter {
    Kind kind;
    regions::Message message;
  };

  void send(Kind kind, std::size_t from, regions::Outbox& out);
  void deliver(std::size_t from, std::size_t to);
  void deliverAny(oracle::Random& random);
  void deliverAll(oracle::Random& random);
  void commit(std::size_t rank);

  regions::Cutting cutting_;
  std::vector<regions::Region> regions_;
  std::vector<Copy> copies_;                                                // of each rank
  std::map<std::pair<std::size_t, std::size_t>, std::deque<Letter>> mail_;  // by sender and receiver; none is empty
  std::uint64_t refused_ = 0;
  Listed listed_;
};

// --- Inline ----------------------------------------------------------------------------------------------------------

/// What a segment is, but for its id.
std::pair<Key, Row> rowOf(const World& world, SegmentId id);

template <class Lists>
void Copy::update(const World& world, const Lists& lists, Listed& listed) {
  for (const SegmentId id : lists.removed) {
    const auto gone = rows_.extract(id);
    failUnless(!gone.empty(), "a segment was removed that was not there");
    listed.emplace(Change::removed, gone.mapped().first);
  }
  for (const SegmentId id : lists.added) {
    const auto [place, isNew] = rows_.emplace(id, rowOf(world, id));
    failUnless(isNew, "a segment was added that was there");
    listed.emplace(Change::added, place->second.first);
  }
  for (const SegmentId id : lists.relinked) {
    const auto there = rows_.find(id);
    failUnless(there != rows_.end(), "a segment was relinked that was not there");
    there->second = rowOf(world, id);
    listed.emplace(Change::relinked, there->second.first);
  }
}

}  // namespace lgs::test
