#include "bad_edits.h"

#include <gtest/gtest.h>
#include <array>
#include <limits>
#include <tuple>

namespace lgs::test {
namespace {

constexpr Cell kFull{0, 0}, kRamp{1, 0}, kTwo{2, 0}, kEmpty{5, -3}, kTooFar{kMaxCell + 1, 0}, kTooLow{0, -kMaxCell - 1};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
constexpr float kHugeFloat = std::numeric_limits<float>::max();
constexpr const char* kTooMuch =
    "too much: a cell holds at most 254 polygons with 4,096 vertices, and 2^28 - 1 polygons in its time; a world "
    "2^22 - 1 chunks of 32x32 cells, and 2^23 - 1 distinct contents of cells; a call 2^31 - 1 entries; in one cell a "
    "brush 4,096 edges and 32,768 crossings";

template <class T>
Error errorOf(const Expected<T>& result) {
  return result ? Error{} : result.error();
}

/// An expected error, said field by field.
struct Expect {
  Error error;
  explicit Expect(ErrorCode code) { error.code = code; }
  Expect& in(Cell cell) {
    error.cell = cell;
    return *this;
  }
  Expect& polygon(int index) { return error.polygon = index, *this; }
  Expect& vertex(int a, int b = -1) { return error.vertex = a, error.vertex2 = b, *this; }
  Expect& polygon2(int index) { return error.polygon2 = index, *this; }
};

BadEdit addLocal(std::string name, Cell cell, const LocalPolygon& polygon, const Expect& expected, std::string text) {
  return {std::move(name),
          [=](Stage& s) { return errorOf(s.world.add(cell, std::span<const LocalPoint>(polygon), 9)); }, expected.error,
          std::move(text)};
}

template <class Real>
BadEdit addReal(std::string name, Cell cell, std::vector<RealPoint<Real>> polygon, const Expect& expected,
                std::string text) {
  return {std::move(name),
          [=](Stage& s) { return errorOf(s.world.add(cell, std::span<const RealPoint<Real>>(polygon), 9)); },
          expected.error, std::move(text)};
}

BadEdit makeShape(std::string name, const std::vector<LocalPolygon>& polygons, const Expect& expected,
                  std::string text) {
  return {std::move(name), [=](Stage& s) { return errorOf(s.world.shape(polygons)); }, expected.error, std::move(text)};
}

/// The same edit where `expected.other` is one of the stage's handles, and its polygon has this block.
BadEdit withOther(BadEdit edit, PolygonHandle Stage::*other, Block block) {
  edit.expected.other = makeStage().*other;  // every stage is the same
  edit.expected.otherBlock = block;
  const std::string handle =
      std::to_string(edit.expected.other.cellRef) + ":" + std::to_string(edit.expected.other.serial);
  edit.text.replace(edit.text.find('@'), 1, handle);
  edit.text.replace(edit.text.find('#'), 1, std::to_string(block));
  return edit;
}

LocalPolygon wheel(std::size_t vertices) {
  LocalPolygon polygon;
  for (std::size_t k = 0; k + 1 < vertices; ++k) polygon.push_back({static_cast<std::int32_t>(k), 0});
  polygon.push_back({0, U});
  return polygon;
}

void addVertexFaults(std::vector<BadEdit>& out) {
  using enum ErrorCode;
  const auto at = [](ErrorCode code) { return Expect(code).in(kEmpty).polygon(0); };
  const std::string where = "cell (5, -3), polygon 0: ";
  out.push_back(addLocal("cell too far", kTooFar, unitSquare(), Expect(cellOutOfRange).in(kTooFar),
                         "cell (1073741825, 0): the cell is out of range; both indices must be within ±2^30"));
  out.push_back(addLocal("cell too low", kTooLow, {}, Expect(cellOutOfRange).in(kTooLow),
                         "cell (0, -1073741825): the cell is out of range; both indices must be within ±2^30"));
  out.push_back(addLocal("no vertices", kEmpty, {}, at(tooFewVertices), where + "a polygon needs at least 3 vertices"));
  out.push_back(addLocal("two vertices, one outside", kEmpty, {{0, 0}, {-1, 0}}, at(tooFewVertices),
                         where + "a polygon needs at least 3 vertices"));
  out.push_back(addLocal("too many vertices", kEmpty, wheel(kMaxVerticesPerCell + 1), at(capacity), where + kTooMuch));
  out.push_back(addLocal("left of the cell", kEmpty, {{0, 0}, {U, 0}, {-1, U}}, at(outsideCell).vertex(2),
                         where + "vertex 2 is outside the cell; coordinates run from 0 to 1 cell, rim included"));
  out.push_back(addLocal("above the cell, and repeated", kEmpty, {{0, 0}, {0, U + 1}, {0, 0}, {5, 5}},
                         at(outsideCell).vertex(1),
                         where + "vertex 1 is outside the cell; coordinates run from 0 to 1 cell, rim included"));
  out.push_back(addLocal("repeated vertex", kEmpty, {{0, 0}, {U, 0}, {U, U}, {U, 0}}, at(repeatedVertex).vertex(1, 3),
                         where + "vertex 1 and vertex 3 are the same lattice point; leave one out"));
  out.push_back(addLocal("no area", kEmpty, {{0, 0}, {5, 5}, {9, 9}}, at(zeroArea),
                         where + "the polygon has no area, or crosses itself so that its areas cancel"));
  out.push_back(addLocal("bow tie without area", kEmpty, {{0, 0}, {U, U}, {U, 0}, {0, U}}, at(zeroArea),
                         where + "the polygon has no area, or crosses itself so that its areas cancel"));
  out.push_back(addLocal("clockwise", kEmpty, {{0, 0}, {0, U}, {U, U}}, at(clockwise),
                         where + "the polygon runs clockwise; reverse its vertices"));
  const std::string crosses = where + "the polygon crosses itself, or touches itself: the edge from vertex ";
  out.push_back(addLocal("bow tie, clockwise on the whole", kEmpty, {{0, 0}, {0, U}, {U, 0}, {U, U / 2}},
                         at(selfIntersecting).vertex(1, 3), crosses + "1 meets the edge from vertex 3"));
  out.push_back(addLocal("edges cross", kEmpty, {{0, 0}, {U, 0}, {U / 8, U / 2}, {U, U}},
                         at(selfIntersecting).vertex(1, 3), crosses + "1 meets the edge from vertex 3"));
  out.push_back(addLocal("touches itself", kEmpty, {{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}},
                         at(selfIntersecting).vertex(0, 2), crosses + "0 meets the edge from vertex 2"));
  out.push_back(addLocal("folds back", kEmpty, {{0, 0}, {9, 0}, {5, 0}, {5, 5}}, at(selfIntersecting).vertex(0, 1),
                         crosses + "0 meets the edge from vertex 1"));
}

void addRealFaults(std::vector<BadEdit>& out) {
  using enum ErrorCode;
  const auto at = [](ErrorCode code) { return Expect(code).in(kEmpty).polygon(0); };
  const std::string where = "cell (5, -3), polygon 0: ";
  const std::string outside = " is outside the cell; coordinates run from 0 to 1 cell, rim included";
  out.push_back(addReal<double>("not a number, after one outside", kEmpty, {{-1, 0}, {1, 0}, {1, kNan}},
                                at(notFinite).vertex(2), where + "vertex 2 is infinite or not a number"));
  out.push_back(addReal<double>("infinite", kEmpty, {{0, 0}, {-kInf, 0}, {1, 1}}, at(notFinite).vertex(1),
                                where + "vertex 1 is infinite or not a number"));
  out.push_back(addReal<float>("infinite float", kEmpty, {{0, 0}, {1, 0}, {1, std::numeric_limits<float>::infinity()}},
                               at(notFinite).vertex(2), where + "vertex 2 is infinite or not a number"));
  out.push_back(addReal<double>("half a unit out", kEmpty, {{0, 0}, {1 + 0.5 / U, 0}, {1, 1}},
                                at(outsideCell).vertex(1), where + "vertex 1" + outside));
  out.push_back(addReal<double>("half a unit below", kEmpty, {{0, 0}, {1, 0}, {1, 1}, {0, -0.5 / U}},
                                at(outsideCell).vertex(3), where + "vertex 3" + outside));
  out.push_back(addReal<float>("huge float", kEmpty, {{kHugeFloat, 0}, {1, 0}, {1, 1}}, at(outsideCell).vertex(0),
                               where + "vertex 0" + outside));
  out.push_back(addReal<double>("huge double", kEmpty, {{0, 0}, {1, -1e308}, {1, 1}}, at(outsideCell).vertex(1),
                                where + "vertex 1" + outside));
  out.push_back(addReal<double>("rounded onto each other", kEmpty, {{0, 0}, {1, 0}, {0.4 / U, 0.4 / U}},
                                at(repeatedVertex).vertex(0, 2),
                                where + "vertex 0 and vertex 2 are the same lattice point; leave one out"));
  out.push_back(addReal<double>("too few, not a number", kEmpty, {{kNan, 0}, {1, 0}}, at(tooFewVertices),
                                where + "a polygon needs at least 3 vertices"));
  out.push_back(addReal<double>("not a number, cell too far", kTooFar, {{kNan, 0}, {1, 0}, {1, 1}},
                                Expect(cellOutOfRange).in(kTooFar),
                                "cell (1073741825, 0): the cell is out of range; both indices must be within ±2^30"));
  std::vector<DoublePoint> tooMany(kMaxVerticesPerCell + 1, {0.5, 0.5});
  tooMany[7].x = kNan;
  out.push_back(addReal<double>("too many, not a number", kEmpty, tooMany, at(capacity), where + kTooMuch));
}

void addOverlaps(std::vector<BadEdit>& out) {
  using enum ErrorCode;
  const std::string overlaps =
      "its interior overlaps that of a polygon of block # that is already in this cell (handle @)";
  out.push_back(withOther(addLocal("the same again", kFull, unitSquare(), Expect(overlap).in(kFull).polygon(0),
                                   "cell (0, 0), polygon 0: " + overlaps),
                          &Stage::full, 1));
  out.push_back(withOther(addLocal("a new one inside", kFull, {{77, 77}, {99, 77}, {99, 98}},
                                   Expect(overlap).in(kFull).polygon(0), "cell (0, 0), polygon 0: " + overlaps),
                          &Stage::full, 1));
  out.push_back(withOther(addLocal("across the ramp", kRamp, {{0, 0}, {U, 0}, {0, U}},
                                   Expect(overlap).in(kRamp).polygon(0), "cell (1, 0), polygon 0: " + overlaps),
                          &Stage::ramp, 2));
  out.push_back(withOther(addLocal("one of two", kTwo, eighths({{0, 6}, {8, 6}, {8, 8}}),
                                   Expect(overlap).in(kTwo).polygon(0), "cell (2, 0), polygon 0: " + overlaps),
                          &Stage::upper, 2));
  BadEdit byShape{"the first of a shape", [](Stage& s) { return errorOf(s.world.add(kRamp, s.twoRamps, 9)); },
                  Expect(overlap).in(kRamp).polygon(0).error, "cell (1, 0), polygon 0: " + overlaps};
  out.push_back(withOther(std::move(byShape), &Stage::ramp, 2));
  BadEdit fill{"the last cell of a fill",
               [](Stage& s) {
                 return errorOf(s.world.fill({{-40, -1}, {0, 0}}, s.square, 9));
               },
               Expect(overlap).in(kFull).polygon(0).error, "cell (0, 0), polygon 0: " + overlaps};
  out.push_back(withOther(std::move(fill), &Stage::full, 1));
}

void addUnknown(std::vector<BadEdit>& out) {
  using enum ErrorCode;
  const std::string noShape = "this world has no such shape";
  const std::string far = "the cell is out of range; both indices must be within ±2^30";
  const auto add = [&](std::string name, auto attempt, const Expect& expected, std::string text) {
    out.push_back({std::move(name), [attempt](Stage& s) { return errorOf(attempt(s)); }, expected.error, text});
  };
  add(
      "null shape", [](Stage& s) { return s.world.add(kEmpty, ShapeId{}, 9); }, Expect(unknownShape).in(kEmpty),
      "cell (5, -3): " + noShape);
  add(
      "unknown shape", [](Stage& s) { return s.world.add(kEmpty, ShapeId{4711}, 9); }, Expect(unknownShape).in(kEmpty),
      "cell (5, -3): " + noShape);
  add(
      "unknown shape, cell too far", [](Stage& s) { return s.world.add(kTooFar, ShapeId{4711}, 9); },
      Expect(cellOutOfRange).in(kTooFar), "cell (1073741825, 0): " + far);
  add(
      "null shape in the place of what stands", [](Stage& s) { return s.world.replace(kTwo, ShapeId{}, 9); },
      Expect(unknownShape).in(kTwo), "cell (2, 0): " + noShape);
  add(
      "replacing in a cell too far", [](Stage& s) { return s.world.replace(kTooFar, s.square, 9); },
      Expect(cellOutOfRange).in(kTooFar), "cell (1073741825, 0): " + far);
  add(
      "fill with an unknown shape",
      [](Stage& s) {
        return s.world.fill({kEmpty, {7, 7}}, ShapeId{4711}, 9);
      },
      Expect(unknownShape).in(kEmpty), "cell (5, -3): " + noShape);
  add(
      "fill beyond the range",
      [](Stage& s) {
        return s.world.fill({kEmpty, kTooFar}, s.square, 9);
      },
      Expect(cellOutOfRange).in(kTooFar), "cell (1073741825, 0): " + far);
  add(
      "fill more than fits",
      [](Stage& s) {
        return s.world.fill({{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}}, s.square, 9);
      },
      Expect(capacity).in({-kMaxCell, -kMaxCell}), std::string("cell (-1073741824, -1073741824): ") + kTooMuch);
  add(
      "clear beyond the range",
      [](Stage& s) {
        return s.world.clear({kTooLow, kFull});
      },
      Expect(cellOutOfRange).in(kTooLow), "cell (0, -1073741825): " + far);
}

void addStaleHandles(std::vector<BadEdit>& out) {
  const auto add = [&](const std::string& name, PolygonHandle handle, const std::string& text) {
    Expect expected(ErrorCode::staleHandle);
    expected.error.other = handle;
    out.push_back({name, [handle](Stage& s) { return errorOf(s.world.remove(handle)); }, expected.error, text});
    out.push_back({name + ", for setBlock()", [handle](Stage& s) { return errorOf(s.world.setBlock(handle, 9)); },
                   expected.error, text});
  };
  const auto addStale = [&](const std::string& name, PolygonHandle handle) {
    add(name, handle,
        "the handle " + std::to_string(handle.cellRef) + ":" + std::to_string(handle.serial) +
            " names no polygon; it was removed, or never existed");
  };
  const Stage stage = makeStage();
  add("null handle", {}, "the handle is null, and names no polygon; was the edit refused that should have given it?");
  addStale("removed before", stage.removed);
  addStale("a serial not given out yet", {stage.full.cellRef, stage.full.serial + 1});
  addStale("serial null", {stage.full.cellRef, 0});
  addStale("serial null where there are several", {stage.upper.cellRef, 0});
  addStale("an empty cell of a chunk that exists", {stage.full.cellRef + 20, 1});
  addStale("a chunk that does not exist", {0xffff'ffff, 1});
  addStale("chunk null", {5, 1});
}

void addExchanges(std::vector<BadEdit>& out) {
  using enum ErrorCode;
  using Handles = std::vector<PolygonHandle>;
  const LocalPolygon low = eighths({{0, 0}, {8, 0}, {8, 2}, {0, 2}}), high = eighths({{0, 6}, {8, 6}, {8, 8}, {0, 8}});
  const auto add = [&](std::string name, Cell cell, auto goes, const std::vector<LocalPolygon>& comes,
                       const Expect& expected, std::string text) {
    const auto attempt = [=](Stage& s) {
      std::vector<NewPolygon> polygons;
      for (const LocalPolygon& p : comes) polygons.push_back({p, 9});
      std::vector<PolygonHandle> handles(polygons.size(), PolygonHandle{4, 4});
      const Handles untouched = handles;
      const auto done = s.world.exchange(cell, goes(s), polygons, handles);
      EXPECT_EQ(handles, untouched) << "a refused exchange writes handles";
      return errorOf(done);
    };
    out.push_back({std::move(name), attempt, expected.error, std::move(text)});
  };
  const auto stale = [&](std::string name, Cell cell, auto goes, std::size_t index) {
    const PolygonHandle handle = goes(makeStage())[index];
    Expect expected = Expect(staleHandle).in(cell);
    expected.error.other = handle;
    expected.error.index = static_cast<std::int32_t>(index);
    const std::string what = handle ? "the handle " + std::to_string(handle.cellRef) + ":" +
                                          std::to_string(handle.serial) +
                                          " names no polygon; it was removed, or never existed"
                                    : "the handle is null, and names no polygon; was the edit refused that should "
                                      "have given it?";
    add(std::move(name), cell, goes, {high}, expected,
        "entry " + std::to_string(index) + ", cell (" + std::to_string(cell.i) + ", " + std::to_string(cell.j) +
            "): " + what);
  };
  const auto none = [](const Stage&) { return Handles(); };
  const auto both = [](const Stage& s) { return Handles{s.upper, s.lower}; };
  stale(
      "exchange of what is gone", kRamp,
      [](const Stage& s) {
        return Handles{s.ramp, s.removed};
      },
      1);
  stale(
      "exchange of what is in another cell", kTwo,
      [](const Stage& s) {
        return Handles{s.upper, s.full};
      },
      1);
  stale(
      "exchange of the same twice", kTwo,
      [](const Stage& s) {
        return Handles{s.lower, s.upper, s.lower};
      },
      2);
  stale(
      "exchange of nothing, in an empty cell", kEmpty, [](const Stage&) { return Handles{PolygonHandle{}}; }, 0);
  add("exchange beyond the range", kTooFar, none, {low}, Expect(cellOutOfRange).in(kTooFar),
      "cell (1073741825, 0): the cell is out of range; both indices must be within ±2^30");
  add(
      "exchange for what overlaps the other one", kTwo, [](const Stage& s) { return Handles{s.lower}; }, {low, high},
      Expect(overlap).in(kTwo).polygon(1),
      "cell (2, 0), polygon 1: its interior overlaps that of a polygon of block # that is already in this cell (handle "
      "@)");
  out.back() = withOther(std::move(out.back()), &Stage::upper, 2);
  add("exchange for two that overlap", kTwo, both, {low, high, ramp()}, Expect(overlap).in(kTwo).polygon(2).polygon2(0),
      "cell (2, 0), polygon 2: its interior overlaps that of polygon 0");
  add("exchange for two that overlap, in an empty cell", kEmpty, none, {unitSquare(), ramp()},
      Expect(overlap).in(kEmpty).polygon(1).polygon2(0),
      "cell (5, -3), polygon 1: its interior overlaps that of polygon 0");
  add("exchange for a bad polygon", kTwo, both, {low, {{0, 0}, {0, U}, {U, U}}}, Expect(clockwise).in(kTwo).polygon(1),
      "cell (2, 0), polygon 1: the polygon runs clockwise; reverse its vertices");
  std::vector<LocalPolygon> many;
  for (std::int32_t k = 0; k <= static_cast<std::int32_t>(kMaxPolygonsPerCell); ++k)
    many.push_back({{2 * k, 0}, {2 * k + 1, 0}, {2 * k + 1, 1}});
  add("exchange for more than fits", kTwo, both, many, Expect(capacity).in(kTwo),
      std::string("cell (2, 0): ") + kTooMuch);
}

template <class Real>
BadEdit makeRealShape(std::string name, std::vector<RealPoint<Real>> polygon, const Expect& expected,
                      std::string text) {
  return {std::move(name), [=](Stage& s) { return errorOf(s.world.shape(std::span<const RealPoint<Real>>(polygon))); },
          expected.error, std::move(text)};
}

void addShapes(std::vector<BadEdit>& out) {
  using enum ErrorCode;
  out.push_back(makeRealShape<double>("shape that is no number", {{0, 0}, {1, 0}, {1, kNan}},
                                      Expect(notFinite).polygon(0).vertex(2),
                                      "polygon 0: vertex 2 is infinite or not a number"));
  out.push_back(makeRealShape<float>("shape of floats that is too large", {{0, 0}, {kHugeFloat, 0}, {1, 1}},
                                     Expect(outsideCell).polygon(0).vertex(1),
                                     "polygon 0: vertex 1 is outside the cell; coordinates run from 0 to 1 cell, rim "
                                     "included"));
  out.push_back(makeRealShape<double>("shape of two vertices, one no number", {{kNan, 0}, {1, 0}},
                                      Expect(tooFewVertices).polygon(0),
                                      "polygon 0: a polygon needs at least 3 vertices"));
  out.push_back(makeShape("empty shape", {}, Expect(emptyShape), "a shape needs at least one polygon"));
  out.push_back(makeShape("shape with a bad polygon", {ramp(), {{0, 0}, {0, 9}, {9, 9}}}, Expect(clockwise).polygon(1),
                          "polygon 1: the polygon runs clockwise; reverse its vertices"));
  out.push_back(makeShape("shape with an overlap", {eighths({{1, 5}, {2, 5}, {2, 6}}), ramp(), unitSquare()},
                          Expect(overlap).polygon(2).polygon2(0),
                          "polygon 2: its interior overlaps that of polygon 0"));
  out.push_back(makeShape("shape with the same twice", {ramp(), ramp()}, Expect(overlap).polygon(1).polygon2(0),
                          "polygon 1: its interior overlaps that of polygon 0"));
  std::vector<LocalPolygon> many;
  for (std::int32_t k = 0; k <= static_cast<std::int32_t>(kMaxPolygonsPerCell); ++k)
    many.push_back({{2 * k, 0}, {2 * k + 1, 0}, {2 * k + 1, 1}});
  out.push_back(makeShape("shape of three that overlap all", {unitSquare(), ramp(), unitSquare()},
                          Expect(overlap).polygon(1).polygon2(0),
                          "polygon 1: its interior overlaps that of polygon 0"));
  out.push_back(makeShape("shape of too many", many, Expect(capacity), kTooMuch));
}

}  // namespace

const std::vector<Cell>& Stage::cells() {
  static const std::vector<Cell> cells = cellsOf({{-41, -4}, {8, 8}});
  return cells;
}

Stage makeStage() {
  Stage s;
  s.square = shapeOf(s.world, {unitSquare()});
  s.twoRamps = shapeOf(s.world, shapeNamed("two ramps"));
  s.full = place(s.world, kFull, unitSquare(), 1);
  s.ramp = place(s.world, kRamp, ramp(), 2);
  s.removed = place(s.world, kRamp, eighths({{0, 2}, {6, 8}, {0, 8}}), 3);
  s.lower = place(s.world, kTwo, eighths({{0, 0}, {8, 0}, {8, 4}, {0, 4}}), 1);
  s.upper = place(s.world, kTwo, eighths({{0, 4}, {8, 4}, {8, 8}, {0, 8}}), 2);
  s.world.commit();
  EXPECT_TRUE(s.world.remove(s.removed));
  s.world.commit();
  return s;
}

const std::vector<BadEdit>& badEdits() {
  static const std::vector<BadEdit> edits = [] {
    std::vector<BadEdit> out;
    addVertexFaults(out);
    addRealFaults(out);
    addOverlaps(out);
    addUnknown(out);
    addStaleHandles(out);
    addExchanges(out);
    addShapes(out);
    return out;
  }();
  return edits;
}

}  // namespace lgs::test
