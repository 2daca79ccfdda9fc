// Engines that take strokes: what is right, and what is found of those that are not.
#include "oracle/check/failure.h"
#include "oracle/check/finding.h"
#include "oracle/check/library_engine.h"
#include "oracle/check/report.h"
#include "oracle/engine/process_engine.h"
#include "oracle/engine/serve.h"
#include "oracle/generate/generator.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace lgs::oracle {
namespace {

constexpr std::int64_t kCell = kUnitsPerCell;
constexpr const char* kAll = "ghosts blocks slants preserve regions round=1";

Capabilities saying(const std::string& words) { return parseCapabilities(words).value(); }

/// This library's brushes, and what becomes of their outline.
class Brushes : public LibraryEngine {
 public:
  using Change = std::function<void(Outline&)>;
  explicit Brushes(const std::string& words, Change change = {}) : change_(std::move(change)) { assume(saying(words)); }
  Outline outline() const override {
    Outline outline = LibraryEngine::outline();
    if (change_) change_(outline);
    std::ranges::sort(outline);
    return outline;
  }

 private:
  Change change_;
};

Trace traceOf(const char* text) { return parseTrace(text).trace; }

std::optional<Mismatch> found(Engine& engine, const Trace& trace) { return findMismatch(trace, {.engine = &engine}); }

/// The first mismatch in some random worlds of what the engine can have.
std::optional<Mismatch> foundAtRandom(Engine& engine, std::uint64_t cases = 12) {
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const Trace trace = caseOf(seed, {3, 3, 15, engine.can(), false}, seed);
    EXPECT_EQ(whyNot(trace, engine.can()), "");
    if (auto mismatch = found(engine, trace)) return mismatch;
  }
  return std::nullopt;
}

void moveBy(Outline& outline, std::int64_t units) {
  for (OutlineSegment& s : outline) s.start.x += units, s.end.x += units;
}

constexpr const char* kFrame = "lgs-trace 2\npaint 1 fill  0 0, 3 0, 3 3, 0 3 | 1 1, 2 1, 2 2, 1 2\n";

TEST(Regions, OfThisLibraryAreNearThroughTheProtocol) {
  for (const std::string words :
       {"regions", "slants regions round=1", kAll, "slants regions lattice=8 cells=20 round=1"}) {
    const auto engine = ProcessEngine::start({serving(std::make_shared<Brushes>(words))});
    ASSERT_TRUE(engine) << engine.error().text;
    EXPECT_EQ(print((*engine)->can()), words);
    const auto mismatch = foundAtRandom(**engine);
    EXPECT_FALSE(mismatch) << words << "\n" << mismatch->text;
  }
}

TEST(Regions, AreOnlyWhatTheEngineCanHave) {
  const auto isMadeWith = [](const std::string& words, const std::string& without) {
    for (std::uint64_t seed = 0; seed < 30; ++seed)
      if (!whyNot(caseOf(seed, {3, 3, 15, saying(words), false}, seed), saying(without)).empty()) return true;
    return false;
  };
  EXPECT_TRUE(isMadeWith("slants regions round=1", "regions"));
  EXPECT_TRUE(isMadeWith("regions", "regions lattice=8"));
  EXPECT_TRUE(isMadeWith("regions", "regions cells=40"));
  EXPECT_TRUE(isMadeWith(kAll, "slants regions round=1"));
  EXPECT_EQ(whyNot(traceOf("lgs-trace 1\nadd a 0 0 1 0 0 1 0 1 1\n"), saying("regions")),
            "edit 1: an engine with 'regions' takes strokes alone");
  EXPECT_EQ(whyNot(traceOf("lgs-trace 2\npaint 1 fill 0 0 1 0 1 1\n"), saying("regions")),
            "edit 1: it has a slanted edge");
  EXPECT_EQ(whyNot(traceOf("lgs-trace 4\ncarve 0 0 1 0 1 1 0 1 united\n"), saying("regions")),
            "edit 1: it is united, and strokes for engines are even-odd");
  const Trace two = traceOf("lgs-trace 2\npaint 1 fill 0 0 1 0 1 1 0 1\npaint 2 fill 0 0 2 0 2 1 0 1\n");
  EXPECT_EQ(whyNot(two, saying("regions")), "");
  EXPECT_NE(whyNot(two, saying("blocks preserve regions")), "") << "the seam between them";
}

