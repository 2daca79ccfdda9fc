// A mark that was forgotten, or that the world rolled back beyond, leads nowhere; nor does one behind lead forward.
#include "oracle/check/laws/list.h"

#include <algorithm>

namespace lgs::oracle {
namespace {

class MarksLaw : public Law {
 public:
  void before(Seen& seen, const Judged&) override {
    ahead_.clear();
    for (const auto& known : seen.library->player().timeline().ahead()) ahead_.push_back(known.mark);
  }

  Found after(Seen& seen, const Judged& judged, bool isRefused) override {
    using enum Call::Kind;
    const Call& call = judged.call;
    const auto& timeline = seen.library->player().timeline();
    if (isRefused || !movesInTime(call.kind)) return std::nullopt;
    if (call.kind == mark) ever_.push_back(timeline.behind().back().mark);
    const std::size_t placed = seen.model().state().given.size();
    const bool isKept = call.kind == redo || (call.kind == rollBack && call.keeps != Call::Keeps::never);
    // The world rolled back beyond something that was placed before where it could have redone from.
    if (call.kind == rollBack && !isKept && timeline.ahead().empty() && placed < placed_)
      dropped_.insert(dropped_.end(), ahead_.begin(), ahead_.end());
    if (isKept) placed_ = placed;
    return look(seen);
  }

  Found afterCommit(Seen& seen) override { return look(seen); }

 private:
  Found look(Seen& seen) {
    World& world = seen.world();
    const auto& behind = seen.library->player().timeline().behind();
    const auto isRefused = [](const Expected<void>& done) {
      return !done && done.error().code == ErrorCode::unknownMark;
    };
    const auto isBehind = [&](Mark mark) {
      return std::ranges::any_of(behind, [&](const auto& known) { return known.mark == mark; });
    };
    for (const Mark mark : ever_)
      if (!isBehind(mark) && !isRefused(world.rollBack(mark)))
        return seen.mismatch(Mismatch::Kind::past, "the world rolls back to a mark that is not behind it");
    for (const Mark mark : dropped_)
      if (!isRefused(world.redo(mark)))
        return seen.mismatch(Mismatch::Kind::past, "the world redoes to a mark that was dropped");
    return std::nullopt;
  }

  std::vector<Mark> ever_, ahead_, dropped_;
  std::size_t placed_ = 0;  // so far, where the last roll-back or redo led
};

}  // namespace

std::unique_ptr<Law> laws::marks() { return std::make_unique<MarksLaw>(); }

}  // namespace lgs::oracle
