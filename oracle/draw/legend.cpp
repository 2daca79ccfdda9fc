#include "oracle/draw/legend.h"

#include "oracle/draw/colours.h"
#include "oracle/reference/words.h"

#include <algorithm>
#include <numbers>
#include <set>

namespace lgs::oracle::drawing {

namespace {

constexpr double kSignWidth = 26;
constexpr double kEntryGap = 22;
constexpr double kRowHeight = 22;
constexpr double kTextSize = 12;
constexpr double kTitleSize = 19;

double widthOf(const LegendEntry& entry) { return kSignWidth + 7 + textWidth(entry.label, kTextSize); }

LegendEntry directionEntry() {
  return {"boundary segment, solid on its left; tick: outward normal", [](Svg& svg, Vec at) {
            Path line;
            Path head;
            const Vec start = at - Vec{12, 3};
            const Vec end = at + Vec{12, -3};
            line.line(start, end);
            addArrowHead(head, start, end, 8);
            Path normal;
            addNormal(normal, start, end, 8);
            svg.path(line, {{"stroke", kInk}, {"stroke-width", 2.2}});
            svg.path(normal, {{"stroke", kInk}, {"stroke-width", 1.25}});
            svg.path(head, {{"fill", kInk}});
          }};
}

LegendEntry editedEntry() {
  return {"edited cell", [](Svg& svg, Vec at) {
            Path cell;
            cell.rect(at - Vec{9, 7}, 18, 14);
            svg.path(cell, {{"fill", kEdited},
                            {"fill-opacity", 0.07},
                            {"stroke", kEdited},
                            {"stroke-width", 1.5},
                            {"stroke-dasharray", "4 2"}});
          }};
}

}  // namespace

Legend::Legend(std::vector<LegendEntry> entries, double width) : entries_(std::move(entries)), height_(kRowHeight) {
  double x = 0;
  for (const LegendEntry& entry : entries_) {
    if (x > 0 && x + widthOf(entry) > width) {
      x = 0;
      height_ += kRowHeight;
    }
    places_.push_back({x, height_ - kRowHeight / 2});
    x += widthOf(entry) + kEntryGap;
  }
}

void Legend::draw(Svg& svg, Vec topLeft) const {
  svg.open("g", {{"font-size", kTextSize}, {"fill", kInk}});
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const Vec place = topLeft + places_[k];
    entries_[k].sign(svg, place + Vec{kSignWidth / 2, 0});
    svg.text(place + Vec{kSignWidth + 7, kTextSize * 0.36}, entries_[k].label, {});
  }
  svg.close();
}

LegendEntry lineEntry(std::string label, std::string_view colour, double width, std::string_view dashes) {
  return {std::move(label), [=](Svg& svg, Vec at) {
            Path line;
            line.line(at - Vec{12, 0}, at + Vec{12, 0});
            svg.path(line, {{"stroke", colour}, {"stroke-width", width}, {"stroke-dasharray", dashes}});
          }};
}

LegendEntry linkEntry(std::string label, const TurnStyle& style) {
  return {std::move(label), [=](Svg& svg, Vec at) {
            Turns turns;
            turns.add(at + Vec{0, 5}, 0, std::numbers::pi, 10);
            turns.draw(svg, style);
          }};
}

LegendEntry ringEntry(std::string label) {
  return {std::move(label), [](Svg& svg, Vec at) {
            Path ring;
            ring.circle(at, 7);
            svg.path(ring, {{"fill", "none"}, {"stroke", kInk}, {"stroke-width", 1.5}});
          }};
}

void addBackdrop(std::vector<LegendEntry>& entries, const Plot& plot, const Scene& scene,
                 std::span<const Cell> edited) {
  constexpr std::size_t kMost = 12;
  std::set<Block> blocks;
  for (const ScenePolygon& p : scene.polygons) {
    if (plot.shows(cellsOf(p.cell))) blocks.insert(p.block);
  }
  const auto fills = fillsOf(scene);
  std::size_t count = 0;
  for (const Block block : blocks) {
    if (count++ == kMost) break;
    entries.push_back({"block " + std::to_string(block), [fill = fills.at(block)](Svg& svg, Vec at) {
                         svg.leaf("rect", {{"x", at.x - 9},
                                           {"y", at.y - 7},
                                           {"width", 18},
                                           {"height", 14},
                                           {"rx", 2},
                                           {"fill", fill},
                                           {"stroke", kInk},
                                           {"stroke-opacity", 0.25}});
                       }});
  }
  if (blocks.size() > kMost) {
    entries.push_back({"and " + counted(blocks.size() - kMost, "more block"), [](Svg&, Vec) {}});
  }
  if (std::any_of(edited.begin(), edited.end(), [&](const Cell& c) { return plot.shows(cellsOf(c)); })) {
    entries.push_back(editedEntry());
  }
}

void addOutlines(std::vector<LegendEntry>& entries, const Plot& plot, std::span<const Outline* const> outlines) {
  if (std::all_of(outlines.begin(), outlines.end(), [](const Outline* o) { return o->empty(); })) return;
  if (plot.detail() == Detail::lines) {
    entries.push_back(lineEntry("boundary segment", kInk, 1.7));
    return;
  }
  entries.push_back(directionEntry());
  if (plot.detail() != Detail::full) return;
  entries.push_back(linkEntry("link to the next segment", {kLink, 1.4}));
  if (std::any_of(outlines.begin(), outlines.end(), [](const Outline* o) { return !linksOf(*o).oneSided.empty(); })) {
    entries.push_back(linkEntry("link that is not mutual", {kLink, 1.4, kNotMutual}));
  }
}

void drawHeading(Svg& svg, std::string_view title, std::string_view subtitle) {
  svg.text({kMargin, kMargin + kTitleSize * 0.8}, title,
           {{"font-size", kTitleSize}, {"font-weight", "600"}, {"fill", kInk}});
  svg.text({kMargin, kMargin + kTitleSize + 18}, subtitle, {{"font-size", 12.5}, {"fill", kMuted}});
}

double headingWidth(std::string_view title, std::string_view subtitle) {
  return std::max(textWidth(title, kTitleSize * 1.05), textWidth(subtitle, 12.5));
}

std::string shortened(std::string_view title) {
  constexpr std::size_t kMost = 120;
  if (title.size() <= kMost) return std::string(title);
  std::size_t end = kMost;
  while (end > 0 && (static_cast<unsigned char>(title[end]) & 0xC0) == 0x80) --end;  // not within a character
  return std::string(title.substr(0, end)) + "…";
}

}  // namespace lgs::oracle::drawing
