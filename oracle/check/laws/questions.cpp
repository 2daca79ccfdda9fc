// What a world is asked about places, and whether it is the same as another one, against the slow way.
#include "oracle/check/questions.h"

#include "oracle/check/laws/list.h"

#include <algorithm>

namespace lgs::oracle {
namespace {

class QuestionsLaw : public Law {
 public:
  Found nowAndThen(Seen& seen) override {
    constexpr std::size_t kAtLeast = 3;
    const Scene scene = seen.scene();
    const Outline& whole = seen.whole();
    Random random(whole.size());
    const std::size_t count = std::max(seen.options.questions, kAtLeast);
    return found(seen, wrongAnswers(seen.world(), scene, whole, random, count));
  }

  // Of a world that is in memory as a whole the law of history compares more.
  Found atEnd(Seen& seen) override {
    return seen.model().isWhole() ? std::nullopt : found(seen, wrongComparison(seen.world(), World(seen.world())));
  }

 private:
  static Found found(const Seen& seen, std::string wrong) {
    return wrong.empty() ? std::nullopt : Found(seen.mismatch(Mismatch::Kind::reading, std::move(wrong)));
  }
};

}  // namespace

std::unique_ptr<Law> laws::questions() { return std::make_unique<QuestionsLaw>(); }

}  // namespace lgs::oracle
