#include "oracle/check/checker.h"

#include "oracle/cgal/cgal_union.h"
#include "oracle/check/window.h"
#include "oracle/generate/random.h"
#include "oracle/reference/canonical.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/mirror.h"
#include "oracle/trace/model.h"
#include "oracle/trace/player.h"

#include <fmt/format.h>
#include <algorithm>
#include <functional>

namespace lgs::oracle {
namespace {

Loops mergedLoops(const World& world) {
  Loops loops;
  for (Loop& loop : world.loops(Collinear::merge)) loops.push_back(std::move(loop.vertices));
  return canonical(std::move(loops));
}

bool equalPolygons(std::vector<PlacedPolygon> actual, const std::vector<Model::Placed>& expected) {
  return actual.size() == expected.size() && std::all_of(expected.begin(), expected.end(), [&](const Model::Placed& e) {
           return std::any_of(actual.begin(), actual.end(), [&](const PlacedPolygon& a) {
             return a.block == e.block &&
                    std::is_permutation(a.vertices.begin(), a.vertices.end(), e.vertices.begin(), e.vertices.end());
           });
         });
}

class Check {
 public:
  Check(const Trace& trace, const CheckOptions& options, CheckStats& stats)
      : trace_(trace), options_(options), stats_(stats), player_(trace.preserve) {}

  tl::expected<std::optional<Mismatch>, TraceError> run() {
    for (const Edit& edit : trace_.edits) {
      ++edits_;
      if (edit.kind == Edit::Kind::commit) {
        if (auto mismatch = commit()) return mismatch;
        if (stopped_) return std::nullopt;
      } else {
        auto mismatch = apply(edit);
        if (!mismatch || *mismatch) return mismatch;
      }
    }
    if (player_.pending()) {
      if (auto mismatch = commit()) return mismatch;
      if (stopped_) return std::nullopt;
    }
    if (!lastWasWhole_ || options_.unionAtEnd) {
      if (auto mismatch = compareWhole(true)) return mismatch;
    }
    return checkHistory();
  }

 private:
  using Result = std::optional<Mismatch>;

  Mismatch mismatch(Mismatch::Kind kind, std::string text) const {
    if (!text.ends_with('\n')) text += '\n';
    Outline outline = outlineOf(player_.world());
    return {
        kind, std::move(text), edits_, commits_, player_.scene(), outline, outline, {edited_.begin(), edited_.end()}};
  }

  tl::expected<Result, TraceError> apply(const Edit& edit) {
    ++stats_.edits;
    const Model::Verdict verdict = model_.judge(edit);
    const bool isRemoval = edit.kind == Edit::Kind::remove && verdict.accepted;
    const Cell cell = isRemoval ? model_.cellOf(edit.name) : edit.polygon.cell;
    const PolygonHandle handle = isRemoval ? player_.handleOf(edit.name) : PolygonHandle{};
    const auto done = player_.apply(edit);
    if (done && verdict.accepted) {
      model_.apply(edit);
      edited_.insert(cell);
      if (isRemoval) return checkStale(handle);
      return Result();
    }
    if (done) {
      return mismatch(Mismatch::Kind::verdict,
                      fmt::format("accepted, but must be refused as {}: add '{}'", nameOf(verdict.code), edit.name));
    }
    const TraceError& error = done.error();
    if (error.refusal == ErrorCode::capacity) return tl::unexpected(error);  // limits are the engine's own
    if (verdict.accepted) {
      return mismatch(Mismatch::Kind::verdict, fmt::format("refused, but is good: '{}': {}", edit.name, error.text));
    }
    if (error.refusal != verdict.code) {
      return mismatch(Mismatch::Kind::verdict,
                      fmt::format("refused as {}, but must be as {}: '{}': {}", nameOf(error.refusal),
                                  nameOf(verdict.code), edit.name, error.text));
    }
    if (!options_.skipRefused) return tl::unexpected(error);
    ++stats_.refused;
    if (!verdict.code) return Result();  // the engine was not asked
    if (!equalPolygons(player_.world().polygons(cell), model_.in(cell))) {
      return mismatch(Mismatch::Kind::refusal, fmt::format("the refusal of '{}' changed its cell", edit.name));
    }
    return Result();
  }

  static std::string nameOf(std::optional<ErrorCode> code) { return code ? name(*code) : "a bad name"; }

  tl::expected<Result, TraceError> checkStale(PolygonHandle handle) {
    const auto again = player_.world().remove(handle);
    if (again || again.error().code != ErrorCode::staleHandle || player_.world().polygon(handle)) {
      return mismatch(Mismatch::Kind::verdict, "the handle of a removed polygon is not stale");
    }
    return Result();
  }

