#include "oracle/check/checker.h"

#include "oracle/calls/random.h"
#include "oracle/cgal/brushed.h"
#include "oracle/cgal/cgal_union.h"
#include "oracle/check/comparable.h"
#include "oracle/check/failure.h"
#include "oracle/check/library_engine.h"
#include "oracle/check/reach.h"
#include "oracle/check/refusal.h"
#include "oracle/check/window.h"
#include "oracle/generate/ways.h"
#include "oracle/reference/canonical.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/brushing.h"
#include "oracle/trace/row.h"
#include "oracle/views/named_islands.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

// A trace that adds the polygons of a scene, cell by cell.
Trace inAnotherOrder(const Scene& scene) {
  std::vector<ScenePolygon> polygons = scene.polygons;
  Random random(polygons.size());
  random.shuffle(polygons);
  std::ranges::stable_sort(polygons, std::greater(), &ScenePolygon::cell);
  Trace trace{scene.preserve, {}};
  for (ScenePolygon& polygon : polygons)
    trace.edits.push_back(Edit::add(fmt::format("p{}", trace.edits.size()), std::move(polygon)));
  chooseWays(trace.edits, random);
  return trace;
}

class Check {
 public:
  Check(const Trace& trace, const CheckOptions& options, CheckStats& stats)
      : trace_(trace),
        options_(options),
        stats_(stats),
        library_(options.engine ? nullptr : &own_),
        engine_(options.engine ? *options.engine : own_),
        rows_(trace) {
    if (options.views) own_.followViews();
  }

  tl::expected<std::optional<Mismatch>, TraceError> run() {
    engine_.reset(trace_.preserve);
    while (const auto row = rows_.next(calls())) {
      edits_ = row->end;
      if (row->isCommit()) {
        if (library_ != nullptr) library_->useExecutor(row->way.number);
        if (auto found = commit()) return found;
        if (stopped_) return std::nullopt;
      } else {
        if (row->verdict.accepted) edited_.insert(row->cells.begin(), row->cells.end());
        auto found = apply(*row);
        if (!found || *found) return found;
      }
    }
    if (pending_) {
      if (auto found = commit()) return found;
      if (stopped_) return std::nullopt;
    }
    if (!lastWasWhole_ || options_.unionAtEnd) {
      if (auto found = compareWhole(true)) return found;
    }
    if (auto found = readAll()) return found;
    return checkHistory();
  }

  void addDetours() {
    for (std::size_t k = 0; library_ != nullptr && k < kDetours; ++k) stats_.detours[k] += library_->detours()[k];
  }

 private:
  using Result = std::optional<Mismatch>;

  const CallModel& calls() const { return library_ != nullptr ? library_->calls() : placed_; }
  const Model& model() const { return calls().standing(); }
  Scene scene() const { return model().scene(trace_.preserve); }

  Mismatch mismatch(Mismatch::Kind kind, std::string text) const {
    if (!text.ends_with('\n')) text += '\n';
    Outline outline = engine_.outline();
    return {kind, std::move(text), edits_, commits_, scene(), outline, outline, {edited_.begin(), edited_.end()},
            {},   engine_.can()};
  }

  Mismatch mismatch(Complaint complaint) const {
    Mismatch found = mismatch(complaint.kind, std::move(complaint.text));
    found.marked = std::move(complaint.marked);
    return found;
  }

  // The outline of an engine that gave no answer is an old one. The picture shows what it should have answered.
  Mismatch mismatch(const Failure& failure) {
    constexpr std::array kKinds{Mismatch::Kind::crash, Mismatch::Kind::hang, Mismatch::Kind::protocol};
    const std::string text = inWords(failure, fmt::format(" after edit {}", edits_));
    Mismatch found = mismatch(kKinds[static_cast<std::size_t>(failure.kind)], text);
    found.expected = found.actual = comparable(naive_(scene()).outline, engine_.can());
    return found;
  }

  tl::expected<Result, TraceError> apply(const Row& row) {
    if (!row.isTrial) stats_.edits += row.edits.size();
    if (row.way.door == Door::brush) return brush(row);
    if (row.verdict.accepted) note(row);
    if (library_ != nullptr) return applyByDoor(row);
    return row.isTrial ? Result() : applyOneByOne(row);
  }

  void note(const Row& row) {
    stats_.doors[static_cast<std::size_t>(row.way.door)] += row.edits.size();
    pending_ = true;
  }

