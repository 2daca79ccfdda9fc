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
#include "oracle/generate/forms.h"
#include "oracle/reference/canonical.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/call_text.h"
#include "oracle/trace/plain_edits.h"
#include "oracle/views/named_islands.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

// A trace that adds the polygons of a scene, cell by cell.
Trace inAnotherOrder(const Scene& scene, bool inForms) {
  std::vector<ScenePolygon> polygons = scene.polygons;
  Random random(polygons.size());
  random.shuffle(polygons);
  std::ranges::stable_sort(polygons, std::greater(), &ScenePolygon::cell);
  Trace trace{scene.preserve, {}};
  for (ScenePolygon& polygon : polygons)
    trace.calls.push_back(Call::add(fmt::format("p{}", trace.calls.size()), std::move(polygon)));
  if (!inForms) return trace;
  Model model;
  const std::vector<Call> edits = std::exchange(trace.calls, {});
  makeInForms(edits, model, random, [&](Call call) { trace.calls.push_back(std::move(call)); });
  return trace;
}

class Check {
 public:
  Check(const Trace& trace, const CheckOptions& options, CheckStats& stats)
      : trace_(trace),
        options_(options),
        stats_(stats),
        library_(options.engine ? nullptr : &own_),
        engine_(options.engine ? *options.engine : own_) {
    if (options.views) own_.followViews();
  }

  tl::expected<std::optional<Mismatch>, TraceError> run() {
    engine_.reset(trace_.preserve);
    for (const Call& call : trace_.calls) {
      ++edits_;
      if (call.kind == Call::Kind::commit || call.kind == Call::Kind::load) {
        if (auto found = commit(call.nth)) return found;
        if (stopped_) return std::nullopt;
      }
      if (call.kind == Call::Kind::commit) continue;
      auto found = apply(call);
      if (!found || *found) return found;
    }
    if (pending()) {
      if (auto found = commit(0)) return found;
      if (stopped_) return std::nullopt;
    }
    if (!lastWasWhole_ || options_.unionAtEnd) {
      if (auto found = compareWhole(true)) return found;
    }
    if (auto found = readAll()) return found;
    if (auto found = comparePast()) return found;
    return checkHistory();
  }

 private:
  using Result = std::optional<Mismatch>;

  const Model& model() const { return library_ != nullptr ? library_->model() : placed_; }
  bool pending() const { return library_ != nullptr ? library_->player().pending() : pending_; }
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

  tl::expected<Result, TraceError> apply(const Call& call) {
    ++stats_.edits;
    if (library_ == nullptr) return applyByName(call);
    Judged judged;
    if (call.kind != Call::Kind::group && call.kind != Call::Kind::repeat) judged = library_->player().judge(call);
    const Verdict& verdict = judged.verdict;
    stats_.full += !verdict.accepted && verdict.code == ErrorCode::capacity ? 1 : 0;
    const bool isBrush = call.kind == Call::Kind::brush;
    const Scene before = isBrush ? sceneOf(model().standing(), near(call.brush)) : Scene();
    touch(call, judged);
    auto complaint = library_->apply(call, judged);
    if (!complaint) return refused(call, verdict, complaint.error());
    if (*complaint) return mismatch(std::move(**complaint));
    ++stats_.made[static_cast<std::size_t>(call.kind)];
    if (isBrush) return brushed(call.brush, before);
    const bool hasTravelled = call.kind == Call::Kind::goBack || call.kind == Call::Kind::goForward;
    return hasTravelled && !pending() ? compareWhole(false) : Result();
  }

