#include "oracle/draw/colours.h"

#include <array>

namespace lgs::oracle::drawing {

namespace {

// Paul Tol's "light" scheme, half way to white.
constexpr std::array<std::string_view, 9> kFills{"#b5cfe8", "#f4e9b5", "#9fd8c7", "#f5bfac", "#c3ebff",
                                                 "#ffd0d9", "#dbe38f", "#cfcf7a", "#cfd3da"};

}  // namespace

std::map<Block, std::string_view> fillsOf(const Scene& scene) {
  std::map<Block, std::string_view> fills;
  for (const ScenePolygon& p : scene.polygons) fills[p.block];
  std::array<bool, kFills.size()> taken{};
  std::size_t count = 0;
  for (auto& [block, fill] : fills) {
    std::size_t slot = block % kFills.size();
    if (count++ < kFills.size()) {
      while (taken[slot]) slot = (slot + 1) % kFills.size();
    }
    taken[slot] = true;
    fill = kFills[slot];
  }
  return fills;
}

}  // namespace lgs::oracle::drawing
