#include "oracle/check/checker.h"

#include "oracle/check/law.h"
#include "oracle/check/levels.h"
#include "oracle/check/refusal.h"
#include "oracle/trace/call_text.h"

#include <utility>

namespace lgs::oracle {
namespace {

class Check {
 public:
  Check(const Trace& trace, const CheckOptions& options, CheckStats& stats)
      : seen_(trace, options, stats), laws_(lawsOf(seen_)) {}

  tl::expected<Found, TraceError> run() {
    seen_.engine.reset(seen_.trace.preserve);
    for (const auto& law : laws_) law->begin(seen_);
    for (const Call& call : seen_.trace.calls) {
      ++seen_.edits;
      seen_.stats.edits += call.kind == Call::Kind::commit || call.kind == Call::Kind::follow ? 0 : 1;
      auto found = play(call);
      if (!found || *found || stopped_) return found;
    }
    if (pending_ || seen_.isPending()) {
      if (auto found = commit(0)) return found;
      if (stopped_) return std::nullopt;
    }
    seen_.stats.read += seen_.library != nullptr ? 1 : 0;
    return ask([&](Law& law) {
      auto found = law.nowAndThen(seen_);
      return found ? found : law.atEnd(seen_);
    });
  }

 private:
  template <class Ask>
  Found ask(Ask&& ask) {
    for (const auto& law : laws_) {
      auto found = ask(*law);
      if (!found || takesAdvice(*found)) continue;
      found->law = law->number;
      return found;
    }
    return std::nullopt;
  }

  bool takesAdvice(const Mismatch& found) {
    if (!isAdvice(found, seen_.options.recommended)) return false;
    const LawSet broken = brokenBy(found);
    if ((broken & ~advised_) != 0 && seen_.options.advise) seen_.options.advise(found);
    advised_ |= broken;
    return true;
  }

  tl::expected<Found, TraceError> play(const Call& call) {
    if (call.kind == Call::Kind::repeat && seen_.library != nullptr) {
      for (std::uint32_t k = 0; k < call.nth; ++k) {
        for (const Call& part : call.group) {
          auto found = play(part);
          if (!found || *found || stopped_) return found;
        }
      }
      ++seen_.stats.made[static_cast<std::size_t>(Call::Kind::repeat)];
      return Found();
    }
    if (call.kind == Call::Kind::commit || commitsFirst(call.kind))
      if (auto found = commit(call.nth); found || stopped_) return found;
    if (call.kind == Call::Kind::commit) return Found();
    return seen_.library != nullptr ? make(call) : makeByName(call);
  }

  tl::expected<Found, TraceError> make(const Call& call) {
    const Model& model = seen_.model();
    const bool isOfParts = has(call.kind, KindOfCall::parts);
    const Judged judged = isOfParts ? Judged{call, {}} : seen_.library->player().judge(call);
    const Verdict& verdict = judged.verdict;
    seen_.stats.full += !verdict.accepted && verdict.code == ErrorCode::capacity ? 1 : 0;
    const bool isNowhere = (call.kind == Call::Kind::rollBack && !model.hasMarks()) ||
                           (call.kind == Call::Kind::redo && !model.hasAhead());
    for (const auto& law : laws_) law->before(seen_, judged);
    seen_.willChange();
    const auto done = seen_.library->apply(judged);
    if (!done && done.error().isWrong) return seen_.mismatch(Mismatch::Kind::verdict, done.error().text);
    seen_.wasAway = seen_.wasAway || !model.isWhole();
    seen_.isAnywhere = seen_.isAnywhere || (done && !isEdit(call.kind));
    seen_.edited.merge(seen_.library->player().takeEdited());
    const bool travels = done && (call.kind == Call::Kind::rollBack || call.kind == Call::Kind::redo);
    const auto look = [&](Law& law) {
      auto found = law.after(seen_, judged, !done);
      return found || !travels ? found : law.afterTravel(seen_);
    };
    if (auto found = isNowhere ? std::nullopt : ask(look)) return found;
    if (!done) return refused(judged.call, verdict, done.error());
    ++seen_.stats.made[static_cast<std::size_t>(call.kind)];
    return Found();
  }

