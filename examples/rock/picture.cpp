#include "picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace examples {
namespace {

constexpr int kScale = 18;  // pixels a cell

double pixels(double cells) { return std::round(cells * kScale * 10) / 10; }

}  // namespace

void draw(std::vector<Drawn>& out, std::size_t first, const char* look, std::vector<lgs::DoublePoint> polygon) {
  const auto begin = out.begin() + static_cast<std::ptrdiff_t>(first);
  auto found = std::find_if(begin, out.end(), [look](const Drawn& d) { return d.look == look; });
  if (found == out.end()) found = out.insert(out.end(), {look, {}});
  found->polygons.push_back(std::move(polygon));
}

void drawGround(const lgs::World& world, const char* (*lookOf)(lgs::Block), std::vector<Drawn>& out) {
  const std::size_t first = out.size();
  world.forEachPolygon([&](lgs::Cell cell, const lgs::PlacedPolygon& p) {
    std::vector<lgs::DoublePoint> corners;
    for (const lgs::LocalPoint v : p.vertices)
      corners.push_back({cell.i + static_cast<double>(v.x) / lgs::kUnitsPerCell,
                         cell.j + static_cast<double>(v.y) / lgs::kUnitsPerCell});
    draw(out, first, lookOf(p.block), std::move(corners));
  });
}

void writePicture(std::ostream& out, const lgs::CellRect& cells, const std::vector<Drawn>& drawn) {
  const int width = (cells.max.i - cells.min.i + 1) * kScale, height = (cells.max.j - cells.min.j + 1) * kScale;
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << width << ' ' << height << "'>\n"
      << "<rect width='100%' height='100%' fill='#eaf2f6'/>\n"
      << "<style>.soil{fill:#a89a84}.dug{fill:#d9d2c3}.rock{fill:#6b5b4b}.ore{fill:#c9922e}"
         ".falling-rock{fill:#6b5b4b;opacity:.2}.falling-ore{fill:#c9922e;opacity:.5}</style>\n";
  for (const Drawn& d : drawn) {
    out << "<path class='" << d.look << "' d='";
    for (const std::vector<lgs::DoublePoint>& polygon : d.polygons) {
      const char* before = "M";
      for (const lgs::DoublePoint p : polygon) {
        out << before << pixels(p.x - cells.min.i) << ',' << pixels(cells.max.j + 1 - p.y);
        before = " ";
      }
      out << "z\n";
    }
    out << "'/>\n";
  }
  out << "</svg>\n";
}

}  // namespace examples
