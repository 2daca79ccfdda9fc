// Boost.Geometry as an engine of regions for `lgs check --engine`. What is solid is kept in doubles.
//
//     lgs check --engine build/release/examples/engines/boost_regions
#include "examples/engines/regions.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/geometries.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

#include <iostream>

namespace {

namespace bg = boost::geometry;
using Polygon = bg::model::polygon<bg::model::d2::point_xy<double>, false>;  // the solid is on the left
using Solid = bg::model::multi_polygon<Polygon>;

// Inside is where the rings run around an odd number of times: by exclusive or, of each ring, or of the triangles from its
// first vertex if it crosses itself.
Solid regionOf(std::istringstream& words) {
  Solid region;
  const auto take = [&](Polygon part) {
    bg::correct(part);
    if (!bg::is_valid(part)) return false;
    Solid both;
    bg::sym_difference(region, part, both);
    region = both;
    return true;
  };
  for (const auto& points : readRings(words)) {
    Polygon::ring_type ring;
    for (const auto& [x, y] : points) ring.emplace_back(static_cast<double>(x), static_cast<double>(y));
    for (std::size_t k = take({ring}) ? ring.size() : 1; k + 1 < ring.size(); ++k)
      take({{ring[0], ring[k], ring[k + 1]}});
  }
  return region;
}

void print(const bg::model::referring_segment<const Polygon::point_type>& s) {
  const auto ax = std::llround(s.first.x()), ay = std::llround(s.first.y());
  const auto bx = std::llround(s.second.x()), by = std::llround(s.second.y());
  if (ax != bx || ay != by) std::cout << "segment " << ax << ' ' << ay << ' ' << bx << ' ' << by << " - - - - 0\n";
}

}  // namespace

int main() {
  Solid solid;
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string word, block, mode;  // of one block, the modes are the same
    words >> word;
    Solid next;  // empty after a reset
    if (word == "lgs-engine") std::cout << "lgs-engine 1 Boost.Geometry slants regions round=1" << std::endl;
    if (word == "paint" && words >> block >> mode) bg::union_(solid, regionOf(words), next);
    if (word == "carve") bg::difference(solid, regionOf(words), next);
    if (word != "commit") solid = next;
    if (word == "commit") bg::for_each_segment(std::as_const(solid), print), std::cout << "end" << std::endl;
  }
}