  // The cells that a call may edit.
  void touch(const Call& call, const Judged& judged) {
    if (!judged.verdict.accepted) return;
    for (const Call& part : call.group) touch(part, {part, {}});
    for (const Coming& coming : judged.call.comes) edited_.insert(coming.cell);
    for (const Named& named : judged.call.goes)
      if (model().isAlive(named.name)) edited_.insert(model().standing().cellOf(named.name));
    const bool isFilled = call.kind == Call::Kind::fill && !isTooLarge(call.cells);
    if (isFilled || call.kind == Call::Kind::exchange)
      for (std::int64_t j = call.cells.min.j; j <= call.cells.max.j; ++j)  // which may be the last number of 32 bits
        for (std::int64_t i = call.cells.min.i; i <= call.cells.max.i; ++i)
          edited_.insert({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)});
    if (call.kind == Call::Kind::clear)
      for (const auto& entry : model().standing().cells())
        if (contains(call.cells, entry.first)) edited_.insert(entry.first);
  }

  static CellRect near(const BrushEdit& brush) {
    const auto [min, max] = cellsUnder(brush);
    return {{min.i - 1, min.j - 1}, {max.i + 1, max.j + 1}};
  }

  // From then on, what the brush did is as if it had been done by hand.
  Result brushed(const BrushEdit& brush, const Scene& before) {
    const Brushed& done = library_->player().brushed();
    if (std::string wrong = wrongReach(brush, done); !wrong.empty())
      return mismatch(Mismatch::Kind::reach, std::move(wrong));
    for (const auto& entry : done.went) edited_.insert(entry.second.cell);
    for (const Call& part : done.edits)
      if (part.kind == Call::Kind::add) edited_.insert(part.comes[0].cell);
    if (!options_.cgal || !brush.staying.empty()) return std::nullopt;
    ++stats_.brushed;
    auto far = farFromExact(before, brush, sceneOf(model().standing(), near(brush)));
    if (!far) return std::nullopt;
    if (const auto refusals = engine_.commit(); !refusals) return mismatch(refusals.error());  // for the picture
    return mismatch(Mismatch::Kind::rounding, std::move(*far));
  }

  // The limits of a cell are this library's: other engines never see an edit that is refused for them.
  tl::expected<Result, TraceError> applyByName(const Call& call) {
    if (!isPlain(call))
      return tl::unexpected(TraceError{call.line, "only this library's engine has such calls: " + printCall(call), {}});
    const Verdict verdict = placed_.judge(call);
    if (verdict.accepted || (engine_.can().refuses && verdict.code != ErrorCode::capacity)) {
      call.kind == Call::Kind::add ? engine_.add(call.name(), call.polygon()) : engine_.remove(call.name());
    } else if (options_.skipRefused) {
      return Result();
    }
    pending_ = true;  // a refusal comes with the next commit
    if (!verdict.accepted) return refused(call, verdict, {call.line, "must be refused: " + printCall(call), {}});
    touch(call, {placed_.resolved(call), verdict});
    placed_.play(call);
    return Result();
  }

  tl::expected<Result, TraceError> refused(const Call& call, const Verdict& verdict, const TraceError& error) {
    if (!options_.skipRefused && !trace_.mayRefuse) return tl::unexpected(error);
    ++stats_.refused;
    expected_.push_back({call.name(), verdict.code ? lgs::name(*verdict.code) : "a bad name"});
    return Result();
  }

  Result commit(std::uint32_t executor) {
    if (library_ != nullptr) library_->useExecutor(executor);
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
    if (lastWasWhole_ && (options_.questions != 0 || stats_.whole % kReadEvery == 0)) {
      if (auto found = readAll()) return found;
    }
    edited_.clear();
    stopped_ = options_.afterCommit && !options_.afterCommit(model());
    return std::nullopt;
  }

  Result readAll() {
    constexpr std::size_t kQuestions = 3;
    if (library_ == nullptr) return std::nullopt;
    ++stats_.read;
    auto complaint = library_->readAll(wholeOutline(), std::max<std::size_t>(options_.questions, kQuestions));
    return complaint ? Result(mismatch(std::move(*complaint))) : std::nullopt;
  }

  Result comparePast() {
    if (library_ == nullptr) return std::nullopt;
    ++stats_.pasts;
    auto complaint = library_->compareWithPast();
    return complaint ? Result(mismatch(std::move(*complaint))) : std::nullopt;
  }

  const Outline& wholeOutline() { return naive_(scene()).outline; }

  // What is in memory shows the segments that it has in the whole world (law 14).
  Outline shown(Outline whole) const {
    if (!model().isWhole()) std::erase_if(whole, [&](const OutlineSegment& s) { return !model().isLoaded(cellOf(s)); });
    return whole;
  }

  // The union and the loops take longest, so they can be left out.
  Result compareWhole(bool withUnion) {
    ++stats_.whole;
    const Outline actual = engine_.outline();
    const Scene all = scene();
    if (options_.naive) {
      ++stats_.naive;
      if (auto found = compareOutlines(Mismatch::Kind::naive, all, shown(naive_(all).outline), actual)) return found;
    }
    if (!withUnion || !options_.cgal || !model().isWhole()) return std::nullopt;
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
    const Scene near = sceneOf(model().standing(), trace_.preserve, around(judged));
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
    if (!model().isWhole()) return std::nullopt;
    const Trace another = inAnotherOrder(scene(), library_ != nullptr);
    const Outline before = engine_.outline();
    if (library_ != nullptr) {
      const auto afresh = LibraryEngine::outlineAtOnce(another);
      if (afresh) return compareOutlines(Mismatch::Kind::history, scene(), *afresh, before);
      return mismatch(Mismatch::Kind::history, "added in another order, a polygon is refused: " + afresh.error().text);
    }
    engine_.reset(another.preserve);
    for (const Call& call : another.calls) engine_.add(call.name(), call.polygon());
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
  Model placed_;  // in another engine
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
  return Check(trace, options, stats).run();
}

}  // namespace lgs::oracle
