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
    const Outline& whole = seen.naive(scene).outline;
    Random random(whole.size());
    const std::size_t count = std::max(seen.options.questions, kAtLeast);
    std::string wrong = wrongAnswers(seen.world(), scene, whole, random, count);
    if (wrong.empty()) wrong = wrongComparison(seen.world());
    return wrong.empty() ? std::nullopt : Found(seen.mismatch(Mismatch::Kind::reading, std::move(wrong)));
  }
};

}  // namespace

std::unique_ptr<Law> laws::questions() { return std::make_unique<QuestionsLaw>(); }

}  // namespace lgs::oracle
