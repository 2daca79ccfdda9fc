// The loops of one outline: a treap for each. An update first opens the loops at every link that is gone, then closes
// what is left at every link that is new (loop_links.cpp). Then it says which loop of now is which of before
// (loop_names.cpp).
#pragma once

#include "treap.h"

#include <lgs/loops.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lgs::detail {

class LoopView {
 public:
  /// Walks all segments of an outline.
  void load(const World& outline);
  /// Takes over the lists of its last commit or roll-back. False, and nothing has changed, where they name segments
  /// that neither were there nor are there now, or leave out some that others are linked with: somebody made them up.
  bool update(const World& outline, const Changes& lists);

  const LoopChanges& changes() const { return changes_; }
  bool isLoop(LoopId id) const { return id.value < roots_.size() && roots_[id.value] != kNoNode; }
  LoopFacts facts(LoopId id) const { return factsOf(id, roots_[id.value]); }
  LoopId of(SegmentId id) const { return {treaps_.has(id.value) ? treaps_[treaps_.root(id.value)].loop : 0}; }
  std::vector<LoopId> all() const;
  std::uint64_t visited() const { return treaps_.visited(); }

 private:
  /// Segments of a loop of before that are still one behind the other, or one that is there again.
  struct Rest {
    std::uint32_t node;  ///< one of them
    std::uint32_t loop;  ///< of before
    std::uint32_t count;
  };
  struct Gone {
    Point start, end;
    std::uint32_t loop;
    friend auto operator<=>(const Gone&, const Gone&) = default;
  };
  /// How many segments of a loop of before a sequence of now has.
  struct Share {
    std::uint32_t loop, root, count;
  };

  bool read(const World& outline, const Changes& lists);
  void begin();
  void cutAll(std::span<const SegmentId> removed, std::span<const Segment> relinked);
  void cutBefore(std::uint32_t id);
  std::uint32_t following(std::uint32_t id);
  void open(std::uint32_t root);
  void setRoot(std::uint32_t root, std::uint32_t loop);
  void dropAll(std::span<const SegmentId> removed);
  void findRests();
  void findOpenEnds();
  void putAll(std::span<const Segment> added);
  void join(std::uint32_t a, std::uint32_t b);

  void nameAll(std::span<const SegmentId> added);
  void findShares();
  void findHeirs();
  const LoopFacts& before(std::uint32_t loop) const;
  bool isBetter(const Share& a, const Share& b) const;
  void tell();
  LoopId newId(std::uint32_t root);
  LoopFacts factsOf(LoopId id, std::uint32_t root) const;

  Treaps treaps_;
  std::vector<std::uint32_t> roots_ = std::vector<std::uint32_t>(1);  ///< by LoopId
  std::vector<std::uint32_t> free_;                                   ///< ids that the next loops get
  LoopChanges changes_;
  bool hasOpen_ = false;  ///< whether there ever was a chain that leads into unloaded ground
  // Working memory of an update.
  std::vector<Segment> segments_;                      ///< that were added, then those that were relinked
  std::vector<SegmentId> removed_, added_, relinked_;  ///< the lists, by id
  std::vector<std::uint32_t> ends_;                    ///< segments on both sides of a cut
  std::vector<Rest> rests_;
  std::vector<std::uint32_t> openEnds_;  ///< segments of open chains beside a link that may be new
  std::vector<Gone> gone_;
  std::vector<std::uint32_t> made_;  ///< roots of the loops of now that may be others than before
  std::vector<LoopId> named_;        ///< in a pair
  std::vector<Share> shares_;        ///< by loop of before, then root
  std::vector<Share> heirs_;         ///< by root: the loop of before that hands its id to it; count is what that had
};

}  // namespace lgs::detail