  Result commit() {
    const Changes& changes = player_.commit();
    ++commits_;
    ++stats_.commits;
    if (auto problem = mirror_.update(player_.world(), changes)) {
      return mismatch(Mismatch::Kind::changes, std::move(*problem));
    }
    for (const Cell& cell : edited_) {
      if (!equalPolygons(player_.world().polygons(cell), model_.in(cell))) {
        return mismatch(Mismatch::Kind::reading, fmt::format("cell ({}, {}) does not read as edited", cell.i, cell.j));
      }
    }
    lastWasWhole_ = options_.wholeEvery != 0 && commits_ % options_.wholeEvery == 0;
    if (auto found = lastWasWhole_ ? compareWhole(!options_.unionAtEnd) : compareWindow()) return found;
    edited_.clear();
    stopped_ = options_.afterCommit && !options_.afterCommit(player_.scene());
    return std::nullopt;
  }

  // With or without what takes longest: the union, the loops and the counts.
  Result compareWhole(bool withUnion) {
    ++stats_.whole;
    const Outline actual = outlineOf(player_.world());
    const bool compareLoops = withUnion && trace_.preserve.empty();
    const Loops loops = compareLoops ? mergedLoops(player_.world()) : Loops();
    const auto differ = [&](Loops expected) {
      return mismatch(
          Mismatch::Kind::loops,
          fmt::format("{} loops where there should be {}, or others, though all segments and links are right",
                      loops.size(), expected.size()));
    };
    if (options_.naive) {
      ++stats_.naive;
      const Outline& expected = naive_(player_.scene()).outline;
      if (auto found = compareOutlines(Mismatch::Kind::naive, player_.scene(), expected, actual)) return found;
      if (compareLoops) {
        const auto followed = followLinks(expected);
        if (!followed || canonical(*followed) != loops) return differ(followed.value_or(Loops()));
      }
    }
    if (withUnion && options_.cgal) {
      if (const auto united = cgalUnion(player_.scene())) {
        ++stats_.cgal;
        const Outline expected = withUnknownLinksOf(actual, united->outline, united->known);
        if (auto found = compareOutlines(Mismatch::Kind::cgal, player_.scene(), expected, actual)) return found;
        if (compareLoops && canonical(united->loops) != loops) return differ(united->loops);
      }
    }
    return withUnion ? checkCounts(actual.size()) : std::nullopt;
  }

  // Reading cell by cell gives every segment once, in its cell; and no polygon is there that was not added.
  Result checkCounts(std::size_t total) {
    const std::uint64_t polygons = player_.world().stats().polygons;
    if (polygons != model_.polygons()) {
      return mismatch(Mismatch::Kind::reading,
                      fmt::format("{} polygons, but there should be {}", polygons, model_.polygons()));
    }
    std::size_t count = 0;
    for (const auto& entry : model_.cells()) {
      for (const SegmentId id : player_.world().segments(CellRect{entry.first, entry.first})) {
        const auto segment = player_.world().segment(id);
        if (segment && segment->cell == entry.first) ++count;
      }
    }
    if (count == total) return std::nullopt;
    return mismatch(Mismatch::Kind::reading, fmt::format("{} segments in all, but {} cell by cell", total, count));
  }

  Result compareWindow() {
    const CellSet judged = around(edited_);
    const Scene scene = sceneOf(model_, trace_.preserve, around(judged));
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
    Player fresh(trace_.preserve);
    std::vector<ScenePolygon> polygons = player_.scene().polygons;
    Random(polygons.size()).shuffle(polygons);
    std::size_t count = 0;
    for (ScenePolygon& polygon : polygons) {
      if (const auto done = fresh.apply(Edit::add(std::to_string(++count), std::move(polygon))); !done) {
        return mismatch(Mismatch::Kind::history, "added in another order, a polygon is refused: " + done.error().text);
      }
    }
    // Built in the jobs that several threads would share, the last one first: their order must not matter either.
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
  Model model_;
  Mirror mirror_;
  NaiveReference naive_;
  CellSet edited_;
  std::size_t edits_ = 0;
  std::size_t commits_ = 0;
  bool lastWasWhole_ = false;
  bool stopped_ = false;
};

}  // namespace

std::string describe(Mismatch::Kind kind) {
  switch (kind) {
    case Mismatch::Kind::verdict:
      return "an edit was not judged as it must be";
    case Mismatch::Kind::refusal:
      return "a refused edit changed something";
    case Mismatch::Kind::changes:
      return "the change list is wrong";
    case Mismatch::Kind::reading:
      return "the world does not read as it was edited";
    case Mismatch::Kind::naive:
      return "the outline differs from the naive reference's";
    case Mismatch::Kind::cgal:
      return "the outline differs from CGAL's";
    case Mismatch::Kind::loops:
      return "the loops are wrong";
    case Mismatch::Kind::history:
      return "the outline depends on the order of the edits";
  }
  return {};
}

tl::expected<std::optional<Mismatch>, TraceError> checkTrace(const Trace& trace, const CheckOptions& options,
                                                             CheckStats& stats) {
  return Check(trace, options, stats).run();
}

}  // namespace lgs::oracle
