// This library's brushes as an engine of regions for `lgs check --engine`: an example of the protocol in C++.
//
//     lgs check --engine build/release/examples/engines/lgs_regions
#include "examples/engines/regions.h"

#include <lgs/brush.h>
#include <lgs/world.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace {

using Pairs = std::set<std::pair<lgs::Block, lgs::Block>>;

lgs::Region regionOf(std::istringstream& words) {
  lgs::Region region{{}, lgs::FillRule::evenOdd};
  for (const auto& points : readRings(words)) {
    lgs::Ring& ring = region.rings.emplace_back();
    for (const auto& [x, y] : points) ring.push_back({x, y});
  }
  return region;
}

void print(const lgs::World& world) {
  const auto printGhost = [](lgs::SegmentId neighbour, lgs::Point p) {
    neighbour ? std::cout << ' ' << p.x << ' ' << p.y : std::cout << " - -";
  };
  for (const lgs::SegmentId id : world.segments()) {
    const lgs::Segment s = *world.segment(id);
    std::cout << "segment " << s.start.x << ' ' << s.start.y << ' ' << s.end.x << ' ' << s.end.y;
    printGhost(s.predecessor, s.ghost1);
    printGhost(s.successor, s.ghost2);
    std::cout << ' ' << s.block << '\n';
  }
  std::cout << "end" << std::endl;
}

}  // namespace

int main() {
  Pairs preserved;
  lgs::World world;
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string word, mode;
    lgs::Block a = 0, b = 0;
    words >> word;
    if (word == "lgs-engine") {
      std::cout << "lgs-engine 1 LocalGridSeg ghosts blocks slants preserve regions round=1" << std::endl;
    } else if (word == "reset") {
      preserved.clear();
      world = lgs::World();
    } else if (word == "preserve" && words >> a >> b) {
      preserved.insert(std::minmax(a, b));
      world = lgs::World(
          [preserved](lgs::Block one, lgs::Block other) { return preserved.contains(std::minmax(one, other)); });
    } else if (word == "paint" && words >> a >> mode) {
      const bool fills = mode == "fill";
      static_cast<void>(paint(world, regionOf(words), a, fills ? lgs::PaintMode::fill : lgs::PaintMode::replace));
    } else if (word == "carve") {
      static_cast<void>(carve(world, regionOf(words)));
    } else if (word == "commit") {
      world.commit();
      print(world);
    }
  }
}
