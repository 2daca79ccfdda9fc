// The pictures: well-formed, complete, repeatable, and of a size that a viewer opens at once.
#include "oracle/draw/draw.h"
#include "proptests/support/worlds.h"

#include "oracle/reference/naive.h"
#include "oracle/reference/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <pugixml.hpp>
#include <random>
#include <sstream>
#include <string>

namespace lgs::oracle {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::Gt;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Lt;
using testing::Not;
using testing::StartsWith;

using test::U;
using Local = std::vector<LocalPoint>;
const Local kSquare{{0, 0}, {U, 0}, {U, U}, {0, U}};
const Local kRamp{{0, 0}, {U, 0}, {U, U}};
const Local kSlope{{0, 0}, {U, 0}, {0, U}};
const Local kDiamond{{U / 2, 0}, {U, U / 2}, {U / 2, U}, {0, U / 2}};

// The numbers of a path, in their order.
std::vector<double> numbersOf(std::string path) {
  const auto isOfNumber = [](char c) { return std::string_view("-.0123456789").find(c) != std::string_view::npos; };
  std::replace_if(
      path.begin(), path.end(), [&](char c) { return !isOfNumber(c); }, ' ');
  std::istringstream in(path);
  return {std::istream_iterator<double>(in), std::istream_iterator<double>()};
}

// A picture as a viewer reads it. Whatever is not well-formed fails the test.
class Picture {
 public:
  explicit Picture(const std::string& svg) {
    const pugi::xml_parse_result parsed = document_.load_buffer(svg.data(), svg.size());
    EXPECT_TRUE(parsed) << parsed.description() << " at " << parsed.offset;
    const auto roots = document_.children();
    EXPECT_EQ(std::distance(roots.begin(), roots.end()), 1);
    EXPECT_STREQ(document_.first_child().name(), "svg");
    // pugixml lets an ampersand pass that begins no entity.
    for (std::size_t at = svg.find('&'); at != std::string::npos; at = svg.find('&', at + 1)) {
      const std::string_view rest = std::string_view(svg).substr(at);
      const auto begins = [&](std::string_view entity) { return rest.starts_with(entity); };
      EXPECT_TRUE(begins("&amp;") || begins("&lt;") || begins("&gt;") || begins("&quot;")) << rest.substr(0, 40);
    }
  }

  /// The texts of all elements, or the values of all attributes, that an XPath selects.
  std::vector<std::string> all(const char* xpath) const {
    std::vector<std::string> values;
    for (const pugi::xpath_node& found : document_.select_nodes(xpath)) {
      values.emplace_back(found.attribute() ? found.attribute().value() : found.node().child_value());
    }
    return values;
  }
  std::vector<std::string> texts() const { return all("//text"); }
  std::vector<std::string> tooltips() const { return all("//path/title"); }
  std::vector<std::string> paths() const { return all("//path/@d"); }

  /// The pieces of the path that draws the outline: the only one with round ends in a picture of a world.
  std::size_t segments() const {
    std::size_t count = 0;
    for (const std::string& path : all("//path[@stroke-linecap='round']/@d")) {
      count += static_cast<std::size_t>(std::count(path.begin(), path.end(), 'M'));
    }
    return count;
  }

 private:
  pugi::xml_document document_;
};

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
  const Picture picture(drawWorld(scene, outline));
  EXPECT_EQ(picture.segments(), outline.size());
  for (const OutlineSegment& s : outline) {
    EXPECT_THAT(picture.tooltips(),
                Contains(StartsWith(inWords(s.start, s.end) + ", block " + std::to_string(s.block) + "; ")));
  }
  EXPECT_THAT(picture.texts(), IsSupersetOf({"block 1", "block 4", "-1", "3", "link to the next segment"}));
  EXPECT_THAT(picture.texts(), Not(Contains("edited cell")));
  EXPECT_THAT(picture.texts(), Not(Contains(HasSubstr("not mutual"))));
}

TEST(DrawWorld, TellsLinksThatAreNotMutual) {
  Scene scene = smallScene();
  scene.preserve.add(1, 4);
  scene.polygons.push_back({{2, 0}, 1, kSquare});
  EXPECT_THAT(Picture(drawWorld(scene, naiveOutline(scene))).texts(), Contains("link that is not mutual"));
}

TEST(DrawWorld, ShowsEverySegmentOfALargeWorldInASmallFile) {
  const Scene scene = randomScene(300, 30);
  const Outline outline = naiveOutline(scene);
  const std::string svg = drawWorld(scene, outline);
  const Picture picture(svg);
  EXPECT_LT(svg.size(), 3'000'000u);
  EXPECT_EQ(picture.segments(), outline.size());
  EXPECT_LT(picture.paths().size(), 30u);  // one for each block, not for each polygon
}

TEST(DrawWorld, EscapesTheTitle) {
  DrawOptions options;
  options.title = "a<b> & \"c\"\x01 ü";
  EXPECT_THAT(Picture(drawWorld({}, {}, options)).all("/svg/title"), ElementsAre("a<b> & \"c\"  ü"));
}

TEST(DrawWorld, DrawsAnEmptyWorld) { EXPECT_THAT(Picture(drawWorld({}, {})).texts(), Contains("empty world")); }

