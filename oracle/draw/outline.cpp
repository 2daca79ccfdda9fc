#include "oracle/draw/colours.h"
#include "oracle/draw/distinct.h"
#include "oracle/draw/panel.h"
#include "oracle/reference/words.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace lgs::oracle::drawing {

namespace {

// From one lattice point to another, in pixels. Positions on the picture would not do: Axis moves what is far outside.
Vec offset(const Plot& plot, Point from, Point to) {
  const double scale = plot.cellSize() / kUnitsPerCell;
  return {static_cast<double>(to.x - from.x) * scale, -static_cast<double>(to.y - from.y) * scale};
}

void drawDirections(Svg& svg, const Plot& plot, std::span<const OutlineSegment> segments) {
  constexpr double kHead = 9;
  constexpr double kNormal = 9;
  Path heads;
  Path normals;
  for (const OutlineSegment& s : segments) {
    const Vec start = plot.at(s.start);
    const Vec end = plot.at(s.end);
    const double size = length(end - start);
    if (size < 14) continue;
    const double scale = std::min(1.0, size / 36);
    addArrowHead(heads, start, end, kHead * scale);
    addNormal(normals, start, end, kNormal * scale);
  }
  svg.path(normals, {{"stroke", kInk}, {"stroke-width", 1.25}, {"stroke-opacity", 0.7}});
  svg.path(heads, {{"fill", kInk}});
}

void drawVertices(Svg& svg, const Plot& plot, std::span<const OutlineSegment> segments) {
  std::vector<Point> vertices;
  for (const OutlineSegment& s : segments) {
    vertices.push_back(s.start);
    vertices.push_back(s.end);
  }
  makeDistinct(vertices);
  const bool full = plot.detail() == Detail::full;
  Path dots;
  for (const Point& p : vertices) dots.circle(plot.at(p), full ? 2.9 : 1.8);
  svg.path(dots, {{"fill", full ? kPaper : kInk}, {"stroke", kInk}, {"stroke-width", full ? 1.4 : 0}});
}

void drawTooltips(Svg& svg, const Plot& plot, std::span<const OutlineSegment> segments) {
  svg.open("g", {{"stroke", kInk}, {"stroke-opacity", "0"}, {"stroke-width", 12}});
  for (const OutlineSegment& s : segments) {
    Path path;
    path.line(plot.at(s.start), plot.at(s.end));
    svg.tooltip(path, inWords(s.start, s.end) + ", block " + std::to_string(s.block) + "; ghost1 " +
                          ghostInWords(s.ghost1) + ", ghost2 " + ghostInWords(s.ghost2));
  }
  svg.close();
}

}  // namespace

void addArrowHead(Path& heads, Vec start, Vec end, double size) {
  const Vec back = unit(end - start) * -size;
  // The tip is beyond the middle, so that the heads of two opposite segments (of a preserve relation) stand apart.
  const Vec tip = start + (end - start) * 0.64 - back * 0.5;
  const Vec side{-back.y * 0.42, back.x * 0.42};
  heads.moveTo(tip).lineTo(tip + back + side).lineTo(tip + back * 0.75).lineTo(tip + back - side).close();
}

void addNormal(Path& normals, Vec start, Vec end, double size) {
  const Vec along = unit(end - start);
  const Vec middle = (start + end) * 0.5;
  normals.line(middle, middle + Vec{-along.y, along.x} * size);  // to the right, as seen with y down
}

void Turns::add(Vec at, double fromAngle, double turn, double radius) {
  // The arc ends a little short of both segments, so that one sees on which side of them the link runs.
  const double gap = std::min(2.5 / radius, turn / 6);
  const double sweep = turn - 2 * gap;
  const double last = fromAngle + gap + sweep;
  const auto onCircle = [&](double angle, double r) { return at + Vec{std::cos(angle), -std::sin(angle)} * r; };
  const Vec end = onCircle(last, radius);
  arcs_.moveTo(onCircle(last - sweep, radius)).arcTo(end, radius, sweep > std::numbers::pi, false);
  const double barb = std::min(4.0, 0.45 * radius * std::min(1.0, sweep));
  const double back = last - barb / radius;
  heads_.moveTo(onCircle(back, radius + barb * 0.7)).lineTo(end).lineTo(onCircle(back, radius - barb * 0.7));
}

void Turns::draw(Svg& svg, const TurnStyle& style) const {
  svg.open("g",
           {{"fill", "none"}, {"stroke", style.colour}, {"stroke-width", style.width}, {"stroke-linejoin", "round"}});
  svg.path(arcs_, {{"stroke-dasharray", style.dashes}});
  svg.path(heads_, {});
  svg.close();
}

Outline segmentsInView(const Plot& plot, const Outline& outline) {
  Outline segments;
  std::copy_if(outline.begin(), outline.end(), std::back_inserter(segments),
               [&](const OutlineSegment& s) { return plot.shows(cellsOf(s)); });
  return segments;
}

Path segmentPath(const Plot& plot, std::span<const OutlineSegment> segments) {
  Path path;
  for (const OutlineSegment& s : segments) path.line(plot.at(s.start), plot.at(s.end));
  return path;
}

void drawLinks(Svg& svg, const Plot& plot, std::span<const Link> links, double radius, const TurnStyle& style) {
  Turns turns;
  for (const Link& link : links) {
    if (!plot.shows(link.at)) continue;
    const Vec from = offset(plot, link.at, link.from);
    const Vec to = offset(plot, link.at, link.to);
    // The arc runs through the free side: counter-clockwise from where the chain comes from to where it goes.
    const double fromAngle = std::atan2(-from.y, from.x);
    double turn = std::atan2(-to.y, to.x) - fromAngle;
    if (turn <= 1e-12) turn += 2 * std::numbers::pi;
    const double roomy = radius / std::clamp(turn / 1.5, 0.5, 1.0);  // a sharp corner has room only further out
    const double fitting = std::min({roomy, length(from) * 0.3, length(to) * 0.3});
    if (fitting >= 2) turns.add(plot.at(link.at), fromAngle, turn, fitting);
  }
  turns.draw(svg, style);
}

void drawOutline(Svg& svg, const Plot& plot, const Outline& outline) {
  const Outline segments = segmentsInView(plot, outline);
  constexpr double kWidths[] = {1.1, 1.7, 2.2};
  beginClip(svg, plot);
  svg.path(segmentPath(plot, segments),
           {{"stroke", kInk}, {"stroke-linecap", "round"}, {"stroke-width", kWidths[static_cast<int>(plot.detail())]}});
  if (plot.detail() != Detail::lines) drawDirections(svg, plot, segments);
  if (plot.detail() == Detail::full) {
    constexpr double kRadius = 12;
    const Links links = linksOf(outline);  // of the whole outline, because a neighbour may be out of view
    drawLinks(svg, plot, links.mutual, kRadius, {kLink, 1.4});
    drawLinks(svg, plot, links.oneSided, kRadius, {kLink, 1.4, kNotMutual});
  }
  if (plot.detail() != Detail::lines) drawVertices(svg, plot, segments);
  if (plot.detail() == Detail::full) drawTooltips(svg, plot, segments);
  endClip(svg);
}

}  // namespace lgs::oracle::drawing
