#include "oracle/draw/difference.h"

#include "oracle/draw/colours.h"
#include "oracle/draw/distinct.h"
#include "oracle/draw/panel.h"

#include <algorithm>

namespace lgs::oracle::drawing {

namespace {

constexpr std::string_view kDashes = "7 4";
constexpr TurnStyle kExpectedLink{kExpected, 2, "4 2"};
constexpr TurnStyle kActualLink{kActual, 2};

// What is to be drawn for a list of differences.
struct Signs {
  explicit Signs(std::span<const Difference> differences) {
    for (const Difference& d : differences) {
      switch (d.kind) {
        case Difference::Kind::missing:
          missing.push_back(*d.expected);
          break;
        case Difference::Kind::extra:
          extra.push_back(*d.actual);
          break;
        case Difference::Kind::block:
        case Difference::Kind::owner:
          otherwiseOwned.push_back(*d.actual);
          break;
        case Difference::Kind::ghost1:
          rings.push_back(d.actual->start);
          if (d.expected->ghost1) expectedLinks.push_back({*d.expected->ghost1, d.expected->start, d.expected->end});
          if (d.actual->ghost1) actualLinks.push_back({*d.actual->ghost1, d.actual->start, d.actual->end});
          break;
        case Difference::Kind::ghost2:
          rings.push_back(d.actual->end);
          if (d.expected->ghost2) expectedLinks.push_back({d.expected->start, d.expected->end, *d.expected->ghost2});
          if (d.actual->ghost2) actualLinks.push_back({d.actual->start, d.actual->end, *d.actual->ghost2});
          break;
      }
    }
    makeDistinct(rings);  // a wrong link is a difference of both its segments
    makeDistinct(expectedLinks);
    makeDistinct(actualLinks);
  }

  std::vector<OutlineSegment> missing;
  std::vector<OutlineSegment> extra;
  std::vector<OutlineSegment> otherwiseOwned;
  std::vector<Point> rings;
  std::vector<Link> expectedLinks;
  std::vector<Link> actualLinks;
};

Path headPath(const Plot& plot, std::span<const OutlineSegment> segments) {
  Path heads;
  for (const OutlineSegment& s : segments) {
    const double size = length(plot.at(s.end) - plot.at(s.start));
    addArrowHead(heads, plot.at(s.start), plot.at(s.end), std::min(12.0, size / 2));
  }
  return heads;
}

void include(Band& band, const Band& other) {
  band.first = std::min(band.first, other.first);
  band.last = std::max(band.last, other.last);
}

bool isAtMost(const Band& band, std::int64_t cells) { return band.last - band.first < cells; }

}  // namespace

std::optional<CellRect> viewOf(std::span<const Difference> differences) {
  constexpr std::int64_t kLargest = 8;
  constexpr std::int64_t kAround = 1;
  std::optional<CellBox> box;
  for (const Difference& d : differences) {
    const CellBox cells = cellsOf(d.segment());
    if (!box) box = cells;
    CellBox larger = *box;
    include(larger.columns, cells.columns);
    include(larger.rows, cells.rows);
    if (isAtMost(larger.columns, kLargest) && isAtMost(larger.rows, kLargest)) box = larger;
  }
  if (!box) return {};
  const auto index = [](std::int64_t cell) { return static_cast<std::int32_t>(cell); };
  return CellRect{{index(box->columns.first - kAround), index(box->rows.first - kAround)},
                  {index(box->columns.last + kAround), index(box->rows.last + kAround)}};
}

void drawDifference(Svg& svg, const Plot& plot, const Outline& actual, std::span<const Difference> differences) {
  const Signs signs(differences);
  const Outline around = segmentsInView(plot, actual);
  Path rings;
  for (const Point& p : signs.rings) rings.circle(plot.at(p), 20);

  beginClip(svg, plot);
  svg.path(rings, {{"fill", kPaper}, {"fill-opacity", 0.7}});
  svg.path(segmentPath(plot, around), {{"stroke", kMuted}, {"stroke-width", 1.2}});
  svg.path(segmentPath(plot, signs.otherwiseOwned), {{"stroke", kLink}, {"stroke-width", 4}});
  svg.path(segmentPath(plot, signs.extra), {{"stroke", kActual}, {"stroke-width", 4}, {"stroke-linecap", "round"}});
  svg.path(headPath(plot, signs.extra), {{"fill", kActual}});
  svg.path(segmentPath(plot, signs.missing),
           {{"stroke", kExpected}, {"stroke-width", 3}, {"stroke-dasharray", kDashes}});
  svg.path(headPath(plot, signs.missing), {{"fill", kExpected}});
  svg.path(rings, {{"fill", "none"}, {"stroke", kInk}, {"stroke-width", 1.5}});
  drawLinks(svg, plot, signs.actualLinks, 9, kActualLink);  // two radii, because both may lie in the same wedge
  drawLinks(svg, plot, signs.expectedLinks, 14, kExpectedLink);
  endClip(svg);
}

void addSigns(std::vector<LegendEntry>& entries, std::span<const Difference> differences) {
  const Signs signs(differences);
  if (!signs.missing.empty()) entries.push_back(lineEntry("missing segment", kExpected, 3, kDashes));
  if (!signs.extra.empty()) entries.push_back(lineEntry("extra segment", kActual, 4));
  if (!signs.otherwiseOwned.empty()) entries.push_back(lineEntry("wrong block or owner", kLink, 4));
  if (!signs.rings.empty()) entries.push_back(ringEntry("vertex with a wrong link"));
  if (!signs.expectedLinks.empty()) entries.push_back(linkEntry("link as expected", kExpectedLink));
  if (!signs.actualLinks.empty()) entries.push_back(linkEntry("link as it is", kActualLink));
}

}  // namespace lgs::oracle::drawing
