#include "oracle/check/checker.h"

#include "oracle/cgal/cgal_union.h"
#include "oracle/check/reads.h"
#include "oracle/check/refusal.h"
#include "oracle/check/window.h"
#include "oracle/generate/random.h"
#include "oracle/generate/steps.h"
#include "oracle/reference/canonical.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/mirror.h"

#include <fmt/format.h>
#include <algorithm>
#include <functional>

namespace lgs::oracle {
namespace {

// Whether a refusal left all counts as they were. It may leave new shapes.
bool sameCounts(const Stats& a, const Stats& b) {
  return a.polygons == b.polygons && a.cells == b.cells && a.segments == b.segments && a.chunks == b.chunks;
}

// A trace that adds the polygons of a scene, cell by cell.
Trace inAnotherOrder(const Scene& scene) {
  std::vector<ScenePolygon> polygons = scene.polygons;
  Random random(polygons.size());
  random.shuffle(polygons);
  std::ranges::stable_sort(polygons, std::greater(), &ScenePolygon::cell);
  Trace trace{scene.preserve, {}};
  for (ScenePolygon& polygon : polygons) {
    const std::string name = fmt::format("p{}{}", trace.edits.size(), randomLetters(random.next()));
    trace.edits.push_back(Edit::add(name, std::move(polygon)));
  }
  return trace;
}

class Check {
 public:
  Check(const Trace& trace, const CheckOptions& options, CheckStats& stats)
      : trace_(trace), options_(options), stats_(stats), player_(trace.preserve), steps_(trace) {}

  tl::expected<std::optional<Mismatch>, TraceError> run() {
    while (const auto step = steps_.next()) {
      edits_ = step->end;
      if (step->isCommit()) {
        if (auto found = commit()) return found;
        if (stopped_) return std::nullopt;
      } else {
        auto found = apply(*step);
        if (!found || *found) return found;
      }
    }
    if (player_.pending()) {
      if (auto found = commit()) return found;
      if (stopped_) return std::nullopt;
    }
    if (!lastWasWhole_ || options_.unionAtEnd) {
      if (auto found = compareWhole(true)) return found;
    }
    if (auto found = readAll()) return found;
    return checkHistory();
  }

  const Detours& detours() const { return player_.detours(); }

 private:
  using Result = std::optional<Mismatch>;

  const Model& model() const { return steps_.model(); }

  Mismatch mismatch(Mismatch::Kind kind, std::string text) const {
    if (!text.ends_with('\n')) text += '\n';
    Outline outline = outlineOf(player_.world());
    return {
        kind, std::move(text), edits_, commits_, player_.scene(), outline, outline, {edited_.begin(), edited_.end()},
        {}};
  }

  tl::expected<Result, TraceError> apply(const Step& step) {
    std::vector<PolygonHandle> removed;
    std::vector<Cell> cells;
    for (const Edit& edit : step.edits) {
      const bool isRemoval = step.verdict.accepted && edit.kind == Edit::Kind::remove;
      if (isRemoval && step.door != Door::setBlock) removed.push_back(player_.handleOf(edit.name));
      cells.push_back(isRemoval ? player_.cellOf(edit.name) : edit.polygon.cell);
    }
    const Stats before = step.verdict.accepted ? Stats() : player_.world().stats();
    const auto done = player_.apply(step);
    if (!step.isTrial) stats_.edits += step.edits.size();
    if (std::string wrong = wrongAnswer(step, done, model(), player_.world()); !wrong.empty())
      return mismatch(Mismatch::Kind::verdict, std::move(wrong));
    if (!step.verdict.accepted) return afterRefusal(step, done.error(), before);
    stats_.doors[static_cast<std::size_t>(step.door)] += step.edits.size();
    stats_.worn += step.worn == 0 ? 0 : 1;
    edited_.insert(cells.begin(), cells.end());
    return checkStale(removed);
  }

  tl::expected<Result, TraceError> afterRefusal(const Step& step, const TraceError& error, const Stats& before) {
    if (error.refusal) {
      const Cell cell = step.edits.front().polygon.cell;
      if (readCell(player_, model(), cell) || !sameCounts(player_.world().stats(), before))
        return mismatch(Mismatch::Kind::refusal, fmt::format("the refusal changed something: {}", inWords(step)));
    }
    if (!step.isTrial) {
      if (!options_.skipRefused) return tl::unexpected(error);
      ++stats_.refused;
    }
    stats_.full += step.verdict.code == ErrorCode::capacity ? 1 : 0;
    return Result();
  }

  tl::expected<Result, TraceError> checkStale(const std::vector<PolygonHandle>& handles) {
    for (const PolygonHandle handle : handles) {
      const auto again = player_.world().remove(handle);
      if (again || again.error().code != ErrorCode::staleHandle || again.error().other != handle ||
          player_.world().polygon(handle) || player_.world().cellOf(handle)) {
        return mismatch(Mismatch::Kind::verdict, "the handle of a removed polygon is not stale");
      }
      stale_.push_back(handle);
    }
    return Result();
  }

  Result commit() {
    const Changes& changes = player_.commit();
    ++commits_;
    ++stats_.commits;
    if (auto problem = mirror_.update(player_.world(), changes)) {
      Mismatch found = mismatch(Mismatch::Kind::changes, std::move(*problem));
      found.marked = mirror_.blamed();
      return found;
    }
    for (const Cell& cell : edited_)
      if (auto found = reading(readCell(player_, model(), cell))) return found;
    lastWasWhole_ = options_.wholeEvery != 0 && commits_ % options_.wholeEvery == 0;
    if (auto found = lastWasWhole_ ? compareWhole(!options_.unionAtEnd) : compareWindow()) return found;
    constexpr std::size_t kReadEvery = 8;  // it takes half as long as all the rest of a commit
    if (lastWasWhole_ && stats_.whole % kReadEvery == 0) {
      if (auto found = readAll()) return found;
    }
    edited_.clear();
    stopped_ = options_.afterCommit && !options_.afterCommit(player_.scene());
    return std::nullopt;
  }

