// Parts about places: brushes, questions, and edges that belong to no world.
#include "editor.h"
#include "parts.h"

#include <lgs/brush.h>
#include <lgs/radial_match.h>

namespace platform {
namespace {

/// In or near the cells from −2 to 10. One in four is a corner of cells, or the middle of a side.
lgs::Point randomPoint(Random& random) {
  const bool isOnGrid = random.oneIn(4);
  const std::int32_t x = random.between(-2 * 65'536, 10 * 65'536), y = random.between(-2 * 65'536, 10 * 65'536);
  return isOnGrid ? lgs::Point{x / 32'768 * 32'768, y / 32'768 * 32'768} : lgs::Point{x, y};
}

std::vector<lgs::Point> randomPoints(Random& random, std::uint32_t count) {
  std::vector<lgs::Point> points;
  for (; count > 0; --count) points.push_back(randomPoint(random));
  return points;
}

lgs::Region randomRegion(Random& random) {
  const lgs::Point at = randomPoint(random);
  const std::int64_t size = random.between(1, 2 * 65'536);
  switch (random.below(6)) {
    case 0:
    case 1:
      return lgs::circle(at, size, random.between(3, 40));
    case 2:
      return lgs::thickLine(randomPoints(random, random.below(4)), size / 4, 12);
    case 3:
      return lgs::rectangle(at, randomPoint(random), size, size / 3);
    case 4: {  // a ring in cells, which may be no region
      std::vector<std::vector<lgs::DoublePoint>> rings(1);
      for (std::uint32_t k = random.below(6); k > 0; --k) {
        const lgs::Point p = randomPoint(random);
        rings[0].push_back({static_cast<double>(p.x) / 65'536, static_cast<double>(p.y) / 65'536 + 0x1p-18});
      }
      if (random.oneIn(20)) rings[0].push_back({1e300, 0});
      return lgs::region(rings, lgs::FillRule::evenOdd);
    }
    default:
      return {{randomPoints(random, 3), randomPoints(random, 4)},
              random.oneIn(2) ? lgs::FillRule::nonZero : lgs::FillRule::evenOdd};
  }
}

void put(Hash& hash, const lgs::BrushResult& result) {
  putAll(hash, result.went);
  putAll(hash, result.came);
  putAll(hash, result.bent);
  for (const lgs::BrushChange& change : result.changed) {
    platform::put(hash, change.old);
    putAll(hash, change.now);
  }
}

/// Ground that was painted and dug in, and of which some cells have other shapes.
void prepare(lgs::World& world, Hash& hash, std::uint64_t seed) {
  Editor editor(world, hash, seed, {0, 0});
  editor.edits(300);
  editor.commit();
}

std::vector<lgs::DirectedEdge> randomEdges(Random& random, std::uint32_t points) {
  std::vector<lgs::DirectedEdge> edges;
  for (std::uint32_t k = 3 * points; k > 0; --k) {
    const std::uint32_t from = random.below(points), to = random.below(points);
    if (from != to || random.oneIn(40)) edges.push_back({from, to});
  }
  return edges;
}

}  // namespace

void brushes(Hash& hash) {
  for (std::uint64_t seed = 500; seed < 504; ++seed) {
    lgs::World world;
    Random random(seed);
    prepare(world, hash, seed);
    Editor editor(world, hash, seed + 50, {0, 0});
    for (int k = 0; k < 120; ++k) {
      const lgs::Region region = randomRegion(random);
      const lgs::PaintMode mode = random.oneIn(2) ? lgs::PaintMode::fill : lgs::PaintMode::replace;
      const auto done = random.oneIn(3) ? lgs::carve(world, region) : lgs::paint(world, region, random.below(4), mode);
      if (putResult(hash, done)) put(hash, *done);
      editor.commit();
    }
    editor.readAll();
  }
}

void questions(Hash& hash) {
  lgs::World world;
  Random random(600);
  prepare(world, hash, 600);
  for (int k = 0; k < 4'000; ++k) {
    const lgs::Point at = randomPoint(random);
    const lgs::Spot spot = world.at(at);
    hash.number(static_cast<std::uint64_t>(spot.where));
    put(hash, spot.polygon);
    put(hash, spot.cell);
    const auto nearest = world.nearest(at, random.between(-1, 12) / 4.0);
    if (putResult(hash, nearest)) put(hash, nearest->segment);
    const auto hit = world.rayCast(at, randomPoint(random));
    if (putResult(hash, hit)) put(hash, hit->segment);
    hash.step();
  }
}

void radial(Hash& hash) {
  Random random(700);
  for (int k = 0; k < 150; ++k) {
    const std::vector<lgs::Point> points = randomPoints(random, 2 + random.below(30));
    const auto links = lgs::radialMatch(points, randomEdges(random, static_cast<std::uint32_t>(points.size())));
    if (putResult(hash, links)) {
      for (const lgs::EdgeLinks& link : *links) hash.number(std::uint64_t{link.predecessor} << 32 | link.successor);
      for (const auto& loop : lgs::loopsOf(*links))
        for (const std::uint32_t edge : loop) hash.number(edge);
    }
    hash.step();
  }
}

void answers(Hash& hash) {
  lgs::World world;
  Random random(800);
  prepare(world, hash, 800);
  for (int k = 0; k < 4'000; ++k) {
    const lgs::Point at = randomPoint(random);
    const lgs::Nearest nearest = world.nearest(at, 3).value_or(lgs::Nearest{});
    put(hash, nearest.point);
    hash.real(nearest.distance);
    const lgs::RayHit hit = world.rayCast(at, randomPoint(random)).value_or(lgs::RayHit{});
    hash.real(hit.fraction);
    put(hash, hit.point);
    put(hash, hit.normal);
    if (nearest.segment) hash.real(world.segment(nearest.segment)->length());
    hash.step();
  }
}

}  // namespace platform
