// Suites of others: what is read of each format, what becomes of it, and what is said of what is bad.
#include "oracle/suites/strokes.h"
#include "oracle/suites/suite.h"
#include "oracle/trace/player.h"
#include "proptests/support/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <string>
#include <vector>

namespace lgs::oracle {
namespace {

using testing::HasSubstr;

class Suites : public test::InAFolder {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    put(name, text);
    return path(name);
  }
  Suite read(const std::string& name, const std::string& text) const {
    auto suite = readSuite(file(name, text));
    EXPECT_TRUE(suite) << suite.error();
    return suite.value_or(Suite());
  }
  std::string fault(const std::string& name, const std::string& text) const {
    const auto suite = readSuite(file(name, text));
    return suite ? "none" : suite.error();
  }
};

/// The area of a case as this library's brushes make it, in units of the suite, in which all of it is 6 wide.
double areaOf(const SuiteCase& of) {
  const auto strokes = strokesOf(of);
  EXPECT_TRUE(strokes) << strokes.error();
  if (!strokes) return -1;
  EXPECT_FALSE(strokes->isRounded);
  Player player(PreservePairs{});
  EXPECT_TRUE(play(strokes->trace, player));
  double area = 0;
  Point max{0, 0};
  for (const Call& call : strokes->trace.calls)
    for (const auto& ring : call.brush.rings)
      for (const Point p : ring) max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  for (const ScenePolygon& polygon : player.scene().polygons)
    for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
      const LocalPoint a = polygon.vertices[k], b = polygon.vertices[(k + 1) % polygon.vertices.size()];
      area += 0.5 * (static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x);
    }
  const double unit = static_cast<double>(std::max(max.x, max.y)) / 6;
  return area / (unit * unit);
}

/// Two squares of 4, of which one lies two to the right of the other, and two above.
void expectSquares(const Suite& suite, const std::vector<double>& areas) {
  ASSERT_EQ(suite.cases.size(), areas.size());
  for (std::size_t k = 0; k < areas.size(); ++k)
    EXPECT_DOUBLE_EQ(areaOf(suite.cases[k]), areas[k]) << suite.cases[k].name;
}
const std::vector<double> kAllAreas{28, 4, 12, 24};

TEST_F(Suites, OfClipper) {
  const Suite suite =
      read("Polygons.txt",
           "CAPTION: 1. union\r\nCLIPTYPE: UNION\r\nFILLRULE: NONZERO\r\nSOL_AREA: 28\r\nSUBJECTS\r\n"
           "0,0, 4,0, 4,4, 0,4\r\nCLIPS\r\n2,2 6,2 6,6 2,6\r\n\r\n"
           "CAPTION: 2.\nCLIPTYPE: INTERSECTION\nFILLRULE: EVENODD\nSUBJECTS\n0,0, 4,0, 4,4, 0,4\n"
           "SUBJECTS_OPEN\n0,0, 6,0, 6,6\nCLIPS\n2.0,2 , 6,2 , 6,6 , 2,6\n"
           "CAPTION: 3.\nCLIPTYPE: DIFFERENCE\nFILLRULE: POSITIVE\nSUBJECTS\n0,0, 4,0, 4,4, 0,4\nCLIPS\n"
           "2,2, 6,2, 6,6, 2,6\nCAPTION: 4.\nCLIPTYPE: XOR\nSUBJECTS\n0,0, 4,0, 4,4, 0,4\nCLIPS\n"
           "2,2, 6,2, 6,6, 2,6\nCAPTION: 5.\nCLIPTYPE: NONE\nSUBJECTS\n0,0, 4,0, 4,4\n");
  expectSquares(suite, kAllAreas);
  EXPECT_THAT(suite.cases[0].name, HasSubstr("Polygons.txt:1: caption 1.: union"));
  EXPECT_EQ(suite.leftOut.size(), 2U) << "open paths, and no operation";
}

TEST_F(Suites, OfIOverlay) {
  const std::string squares = R"("subjPaths": [[[0,0],[4,0],[4,4],[0,4]]], "clipPaths": [[[2,2],[6,2],[6,6],[2,6]]])";
  expectSquares(read("a.json", "{" + squares + R"(, "fillRule": 1, "union": [[]], "xor": [[]]})"), {28, 24});
  expectSquares(read("b.json", "{" + squares + R"(, "intersect": [], "inverseDifference": []})"), {4, 12});
  expectSquares(read("c.json", "{" + squares + "}"), kAllAreas);
  expectSquares(read("rule.json", R"({"subjPaths": [[[0,0],[4,0],[4,4],[0,4]], [[2,2],[6,2],[6,6],[2,6]]],
    "clipPaths": [[[0,0],[1,0],[1,1],[0,1]]], "fillRule": 1, "union": [[]]})"),
                {28});
  EXPECT_EQ(read("d.json", "{" + squares + R"(, "subject": [], "clip": [], "union": []})").cases.size(), 3U);
}

