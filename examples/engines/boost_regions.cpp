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

// Inside is where the rings run around an odd number of times: the triangles from a ring's first vertex, by exclusive or.
Solid regionOf(std::istringstream& words) {
  Solid region;
  for (const auto& ring : readRings(words)) {
    const auto at = [&](std::size_t k) {
      return Vertex(static_cast<double>(ring[k].first), static_cast<double>(ring[k].second));
    };
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
      Polygon triangle{{at(0), at(k), at(k + 1), at(0)}};
      bg::correct(triangle);
      if (bg::area(triangle) == 0) continue;
      Solid both;
      bg::sym_difference(region, triangle, both);
      region = both;
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
