// Boost.Geometry as an engine of regions for `lgs check --engine`. What is solid is kept in doubles.
//
//     lgs check --engine build/release/examples/engines/boost_regions
#include "examples/engines/regions.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <array>
#include <cstddef>
#include <iostream>

namespace {

namespace bg = boost::geometry;
using Vertex = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Vertex, false>;  // counter-clockwise, holes clockwise: the solid is on the left
using Solid = bg::model::multi_polygon<Polygon>;

Solid exclusiveOr(const Solid& region, const Polygon& polygon) {
  Solid both;
  bg::sym_difference(region, polygon, both);
  return both;
}

// Inside is where the rings run around an odd number of times: by exclusive or, of each ring, or of the triangles from its
// first vertex if it crosses itself.
Solid regionOf(std::istringstream& words) {
  Solid region;
  for (const auto& points : readRings(words)) {
    Polygon polygon;
    for (const auto& [x, y] : points) polygon.outer().emplace_back(static_cast<double>(x), static_cast<double>(y));
    const auto ring = polygon.outer();
    bg::correct(polygon);
    if (bg::is_valid(polygon)) {
      region = exclusiveOr(region, polygon);
      continue;
    }
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
      Polygon triangle{{ring[0], ring[k], ring[k + 1], ring[0]}};
      bg::correct(triangle);
      if (bg::area(triangle) != 0) region = exclusiveOr(region, triangle);
    }
  }
  return region;
}

void printRing(const Polygon::ring_type& ring) {
  for (std::size_t k = 1; k < ring.size(); ++k) {
    const auto [ax, ay, bx, by] = std::array{std::llround(ring[k - 1].x()), std::llround(ring[k - 1].y()),
                                             std::llround(ring[k].x()), std::llround(ring[k].y())};
    if (ax != bx || ay != by) std::cout << "segment " << ax << ' ' << ay << ' ' << bx << ' ' << by << " - - - - 0\n";
  }
}

}  // namespace

int main() {
  Solid solid;
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string word, block, mode;  // of one block, the modes are the same
    words >> word;
    Solid next;
    if (word == "lgs-engine") {
      std::cout << "lgs-engine 1 Boost.Geometry slants regions round=1" << std::endl;
    } else if (word == "reset") {
      solid.clear();
    } else if (word == "paint" && words >> block >> mode) {
      bg::union_(solid, regionOf(words), next);
      solid = next;
    } else if (word == "carve") {
      bg::difference(solid, regionOf(words), next);
      solid = next;
    } else if (word == "commit") {
      for (const Polygon& polygon : solid) {
        printRing(polygon.outer());
        for (const auto& hole : polygon.inners()) printRing(hole);
      }
      std::cout << "end" << std::endl;
    }
  }
}
