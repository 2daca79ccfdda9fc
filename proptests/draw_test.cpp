// The pictures: well-formed, complete, repeatable, and of a size that a viewer opens at once.
#include "oracle/draw/draw.h"

#include "oracle/reference/naive.h"
#include "oracle/reference/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace lgs::oracle {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::int32_t U = kUnitsPerCell;
using Local = std::vector<LocalPoint>;
const Local kSquare{{0, 0}, {U, 0}, {U, U}, {0, U}};
const Local kRamp{{0, 0}, {U, 0}, {U, U}};
const Local kSlope{{0, 0}, {U, 0}, {0, U}};
const Local kDiamond{{U / 2, 0}, {U, U / 2}, {U / 2, U}, {0, U / 2}};

// Reads just enough XML: returns what is wrong first, or nothing.
std::string wrongWith(const std::string& xml) {
  static const std::regex kTag(R"(</?([a-z]+)((?: [a-zA-Z:-]+="[^"<]*")*)(/?)>)");
  static const std::regex kText(R"((?:[^&<>]|&(?:amp|lt|gt|quot);)*)");
  std::vector<std::string> open;
  std::set<std::string> roots;
  std::size_t at = 0;
  while (at < xml.size()) {
    if (xml[at] != '<') {
      const std::size_t end = std::min(xml.find('<', at), xml.size());
      if (!std::regex_match(xml.substr(at, end - at), kText)) return "text at " + std::to_string(at);
      at = end;
      continue;
    }
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return "an open tag at the end";
    const std::string tag = xml.substr(at, end - at + 1);
    at = end + 1;
    const bool closes = tag[1] == '/';
    const std::string name = tag.substr(closes ? 2 : 1, tag.find_first_of(" />", 2) - (closes ? 2 : 1));
    // The regular expression recurses for each character, so the long paths are looked at less closely.
    std::smatch match;
    if (tag.size() < 2'000 && !std::regex_match(tag, match, kTag)) return "tag " + tag;
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return "quotes in " + tag.substr(0, 100);
    if (closes) {
      if (open.empty() || open.back() != name) return "unexpected " + tag;
      open.pop_back();
    } else if (tag[tag.size() - 2] != '/') {
      if (open.empty()) roots.insert(name);
      open.push_back(name);
    }
  }
  if (!open.empty()) return open.back() + " not closed";
  return roots == std::set<std::string>{"svg"} ? "" : "no single svg element";
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

// The number of pieces of the path that draws the outline: the only one with round ends in a picture of a world.
std::size_t drawnSegments(const std::string& svg) {
  const std::size_t mark = svg.find("stroke-linecap=\"round\"");
  if (mark == std::string::npos) return 0;
  const std::string path = svg.substr(svg.rfind("<path", mark), mark - svg.rfind("<path", mark));
  return static_cast<std::size_t>(std::count(path.begin(), path.end(), 'M'));
}

// The largest number anywhere in a path.
double largestCoordinate(const std::string& svg) {
  static const std::regex kNumber(R"([ML](-?[0-9.]+) (-?[0-9.]+))");
  double largest = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), kNumber), end; it != end; ++it) {
    for (const std::size_t group : {1u, 2u}) largest = std::max(largest, std::abs(std::stod((*it)[group].str())));
  }
  return largest;
}

Scene smallScene() {
  Scene scene;
  scene.polygons = {{{-1, 0}, 1, kSquare}, {{0, 0}, 1, kRamp},   {{1, 1}, 2, kSlope},
                    {{0, 1}, 3, kDiamond}, {{1, 0}, 4, kSquare}, {{2, -1}, 1, kRamp}};
  return scene;
}

Scene randomScene(std::int32_t width, std::int32_t height) {
  Scene scene;
  std::mt19937 random(7);
  for (std::int32_t i = 0; i < width; ++i) {
    for (std::int32_t j = 0; j < height; ++j) {
      const Local* const shapes[] = {&kSquare, &kRamp, &kSlope, &kDiamond};
      scene.polygons.push_back({{i, j}, static_cast<Block>(random() % 5), *shapes[random() % 4]});
    }
  }
  return scene;
}

