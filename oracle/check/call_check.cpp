#include "oracle/check/call_check.h"

#include "oracle/check/reads.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/dump.h"

#include <fmt/format.h>
#include <utility>

namespace lgs::oracle {

CallCheck::CallCheck(Cell corner, PreservePairs preserve)
    : preserve_(std::move(preserve)), caller_(World(relationOf(preserve_)), corner) {}

std::optional<std::string> CallCheck::make(const Call& call) {
  bool isAccepted = true;
  const std::string wrong = call.kind == Call::Kind::group ? makeGroup(call) : makeOne(call, isAccepted);
  return wrong.empty() ? std::nullopt : std::optional(fmt::format("{}: {}", inWords(call), wrong));
}

std::string CallCheck::makeGroup(const Call& call) {
  const CallModel before = model_;
  std::string wrong;
  const bool isKept = caller_.makeGroup(call, [&](const Call& part) {
    bool isAccepted = false;
    if (wrong.empty()) wrong = makeOne(part, isAccepted);
    return isAccepted;
  });
  if (!isKept) model_ = before;
  return wrong;
}

std::string CallCheck::makeOne(const Call& call, bool& isAccepted) {
  const Call resolved = caller_.resolved(call);
  const Verdict verdict = model_.judge(resolved);
  isAccepted = verdict.accepted;
  if (!isAccepted && !triesRefused) {
    caller_.makeShapes(resolved);
    return "";
  }
  const Outcome outcome = caller_.makeResolved(resolved);
  if (std::string wrong = model_.wrongAnswer(resolved, verdict, outcome, caller_.world); !wrong.empty()) return wrong;
  if (!isAccepted) return "";
  model_.apply(resolved, outcome.handles);
  if (afterAccepted) afterAccepted(resolved, outcome);
  return call.kind == Call::Kind::commit || call.kind == Call::Kind::load ? look() : "";
}

std::string CallCheck::look() const {
  const Scene scene = model_.standing().scene(preserve_);
  for (const auto& entry : model_.standing().cells())
    if (const auto wrong = readCell(caller_.world, model_.standing(), entry.first)) return wrong->text;
  if (caller_.world.stats().polygons != scene.polygons.size()) return "another number of polygons stands there";
  const Outline expected = NaiveReference()(scene).outline, actual = outlineOf(caller_.world);
  return expected == actual ? "" : "the outline is not that of the laws\n" + describe(compare(expected, actual));
}

}  // namespace lgs::oracle