  // The limits of a cell are this library's: other engines never see an edit that is refused for them.
  tl::expected<Found, TraceError> makeByName(const Call& call) {
    const bool takesStrokes = seen_.engine.can().regions;
    if (takesStrokes && call.kind == Call::Kind::brush) return stroke(call.brush);
    if (takesStrokes)
      return tl::unexpected(
          TraceError{call.line, "an engine with 'regions' takes strokes alone: " + printCall(call), {}});
    if (!isPlain(call))
      return tl::unexpected(TraceError{call.line, "only this library's engine has such calls: " + printCall(call), {}});
    seen_.willChange();
    Model& placed = seen_.placed;
    const Verdict verdict = placed.judge(call);
    if (verdict.accepted || (seen_.engine.can().refuses && verdict.code != ErrorCode::capacity)) {
      call.kind == Call::Kind::add ? seen_.engine.add(call.name(), call.polygon()) : seen_.engine.remove(call.name());
    } else if (seen_.options.skipRefused) {
      return Found();
    }
    pending_ = true;  // a refusal comes with the next commit
    if (!verdict.accepted) return refused(call, verdict, {call.line, "must be refused: " + printCall(call), {}});
    const bool isAdd = call.kind == Call::Kind::add;
    seen_.edited.insert(isAdd ? call.comes[0].cell : placed.standing().cellOf(call.name()));
    isAdd ? static_cast<void>(seen_.added.insert(call.name())) : static_cast<void>(seen_.added.erase(call.name()));
    placed.play(call);
    return Found();
  }

  Found stroke(const BrushEdit& brush) {
    seen_.willChange();
    seen_.engine.stroke(brush);
    seen_.strokes.push_back(brush);
    pending_ = true;
    return std::nullopt;
  }

  tl::expected<Found, TraceError> refused(const Call& call, const Verdict& verdict, const TraceError& error) {
    if (!seen_.options.skipRefused && !seen_.trace.mayRefuse) return tl::unexpected(error);
    ++seen_.stats.refused;
    expected_.push_back({call.name(), verdict.code ? lgs::name(*verdict.code) : "a bad name"});
    return Found();
  }

  Found commit(std::uint32_t executor) {
    seen_.willChange();
    if (seen_.library != nullptr) seen_.library->useExecutor(executor);
    const auto refusals = seen_.engine.commit();
    ++seen_.commits;
    ++seen_.stats.commits;
    pending_ = false;
    if (!refusals) return seen_.noAnswer(refusals.error());
    if (std::string wrong = wrongRefusals(std::exchange(expected_, {}), *refusals); !wrong.empty())
      return seen_.mismatch(Mismatch::Kind::verdict, std::move(wrong));
    // A joined segment belongs to many cells, so nothing can be said of some of them.
    const CheckOptions& options = seen_.options;
    seen_.isWhole = seen_.engine.can().merged || (options.wholeEvery != 0 && seen_.commits % options.wholeEvery == 0);
    if (auto found = ask([&](Law& law) { return law.afterCommit(seen_); })) return found;
    constexpr std::size_t kReadEvery = 8;  // it takes half as long as all the rest of a commit
    if (seen_.isWhole && (options.questions != 0 || seen_.stats.whole % kReadEvery == 0)) {
      seen_.stats.read += seen_.library != nullptr ? 1 : 0;
      if (auto found = ask([&](Law& law) { return law.nowAndThen(seen_); })) return found;
    }
    seen_.edited.clear();
    seen_.added.clear();
    seen_.isAnywhere = false;
    stopped_ = options.afterCommit && !options.afterCommit(seen_.model());
    return std::nullopt;
  }

  Seen seen_;
  Laws laws_;
  std::vector<RefusedEdit> expected_;  // what must be refused since the last commit, and why
  bool pending_ = false;               // edits of another engine
  bool stopped_ = false;
  LawSet advised_ = 0;  // what the engine was told of in this trace
};

}  // namespace

tl::expected<std::optional<Mismatch>, TraceError> checkTrace(const Trace& trace, const CheckOptions& options,
                                                             CheckStats& stats) {
  return Check(trace, options, stats).run();
}

}  // namespace lgs::oracle