TEST(DrawWorld, ShowsEverySegmentOfASmallWorldWithATooltip) {
  const Scene scene = smallScene();
  const Outline outline = naiveOutline(scene);
  const std::string svg = drawWorld(scene, outline);
  EXPECT_EQ(wrongWith(svg), "");
  EXPECT_EQ(drawnSegments(svg), outline.size());
  for (const OutlineSegment& s : outline) {
    EXPECT_THAT(svg, HasSubstr("<title>" + inWords(s.start, s.end) + ", block " + std::to_string(s.block) + "; "));
  }
  for (const char* label : {">block 1<", ">block 4<", ">-1<", ">3<", ">link to the next segment<"}) {
    EXPECT_THAT(svg, HasSubstr(label));
  }
  EXPECT_THAT(svg, Not(HasSubstr("edited cell")));
  EXPECT_THAT(svg, Not(HasSubstr("not mutual")));
}

TEST(DrawWorld, TellsLinksThatAreNotMutual) {
  Scene scene = smallScene();
  scene.preserve.add(1, 4);
  scene.polygons.push_back({{2, 0}, 1, kSquare});
  EXPECT_THAT(drawWorld(scene, naiveOutline(scene)), HasSubstr("link that is not mutual"));
}

TEST(DrawWorld, ShowsEverySegmentOfALargeWorldInASmallFile) {
  const Scene scene = randomScene(300, 30);
  const Outline outline = naiveOutline(scene);
  const std::string svg = drawWorld(scene, outline);
  EXPECT_EQ(wrongWith(svg), "");
  EXPECT_LT(svg.size(), 3'000'000u);
  EXPECT_EQ(drawnSegments(svg), outline.size());
  EXPECT_LT(count(svg, "<path"), 30u);  // one for each block, not for each polygon
}

TEST(DrawWorld, IsTheSameEveryTime) {
  const Scene scene = smallScene();
  const Outline outline = naiveOutline(scene);
  EXPECT_EQ(drawWorld(scene, outline), drawWorld(scene, outline));
}

TEST(DrawWorld, EscapesTheTitle) {
  DrawOptions options;
  options.title = "a<b> & \"c\"\x01 ü";
  const std::string svg = drawWorld({}, {}, options);
  EXPECT_EQ(wrongWith(svg), "");
  EXPECT_THAT(svg, HasSubstr("<title>a&lt;b&gt; &amp; &quot;c&quot;  ü</title>"));
}

TEST(DrawWorld, DrawsAnEmptyWorld) {
  const std::string svg = drawWorld({}, {});
  EXPECT_EQ(wrongWith(svg), "");
  EXPECT_THAT(svg, HasSubstr("empty world"));
}

TEST(DrawWorld, HighlightsEditedCells) {
  DrawOptions options;
  options.edited = {{5, 5}};
  const std::string svg = drawWorld({}, {}, options);
  EXPECT_THAT(svg, HasSubstr("edited cell"));
  EXPECT_THAT(svg, HasSubstr(">6<"));
}

