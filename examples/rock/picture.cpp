#include "picture.h"

#include <cmath>

namespace examples {
namespace {

constexpr int kScale = 18;  // pixels a cell

double pixels(double cells) { return std::round(cells * kScale * 10) / 10; }

}  // namespace

void drawGround(const lgs::World& world, const char* (*lookOf)(lgs::Block), std::vector<Drawn>& out) {
  world.forEachPolygon([&](lgs::Cell cell, const lgs::PlacedPolygon& p) {
    Drawn drawn{{}, lookOf(p.block)};
    for (const lgs::LocalPoint v : p.vertices)
      drawn.corners.push_back({cell.i + static_cast<double>(v.x) / lgs::kUnitsPerCell,
                               cell.j + static_cast<double>(v.y) / lgs::kUnitsPerCell});
    out.push_back(std::move(drawn));
  });
}

void writePicture(std::ostream& out, const lgs::CellRect& cells, const std::vector<Drawn>& drawn) {
  const int width = (cells.max.i - cells.min.i + 1) * kScale, height = (cells.max.j - cells.min.j + 1) * kScale;
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << width << ' ' << height << "'>\n"
      << "<rect width='100%' height='100%' fill='#eaf2f6'/>\n"
      << "<style>.g{fill:#a89a84;stroke:#a89a84}.d{fill:#d9d2c3;stroke:#d9d2c3}.r{fill:#6b5b4b;stroke:#6b5b4b}"
         ".o{fill:#c9922e;stroke:#c9922e}.w{fill:none;stroke:#6b5b4b;stroke-opacity:.55}path{stroke-width:.7}</"
         "style>\n";
  for (const Drawn& d : drawn) {
    const char* before = "M";
    out << "<path class='" << d.look << "' d='";
    for (const lgs::DoublePoint p : d.corners) {
      out << before << pixels(p.x - cells.min.i) << ',' << pixels(cells.max.j + 1 - p.y);
      before = " ";
    }
    out << "z'/>\n";
  }
  out << "</svg>\n";
}

}  // namespace examples