  // Asks the world everything. To be called after a commit.
  Result readAll() {
    ++stats_.read;
    const World& world = player_.world();
    const auto isThere = [&](PolygonHandle handle) { return world.polygon(handle).has_value(); };
    if (std::ranges::any_of(stale_, isThere))
      return mismatch(Mismatch::Kind::reading, "the handle of a removed polygon names another one now");
    if (auto found = reading(readPolygons(player_, model()))) return found;
    if (auto found = reading(readSegments(world, mirror_.segments()))) return found;
    return reading(readLoops(world, mirror_.segments()));
  }

  Result reading(std::optional<WrongRead> wrong) const {
    if (!wrong) return std::nullopt;
    Mismatch found = mismatch(Mismatch::Kind::reading, std::move(wrong->text));
    found.marked = std::move(wrong->about);
    return found;
  }

  // The union and the loops take longest, so they can be left out.
  Result compareWhole(bool withUnion) {
    ++stats_.whole;
    const Outline actual = outlineOf(player_.world());
    if (options_.naive) {
      ++stats_.naive;
      const Outline& expected = naive_(player_.scene()).outline;
      if (auto found = compareOutlines(Mismatch::Kind::naive, player_.scene(), expected, actual)) return found;
    }
    if (!withUnion || !options_.cgal) return std::nullopt;
    const auto united = cgalUnion(player_.scene());
    if (!united) return std::nullopt;  // a preserve relation that is no partition: CGAL has no say
    ++stats_.cgal;
    const Outline expected = withUnknownLinksOf(actual, united->outline, united->known);
    if (auto found = compareOutlines(Mismatch::Kind::cgal, player_.scene(), expected, actual)) return found;
    return trace_.preserve.empty() ? compareLoops(canonical(united->loops)) : std::nullopt;
  }

  Result compareLoops(const Loops& expected) {
    Loops actual;
    for (Loop& loop : player_.world().loops(Collinear::merge)) actual.push_back(std::move(loop.vertices));
    if (actual == expected) return std::nullopt;
    return mismatch(Mismatch::Kind::loops,
                    fmt::format("{} loops where there should be {}, or others, though all segments and links are right",
                                actual.size(), expected.size()));
  }

  Result compareWindow() {
    const CellSet judged = around(edited_);
    const Scene scene = sceneOf(model(), trace_.preserve, around(judged));
    Outline actual;
    for (const Cell& cell : judged) {
      for (const SegmentId id : player_.world().segments(CellRect{cell, cell})) {
        if (const auto segment = player_.world().segment(id)) actual.push_back(outlineSegment(*segment));
      }
    }
    std::sort(actual.begin(), actual.end());
    if (options_.naive) {
      ++stats_.naive;
      Outline expected = naive_(scene).outline;
      keepOnly(expected, judged);
      if (auto found = compareOutlines(Mismatch::Kind::naive, scene, expected, actual)) return found;
    }
    if (options_.cgal) {
      if (const auto united = cgalUnion(scene)) {
        ++stats_.cgal;
        Outline expected = withUnknownLinksOf(actual, united->outline, united->known);
        keepOnly(expected, judged);
        if (auto found = compareOutlines(Mismatch::Kind::cgal, scene, expected, actual)) return found;
      }
    }
    return std::nullopt;
  }

  Result compareOutlines(Mismatch::Kind kind, const Scene& scene, const Outline& expected, const Outline& actual) {
    stats_.segments += expected.size();
    if (expected == actual) return std::nullopt;
    Mismatch found = mismatch(kind, describe(compare(expected, actual)));
    found.scene = scene;
    found.expected = expected;
    found.actual = actual;
    return found;
  }

  Result checkHistory() {
    const Trace another = inAnotherOrder(player_.scene());
    Player fresh(trace_.preserve);
    Steps steps(another);
    while (const auto step = steps.next()) {
      if (const auto done = fresh.apply(*step); !done)
        return mismatch(Mismatch::Kind::history, "added in another order, a polygon is refused: " + done.error().text);
    }
    // Threads would share the jobs of this executor. It runs the last one first: their order must not matter either.
    fresh.world().commit([](std::size_t jobs, const std::function<void(std::size_t)>& run) {
      while (jobs-- > 0) run(jobs);
    });
    return compareOutlines(Mismatch::Kind::history, player_.scene(), outlineOf(fresh.world()),
                           outlineOf(player_.world()));
  }

  const Trace& trace_;
  const CheckOptions& options_;
  CheckStats& stats_;
  Player player_;
  Steps steps_;
  Mirror mirror_;
  NaiveReference naive_;
  std::vector<PolygonHandle> stale_;  // of all polygons that were removed
  CellSet edited_;
  std::size_t edits_ = 0;
  std::size_t commits_ = 0;
  bool lastWasWhole_ = false;
  bool stopped_ = false;
};

}  // namespace

tl::expected<std::optional<Mismatch>, TraceError> checkTrace(const Trace& trace, const CheckOptions& options,
                                                             CheckStats& stats) {
  Check check(trace, options, stats);
  auto result = check.run();
  stats.detours += check.detours();
  return result;
}

}  // namespace lgs::oracle
