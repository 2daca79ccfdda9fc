// The naive reference of the harness, for the article: JavaScript hands over the polygons of a world, and gets the
// outline that the laws demand of them. Nothing of the engine is in it.
#include "bridge.h"

#include "oracle/reference/naive.h"

#include <algorithm>
#include <limits>

namespace {

using lgs::oracle::OutlineSegment;

std::vector<double> numbersIn;
std::vector<double> numbersOut;

void put(lgs::Point point) {
  numbersOut.push_back(lgs::web::cellsOf(point.x));
  numbersOut.push_back(lgs::web::cellsOf(point.y));
}

void put(const std::optional<lgs::Point>& ghost) {
  if (ghost)
    put(*ghost);
  else
    numbersOut.insert(numbersOut.end(), 2, std::numeric_limits<double>::quiet_NaN());
}

// i, j, block, the number of vertices, and x, y of each vertex in its cell, in units.
lgs::oracle::Scene sceneOf(const std::vector<double>& numbers) {
  lgs::oracle::Scene scene;
  for (std::size_t k = 0; k < numbers.size();) {
    lgs::oracle::ScenePolygon& polygon = scene.polygons.emplace_back();
    polygon.cell = {static_cast<std::int32_t>(numbers[k]), static_cast<std::int32_t>(numbers[k + 1])};
    polygon.block = static_cast<lgs::Block>(numbers[k + 2]);
    const auto count = static_cast<std::size_t>(numbers[k + 3]);
    k += 4;
    for (std::size_t n = 0; n < count; ++n, k += 2)
      polygon.vertices.push_back({static_cast<std::int32_t>(numbers[k]), static_cast<std::int32_t>(numbers[k + 1])});
  }
  return scene;
}

}  // namespace

/// Where so many numbers go: the polygons.
LGS_EXPORT("input") double* input(std::size_t count) {
  numbersIn.resize(count);
  return numbersIn.data();
}

/// Works out the outline. Returns how many segments it has.
LGS_EXPORT("outline") std::size_t outline() {
  const lgs::oracle::Outline segments = lgs::oracle::naiveOutline(sceneOf(numbersIn));
  numbersOut.clear();
  for (const OutlineSegment& segment : segments) {
    put(segment.start);
    put(segment.end);
    put(segment.ghost1);
    put(segment.ghost2);
    numbersOut.push_back(segment.block);
  }
  return segments.size();
}

/// The outline: nine numbers a segment, in the order of the package's geometry, and then the block.
LGS_EXPORT("answer") const double* answer() { return numbersOut.data(); }
