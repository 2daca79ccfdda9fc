// What stands around the panels: heading, legend.
#pragma once

#include "oracle/draw/panel.h"
#include "oracle/draw/svg.h"
#include "oracle/reference/scene.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lgs::oracle::drawing {

inline constexpr double kMargin = 28;         ///< of the page
inline constexpr double kHeadingHeight = 56;  ///< title and subtitle

/// One sign and what it means. `sign` draws into the 26×16 pixels around the given centre.
struct LegendEntry {
  std::string label;
  std::function<void(Svg&, Vec)> sign;
};

/// The legend, set in rows of a given width.
class Legend {
 public:
  Legend(std::vector<LegendEntry> entries, double width);
  double height() const { return height_; }
  void draw(Svg& svg, Vec topLeft) const;

 private:
  std::vector<LegendEntry> entries_;
  std::vector<Vec> places_;
  double height_ = 0;
};

LegendEntry lineEntry(std::string label, std::string_view colour, double width, std::string_view dashes = "none");
LegendEntry linkEntry(std::string label, const TurnStyle& style);
LegendEntry ringEntry(std::string label);

/// Adds what drawBackdrop() shows: a swatch for each block in view, up to a dozen, and the edited cells.
void addBackdrop(std::vector<LegendEntry>& entries, const Plot& plot, const Scene& scene, std::span<const Cell> edited);

/// Adds what drawOutline() shows of these outlines.
void addOutlines(std::vector<LegendEntry>& entries, const Plot& plot, std::span<const Outline* const> outlines);

/// Draws a heading at the upper left of the page.
void drawHeading(Svg& svg, std::string_view title, std::string_view subtitle);
double headingWidth(std::string_view title, std::string_view subtitle);
/// Cuts a title that is too long for any page.
std::string shortened(std::string_view title);

}  // namespace lgs::oracle::drawing