TEST(DrawWorld, FoldsWhatIsEmptyBetweenTheEndsOfTheWorld) {
  Scene scene;
  scene.polygons = {{{-kMaxCell, -kMaxCell}, 1, kDiamond}, {{kMaxCell, kMaxCell}, 2, kRamp}};
  const Outline outline = naiveOutline(scene);
  const std::string svg = drawWorld(scene, outline);
  EXPECT_EQ(wrongWith(svg), "");
  EXPECT_EQ(drawnSegments(svg), outline.size());
  EXPECT_LT(largestCoordinate(svg), 1'000);
  EXPECT_THAT(svg, HasSubstr(">-1073741824<"));
  EXPECT_THAT(svg, HasSubstr(">1073741825<"));
}

TEST(DrawWorld, DrawsFarCellsAsItDrawsNearOnes) {
  const auto drawnAt = [](std::int32_t i) {
    Scene scene;
    scene.polygons = {{{i, i}, 1, {{0, 0}, {1, 0}, {21'845, U}}}};
    const std::string svg = drawWorld(scene, naiveOutline(scene));
    const std::size_t mark = svg.find("<path", svg.find("fill-opacity"));  // the solid
    std::vector<double> numbers;
    const std::regex kPoint(R"([ML]([0-9.]+) )");
    const std::string path = svg.substr(mark, svg.find('>', mark) - mark);
    for (std::sregex_iterator it(path.begin(), path.end(), kPoint), end; it != end; ++it) {
      numbers.push_back(std::stod((*it)[1].str()));
    }
    // Not the positions themselves: they depend on the width of the axis labels.
    return std::vector{numbers.at(1) - numbers.at(0), numbers.at(2) - numbers.at(0)};
  };
  const std::vector<double> near = drawnAt(0);
  const std::vector<double> far = drawnAt(kMaxCell);
  EXPECT_DOUBLE_EQ(near[0], far[0]);
  EXPECT_DOUBLE_EQ(near[1], far[1]);
}

TEST(DrawMismatch, ShowsEveryKindOfDifference) {
  const Scene scene = smallScene();
  const Outline expected = naiveOutline(scene);
  Outline actual = expected;
  actual[4].ghost2.reset();
  actual[6].block = 9;
  actual[8].ghost1 = Point{5 * U, 7 * U};
  actual.erase(actual.begin());
  actual.push_back({{5 * U, 5 * U}, {6 * U, 5 * U}, 1, {}, {}});

  MismatchOptions options;
  options.expectedName = "CGAL";
  options.actualName = "engine <1>";
  const std::string svg = drawMismatch(scene, expected, actual, options);
  EXPECT_EQ(wrongWith(svg), "");
  for (const char* text : {">5 differences<", ">CGAL<", ">engine &lt;1&gt;<", ">missing segment<", ">extra segment<",
                           ">wrong block or owner<", ">vertex with a wrong link<", ">link as expected<"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
  EXPECT_THAT(svg, HasSubstr("extra segment: (5, 5) → (6, 5)"));
  EXPECT_EQ(svg, drawMismatch(scene, expected, actual, options));
}

TEST(DrawMismatch, SeesWrongOwners) {
  const Scene scene = smallScene();
  NaiveReference reference;
  const OwnedOutline expected = reference(scene);
  OwnedOutline actual = expected;
  actual.owner[0] += 1;
  const std::string svg = drawMismatch(scene, expected, actual);
  EXPECT_THAT(svg, HasSubstr(">1 difference<"));
  EXPECT_THAT(svg, HasSubstr(">wrong block or owner<"));
}

TEST(DrawMismatch, ZoomsInOnALargeWorld) {
  const Scene scene = randomScene(60, 40);
  const Outline expected = naiveOutline(scene);
  Outline actual = expected;
  actual.erase(actual.begin() + static_cast<std::ptrdiff_t>(actual.size() / 2));
  const std::string svg = drawMismatch(scene, expected, actual);
  EXPECT_EQ(wrongWith(svg), "");
  EXPECT_LT(svg.size(), 200'000u);
  EXPECT_THAT(svg, HasSubstr(">1 difference<"));
  EXPECT_THAT(svg, HasSubstr("<title>(" + std::to_string(expected[actual.size() / 2].start.x / U)));

  actual.erase(actual.begin());  // at the other end of the world: one of both is left to the list
  EXPECT_THAT(drawMismatch(scene, expected, actual), HasSubstr(">2 differences, 1 in this view<"));
}

TEST(DrawMismatch, ListsSegmentsBeforeGhosts) {
  Scene scene;
  scene.polygons = {{{0, 0}, 1, kSquare}, {{1, 0}, 1, kSquare}};
  const Outline expected = naiveOutline(scene);
  Outline actual = expected;
  actual.front().ghost2.reset();
  actual.pop_back();
  const std::string svg = drawMismatch(scene, expected, actual);
  EXPECT_LT(svg.find(">missing segment: "), svg.find(">wrong ghost2 at "));
}

TEST(DrawMismatch, SaysWhenThereIsNoDifference) {
  const Scene scene = smallScene();
  const Outline outline = naiveOutline(scene);
  EXPECT_THAT(drawMismatch(scene, outline, outline), HasSubstr(">no difference<"));
}

}  // namespace
}  // namespace lgs::oracle