TEST_F(Suites, OfGeoJson) {
  const std::string a = R"({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
    [[[0,0],[4,0],[4,4],[0,4],[0,0]]]}})";
  const std::string b = R"({"type": "Feature", "properties": null, "geometry": {"type": "MultiPolygon", "coordinates":
    [[[[2,2],[6,2],[6,6],[2,6],[2,2]]]]}})";
  const auto collection = [&](const std::string& more) {
    return R"({"type": "FeatureCollection", "features": [)" + a + "," + b + more + "]}";
  };
  expectSquares(read("plain.geojson", collection("")), kAllAreas);
  const std::string answer = R"(,{"type": "Feature", "properties": {"operation": "diff_ba"}, "geometry": null})";
  const std::string low = R"(,{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
    [[[2,2],[6,2],[6,4],[2,4],[2,2]]]}})";
  const std::string both = R"({"type": "FeatureCollection", "features": [)" + a + low + answer + "]}";
  expectSquares(read("martinez.geojson", both), {4});
  // Of a folder: what lies beside args.geojson is answers.
  file("end-to-end/one/args.geojson", collection(""));
  file("end-to-end/one/xor.geojson", a);
  file("end-to-end/one/README.md", "none");
  file("end-to-end/two/args.geojson", collection(""));
  file("end-to-end/two/all.geojson", a);
  file("end-to-end/two/bad.geojson", "{");
  const auto suite = readSuite(path("end-to-end"));
  ASSERT_TRUE(suite) << suite.error();
  expectSquares(*suite, {24, 28, 4, 12, 24});
  EXPECT_EQ(suite->files, 2U);
  EXPECT_EQ(suite->leftOut.size(), 2U);
}

TEST_F(Suites, OfWktAndXml) {
  const std::string a = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))", b = "MULTIPOLYGON(((2 2, 6 2,\n6 6, 2 6, 2 2)))";
  expectSquares(read("pairs.wkt", a + "\n" + b + "\n"), kAllAreas);
  const Suite mixed = read("mixed.wkt", "# a point first\nPoint (1 2)\n" + a + "\npolygon((0 0,4 0,4 4,0 4,0 0))\n" +
                                            b + "\nLINESTRING EMPTY\n");
  expectSquares(mixed, kAllAreas);
  ASSERT_EQ(mixed.leftOut.size(), 1U);
  EXPECT_EQ(mixed.leftOut.begin()->second, 2U) << "a pair with a point, and a last one";
  const std::string program = "// Polygon (as above)\ns[1] = {\"" + a +
                              "\"};\ns[2] = {\"POLYGON((0 0, 4 0,\\\n4 4, 0 4, 0 0))\", \"" + b + "\"};";
  const Suite strings = read("cases.hpp", program);
  expectSquares(strings, kAllAreas);
  EXPECT_EQ(strings.leftOut.begin()->second, 1U) << "one that is alone";
  expectSquares(read("e.wkt", "SRID=1;" + a + " SRID=1;" + b), kAllAreas);
  const std::string wkb =  // the square b
      "010300000001000000050000000000000000000040000000000000004000000000000018400000000000000040"
      "000000000000184000000000000018400000000000000040000000000000184000000000000000400000000000000040";
  const auto xml = [&](const std::string& second, const std::string& tests) {
    return "<run><precisionModel type=\"FLOATING\"/>\n<case><desc>x</desc><a>\n" + a + "\n</a><b>" + second + "</b>" +
           tests + "</case></run>";
  };
  const auto op = [](const std::string& name, const std::string& args) {
    return "<test><op name=\"" + name + "\" " + args + ">POLYGON EMPTY</op></test>";
  };
  const std::string ab = "arg1=\"A\" arg2=\"B\"", ba = "arg1='b' arg2='a'";
  expectSquares(read("a.xml", xml(b, op("union", ab) + op("intersectionNG", ab) + op("difference", ba) +
                                         op("symdifference", ab) + op("relate", ab))),
                kAllAreas);
  expectSquares(read("b.xml", xml(wkb, op("union", ab) + op("overlayareatest", ab))), {28, 28, 4, 12, 24});
  EXPECT_EQ(read("c.xml", xml("LINESTRING(0 0, 1 1)", op("union", ab)))
                .leftOut.count("operand that is a LINESTRING, and no polygon"),
            1U);
  const std::string parts =
      "GEOMETRYCOLLECTION (POLYGON EMPTY, " + b + ", MULTIPOLYGON (((5 5, 6 5, 6 6, 5 5), EMPTY), EMPTY))";
  expectSquares(read("parts.xml", xml(parts, op("union", ab))), {28});
  EXPECT_EQ(read("point.xml", xml("GEOMETRYCOLLECTION (" + b + ", POINT (1 1))", op("union", ab)))
                .leftOut.count("operand that is a POINT, and no polygon"),
            1U);
  EXPECT_EQ(read("d.xml", xml(wkb.substr(0, 40), op("union", ab))).leftOut.count("geometry in WKB that ends too early"),
            1U);
}

