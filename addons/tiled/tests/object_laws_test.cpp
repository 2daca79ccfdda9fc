// Random objects: no area is lost, and the world takes whatever overlaps.
#include "maps.h"
#include "proptests/support/law.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <tuple>

namespace lgs::tiled {
namespace {

/// A polygon of a few tiles around a place in pixels, without crossings: a radius for each direction.
struct Star {
  int x = 0, y = 0, rotation = 0;
  std::vector<int> radii;
};

std::vector<DoublePoint> pointsOf(const Star& star) {
  std::vector<DoublePoint> points;
  const auto n = static_cast<double>(star.radii.size());
  for (std::size_t k = 0; k < star.radii.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / n;
    points.push_back({std::round(star.radii[k] * std::cos(angle)), std::round(star.radii[k] * std::sin(angle))});
  }
  return points;
}

std::string objectOf(const Star& star) {
  std::string points;
  for (const DoublePoint p : pointsOf(star)) {
    points += std::to_string(static_cast<int>(p.x)) + "," + std::to_string(static_cast<int>(p.y)) + " ";
  }
  return "<object id='1' x='" + std::to_string(star.x) + "' y='" + std::to_string(star.y) + "' rotation='" +
         std::to_string(star.rotation) + "'><polygon points='" + points + "'/></object>";
}

std::string xmlOf(const std::vector<Star>& stars) {
  std::string objects;
  for (const Star& star : stars) objects += objectOf(star);
  return "<objectgroup name='Walls'>" + objects + "</objectgroup>\n";
}

void showValue(const Star& star, std::ostream& out) { out << xmlOf({star}); }

rc::Gen<Star> anyStar() {
  const auto drawn = rc::gen::tuple(rc::gen::inRange(-200, 200), rc::gen::inRange(-200, 200), rc::gen::inRange(0, 360),
                                    rc::gen::container<std::vector<int>>(7, rc::gen::inRange(20, 120)));
  return rc::gen::map(drawn, [](std::tuple<int, int, int, std::vector<int>> d) {
    return Star{std::get<0>(d), std::get<1>(d), std::get<2>(d), std::get<3>(d)};
  });
}

double areaOf(const Star& star) {
  const std::vector<DoublePoint> points = pointsOf(star);
  double area = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const DoublePoint a = points[k], b = points[(k + 1) % points.size()];
    area += (a.x * b.y - a.y * b.x) / 2 / (32 * 32);
  }
  return area;
}

double lengthOf(const Star& star) {
  const std::vector<DoublePoint> points = pointsOf(star);
  double length = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const DoublePoint a = points[k], b = points[(k + 1) % points.size()];
    length += std::hypot(b.x - a.x, b.y - a.y) / 32;
  }
  return length;
}

/// Rounding moves a vertex by less than a unit, and the brush may then differ within a unit of each edge.
double slack(const Star& star) { return (2 * lengthOf(star) + 1) * 2 / kUnitsPerCell; }

TEST(TiledObjectLaws, NoAreaIsLostOrWon) {
  const auto law = [](const Star& star) {
    const ImportedMap map = mustImport(xmlOf({star}), {.tolerance = 0});
    EXPECT_NEAR(areaInCells(map), areaOf(star), slack(star));
    EXPECT_EQ(worldOf(map).loops().size(), 1U) << "there is a seam inside, or a part is missing";
  };
  test::forAll(300, law, rc::gen::resize(rc::kNominalSize, anyStar()));
}

/// Objects over each other and over tiles with slanted shapes. mustImport() sees that the world takes all of it.
TEST(TiledObjectLaws, TheWorldTakesAllOverlaps) {
  const auto law = [](const Star& a, const Star& b, const Star& c) {
    const std::string tiles = tilesetXml({"<object id='1' x='0' y='32'><polygon points='0,0 32,0 32,-16'/></object>",
                                          "<object id='1' x='-10' y='4' width='30' height='20' rotation='20'/>"}) +
                              csvLayer(4, 3, "1,2,0,1,2,1,1,0,2,2,1,1");
    const Options options{.tolerance = 0};
    const double ofTiles = areaInCells(mustImport(tiles, options));
    const double area = areaInCells(mustImport(tiles + xmlOf({a, b, c}), options));
    const double some = 0.001;
    EXPECT_LE(area, ofTiles + areaOf(a) + areaOf(b) + areaOf(c) + some);
    EXPECT_GE(area, std::max({ofTiles, areaOf(a), areaOf(b), areaOf(c)}) - some);
  };
  const auto star = rc::gen::resize(rc::kNominalSize, anyStar());
  test::forAll(100, law, star, star, star);
}

}  // namespace
}  // namespace lgs::tiled
