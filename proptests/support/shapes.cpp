#include "proptests/support/shapes.h"

#include "oracle/calls/shapes.h"
#include "oracle/generate/generator.h"
#include "oracle/trace/model.h"
#include "proptests/support/traces.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <ostream>

namespace lgs::test {
namespace {

using oracle::Call;
using oracle::LocalPolygon;
using oracle::Random;
using oracle::Trace;

/// One cell, and what is added to it: so that the shrinker of traces can make it small.
Trace added(const std::vector<LocalPolygon>& polygons) {
  Trace trace;
  for (const LocalPolygon& p : polygons)
    trace.calls.push_back(Call::add(fmt::format("p{}", trace.calls.size() + 1), {{}, 1, p}));
  return trace;
}

/// What a trace leaves in the first of its cells.
std::vector<LocalPolygon> polygonsOf(const Trace& trace) {
  std::vector<LocalPolygon> polygons;
  const auto standing = survivors(trace);
  for (const auto& [name, add] : standing)
    if (add.comes[0].cell == standing.begin()->second.comes[0].cell) polygons.push_back(add.comes[0].shape[0]);
  return polygons;
}

Trace anyShape(int, Random random) {
  if (random.chance(30)) {
    const auto left = polygonsOf(withoutRefused(oracle::randomCase({1, 1, 8}, random.next())));
    if (!left.empty()) return added(left);
  }
  const oracle::NamedShape& shape = random.pick(oracle::degenerateShapes());
  const int symmetry = random.below(8);
  std::vector<LocalPolygon> polygons;
  for (const LocalPolygon& p : shape.polygons) polygons.push_back(oracle::turned(p, symmetry));
  return added(polygons);
}

Trace anyPolygon(int size, Random random) { return added({random.pick(polygonsOf(anyShape(size, random)))}); }

std::string inWords(const LocalPolygon& polygon) {
  std::string text;
  for (const LocalPoint& p : polygon) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", p.x, p.y);
  return text;
}

template <class Real>
rc::Gen<AnyReal<Real>> anyReal() {
  namespace gen = rc::gen;
  constexpr std::int32_t U = kUnitsPerCell;
  constexpr Real kLeast = std::numeric_limits<Real>::denorm_min();
  const auto end = gen::element<Real>(0, Real(-0.0), 1, kLeast, -kLeast);
  const auto inside = gen::map(gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 53), [](std::uint64_t v) {
    return static_cast<Real>(v) / static_cast<Real>(std::uint64_t{1} << 53);
  });
  // A lattice point, or between two of them (half a unit outside the cell, too), or one step of Real from there.
  const auto halves =
      gen::oneOf(gen::inRange(-1, 2 * U + 2), gen::element<std::int32_t>(-1, 1, 2, 3, 2 * U - 1, 2 * U, 2 * U + 1));
  const auto nearHalf = gen::map(gen::pair(halves, gen::inRange(-1, 2)), [](const std::pair<std::int32_t, int>& drawn) {
    const auto [count, anyStep] = drawn;
    const Real real = static_cast<Real>(count) / (2 * U);
    const int step = count == -1 ? 1 : count == 2 * U + 1 ? -1 : anyStep;  // what lies outside: inwards
    return step == 0 ? real : std::nextafter(real, step < 0 ? Real(-1) : Real(2));
  });
  return gen::map(gen::resize(rc::kNominalSize, gen::weightedOneOf<Real>({{15, end}, {25, inside}, {60, nearHalf}})),
                  [](Real value) { return AnyReal<Real>{value}; });
}

}  // namespace

void showValue(const AnyPolygon& polygon, std::ostream& out) { out << inWords(polygon.vertices); }
void showValue(const AnyReal<float>& real, std::ostream& out) { out << fmt::format("{:a} of a cell", real.value); }
void showValue(const AnyReal<double>& real, std::ostream& out) { out << fmt::format("{:a} of a cell", real.value); }

rc::Gen<AnyPolygon> AnyPolygon::arbitrary() {
  const auto mayBe = [](const Trace& t) { return t.calls.size() == 1 && isGood(t); };
  return rc::gen::map(traces(anyPolygon, mayBe), [](const Trace& trace) { return AnyPolygon{polygonsOf(trace)[0]}; });
}

template <>
rc::Gen<AnyReal<float>> AnyReal<float>::arbitrary() {
  return anyReal<float>();
}
template <>
rc::Gen<AnyReal<double>> AnyReal<double>::arbitrary() {
  return anyReal<double>();
}

}  // namespace lgs::test
