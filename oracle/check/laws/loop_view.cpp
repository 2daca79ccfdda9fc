// A view of loops that follows the world, also while chunks come and go, has the loops that one has which begins now: those
// that are closed in what is in memory.
#include "oracle/check/laws/list.h"

#include <lgs/loops.h>
#include <algorithm>
#include <set>
#include <tuple>

namespace lgs::oracle {
namespace {

auto factsOf(const lgs::Loops& loops) {
  std::multiset<std::tuple<Point, bool, std::uint64_t>> facts;
  for (const LoopId id : loops.all()) {
    const LoopFacts f = *loops.loop(id);
    facts.emplace(f.west, f.isHole(), f.segments);
  }
  return facts;
}

class LoopViewLaw : public Law {
 public:
  Found after(Seen&, const Judged& judged, bool isRefused) override {
    if (judged.call.kind == Call::Kind::load && !isRefused) view_.reset();
    return std::nullopt;
  }

  Found afterTravel(Seen& seen) override { return keepUp(seen); }

  Found afterCommit(Seen& seen) override { return keepUp(seen); }

  Found nowAndThen(Seen& seen) override {
    if (!view_) return std::nullopt;
    const World& world = seen.world();
    if (factsOf(*view_) != factsOf(lgs::Loops(world)))
      return seen.mismatch(Mismatch::Kind::views, "a view of loops that follows has others than one that begins");
    std::set<SegmentId> closed;
    for (const Loop& loop : world.loops()) closed.insert(loop.segments.begin(), loop.segments.end());
    for (const SegmentId id : world.segments())
      if (bool{view_->of(id)} != closed.contains(id))
        return seen.mismatch(Mismatch::Kind::views, "a view of loops has an open chain, or lacks a loop");
    return std::nullopt;
  }

 private:
  Found keepUp(Seen& seen) {
    if (!seen.trace.preserve.empty()) return std::nullopt;  // where chunks are missing, nobody says what is a loop
    if (view_ && !view_->update(seen.world(), seen.library->changes()))
      return seen.mismatch(Mismatch::Kind::views, "a view of loops refuses what was committed");
    const Changes& changes = seen.library->changes();
    if (view_ && changes.before != changes.after && view_->update(seen.world(), changes))
      return seen.mismatch(Mismatch::Kind::views, "a view of loops takes what does not lead from what it saw last");
    if (!view_) view_.emplace(seen.world());
    return std::nullopt;
  }

  std::optional<lgs::Loops> view_;
};

}  // namespace

std::unique_ptr<Law> laws::loopView() { return std::make_unique<LoopViewLaw>(); }

}  // namespace lgs::oracle
