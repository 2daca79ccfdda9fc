#include "oracle/views/recompute.h"

#include "oracle/reference/canonical.h"
#include "oracle/reference/naive.h"

#include <algorithm>
#include <cstdlib>

namespace lgs::oracle {

std::string inWords(Wide number) {
  std::string digits;
  for (Wide rest = number < 0 ? -number : number; rest != 0 || digits.empty(); rest /= 10)
    digits.insert(digits.begin(), static_cast<char>('0' + static_cast<int>(rest % 10)));
  return number < 0 ? "-" + digits : digits;
}

Scene bareScene(const World& world) {
  Scene scene;
  world.forEachPolygon([&](Cell cell, const PlacedPolygon& p) {
    scene.polygons.push_back({cell, p.block, {p.vertices.begin(), p.vertices.end()}});
  });
  return scene;
}

std::vector<Edge> WalkedLoop::edges() const {
  std::vector<Edge> out;
  for (std::size_t k = 0; k < vertices.size(); ++k) out.emplace_back(vertices[k], vertices[(k + 1) % vertices.size()]);
  return out;
}

std::vector<WalkedLoop> walkedLoops(const Scene& scene) {
  const auto chains = followLinks(naiveOutline(scene));
  if (!chains) std::abort();  // law 3
  std::vector<WalkedLoop> loops;
  for (const std::vector<Point>& chain : *chains) {
    WalkedLoop loop{chain, 0, chain[0], chain[0], *std::ranges::min_element(chain)};
    for (const auto& [a, b] : loop.edges()) {
      loop.doubleArea += Wide{a.x + b.x} * (b.y - a.y);  // twice the trapezoid between the edge and the y axis
      loop.min = {std::min(loop.min.x, a.x), std::min(loop.min.y, a.y)};
      loop.max = {std::max(loop.max.x, a.x), std::max(loop.max.y, a.y)};
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace lgs::oracle
