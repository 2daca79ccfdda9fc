// Law 6: a copy of the segments that the lists of changes alone keep up to date is what the world shows (mirror.h), and
// so are segments, loops and rectangles when they are asked for.
#include "oracle/check/laws/list.h"
#include "oracle/check/reads.h"
#include "oracle/trace/mirror.h"

namespace lgs::oracle {
namespace {

class ChangesLaw : public Law {
 public:
  Found afterTravel(Seen& seen) override {
    return keepUp(seen, seen.isPending() ? Mirror::After::goingBackToPending : Mirror::After::goingBack);
  }

  Found afterCommit(Seen& seen) override { return keepUp(seen, Mirror::After::commit); }

  Found nowAndThen(Seen& seen) override {
    if (auto wrong = readSegments(seen.world(), copy_.segments(), seen.wasAway))
      return seen.mismatch(Mismatch::Kind::reading, std::move(wrong->text), std::move(wrong->about));
    if (auto wrong = readLoops(seen.world(), copy_.segments(), seen.model().isWhole() ? nullptr : &seen.whole()))
      return seen.mismatch(Mismatch::Kind::reading, std::move(wrong->text), std::move(wrong->about));
    return std::nullopt;
  }

 private:
  Found keepUp(Seen& seen, Mirror::After after) {
    auto problem = copy_.update(seen.world(), seen.library->changes(), after);
    if (!problem) return std::nullopt;
    return seen.mismatch(Mismatch::Kind::changes, std::move(*problem), copy_.blamed());
  }

  Mirror copy_;
};

}  // namespace

std::unique_ptr<Law> laws::changes() { return std::make_unique<ChangesLaw>(); }

}  // namespace lgs::oracle