// Each bug, an engine that has it, and the kind of what is found.
TEST(Regions, FindWhatIsWrongWithAnOutline) {
  const auto isHole = [](const OutlineSegment& s) {
    return 0 < std::min(s.start.x, s.end.x) && std::max(s.start.x, s.end.x) < 3 * kCell &&
           0 < std::min(s.start.y, s.end.y) && std::max(s.start.y, s.end.y) < 3 * kCell;
  };
  const std::tuple<const char*, const char*, Brushes::Change> wrong[]{
      {"a hole is dropped", "extra solid", [&](Outline& o) { std::erase_if(o, isHole); }},
      {"only the hole is there", "missing solid", [&](Outline& o) { std::erase_if(o, std::not_fn(isHole)); }},
      {"a segment is missing", "open outline", [](Outline& o) { o.pop_back(); }},
      {"each segment twice", "extra solid",
       [](Outline& o) {
         const Outline once = o;
         o.insert(o.end(), once.begin(), once.end());
       }},
      {"the solid is on the right", "missing solid",
       [](Outline& o) {
         for (OutlineSegment& s : o) std::swap(s.start, s.end);
       }},
      {"a line to and fro", "no boundary",
       [](Outline& o) {
         o.push_back({{5 * kCell, 0}, {6 * kCell, 0}, 1, {}, {}});
         o.push_back({{6 * kCell, 0}, {5 * kCell, 0}, 1, {}, {}});
       }},
      {"a line to and fro inside", "no boundary",
       [](Outline& o) {
         o.push_back({{0, 0}, {kCell / 2, kCell / 2}, 1, {}, {}});
         o.push_back({{kCell / 2, kCell / 2}, {0, 0}, 1, {}, {}});
       }},
      {"two units off", "extra solid", [](Outline& o) { moveBy(o, 2); }},
  };
  for (const auto& [name, kind, change] : wrong) {
    for (const char* const words : {"regions", "slants regions round=1"}) {
      Brushes engine(words, change);
      const auto mismatch = found(engine, traceOf(kFrame));
      ASSERT_TRUE(mismatch) << name;
      EXPECT_EQ(kindOfFinding(*mismatch, engine), kind) << name << ": " << mismatch->text;
      EXPECT_NE(draw(*mismatch), "") << name;
    }
  }
}

TEST(Regions, AreAsNearAsTheEngineSays) {
  for (const auto& [words, most] : {std::pair{"regions", 0}, {"regions round=1", 1}, {"regions round=7", 7}}) {
    for (const int units : {most, most + 1}) {
      Brushes engine(words, [units = units](Outline& o) { moveBy(o, units); });
      EXPECT_EQ(found(engine, traceOf(kFrame)).has_value(), units > most) << words << ", moved by " << units;
    }
  }
}

// The edge of the first stroke is rounded where it leaves its cell, and the second one has an edge nearly along it: they
// cross some units from where the exact ones do.
TEST(Regions, StrokesOfOneCommitAreMeasuredAgainstWhatEachLeaves) {
  Brushes engine("slants regions round=1");
  const auto mismatch =
      found(engine, traceOf("lgs-trace 2\npaint 1 fill 29/32 1.5 1 0 0.9375 0\npaint 1 fill 0 0 1 0 29/32 1\n"));
  EXPECT_FALSE(mismatch) << mismatch->text;
}

TEST(Regions, GhostsAndBlocksAreComparedIfTheyAreDeclared) {
  const auto recoloured = [](Outline& o) {
    for (OutlineSegment& s : o) s.block = 3 - s.block;
  };
  const auto unlinked = [](Outline& o) { o[0].ghost1.reset(); };
  const std::string two = "paint 1 fill 0 0 1 0 1 1 0 1\npaint 2 fill 0 0 3 0 3 1 0 1\n";
  for (const auto& [words, finds] : {std::pair{"slants regions round=1", false}, {kAll, true}}) {
    const Trace trace = traceOf(("lgs-trace 2\n" + (finds ? "preserve 1 2\n" + two : two)).c_str());
    Brushes blocks(words, recoloured), ghosts(words, unlinked);
    EXPECT_EQ(found(blocks, trace).has_value(), finds);
    const auto link = found(ghosts, trace);
    ASSERT_EQ(link.has_value(), finds);
    EXPECT_EQ(link ? kindOfFinding(*link, ghosts) : "none", finds ? "wrong link" : "none");
  }
}

