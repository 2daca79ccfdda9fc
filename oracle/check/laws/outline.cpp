// Laws 1 to 3 and 14: segments, blocks and links are those of the naive reference; if the preserve relation is a
// partition, also those of CGAL's union, and the loops are. What is in memory shows what it shows in the whole world.
#include "oracle/cgal/cgal_union.h"
#include "oracle/check/laws/list.h"
#include "oracle/reference/canonical.h"

#include <fmt/format.h>
#include <algorithm>
#include <optional>
#include <vector>

namespace lgs::oracle {
namespace {

class OutlineLaw : public Law {
 public:
  Found afterTravel(Seen& seen) override { return seen.isPending() ? std::nullopt : compareWhole(seen, false); }

  Found afterCommit(Seen& seen) override {
    lastWasWhole_ = seen.isWhole;
    return seen.isWhole ? compareWhole(seen, !seen.options.unionAtEnd) : compareWindow(seen);
  }

  Found atEnd(Seen& seen) override {
    return !lastWasWhole_ || seen.options.unionAtEnd ? compareWhole(seen, true) : std::nullopt;
  }

 private:
  static Outline shown(const Model& model, Outline whole) {
    if (!model.isWhole()) std::erase_if(whole, [&](const OutlineSegment& s) { return !model.isLoaded(cellOf(s)); });
    return whole;
  }

  // The union and the loops take longest, so they can be left out.
  Found compareWhole(Seen& seen, bool withUnion) {
    ++seen.stats.whole;
    const Outline& actual = seen.shown();
    const Scene all = seen.scene();
    if (seen.options.naive) {
      ++seen.stats.naive;
      if (auto found = seen.differing(Mismatch::Kind::naive, all, shown(seen.model(), seen.whole()), actual))
        return found;
    }
    if (!withUnion || !seen.options.cgal || !seen.model().isWhole()) return std::nullopt;
    if (!united_ || all.polygons != of_) {  // a commit of nothing, or of what was undone, takes no second union
      united_ = cgalUnion(all);
      of_ = all.polygons;
    }
    if (!united_) return std::nullopt;  // a preserve relation that is no partition: CGAL has no say
    if (auto found = compareUnion(seen, all, *united_, actual, nullptr)) return found;
    const bool hasLoops = seen.library != nullptr && seen.trace.preserve.empty();
    return hasLoops ? compareLoops(seen, canonical(united_->loops)) : std::nullopt;
  }

  static Found compareLoops(Seen& seen, const Loops& expected) {
    Loops actual;
    for (Loop& loop : seen.world().loops(Collinear::merge)) actual.push_back(std::move(loop.vertices));
    if (actual == expected) return std::nullopt;
    return seen.mismatch(Mismatch::Kind::loops,
                         fmt::format("{} loops where there should be {}, or others, though all segments "
                                     "and links are right",
                                     actual.size(), expected.size()));
  }

  static Found compareWindow(Seen& seen) {
    const CellSet judged = around(seen.edited);
    const Scene near = sceneOf(seen.model().standing(), seen.trace.preserve, around(judged));
    Outline actual = seen.library != nullptr ? seen.library->outlineIn(judged) : seen.engine.outline();
    if (seen.library == nullptr) keepOnly(actual, judged);
    if (seen.options.naive) {
      ++seen.stats.naive;
      Outline expected = seen.naive(near).outline;
      keepOnly(expected, judged);
      if (auto found = seen.differing(Mismatch::Kind::naive, near, expected, actual)) return found;
    }
    if (!seen.options.cgal) return std::nullopt;
    const auto united = cgalUnion(near);
    return united ? compareUnion(seen, near, *united, actual, &judged) : std::nullopt;
  }

  // With CGAL, which does not know all links. It can not be asked which of those of joined segments it knows.
  static Found compareUnion(Seen& seen, const Scene& scene, const CgalUnion& united, const Outline& actual,
                            const CellSet* judged) {
    ++seen.stats.cgal;
    Outline expected = withUnknownLinksOf(actual, united.outline, united.known);
    if (judged != nullptr) keepOnly(expected, *judged);
    Capabilities can = seen.engine.can();
    can.ghosts = can.ghosts && (!can.merged || scene.preserve.empty());
    return seen.differing(Mismatch::Kind::cgal, scene, expected, actual, can);
  }

  bool lastWasWhole_ = false;
  std::optional<CgalUnion> united_;
  std::vector<ScenePolygon> of_;  // these polygons
};

}  // namespace

std::unique_ptr<Law> laws::outline() { return std::make_unique<OutlineLaw>(); }

}  // namespace lgs::oracle