TEST_F(Suites, WhatIsBadIsSaidWithItsPlace) {
  EXPECT_THAT(fault("a.txt", "CAPTION: 1.\nCLIPTYPE: UNION\nSUBJECTS\n1,2, 3,x\n"), HasSubstr("a.txt:4: '1'"));
  EXPECT_THAT(fault("b.txt", "CLIPTYPE: UNION\n1,2, 3,4\n"), HasSubstr("b.txt:2: a ring must follow"));
  EXPECT_THAT(fault("c.json", "{\"type\":\n 7,,}"), HasSubstr("line 2"));
  EXPECT_THAT(read("d.json", "[1, 2]").leftOut.begin()->first, HasSubstr("neither GeoJSON nor two operands"));
  EXPECT_THAT(fault("e.json", R"({"type": "Polygon", "coordinates": [[[0, "1"]]]})"), HasSubstr("two numbers"));
  EXPECT_THAT(fault("f.json", R"({"type": "Polygon", "coordinates": 5})"), HasSubstr("must be a list"));
  EXPECT_THAT(fault("g.json", R"({"subjPaths": [], "fillRule": 9})"), HasSubstr("'fillRule'"));
  EXPECT_THAT(fault("h.xml", "<run>\n<case></run>"), HasSubstr("h.xml:2: it is no XML"));
  EXPECT_THAT(fault("i.wkt", "\nPOLYGON((0 0, 1 0"), HasSubstr("i.wkt:2: a ( is never closed"));
  EXPECT_THAT(fault("j.wkt", "POLYGON((0 0, 1 zero))"), HasSubstr("j.wkt:1: operand that is no WKT"));
  EXPECT_THAT(fault("k.txt", "nothing\n"), HasSubstr("no case in it"));
  EXPECT_THAT(fault("l.json", R"({"type": "Polygon", "coordinates": [[[0, 1e999], [1, 1], [2, 0]]]})"),
              HasSubstr("l.json"));
  EXPECT_FALSE(readSuite(path("none")));
}

SuiteCase unionOf(std::vector<std::vector<SuitePart::Vertex>> rings, Filled rule = Filled::evenOdd) {
  return {"", Operation::unite, {{SuitePart{std::move(rings), rule}}}};
}

TEST_F(Suites, OtherRulesAreSaidByStrokesWhereTheyCan) {
  const std::vector<SuitePart::Vertex> one{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, other{{2, 2}, {6, 2}, {6, 6}, {2, 6}};
  std::vector<SuitePart::Vertex> reversed(other.rbegin(), other.rend());
  EXPECT_EQ(areaOf(unionOf({one, other})), 24);
  EXPECT_EQ(areaOf(unionOf({one, other}, Filled::nonZero)), 28) << "each ring by itself";
  EXPECT_EQ(areaOf(unionOf({one, reversed}, Filled::nonZero)), 24) << "where both run around they cancel";
  EXPECT_EQ(areaOf(unionOf({one, other}, Filled::positive)), 28);
  // A star: what it runs around twice is solid by one rule, and has corners on no lattice.
  const SuiteCase star = unionOf({{{0, 0}, {6, 0}, {1, 4}, {3, -2}, {5, 4}}}, Filled::nonZero);
  ASSERT_TRUE(strokesOf(star));
  EXPECT_TRUE(strokesOf(star)->isEvenOdd);
}

TEST_F(Suites, CoordinatesAreExactWhereTheyFit) {
  const auto scaled = [](double by, double to) {
    return strokesOf(unionOf({{{to, to}, {to + 4 * by, to}, {to + 4 * by, to + 4 * by}, {to, to + 3 * by}}}));
  };
  const auto plain = scaled(1, 0);
  for (const double by : {1.0, 0.25, 1.0 / 1024, 65'536.0, 0x1p-900, 0x1p+900}) {
    const auto other = scaled(by, 0);
    ASSERT_TRUE(other) << by;
    EXPECT_FALSE(other->isRounded) << by;
    EXPECT_EQ(other->trace, plain->trace) << by;
  }
  EXPECT_FALSE(scaled(1, -1'000'000'000)->isRounded);
  EXPECT_EQ(scaled(1, -1'000'000'000)->trace, plain->trace);
  EXPECT_TRUE(scaled(0.1, 0.1)->isRounded);
  EXPECT_TRUE(scaled(1, 1e16)->isRounded);
  EXPECT_EQ(strokesOf(unionOf({{{1, 1}, {1, 1}, {1, 1}}})).error(), "case without area");
  std::vector<SuitePart::Vertex> many(4'001, {0, 0});
  many[1] = {1, 1};
  EXPECT_EQ(strokesOf(unionOf({many})).error(), "case of more than 4,000 vertices");
  for (std::size_t k = 0; k < many.size(); ++k) many[k] = {k % 2 == 0 ? 0.0 : 4'096.0, static_cast<double>(k % 61)};
  many.pop_back();
  EXPECT_EQ(strokesOf(unionOf({many})).error(), "case of more than 20,000 crossings");
}

}  // namespace
}  // namespace lgs::oracle