/// It puts out a square of a cell whose left side is so many units too far to the right.
class Drifting : public Engine {
 public:
  explicit Drifting(std::vector<std::int64_t> off) : off_(std::move(off)) {
    introduce("drifting", saying("regions round=1"));
  }
  void reset(const PreservePairs&) override { commits_ = 0; }
  void add(const std::string&, const ScenePolygon&) override {}
  void remove(const std::string&) override {}
  Refusals commit() override { return ++commits_, std::vector<RefusedEdit>(); }
  Outline outline() const override {
    const std::int64_t left = off_[commits_ - 1];
    const std::vector<Point> ring{{left, 0}, {kCell, 0}, {kCell, kCell}, {left, kCell}};
    Outline outline;
    for (std::size_t k = 0; k < 4; ++k) outline.push_back({ring[k], ring[(k + 1) % 4], 1, {}, {}});
    std::ranges::sort(outline);
    return outline;
  }

 private:
  std::vector<std::int64_t> off_;
  std::size_t commits_ = 0;
};

// One that goes on from its own outline may drift, a unit at a time; one that keeps all strokes may not.
TEST(Regions, StartFromTheOutlineBeforeOrFromNothing) {
  const Trace twice = traceOf("lgs-trace 2\npaint 1 fill 0 0 1 0 1 1 0 1\ncommit\npaint 1 fill 0 0 0 1 0 0.5\n");
  const Trace atOnce = traceOf("lgs-trace 2\npaint 1 fill 0 0 1 0 1 1 0 1\npaint 1 fill 0 0 0 1 0 0.5\n");
  for (const auto& [off, isRight] : {std::pair<std::vector<std::int64_t>, bool>{{1, 1}, true},
                                     {{1, 2}, true},
                                     {{1, -1}, true},
                                     {{1, 3}, false},
                                     {{0, 2}, false},
                                     {{2, 2}, false}}) {
    Drifting engine(off);
    EXPECT_EQ(!found(engine, twice), isRight) << off[0] << ", " << off[1];
  }
  for (const std::int64_t off : {2, 3}) {  // a unit for each stroke
    Drifting engine({off});
    EXPECT_EQ(found(engine, atOnce).has_value(), off > 2);
  }
}

/// It forgets every third stroke.
class Forgetful : public Brushes {
 public:
  Forgetful() : Brushes("slants regions round=1") {}
  void stroke(const BrushEdit& brush) override {
    if (++strokes_ % 3 != 0) Brushes::stroke(brush);
  }
  void reset(const PreservePairs& preserve) override {
    strokes_ = 0;
    Brushes::reset(preserve);
  }

 private:
  int strokes_ = 0;
};

TEST(Regions, AMismatchIsShrunkToStrokesThatTheEngineCanHave) {
  Forgetful engine;
  CheckOptions options{.engine = &engine};
  const Trace trace = caseOf(1, {3, 3, 15, engine.can(), false}, 1);
  const auto mismatch = findMismatch(trace, options);
  ASSERT_TRUE(mismatch);
  const FindAgain again = sameKind(mismatch->kind, options);
  const Trace small = shrinkWithEngine(*mismatch, trace, engine, again, std::chrono::seconds(20));
  EXPECT_EQ(editCount(small), 3U) << printTrace(small);
  EXPECT_EQ(whyNot(small, engine.can()), "");
  EXPECT_TRUE(again(parseTrace(printTrace(small)).trace)) << "the text shows it again";
}

TEST(Regions, WordsThatDoNotGoTogether) {
  for (const std::string bad :
       {"round=1", "regions round=0", "regions round=65537", "slants regions", "blocks regions", "preserve regions",
        "several regions", "squares regions", "refuses regions", "merged regions", "islands regions"})
    EXPECT_FALSE(parseCapabilities(bad)) << bad;
  for (const std::string good : {"regions", "regions round=65536", kAll}) EXPECT_EQ(print(saying(good)), good);
}

}  // namespace
}  // namespace lgs::oracle
