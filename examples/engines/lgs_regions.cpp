// This library's brushes as an engine of regions for `lgs check --engine`: an example of the protocol in C++.
//
//     lgs check --engine build/release/examples/engines/lgs_regions
#include "examples/engines/regions.h"

#include <lgs/brush.h>
#include <lgs/world.h>

#include <algorithm>
#include <iostream>
#include <set>

namespace {

lgs::Region regionOf(std::istringstream& words) {
  lgs::Region region{{}, lgs::FillRule::evenOdd};
  for (const auto& points : readRings(words)) {
    lgs::Ring& ring = region.rings.emplace_back();
    for (const auto& [x, y] : points) ring.push_back({x, y});
  }
  return region;
}

void print(const lgs::Segment& s) {
  const auto end = [](lgs::Point p) { return ' ' + std::to_string(p.x) + ' ' + std::to_string(p.y); };
  std::cout << "segment" << end(s.start) << end(s.end) << (s.predecessor ? end(s.ghost1) : " - -")
            << (s.successor ? end(s.ghost2) : " - -") << ' ' << s.block << '\n';
}

}  // namespace

int main() {
  std::set<std::pair<lgs::Block, lgs::Block>> preserved;
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
      world = lgs::World([preserved](lgs::Block c, lgs::Block d) { return preserved.contains(std::minmax(c, d)); });
    } else if (word == "paint" && words >> a >> mode) {
      const bool fills = mode == "fill";
      static_cast<void>(paint(world, regionOf(words), a, fills ? lgs::PaintMode::fill : lgs::PaintMode::replace));
    } else if (word == "carve") {
      static_cast<void>(carve(world, regionOf(words)));
    } else if (word == "commit") {
      world.commit();
      for (const lgs::SegmentId id : world.segments()) print(*world.segment(id));
      std::cout << "end" << std::endl;
    }
  }
}
