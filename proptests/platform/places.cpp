// Parts about places: brushes, questions, and edges that belong to no world.
#include "editor.h"
#include "parts.h"

#include <lgs/brush.h>
#include <lgs/radial_match.h>

namespace platform {
namespace {

/// In or near the cells from −2 to 10. One in four is a corner of cells, or the middle of a side.
lgs::Point randomPoint(Random& choices) {
  const bool isOnGrid = choices.chance(25);
  const std::int32_t x = choices.between(-2 * 65'536, 10 * 65'536), y = choices.between(-2 * 65'536, 10 * 65'536);
  return isOnGrid ? lgs::Point{x / 32'768 * 32'768, y / 32'768 * 32'768} : lgs::Point{x, y};
}

std::vector<lgs::Point> randomPoints(Random& choices, std::uint32_t count) {
  std::vector<lgs::Point> points;
  for (; count > 0; --count) points.push_back(randomPoint(choices));
  return points;
}

lgs::Region randomRegion(Random& choices) {
  const lgs::Point at = randomPoint(choices);
  const std::int64_t size = choices.between(1, 2 * 65'536);
  switch (choices.below(6)) {
    case 0:
    case 1:
      return lgs::circle(at, size, choices.between(3, 40));
    case 2:
      return lgs::thickLine(randomPoints(choices, choices.below(4U)), size / 4, 12);
    case 3:
      return lgs::rectangle(at, randomPoint(choices), size, size / 3);
    case 4: {  // a ring in cells, which may be no region
      std::vector<std::vector<lgs::DoublePoint>> rings(1);
      for (std::uint32_t k = choices.below(6U); k > 0; --k) {
        const lgs::Point p = randomPoint(choices);
        rings[0].push_back({static_cast<double>(p.x) / 65'536, static_cast<double>(p.y) / 65'536 + 0x1p-18});
      }
      if (choices.chance(5)) rings[0].push_back({1e300, 0});
      return lgs::region(rings, lgs::FillRule::evenOdd);
    }
    default:
      return {{randomPoints(choices, 3), randomPoints(choices, 4)},
              choices.chance(50) ? lgs::FillRule::nonZero : lgs::FillRule::evenOdd};
  }
}

void put(Hash& hash, const lgs::BrushResult& result) {
  putAll(hash, result.removed);
  putAll(hash, result.added);
  putAll(hash, result.rounded);
  for (const lgs::BrushChange& change : result.changed) {
    platform::put(hash, change.old);
    putAll(hash, change.now);
  }
}

/// Ground of cells with all kinds of shapes.
Editor prepared(Hash& hash, std::uint64_t seed) {
  Editor editor(hash, seed, lgs::World(), Editor::kHabits, {0, 0});
  editor.edits(300);
  editor.commit();
  return editor;
}

std::vector<lgs::DirectedEdge> randomEdges(Random& choices, std::uint32_t points) {
  std::vector<lgs::DirectedEdge> edges;
  for (std::uint32_t k = 3 * points; k > 0; --k) {
    const std::uint32_t from = choices.below(points), to = choices.below(points);
    if (from != to || choices.below(40) == 0) edges.push_back({from, to});
  }
  return edges;
}

}  // namespace

void brushes(Hash& hash) {
  for (std::uint64_t seed = 500; seed < 504; ++seed) {
    Random choices(seed + 1'000);
    Editor editor = prepared(hash, seed);
    lgs::World& world = editor.world();
    for (int k = 0; k < 120; ++k) {
      const lgs::Region region = randomRegion(choices);
      const lgs::PaintMode mode = choices.chance(50) ? lgs::PaintMode::fill : lgs::PaintMode::replace;
      const auto done =
          choices.below(3) == 0 ? lgs::carve(world, region) : lgs::paint(world, region, choices.below(4U), mode);
      if (putResult(hash, done)) put(hash, *done);
      editor.commit();
    }
    editor.readAll();
  }
}

void questions(Hash& hash) {
  Random choices(1600);
  Editor editor = prepared(hash, 600);
  const lgs::World& world = editor.world();
  for (int k = 0; k < 4'000; ++k) {
    const lgs::Point at = randomPoint(choices);
    const lgs::Spot spot = world.at(at);
    hash.number(static_cast<std::uint64_t>(spot.where));
    put(hash, spot.polygon);
    put(hash, spot.cell);
    const auto nearest = world.nearest(at, choices.between(-1, 12) / 4.0);
    if (putResult(hash, nearest)) put(hash, nearest->segment);
    const auto hit = world.rayCast(at, randomPoint(choices));
    if (putResult(hash, hit)) put(hash, hit->segment);
    hash.step();
  }
}

void radial(Hash& hash) {
  Random choices(700);
  for (int k = 0; k < 150; ++k) {
    const std::vector<lgs::Point> points = randomPoints(choices, 2 + choices.below(30U));
    const auto links = lgs::radialMatch(points, randomEdges(choices, static_cast<std::uint32_t>(points.size())));
    if (putResult(hash, links)) {
      for (const lgs::EdgeLinks& link : *links) hash.number(std::uint64_t{link.predecessor} << 32 | link.successor);
      for (const auto& loop : lgs::loopsOf(*links))
        for (const std::uint32_t edge : loop) hash.number(edge);
    }
    hash.step();
  }
}

void answers(Hash& hash) {
  Random choices(1800);
  Editor editor = prepared(hash, 800);
  const lgs::World& world = editor.world();
  for (int k = 0; k < 4'000; ++k) {
    const lgs::Point at = randomPoint(choices);
    const lgs::Nearest nearest = world.nearest(at, 3).value_or(lgs::Nearest{});
    put(hash, nearest.point);
    hash.real(nearest.distance);
    const lgs::RayHit hit = world.rayCast(at, randomPoint(choices)).value_or(lgs::RayHit{});
    hash.real(hit.fraction);
    put(hash, hit.point);
    put(hash, hit.normal);
    if (nearest.segment) hash.real(world.segment(nearest.segment)->length());
    hash.step();
  }
}

}  // namespace platform
