#include "picture.h"

#include <algorithm>
#include <span>

namespace examples {
namespace {

constexpr int kScale = 24;  // pixels a cell

class Picture {
 public:
  Picture(std::ostream& out, const lgs::CellRect& cells) : out_(out), cells_(cells) {
    const int width = (cells.max.i - cells.min.i + 1) * kScale, height = (cells.max.j - cells.min.j + 1) * kScale;
    out_ << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << width << ' ' << height << "'>\n"
         << "<style>.s{fill:#8a7a66;stroke:#75664f}.f{fill:#f6f3ea;stroke:#d9d2bf}.w{fill:#cfe3f2;stroke:#8fb3cc}"
            "path{stroke-width:.6}polyline{fill:none;stroke:#c0392b;stroke-width:2}</style>\n";
  }
  ~Picture() { out_ << "</svg>\n"; }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  void piece(lgs::Cell cell, std::span<const lgs::LocalPoint> vertices, const char* look) {
    const char* before = "M";
    out_ << "<path class='" << look << "' d='";
    for (const lgs::LocalPoint v : vertices) {
      out_ << before;
      point(toWorld(cell, v));
      before = " ";
    }
    out_ << "z'/>\n";
  }

  void line(std::span<const lgs::Point> points) {
    out_ << "<polyline points='";
    for (const lgs::Point p : points) {
      point(p);
      out_ << ' ';
    }
    out_ << "'/>\n";
  }

 private:
  void point(lgs::Point p) {
    const auto pixels = [](std::int64_t units) {  // to a tenth
      return static_cast<double>(units * kScale * 10 / lgs::kUnitsPerCell) / 10;
    };
    out_ << pixels(p.x - std::int64_t{cells_.min.i} * lgs::kUnitsPerCell) << ','
         << pixels((std::int64_t{cells_.max.j} + 1) * lgs::kUnitsPerCell - p.y);
  }

  std::ostream& out_;
  lgs::CellRect cells_;
};

}  // namespace

void drawPieces(std::ostream& out, const lgs::Pieces& pieces, const lgs::CellRect& cells, const Way& way) {
  Picture picture(out, cells);
  for (lgs::Cell cell = cells.min; cell.j <= cells.max.j; ++cell.j) {
    for (cell.i = cells.min.i; cell.i <= cells.max.i; ++cell.i) {
      for (const lgs::Piece& piece : pieces.solidPieces(cell)) picture.piece(cell, piece.vertices, "s");
      std::uint32_t index = 0;
      for (const lgs::Piece& piece : pieces.freePieces(cell)) {
        const bool isOnWay = std::ranges::find(way.pieces, lgs::PieceId{cell, index++}) != way.pieces.end();
        picture.piece(cell, piece.vertices, isOnWay ? "w" : "f");
      }
    }
  }
  picture.line(way.corners);
}

}  // namespace examples
