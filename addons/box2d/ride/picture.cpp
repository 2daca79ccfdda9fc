#include "addons/box2d/ride/picture.h"

#include "oracle/draw/colours.h"
#include "oracle/draw/legend.h"
#include "oracle/draw/panel.h"
#include "oracle/reference/words.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace lgs::bench {

using namespace oracle::drawing;

namespace {

struct Style {
  std::string_view colour;
  double width;
};
constexpr std::array<Style, 3> kStyles{{{kExpected, 2.4}, {kActual, 1.8}, {kLink, 1.8}}};

constexpr double kChartHeight = 120;
constexpr double kChartGap = 34;

class Rides {
 public:
  Rides(const Plot& plot, const std::vector<NamedTrack>& tracks, const RideOptions& options)
      : plot_(plot), tracks_(tracks), options_(options) {}

  void drawPaths(Svg& svg) const {
    beginClip(svg, plot_);
    for (std::size_t k = tracks_.size(); k-- > 0;) {
      Path path;
      path.moveTo(at(options_.start));
      for (const Sample& s : tracks_[k].track.samples) {
        if (plot_.shows(toLattice(s.position))) path.lineTo(at(s.position));
      }
      svg.path(path, {{"fill", "none"},
                      {"stroke", kStyles[k].colour},
                      {"stroke-width", kStyles[k].width},
                      {"stroke-linejoin", "round"}});
      drawKicks(svg, k);
    }
    Path start;
    start.circle(at(options_.start), options_.size / 2 / options_.terrain.cellSize * plot_.cellSize());
    svg.path(start, {{"fill", kExpected}, {"fill-opacity", 0.15}, {"stroke", kExpected}, {"stroke-width", 1.5}});
    endClip(svg);
  }

  // Below the plot: the speed to the right at each place.
  void drawSpeeds(Svg& svg, double top) const {
    float fastest = 1;
    for (const NamedTrack& t : tracks_) {
      for (const Sample& s : t.track.samples) fastest = std::max(fastest, s.velocity.x);
    }
    const double bottom = top + kChartHeight;
    const double left = plot_.corner().x;
    const auto height = [&](double speed) { return bottom - std::clamp(speed / fastest, 0.0, 1.0) * kChartHeight; };
    svg.leaf("rect", {{"x", left},
                      {"y", top},
                      {"width", plot_.width()},
                      {"height", kChartHeight},
                      {"fill", kPaper},
                      {"stroke", kGrid},
                      {"stroke-opacity", 0.35}});
    const double unit = fastest > 8 ? 4 : fastest > 3 ? 2 : 1;
    Path lines;
    for (int k = 0; k * unit <= fastest; ++k) {
      const double speed = k * unit;
      lines.line({left, height(speed)}, {left + plot_.width(), height(speed)});
      svg.text({left - 7, height(speed) + 4}, number(speed),
               {{"font-size", kLabelSize}, {"fill", kMuted}, {"text-anchor", "end"}});
    }
    svg.path(lines, {{"stroke", kGrid}, {"stroke-width", 0.75}, {"stroke-opacity", 0.5}});
    svg.text({left, top - 8}, "speed to the right, in metres a second (a cell is a metre)",
             {{"font-size", kLabelSize}, {"fill", kMuted}});
    for (std::size_t k = tracks_.size(); k-- > 0;) {
      Path path;
      for (const Sample& s : tracks_[k].track.samples) {
        if (!plot_.shows(toLattice(s.position))) continue;
        const Vec p{at(s.position).x, height(s.velocity.x)};
        path.empty() ? path.moveTo(p) : path.lineTo(p);
      }
      svg.path(path, {{"fill", "none"}, {"stroke", kStyles[k].colour}, {"stroke-width", kStyles[k].width * 0.75}});
    }
  }

 private:
  Point toLattice(b2Vec2 p) const {
    const double scale = kUnitsPerCell / options_.terrain.cellSize;
    const Point origin = toWorld(options_.terrain.origin, {});
    return {origin.x + std::llround(p.x * scale), origin.y + std::llround(p.y * scale)};
  }
  Vec at(b2Vec2 p) const { return plot_.at(toLattice(p)); }

  void drawKicks(Svg& svg, std::size_t which) const {
    for (const Kick& kick : tracks_[which].track.kicks) {
      Path ring;
      ring.circle(at(kick.position), 3 + 2 * std::sqrt(std::min(kick.strength, 10.0F)));
      svg.path(ring, {{"fill", kStyles[which].colour},
                      {"fill-opacity", 0.12},
                      {"stroke", kStyles[which].colour},
                      {"stroke-width", 1.2}});
    }
  }

  const Plot& plot_;
  const std::vector<NamedTrack>& tracks_;
  const RideOptions& options_;
};

// The cells that the bodies came through, so that the plot shows all of them.
std::vector<Cell> cellsOf(const std::vector<NamedTrack>& tracks, const RideOptions& options) {
  const box2d::Frame frame{options.terrain.cellSize, options.terrain.origin, options.terrain.chunkCells};
  std::vector<Cell> cells{frame.cellAt({options.start.x, options.start.y})};
  for (const NamedTrack& t : tracks) {
    for (const Sample& s : t.track.samples) cells.push_back(frame.cellAt({s.position.x, s.position.y}));
  }
  return cells;
}

LegendEntry entryOf(std::size_t which, const NamedTrack& t) {
  const std::string kicks = t.track.kicks.empty() ? "no ghost collision"
                                                  : oracle::counted(t.track.kicks.size(), "ghost collision") +
                                                        ", up to " + number(t.track.strongest()) + " m/s";
  return lineEntry(fmt::format("{}: {}", name(t.way), kicks), kStyles[which].colour, kStyles[which].width);
}

}  // namespace

std::string drawRides(const oracle::Scene& scene, const oracle::Outline& outline, const std::vector<NamedTrack>& tracks,
                      const RideOptions& options, const std::string& title) {
  constexpr double kWidest = 1400;
  constexpr double kHighest = 700;
  const Extent extent = extentOf(scene, std::array{&outline}, cellsOf(tracks, options), {});
  const Panel panel(extent, fittingCellSize(extent, kWidest, kHighest), {kMargin, kMargin + kHeadingHeight});

  const std::string subtitle =
      fmt::format("A {} of {:.2g} m over {} in Box2D 2.4; a ring is a ghost collision", name(options.rider),
                  options.size, oracle::counted(scene.polygons.size(), "polygon"));
  std::vector<LegendEntry> entries;
  for (std::size_t k = 0; k < tracks.size(); ++k) entries.push_back(entryOf(k, tracks[k]));
  const double width = std::max(panel.width, headingWidth(title, subtitle));
  const Legend legend(std::move(entries), width);
  const double chartTop = kMargin + kHeadingHeight + panel.height + kChartGap;
  const double legendTop = chartTop + kChartHeight + 16;

  Svg svg(width + 2 * kMargin, legendTop + legend.height() + kMargin - 8, title, subtitle, kPage);
  drawHeading(svg, title, subtitle);
  drawBackdrop(svg, panel.plot, scene, {}, 0.8);
  beginClip(svg, panel.plot);
  svg.path(segmentPath(panel.plot, outline), {{"stroke", kInk}, {"stroke-linecap", "round"}, {"stroke-width", 1.4}});
  endClip(svg);
  const Rides rides(panel.plot, tracks, options);
  rides.drawPaths(svg);
  rides.drawSpeeds(svg, chartTop);
  legend.draw(svg, {kMargin, legendTop});
  return std::move(svg).finish();
}

}  // namespace lgs::bench