  // From then on, what the brush did is as if it had been done by hand.
  tl::expected<Result, TraceError> brush(const Row& row) {
    const Edit& edit = row.edits.front();
    if (library_ == nullptr) return tl::unexpected(TraceError{edit.line, "only this library's engine has brushes", {}});
    const auto [min, max] = cellsUnder(edit.brush);
    const CellRect near{{min.i - 1, min.j - 1}, {max.i + 1, max.j + 1}};
    const Scene before = sceneOf(model(), near);
    const auto done = library_->brush(edit);
    if (!done) return refusedBrush(row, done.error());
    if (!row.verdict.accepted) return mismatch(Mismatch::Kind::verdict, "a brush is out of reach, but is accepted");
    note(row);
    if (std::string wrong = wrongReach(edit.brush, *done); !wrong.empty())
      return mismatch(Mismatch::Kind::reach, std::move(wrong));
    for (const auto& entry : done->went) edited_.insert(entry.second.cell);
    for (const Edit& part : done->edits)
      if (part.kind == Edit::Kind::add) edited_.insert(part.polygon.cell);
    if (!options_.cgal) return Result();
    ++stats_.brushed;
    auto far = farFromExact(before, edit.brush, sceneOf(model(), near));
    if (!far) return Result();
    if (const auto refusals = engine_.commit(); !refusals) return mismatch(refusals.error());  // for the picture
    return mismatch(Mismatch::Kind::rounding, std::move(*far));
  }

  // Whether a cell is full can not be known beforehand.
  tl::expected<Result, TraceError> refusedBrush(const Row& row, const TraceError& error) {
    const std::optional<Error>& refusal = error.refusal;
    const bool isExpected = refusal && refusal->code == row.verdict.code.value_or(ErrorCode::capacity);
    if (!isExpected)
      return mismatch(Mismatch::Kind::verdict, (refusal ? "a brush is refused, but is good: " : "") + error.text);
    if (auto complaint = library_->afterRefusedBrush()) return mismatch(std::move(*complaint));
    if (!options_.skipRefused) return tl::unexpected(error);
    ++stats_.refused;
    return Result();
  }

  tl::expected<Result, TraceError> applyByDoor(const Row& row) {
    stats_.full += row.verdict.code == ErrorCode::capacity ? 1 : 0;
    auto complaint = library_->apply(row);
    if (!complaint) return refused(row, complaint.error());
    if (*complaint) return mismatch(std::move(**complaint));
    return Result();
  }

  // The limits of a cell are this library's: other engines never see an edit that is refused for them.
  tl::expected<Result, TraceError> applyOneByOne(const Row& row) {
    const auto& [accepted, code, cell, index] = row.verdict;
    if (accepted || (engine_.can().refuses && code != ErrorCode::capacity)) {
      for (const Edit& edit : row.edits) {
        edit.kind == Edit::Kind::add ? engine_.add(edit.name, edit.polygon) : engine_.remove(edit.name);
        if (accepted)
          placed_.apply(edit, edit.kind == Edit::Kind::add ? PolygonHandle{1, ++handles_} : PolygonHandle{});
      }
    } else if (options_.skipRefused) {
      return Result();
    }
    if (accepted) return Result();
    pending_ = true;  // the refusal comes with the next commit
    return refused(row, {row.edits.front().line, "must be refused: " + inWords(row), {}});
  }

  tl::expected<Result, TraceError> refused(const Row& row, const TraceError& error) {
    if (!options_.skipRefused) return tl::unexpected(error);
    ++stats_.refused;
    const auto& code = row.verdict.code;
    expected_.push_back({row.edits.front().name, code ? lgs::name(*code) : "a bad name"});
    return Result();
  }

  Result commit() {
    const auto refusals = engine_.commit();
    ++commits_;
    ++stats_.commits;
    pending_ = false;
    if (!refusals) return mismatch(refusals.error());
    if (std::string wrong = wrongRefusals(std::exchange(expected_, {}), *refusals); !wrong.empty())
      return mismatch(Mismatch::Kind::verdict, std::move(wrong));
    if (library_ != nullptr) {
      if (auto complaint = library_->afterCommit(edited_)) return mismatch(std::move(*complaint));
    }
    // A joined segment belongs to many cells, so nothing can be said of some of them.
    lastWasWhole_ = engine_.can().merged || (options_.wholeEvery != 0 && commits_ % options_.wholeEvery == 0);
    if (auto found = lastWasWhole_ ? compareWhole(!options_.unionAtEnd) : compareWindow()) return found;
    if (auto found = compareIslands()) return found;
    constexpr std::size_t kReadEvery = 8;  // it takes half as long as all the rest of a commit
    if (lastWasWhole_ && stats_.whole % kReadEvery == 0) {
      if (auto found = readAll()) return found;
    }
    edited_.clear();
    stopped_ = options_.afterCommit && !options_.afterCommit(model());
    return std::nullopt;
  }

  Result readAll() {
    if (library_ == nullptr) return std::nullopt;
    ++stats_.read;
    auto complaint = library_->readAll();
    return complaint ? Result(mismatch(std::move(*complaint))) : std::nullopt;
  }

