// Engines that hang, or are slow: how long they are waited for, and what is left of the trace.
#include "checking.h"
#include "oracle/check/reference_engine.h"
#include "oracle/check/report.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>
#include <chrono>
#include <thread>
#include <vector>

namespace lgs::oracle::hanging {
namespace {

using namespace std::chrono_literals;
using test::must;

// It never answers, which is waited for each time.
class Hanging : public ReferenceEngine {
 public:
  Hanging() : ReferenceEngine(true, false) {}
  Refusals commit() override {
    ++commits;
    std::this_thread::sleep_for(5ms);
    return tl::unexpected(Failure{Failure::Kind::hang, "hangs"});
  }
  std::chrono::duration<double> timeout() const override { return 10ms; }

  int commits = 0;
};

TEST(CheckHang, AHangIsShrunkForThreeTimeouts) {
  Hanging engine;
  Trace trace;
  for (std::int32_t i = 0; i < 30; ++i)
    trace.calls.push_back(Call::add("s" + std::to_string(i), {{7 * i, 5}, 3, {{0, 0}, {9'999, 7}, {65'535, 65'535}}}));
  trace.calls.push_back(Call::commit());
  const CheckOptions options{.engine = &engine};
  const Mismatch found = must(findMismatch(trace, options));
  shrinkWithEngine(found, trace, engine, sameKind(found.kind, options), 60s);
  EXPECT_LE(engine.commits, 2 + 3 * 2 + 4) << "found, shrunk, and looked at again";
}

// It has not answered in time once five polygons stand, or two in haste.
class Slow : public ReferenceEngine {
 public:
  Slow() : ReferenceEngine(true, false) {}
  void hurry(Haste haste) override { few_ = haste == Haste::none ? 5 : 2; }
  void reset(const PreservePairs& preserve) override { stands_ = 0, ReferenceEngine::reset(preserve); }
  void add(const std::string& name, const ScenePolygon& p) override { ++stands_, ReferenceEngine::add(name, p); }
  void remove(const std::string& name) override { --stands_, ReferenceEngine::remove(name); }
  Refusals commit() override {
    if (stands_ >= few_) return tl::unexpected(Failure{Failure::Kind::hang, "is slow"});
    return ReferenceEngine::commit();
  }

 private:
  int stands_ = 0, few_ = 5;
};

TEST(CheckHang, OfASlowEngineHasTheTraceWhatStands) {
  Slow engine;
  Trace trace, least;
  for (std::int32_t i = 0; i < 8; ++i) {
    trace.calls.push_back(square("s" + std::to_string(i), {20 + i, 5}));
    trace.calls.push_back(Call::commit());
    if (i < 3) trace.calls.push_back(Call::remove("s" + std::to_string(i)));
    if (i < 5)
      least.calls.push_back(
          Call::add("p" + std::to_string(i + 1), {{i, 0}, 1, {{0, 0}, {kUnitsPerCell, 0}, {0, kUnitsPerCell}}}));
  }
  const CheckOptions options{.engine = &engine};
  const Mismatch found = must(findMismatch(trace, options));
  EXPECT_EQ(printTrace(shrinkWithEngine(found, trace, engine, sameKind(found.kind, options), 10s)), printTrace(least));
}

// Only where a hang is looked for.
TEST(CheckHang, IsLookedForInHaste) {
  class Hasty : public ReferenceEngine {
   public:
    Hasty() : ReferenceEngine(true, false) {}
    void hurry(Haste haste) override { hastes.push_back(haste); }
    std::vector<Haste> hastes;
  };
  using enum Engine::Haste;
  for (const auto& [kind, haste] : {std::pair{Mismatch::Kind::hang, much}, {Mismatch::Kind::crash, none}}) {
    Hasty engine;
    const Trace trace{{}, {square("a", {0, 0})}};
    Mismatch found;
    found.kind = kind;
    found.edits = 1;
    const FindAgain nowhere = [](const Trace&) { return std::nullopt; };
    EXPECT_EQ(shrinkWithEngine(found, trace, engine, nowhere, 1s), untilFound(trace, found));
    EXPECT_EQ(engine.hastes, (std::vector{haste, none}));
  }
}

}  // namespace
}  // namespace lgs::oracle::hanging
