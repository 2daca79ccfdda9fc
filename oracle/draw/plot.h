// Where the points of the world land on the picture: which cells are shown, which stretches are folded away. y is
// flipped.
//
// All decisions are made on integers. Only the position relative to a nearby cell becomes a `double`, so cells at the
// far ends of the world are drawn as exactly as those at the origin.
#pragma once

#include "oracle/draw/svg.h"
#include "oracle/reference/outline.h"
#include "oracle/reference/scene.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lgs::oracle::drawing {

/// Columns or rows of cells, `first` to `last`, both included.
struct Band {
  std::int64_t first = 0;
  std::int64_t last = 0;
};

/// The cells whose closed areas hold a segment. A segment on a grid line belongs to the side where its solid is.
struct CellBox {
  Band columns;
  Band rows;
};
CellBox cellsOf(const OutlineSegment& segment);
CellBox cellsOf(Cell cell);

/// One axis of a picture. Positions are in cells from its beginning.
class Axis {
 public:
  /// Shows these bands and the gaps between them. A gap longer than kLongestGap is folded to the width fold().
  explicit Axis(std::vector<Band> used);

  struct Stretch : Band {
    double position = 0;  ///< of the near side of `first`
  };
  const std::vector<Stretch>& stretches() const { return stretches_; }
  double length() const;
  double fold() const { return fold_; }
  bool shows(const Band& cells) const;  ///< at least one of them
  double position(std::int64_t lattice) const;

 private:
  static constexpr std::int64_t kLongestGap = 48;
  std::vector<Stretch> stretches_;  // in increasing order, at least one
  double fold_ = 1;
};

/// The cells to be shown.
struct Extent {
  Axis columns;
  Axis rows;
};

/// Everything in the scene, the outlines and the edited cells, or only what is inside `view`.
Extent extentOf(const Scene& scene, std::span<const Outline* const> outlines, std::span<const Cell> edited,
                const std::optional<CellRect>& view);

/// How much is drawn; see draw.h.
enum class Detail { lines, shapes, full };

/// An extent at a place on the picture. The extent must outlive it.
class Plot {
 public:
  Plot(const Extent& extent, double cellSize, Vec corner) : extent_(&extent), cellSize_(cellSize), corner_(corner) {}

  Vec at(Point p) const { return {column(p.x), row(p.y)}; }
  double column(std::int64_t latticeX) const { return corner_.x + extent_->columns.position(latticeX) * cellSize_; }
  double row(std::int64_t latticeY) const { return bottom() - extent_->rows.position(latticeY) * cellSize_; }

  Vec corner() const { return corner_; }  ///< upper left
  double width() const { return extent_->columns.length() * cellSize_; }
  double height() const { return extent_->rows.length() * cellSize_; }
  double bottom() const { return corner_.y + height(); }
  double cellSize() const { return cellSize_; }
  const Extent& extent() const { return *extent_; }
  bool shows(const CellBox& box) const { return extent_->columns.shows(box.columns) && extent_->rows.shows(box.rows); }
  bool shows(Point p) const;  ///< also on the rim
  Detail detail() const;

 private:
  const Extent* extent_;
  double cellSize_;
  Vec corner_;
};

/// The size of a cell in pixels with which a plot fits in this area. A whole number where possible, for crisp edges.
double fittingCellSize(const Extent& extent, double width, double height);

}  // namespace lgs::oracle::drawing