  // The union and the loops take longest, so they can be left out.
  Result compareWhole(bool withUnion) {
    ++stats_.whole;
    const Outline actual = engine_.outline();
    const Scene all = scene();
    if (options_.naive) {
      ++stats_.naive;
      if (auto found = compareOutlines(Mismatch::Kind::naive, all, naive_(all).outline, actual)) return found;
    }
    if (!withUnion || !options_.cgal) return std::nullopt;
    const auto united = cgalUnion(all);
    if (!united) return std::nullopt;  // a preserve relation that is no partition: CGAL has no say
    if (auto found = compareUnion(all, *united, actual, nullptr)) return found;
    return library_ != nullptr && trace_.preserve.empty() ? compareLoops(canonical(united->loops)) : std::nullopt;
  }

  Result compareIslands() const {
    if (!engine_.can().islands) return std::nullopt;
    std::string text = describeIslands(namedIslands(scene()), engine_.islands());
    return text.empty() ? Result() : mismatch(Mismatch::Kind::views, std::move(text));
  }

  Result compareLoops(const Loops& expected) {
    const Loops actual = library_->loops();
    if (actual == expected) return std::nullopt;
    return mismatch(Mismatch::Kind::loops,
                    fmt::format("{} loops where there should be {}, or others, though all segments and links are right",
                                actual.size(), expected.size()));
  }

  Result compareWindow() {
    const CellSet judged = around(edited_);
    const Scene near = sceneOf(model(), trace_.preserve, around(judged));
    Outline actual = library_ != nullptr ? library_->outlineIn(judged) : engine_.outline();
    if (library_ == nullptr) keepOnly(actual, judged);
    if (options_.naive) {
      ++stats_.naive;
      Outline expected = naive_(near).outline;
      keepOnly(expected, judged);
      if (auto found = compareOutlines(Mismatch::Kind::naive, near, expected, actual)) return found;
    }
    if (!options_.cgal) return std::nullopt;
    const auto united = cgalUnion(near);
    return united ? compareUnion(near, *united, actual, &judged) : std::nullopt;
  }

  // With CGAL, which does not know all links. It can not be asked which of those of joined segments it knows.
  Result compareUnion(const Scene& scene, const CgalUnion& united, const Outline& actual, const CellSet* judged) {
    ++stats_.cgal;
    Outline expected = withUnknownLinksOf(actual, united.outline, united.known);
    if (judged != nullptr) keepOnly(expected, *judged);
    Capabilities can = engine_.can();
    can.ghosts = can.ghosts && (!can.merged || scene.preserve.empty());
    return compareOutlines(Mismatch::Kind::cgal, scene, expected, actual, can);
  }

  Result compareOutlines(Mismatch::Kind kind, const Scene& scene, const Outline& expected, const Outline& actual) {
    return compareOutlines(kind, scene, expected, actual, engine_.can());
  }

  Result compareOutlines(Mismatch::Kind kind, const Scene& scene, const Outline& expected, const Outline& actual,
                         const Capabilities& can) {
    stats_.segments += expected.size();
    if (expected == actual) return std::nullopt;
    Mismatch found = mismatch(kind, "");
    found.expected = comparable(expected, can);
    found.actual = comparable(actual, can);
    found.can = can;
    if (found.expected == found.actual) return std::nullopt;
    found.text = describe(compare(found.expected, found.actual));
    found.scene = scene;
    return found;
  }

  Result checkHistory() {
    const Trace another = inAnotherOrder(scene());
    const Outline before = engine_.outline();
    if (library_ != nullptr) {
      const auto afresh = LibraryEngine::outlineAtOnce(another);
      if (afresh) return compareOutlines(Mismatch::Kind::history, scene(), *afresh, before);
      return mismatch(Mismatch::Kind::history, "added in another order, a polygon is refused: " + afresh.error().text);
    }
    engine_.reset(another.preserve);
    for (const Edit& edit : another.edits) engine_.add(edit.name, edit.polygon);
    const auto refusals = engine_.commit();
    if (!refusals) return mismatch(refusals.error());
    if (std::string wrong = wrongRefusals({}, *refusals); !wrong.empty())
      return mismatch(Mismatch::Kind::history, "added in another order: " + wrong);
    return compareOutlines(Mismatch::Kind::history, scene(), engine_.outline(), before);
  }

  const Trace& trace_;
  const CheckOptions& options_;
  CheckStats& stats_;
  LibraryEngine own_;
  LibraryEngine* const library_;  // null, if another engine is checked
  Engine& engine_;
  Rows rows_;
  CallModel placed_;           // in another engine
  std::uint32_t handles_ = 0;  // that it might have given
  NaiveReference naive_;
  std::vector<RefusedEdit> expected_;  // what must be refused since the last commit, and why
  CellSet edited_;
  std::size_t edits_ = 0;
  std::size_t commits_ = 0;
  bool pending_ = false;
  bool lastWasWhole_ = false;
  bool stopped_ = false;
};

}  // namespace

tl::expected<std::optional<Mismatch>, TraceError> checkTrace(const Trace& trace, const CheckOptions& options,
                                                             CheckStats& stats) {
  Check check(trace, options, stats);
  auto result = check.run();
  if (options.engine == nullptr) check.addDetours();
  return result;
}

}  // namespace lgs::oracle
