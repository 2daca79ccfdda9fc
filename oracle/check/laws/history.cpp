// Law 4, no history: a new world with the same polygons, added in another order and by other calls, and committed at
// once, has the same outline.
#include "oracle/check/laws/list.h"
#include "oracle/check/questions.h"
#include "oracle/check/refusal.h"
#include "oracle/generate/forms.h"

#include <fmt/format.h>
#include <algorithm>
#include <functional>
#include <utility>

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

class HistoryLaw : public Law {
 public:
  Found atEnd(Seen& seen) override {
    if (!seen.model().isWhole()) return std::nullopt;
    const Scene scene = seen.scene();
    const Outline before = seen.shown();
    return seen.library != nullptr ? ofLibrary(seen, scene, before) : ofEngine(seen, scene, before);
  }

 private:
  static Found ofLibrary(Seen& seen, const Scene& scene, const Outline& before) {
    constexpr std::uint32_t kLastFirst =
        2;  // threads would share the jobs of this executor: their order must not matter
    Player fresh(scene.preserve);
    for (const Call& call : inAnotherOrder(scene, true).calls)
      if (const auto done = fresh.apply(call); !done)
        return seen.mismatch(Mismatch::Kind::history,
                             "added in another order, a polygon is refused: " + done.error().text);
    fresh.commit(kLastFirst);
    if (auto found = seen.differing(Mismatch::Kind::history, scene, outlineOf(fresh.world()), before)) return found;
    std::string wrong = wrongComparison(seen.world(), std::move(fresh.world()));
    return wrong.empty() ? std::nullopt : Found(seen.mismatch(Mismatch::Kind::reading, std::move(wrong)));
  }

  static Found ofEngine(Seen& seen, const Scene& scene, const Outline& before) {
    seen.engine.reset(scene.preserve);
    for (const Call& call : inAnotherOrder(scene, false).calls) seen.engine.add(call.name(), call.polygon());
    const auto refusals = seen.engine.commit();
    if (!refusals) return seen.noAnswer(refusals.error());
    if (std::string wrong = wrongRefusals({}, *refusals); !wrong.empty())
      return seen.mismatch(Mismatch::Kind::history, "added in another order: " + wrong);
    return seen.differing(Mismatch::Kind::history, scene, seen.engine.outline(), before);
  }
};

}  // namespace

std::unique_ptr<Law> laws::history() { return std::make_unique<HistoryLaw>(); }

}  // namespace lgs::oracle
