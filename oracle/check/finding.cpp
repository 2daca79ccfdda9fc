#include "oracle/check/finding.h"

#include "oracle/check/comparable.h"
#include "oracle/engine/play.h"
#include "oracle/reference/compare.h"

#include <fmt/format.h>
#include <algorithm>
#include <string_view>

namespace lgs::oracle {
namespace {

using Kind = Difference::Kind;

// Whether the engine is right about the scene if it knows nothing else.
bool isRightAfresh(const Mismatch& mismatch, Engine& engine) {
  Trace trace{mismatch.scene.preserve, {}};
  for (const ScenePolygon& polygon : mismatch.scene.polygons)
    trace.calls.push_back(Call::add(fmt::format("p{}", trace.calls.size() + 1), polygon));
  const auto afresh = play(trace, engine);
  return afresh && comparable(*afresh, engine.can()) == comparable(mismatch.expected, engine.can());
}

// By the notes of compare(), which say what probably went wrong.
std::string kindOf(const std::vector<Difference>& differences) {
  const auto says = [&](std::string_view words) {
    return std::ranges::any_of(differences,
                               [&](const Difference& d) { return d.note.find(words) != std::string::npos; });
  };
  const auto isA = [&](Kind kind) {
    return std::ranges::find(differences, kind, &Difference::kind) != differences.end();
  };
  if (says("to be preserved")) return "lost preserve";
  if (says("should have been cancelled") || says("only the opposite direction")) return "uncancelled edge";
  if (says("not cut at") || says("should be cut at")) return "missing cut";
  if (isA(Kind::missing) || isA(Kind::extra)) return "other segments";
  return isA(Kind::ghost1) || isA(Kind::ghost2) ? "wrong link" : "wrong block";
}

}  // namespace

std::string kindOfFinding(const Mismatch& mismatch, Engine& engine) {
  for (const char* const kind : {"open outline", "missing solid", "extra solid", "no boundary"})
    if (engine.can().regions && mismatch.text.starts_with(kind)) return kind;
  switch (mismatch.kind) {
    case Mismatch::Kind::crash:
      return "crash";
    case Mismatch::Kind::hang:
      return "hang";
    case Mismatch::Kind::protocol:
      return "protocol";
    case Mismatch::Kind::verdict:
      return "refusal";
    case Mismatch::Kind::history:
      return "order of edits matters";
    case Mismatch::Kind::changes:
      return "wrong id";
    case Mismatch::Kind::needless:
      return "needless change";
    case Mismatch::Kind::views:
      return "wrong island";
    default:
      break;
  }
  const auto differences = compare(mismatch.expected, mismatch.actual);
  if (engine.can().regions || !isRightAfresh(mismatch, engine)) return kindOf(differences);
  const auto isGhost = [](const Difference& d) { return d.kind == Kind::ghost1 || d.kind == Kind::ghost2; };
  return std::ranges::all_of(differences, isGhost) ? "stale ghost" : "order of edits matters";
}

}  // namespace lgs::oracle