TEST(DrawWorld, HighlightsEditedCells) {
  DrawOptions options;
  options.edited = {{5, 5}};
  EXPECT_THAT(Picture(drawWorld({}, {}, options)).texts(), IsSupersetOf({"edited cell", "6"}));
}

TEST(DrawWorld, FoldsWhatIsEmptyBetweenTheEndsOfTheWorld) {
  Scene scene;
  scene.polygons = {{{-kMaxCell, -kMaxCell}, 1, kDiamond}, {{kMaxCell, kMaxCell}, 2, kRamp}};
  const Outline outline = naiveOutline(scene);
  const Picture picture(drawWorld(scene, outline));
  EXPECT_EQ(picture.segments(), outline.size());
  for (const std::string& path : picture.paths()) EXPECT_THAT(numbersOf(path), Each(AllOf(Gt(-1'000), Lt(1'000))));
  EXPECT_THAT(picture.texts(), IsSupersetOf({"-1073741824", "1073741825"}));
}

TEST(DrawWorld, DrawsFarCellsAsItDrawsNearOnes) {
  const auto drawnAt = [](std::int32_t i) {
    Scene scene;
    scene.polygons = {{{i, i}, 1, {{0, 0}, {1, 0}, {21'845, U}}}};
    const Picture picture(drawWorld(scene, naiveOutline(scene)));
    const std::vector<double> solid = numbersOf(picture.all("//g[@fill-opacity]/path/@d").at(0));  // x y x y x y
    // Not the positions themselves: they depend on the width of the axis labels.
    return std::vector{solid.at(2) - solid.at(0), solid.at(4) - solid.at(0)};
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
  const Picture picture(svg);
  EXPECT_THAT(picture.texts(), IsSupersetOf({"5 differences", "CGAL", "engine <1>", "missing segment", "extra segment",
                                             "wrong block or owner", "vertex with a wrong link", "link as expected"}));
  EXPECT_THAT(picture.texts(), Contains(StartsWith("extra segment: (5, 5) → (6, 5)")));
  EXPECT_EQ(svg, drawMismatch(scene, expected, actual, options));
}

TEST(DrawMismatch, SeesWrongOwners) {
  const Scene scene = smallScene();
  NaiveReference reference;
  const OwnedOutline expected = reference(scene);
  OwnedOutline actual = expected;
  actual.owner[0] += 1;
  EXPECT_THAT(Picture(drawMismatch(scene, expected, actual)).texts(),
              IsSupersetOf({"1 difference", "wrong block or owner"}));
}

TEST(DrawMismatch, ZoomsInOnALargeWorld) {
  const Scene scene = randomScene(60, 40);
  const Outline expected = naiveOutline(scene);
  Outline actual = expected;
  actual.erase(actual.begin() + static_cast<std::ptrdiff_t>(actual.size() / 2));
  const std::string svg = drawMismatch(scene, expected, actual);
  const Picture picture(svg);
  EXPECT_LT(svg.size(), 200'000u);
  EXPECT_THAT(picture.texts(), Contains("1 difference"));
  EXPECT_THAT(picture.tooltips(), Contains(StartsWith("(" + std::to_string(expected[actual.size() / 2].start.x / U))));

  actual.erase(actual.begin());  // at the other end of the world, so only the list shows it
  EXPECT_THAT(Picture(drawMismatch(scene, expected, actual)).texts(), Contains("2 differences, 1 in this view"));
}

TEST(DrawMismatch, KeepsCoordinatesSmallWhereASegmentLeavesTheView) {
  const Scene scene = smallScene();
  const Outline expected = naiveOutline(scene);
  Outline actual = expected;
  actual.push_back({{5 * U, 5 * U}, {std::int64_t{kMaxCell} * U, 5 * U}, 1, {}, {}});
  MismatchOptions options;
  options.view = CellRect{{-1, -1}, {6, 6}};
  for (const std::string& path : Picture(drawMismatch(scene, expected, actual, options)).paths()) {
    EXPECT_THAT(numbersOf(path), Each(Lt(20'000)));
  }
}

TEST(DrawMismatch, ListsSegmentsBeforeGhosts) {
  Scene scene;
  scene.polygons = {{{0, 0}, 1, kSquare}, {{1, 0}, 1, kSquare}};
  const Outline expected = naiveOutline(scene);
  Outline actual = expected;
  actual.front().ghost2.reset();
  actual.pop_back();
  const std::vector<std::string> texts = Picture(drawMismatch(scene, expected, actual)).texts();
  const auto first = [&](std::string_view beginning) {
    return std::ranges::find_if(texts, [&](const std::string& text) { return text.starts_with(beginning); });
  };
  ASSERT_NE(first("wrong ghost2 at "), texts.end());
  EXPECT_LT(first("missing segment: "), first("wrong ghost2 at "));
}

TEST(DrawMismatch, SaysWhenThereIsNoDifference) {
  const Scene scene = smallScene();
  const Outline outline = naiveOutline(scene);
  EXPECT_THAT(Picture(drawMismatch(scene, outline, outline)).texts(), Contains("no difference"));
}

}  // namespace
}  // namespace lgs::oracle
