// The naive reference and CGAL's union against each other, on random degenerate scenes.
#include "oracle/calls/random.h"
#include "oracle/calls/shapes.h"
#include "oracle/cgal/cgal_union.h"
#include "oracle/check/isolated.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/trace.h"
#include "proptests/support/law.h"
#include "proptests/support/scale.h"
#include "proptests/support/traces.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

namespace lgs::oracle {
namespace {

// Of shapes that touch each other and the rim in every degenerate way there is, in all eight symmetries.
Scene sceneOf(Random& random, std::int32_t side, Cell origin, Block blocks) {
  Scene result;
  for (std::int32_t i = 0; i < side; ++i) {
    for (std::int32_t j = 0; j < side; ++j) {
      if (random.below(8) == 0) continue;
      const int symmetry = random.below(8);
      for (const LocalPolygon& polygon : random.pick(degenerateShapes()).polygons) {
        if (random.below(6) == 0) continue;
        result.polygons.push_back({{origin.i + i, origin.j + j}, random.below(blocks), turned(polygon, symmetry)});
      }
    }
  }
  return result;
}

PreservePairs anyRelation(Random& random, Block blocks) {
  PreservePairs result;
  for (Block a = 0; a < blocks; ++a)
    for (Block b = a; b < blocks; ++b)
      if (random.below(3) == 0) result.add(a, b);
  return result;
}

constexpr std::array kOrigins = {Cell{0, 0}, Cell{-2, -3}, Cell{kMaxCell - 6, -kMaxCell},
                                 Cell{-kMaxCell, kMaxCell - 6}};

Trace traceOf(const Scene& scene) {
  Trace trace{scene.preserve, {}};
  for (const ScenePolygon& polygon : scene.polygons)
    trace.calls.push_back(Call::add(fmt::format("p{}", trace.calls.size() + 1), polygon));
  trace.calls.push_back(Call::commit());
  return trace;
}

/// What the adds of a trace amount to, in their order; there are no removals in these.
Scene sceneOf(const Trace& trace) {
  Scene scene;
  scene.preserve = trace.preserve;
  for (const Call& edit : trace.calls)
    if (edit.kind == Call::Kind::add) scene.polygons.push_back(edit.polygon());
  return scene;
}

/// Scenes as traces, so that they can be made small.
rc::Gen<Trace> tracesOf(const std::function<Scene(Random)>& scene) {
  return test::traces([=](int, Random random) { return traceOf(scene(random)); });
}

/// Fails the case that is running where the two references disagree; also where one of them says that the relation
/// makes no materials.
void expectAgreement(const Scene& scene, const OwnedOutline& naive, const std::optional<CgalUnion>& united) {
  test::failUnless(united.has_value() == materials(scene).has_value(),
                   "CGAL unites where there are no materials, or the reverse");
  if (!united) return;
  const OwnedOutline expected{withUnknownLinksOf(naive.outline, united->outline, united->known), united->owner};
  const auto differences = compare(expected, naive);
  if (!differences.empty()) test::failIf("the naive reference differs from CGAL:\n" + describe(differences));
}

TEST(NaiveAgainstCgal, OneMaterial) {
  const auto scene = [](Random random) {
    const Cell origin = kOrigins[random.below(kOrigins.size())];
    return sceneOf(random, random.between(1, 6), origin, 4);
  };
  NaiveReference naive;  // one for all scenes: it keeps its buffers from one to the next
  const auto law = [&](const Trace& trace) {
    const Scene s = sceneOf(trace);
    const OwnedOutline& outline = naive(s);
    const auto united = cgalUnion(s);
    expectAgreement(s, outline, united);
    const auto loops = followLinks(outline.outline);
    test::failUnless(loops.has_value(), "links are not mutual");
    test::failUnless(canonical(*loops) == canonical(united->loops), "other loops than CGAL's");
  };
  test::forAll(1'500, law, tracesOf(scene));
}

TEST(NaiveAgainstCgal, TenThousandCells) {
  const auto scene = [](Random random) { return sceneOf(random, 100, {-50, -50}, 2); };
  EXPECT_GT(scene(Random(0)).polygons.size(), 10'000U);
  const auto law = [](const Trace& trace) {
    const Scene s = sceneOf(trace);
    NaiveReference naive;
    expectAgreement(s, naive(s), cgalUnion(s));
  };
  test::forAll({.cases = 1}, law, tracesOf(scene));
}

TEST(NaiveAgainstCgal, SeveralMaterials) {
  const auto scene = [](Random random) {
    const Cell origin = kOrigins[random.below(kOrigins.size())];
    Scene result = sceneOf(random, random.between(1, 4), origin, 5);
    for (const auto& [a, b] : {std::pair<Block, Block>{0, 1}, {0, 3}, {2, 1}, {2, 3}, {4, 0}, {4, 1}, {4, 2}, {4, 3}}) {
      result.preserve.add(a, b);  // materials {0, 2}, {1, 3} and {4}
    }
    return result;
  };
  struct Seen {
    std::int64_t united = 0;
    std::int64_t known = 0;
  };
  const Shared<Seen> seen;
  NaiveReference naive;
  const auto law = [&](const Trace& trace) {
    const Scene s = sceneOf(trace);
    const auto united = cgalUnion(s);
    if (united) {
      ++seen->united;
      seen->known += std::count(united->known.begin(), united->known.end(), KnownLinks{});
    }
    expectAgreement(s, naive(s), united);
  };
  test::forAll(1'000, law, tracesOf(scene));
  if (HasFailure()) return;
  EXPECT_EQ(seen->united, test::scaled(1'000));
  EXPECT_GT(seen->known, 2 * test::scaled(1'000));
}

TEST(NaiveAgainstCgal, AnyRelationThatHappensToPartition) {
  const auto scene = [](Random random) {
    Scene result = sceneOf(random, 2, {0, 0}, 4);
    result.preserve = anyRelation(random, 4);
    return result;
  };
  const Shared<std::int64_t> compared;
  NaiveReference naive;
  const auto law = [&](const Trace& trace) {
    const Scene s = sceneOf(trace);
    const auto united = cgalUnion(s);
    *compared += united ? 1 : 0;
    expectAgreement(s, naive(s), united);
  };
  test::forAll(1'500, law, tracesOf(scene));
  if (HasFailure() || test::testScale() < 1) return;
  EXPECT_GT(*compared, 100);
}

TEST(NaiveAgainstCgal, TheOrderOfPolygonsDoesNotMatter) {
  const auto scene = [](Random random) {
    Scene result = sceneOf(random, 4, {-1, -1}, 3);
    result.preserve = anyRelation(random, 3);
    return result;
  };
  NaiveReference naive;
  const auto law = [&](const Trace& trace) {
    Scene s = sceneOf(trace);
    const Outline outline = naive(s).outline;
    std::reverse(s.polygons.begin(), s.polygons.end());
    const auto differences = compare(outline, naive(s).outline);
    if (!differences.empty())
      test::failIf("the outline depends on the order of the polygons:\n" + describe(differences));
  };
  test::forAll(50, law, tracesOf(scene));
}

}  // namespace
}  // namespace lgs::oracle
