#include "oracle/draw/plot.h"

#include "oracle/reference/vector.h"

#include <algorithm>
#include <cmath>

namespace lgs::oracle::drawing {

namespace {

// The cells on both sides of a coordinate; the same one twice unless it is on a grid line.
std::int64_t cellAfter(std::int64_t lattice) { return cellIndex(lattice); }
std::int64_t cellBefore(std::int64_t lattice) { return cellIndex(lattice - 1); }

Band bandOf(std::int64_t a, std::int64_t b, bool solidBefore) {
  if (a == b) {
    const std::int64_t cell = solidBefore ? cellBefore(a) : cellAfter(a);
    return {cell, cell};
  }
  return {cellAfter(std::min(a, b)), cellBefore(std::max(a, b))};
}

double endOf(const Axis::Stretch& s) { return s.position + static_cast<double>(s.last - s.first + 1); }

Axis axisOf(std::vector<Band> used) {
  if (used.empty()) used = {{-1, 1}};  // an empty world is shown as a small empty grid around the origin
  return Axis(std::move(used));
}

}  // namespace

CellBox cellsOf(const OutlineSegment& s) {
  // The solid is on the left: going up it is at smaller x, going left at smaller y.
  return {bandOf(s.start.x, s.end.x, s.end.y > s.start.y), bandOf(s.start.y, s.end.y, s.end.x < s.start.x)};
}

CellBox cellsOf(Cell c) { return {{c.i, c.i}, {c.j, c.j}}; }

Axis::Axis(std::vector<Band> used) {
  std::sort(used.begin(), used.end(), [](const Band& a, const Band& b) { return a.first < b.first; });
  for (const Band& band : used) {
    if (stretches_.empty() || band.first - stretches_.back().last - 1 > kLongestGap) {
      stretches_.push_back({band, 0});
    } else {
      stretches_.back().last = std::max(stretches_.back().last, band.last);
    }
  }
  double cells = 0;
  for (const Stretch& s : stretches_) cells += endOf(s) - s.position;
  fold_ = std::max(1.0, cells / 40);  // wide enough to be seen in a large picture too
  for (std::size_t k = 1; k < stretches_.size(); ++k) stretches_[k].position = endOf(stretches_[k - 1]) + fold_;
}

double Axis::length() const { return endOf(stretches_.back()); }

bool Axis::shows(const Band& cells) const {
  return std::any_of(stretches_.begin(), stretches_.end(),
                     [&](const Stretch& s) { return cells.first <= s.last && cells.last >= s.first; });
}

double Axis::position(std::int64_t lattice) const {
  const std::int64_t cell = cellAfter(lattice);
  const double inCell = static_cast<double>(lattice - cell * kUnitsPerCell) / kUnitsPerCell;
  const auto next = std::upper_bound(stretches_.begin(), stretches_.end(), cell,
                                     [](std::int64_t c, const Stretch& s) { return c < s.first; });
  // What lies outside is only drawn as the hidden end of a line. It is moved nearer, because renderers overflow on very
  // large numbers.
  constexpr double kFarOutside = 100;
  if (next == stretches_.begin()) {
    return std::max(static_cast<double>(cell - next->first) + inCell, -kFarOutside);
  }
  const Stretch& stretch = *std::prev(next);
  if (cell <= stretch.last) return stretch.position + static_cast<double>(cell - stretch.first) + inCell;
  const double beyond = static_cast<double>(cell - stretch.last - 1) + inCell;
  if (next == stretches_.end()) return endOf(stretch) + std::min(beyond, kFarOutside);
  return endOf(stretch) + fold_ * beyond / static_cast<double>(next->first - stretch.last - 1);
}

Extent extentOf(const Scene& scene, std::span<const Outline* const> outlines, std::span<const Cell> edited,
                const std::optional<CellRect>& view) {
  if (view && !isEmpty(*view)) return {Axis({{view->min.i, view->max.i}}), Axis({{view->min.j, view->max.j}})};
  std::vector<Band> columns;
  std::vector<Band> rows;
  const auto add = [&](const CellBox& box) {
    columns.push_back(box.columns);
    rows.push_back(box.rows);
  };
  for (const ScenePolygon& p : scene.polygons) add(cellsOf(p.cell));
  for (const Outline* outline : outlines) {
    for (const OutlineSegment& s : *outline) add(cellsOf(s));
  }
  for (const Cell& c : edited) add(cellsOf(c));
  return {axisOf(std::move(columns)), axisOf(std::move(rows))};
}

bool Plot::shows(Point p) const {
  return shows(CellBox{{cellBefore(p.x), cellAfter(p.x)}, {cellBefore(p.y), cellAfter(p.y)}});
}

Detail Plot::detail() const {
  if (cellSize_ >= 52) return Detail::full;
  return cellSize_ >= 12 ? Detail::shapes : Detail::lines;
}

double fittingCellSize(const Extent& extent, double width, double height) {
  constexpr double kLargest = 120;
  const double size = std::min({width / extent.columns.length(), height / extent.rows.length(), kLargest});
  return size >= 2 ? std::floor(size) : size;
}

}  // namespace lgs::oracle::drawing
