#include "bad_edits.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>

namespace lgs::test {
namespace {

constexpr Cell kFull{0, 0}, kRamp{1, 0}, kTwo{2, 0}, kEmpty{5, -3}, kTooFar{kMaxCell + 1, 0}, kTooLow{0, -kMaxCell - 1};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
constexpr ShapeId kUnknown{4711};
constexpr float kHugeFloat = std::numeric_limits<float>::max(), kInfFloat = std::numeric_limits<float>::infinity();

const std::string kTooMuch =
    "too much: a cell holds at most 254 polygons with 4,096 vertices, and 2^28 - 1 polygons in its time; a world "
    "2^22 - 1 chunks of 32x32 cells, and 2^23 - 1 distinct contents of cells; a call 2^31 - 1 entries; in one cell a "
    "brush 4,096 edges and 32,768 crossings";
const std::string kOutOfRange = "the cell is out of range; both indices must be within ±2^30";
const std::string kTooFew = "a polygon needs at least 3 vertices";
const std::string kNoArea = "the polygon has no area, or crosses itself so that its areas cancel";
const std::string kClockwise = "the polygon runs clockwise; reverse its vertices";
const std::string kNotFinite = " is infinite or not a number";
const std::string kOutside = " is outside the cell; coordinates run from 0 to 1 cell, rim included";
const std::string kSame = " are the same lattice point; leave one out";
const std::string kCrosses = "the polygon crosses itself, or touches itself: the edge from vertex ";
const std::string kNoShape = "this world has no such shape";

std::string of(PolygonHandle handle) { return fmt::format("{}:{}", handle.cellRef, handle.serial); }
std::string in(Cell cell) { return fmt::format("cell ({}, {})", cell.i, cell.j); }

std::string stale(PolygonHandle handle) {
  if (!handle) return "the handle is null, and names no polygon; was the edit refused that should have given it?";
  return fmt::format("the handle {} names no polygon; it was removed, or never existed", of(handle));
}

/// Every stage is the same, so its handles are known before.
std::string overlaps(PolygonHandle Stage::*other, Block block) {
  return fmt::format("its interior overlaps that of a polygon of block {} that is already in this cell (handle {})",
                     block, of(makeStage().*other));
}

LocalPolygon wheel(std::size_t vertices) {
  LocalPolygon polygon;
  for (std::size_t k = 0; k + 1 < vertices; ++k) polygon.push_back({static_cast<std::int32_t>(k), 0});
  polygon.push_back({0, U});
  return polygon;
}

std::vector<LocalPolygon> tooMany() {
  std::vector<LocalPolygon> many;
  for (std::int32_t k = 0; k <= static_cast<std::int32_t>(kMaxPolygonsPerCell); ++k)
    many.push_back({{2 * k, 0}, {2 * k + 1, 0}, {2 * k + 1, 1}});
  return many;
}

struct List {
  std::vector<BadEdit> edits;

  template <class Attempt>
  void call(std::string name, std::string text, Attempt attempt) {
    const auto errorOf = [attempt](Stage& s) {
      const auto result = attempt(s.world, s);
      return result ? Error{} : result.error();
    };
    edits.push_back({std::move(name), errorOf, std::move(text)});
  }
  /// add() of a polygon in any notation.
  template <class Vertex = LocalPoint>
  void add(std::string name, Cell cell, std::vector<Vertex> polygon, const std::string& text) {
    const std::string where = in(cell) + (inRange(cell) ? ", polygon 0: " : ": ");
    call(std::move(name), where + text,
         [=](World& w, Stage&) { return w.add(cell, std::span<const Vertex>(polygon), 9); });
  }
  void shape(std::string name, std::vector<LocalPolygon> polygons, const std::string& text) {
    call(std::move(name), text, [=](World& w, Stage&) { return w.shape(polygons); });
  }
  template <class Vertex>
  void shapeOfReals(std::string name, std::vector<Vertex> polygon, const std::string& text) {
    call(std::move(name), "polygon 0: " + text,
         [=](World& w, Stage&) { return w.shape(std::span<const Vertex>(polygon)); });
  }
  void handle(const std::string& name, PolygonHandle h) {
    call(name, stale(h), [=](World& w, Stage&) { return w.remove(h); });
    call(name + ", for setBlock()", stale(h), [=](World& w, Stage&) { return w.setBlock(h, 9); });
  }
  void exchange(std::string name, Cell cell, std::vector<PolygonHandle> goes, std::vector<LocalPolygon> comes,
                const std::string& text) {
    call(std::move(name), in(cell) + text, [=](World& w, Stage&) {
      std::vector<NewPolygon> polygons;
      for (const LocalPolygon& p : comes) polygons.push_back({p, 9});
      std::vector<PolygonHandle> handles(polygons.size(), PolygonHandle{4, 4});
      const auto untouched = handles;
      const auto done = w.exchange(cell, goes, polygons, handles);
      EXPECT_EQ(handles, untouched) << "a refused exchange writes handles";
      return done;
    });
  }
  /// An exchange of which the entry with this index is no polygon of the cell.
  void exchangeOfNone(std::string name, Cell cell, const std::vector<PolygonHandle>& goes, std::size_t index) {
    exchange(std::move(name), cell, goes, {eighths({{0, 6}, {8, 6}, {8, 8}, {0, 8}})}, ": " + stale(goes[index]));
    edits.back().text.insert(0, fmt::format("entry {}, ", index));
  }
};

void addVertexFaults(List& out) {
  out.add("cell too far", kTooFar, unitSquare(), kOutOfRange);
  out.add("cell too low", kTooLow, {}, kOutOfRange);
  out.add("no vertices", kEmpty, {}, kTooFew);
  out.add("two vertices, one outside", kEmpty, {{0, 0}, {-1, 0}}, kTooFew);
  out.add("too many vertices", kEmpty, wheel(kMaxVerticesPerCell + 1), kTooMuch);
  out.add("left of the cell", kEmpty, {{0, 0}, {U, 0}, {-1, U}}, "vertex 2" + kOutside);
  out.add("above the cell, and repeated", kEmpty, {{0, 0}, {0, U + 1}, {0, 0}, {5, 5}}, "vertex 1" + kOutside);
  out.add("repeated vertex", kEmpty, {{0, 0}, {U, 0}, {U, U}, {U, 0}}, "vertex 1 and vertex 3" + kSame);
  out.add("no area", kEmpty, {{0, 0}, {5, 5}, {9, 9}}, kNoArea);
  out.add("bow tie without area", kEmpty, {{0, 0}, {U, U}, {U, 0}, {0, U}}, kNoArea);
  out.add("clockwise", kEmpty, {{0, 0}, {0, U}, {U, U}}, kClockwise);
  out.add("bow tie, clockwise on the whole", kEmpty, {{0, 0}, {0, U}, {U, 0}, {U, U / 2}},
          kCrosses + "1 meets the edge from vertex 3");
  out.add("edges cross", kEmpty, {{0, 0}, {U, 0}, {U / 8, U / 2}, {U, U}}, kCrosses + "1 meets the edge from vertex 3");
  out.add("touches itself", kEmpty, {{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}},
          kCrosses + "0 meets the edge from vertex 2");
  out.add("folds back", kEmpty, {{0, 0}, {9, 0}, {5, 0}, {5, 5}}, kCrosses + "0 meets the edge from vertex 1");
}

void addRealFaults(List& out) {
  out.add<DoublePoint>("not a number, after one outside", kEmpty, {{-1, 0}, {1, 0}, {1, kNan}},
                       "vertex 2" + kNotFinite);
  out.add<DoublePoint>("infinite", kEmpty, {{0, 0}, {-kInf, 0}, {1, 1}}, "vertex 1" + kNotFinite);
  out.add<FloatPoint>("infinite float", kEmpty, {{0, 0}, {1, 0}, {1, kInfFloat}}, "vertex 2" + kNotFinite);
  out.add<DoublePoint>("half a unit out", kEmpty, {{0, 0}, {1 + 0.5 / U, 0}, {1, 1}}, "vertex 1" + kOutside);
  out.add<DoublePoint>("half a unit below", kEmpty, {{0, 0}, {1, 0}, {1, 1}, {0, -0.5 / U}}, "vertex 3" + kOutside);
  out.add<FloatPoint>("huge float", kEmpty, {{kHugeFloat, 0}, {1, 0}, {1, 1}}, "vertex 0" + kOutside);
  out.add<DoublePoint>("huge double", kEmpty, {{0, 0}, {1, -1e308}, {1, 1}}, "vertex 1" + kOutside);
  out.add<DoublePoint>("rounded onto each other", kEmpty, {{0, 0}, {1, 0}, {0.4 / U, 0.4 / U}},
                       "vertex 0 and vertex 2" + kSame);
  out.add<DoublePoint>("too few, not a number", kEmpty, {{kNan, 0}, {1, 0}}, kTooFew);
  out.add<DoublePoint>("not a number, cell too far", kTooFar, {{kNan, 0}, {1, 0}, {1, 1}}, kOutOfRange);
  std::vector<DoublePoint> many(kMaxVerticesPerCell + 1, {0.5, 0.5});
  many[7].x = kNan;
  out.add("too many, not a number", kEmpty, many, kTooMuch);
}

void addOverlaps(List& out) {
  out.add("the same again", kFull, unitSquare(), overlaps(&Stage::full, 1));
  out.add("a new one inside", kFull, {{77, 77}, {99, 77}, {99, 98}}, overlaps(&Stage::full, 1));
  out.add("across the ramp", kRamp, {{0, 0}, {U, 0}, {0, U}}, overlaps(&Stage::ramp, 2));
  out.add("one of two", kTwo, eighths({{0, 6}, {8, 6}, {8, 8}}), overlaps(&Stage::upper, 2));
  out.call("the first of a shape", in(kRamp) + ", polygon 0: " + overlaps(&Stage::ramp, 2),
           [](World& w, Stage& s) { return w.add(kRamp, s.twoRamps, 9); });
  out.call("the last cell of a fill", in(kFull) + ", polygon 0: " + overlaps(&Stage::full, 1), [](World& w, Stage& s) {
    return w.fill({{-40, -1}, {0, 0}}, s.square, 9);
  });
}

void addUnknown(List& out) {
  constexpr Cell kLeast{-kMaxCell, -kMaxCell};
  out.call("null shape", in(kEmpty) + ": " + kNoShape, [](World& w, Stage&) { return w.add(kEmpty, ShapeId{}, 9); });
  out.call("unknown shape", in(kEmpty) + ": " + kNoShape, [](World& w, Stage&) { return w.add(kEmpty, kUnknown, 9); });
  out.call("unknown shape, cell too far", in(kTooFar) + ": " + kOutOfRange,
           [](World& w, Stage&) { return w.add(kTooFar, kUnknown, 9); });
  out.call("null shape in the place of what stands", in(kTwo) + ": " + kNoShape,
           [](World& w, Stage&) { return w.replace(kTwo, ShapeId{}, 9); });
  out.call("replacing in a cell too far", in(kTooFar) + ": " + kOutOfRange,
           [](World& w, Stage& s) { return w.replace(kTooFar, s.square, 9); });
  out.call("fill with an unknown shape", in(kEmpty) + ": " + kNoShape, [](World& w, Stage&) {
    return w.fill({kEmpty, {7, 7}}, kUnknown, 9);
  });
  out.call("fill beyond the range", in(kTooFar) + ": " + kOutOfRange, [](World& w, Stage& s) {
    return w.fill({kEmpty, kTooFar}, s.square, 9);
  });
  out.call("fill more than fits", in(kLeast) + ": " + kTooMuch, [=](World& w, Stage& s) {
    return w.fill({kLeast, {kMaxCell, kMaxCell}}, s.square, 9);
  });
  out.call("clear beyond the range", in(kTooLow) + ": " + kOutOfRange, [](World& w, Stage&) {
    return w.clear({kTooLow, kFull});
  });
}

void addStaleHandles(List& out, const Stage& stage) {
  out.handle("null handle", {});
  out.handle("removed before", stage.removed);
  out.handle("a serial not given out yet", {stage.full.cellRef, stage.full.serial + 1});
  out.handle("serial null", {stage.full.cellRef, 0});
  out.handle("serial null where there are several", {stage.upper.cellRef, 0});
  out.handle("an empty cell of a chunk that exists", {stage.full.cellRef + 20, 1});
  out.handle("a chunk that does not exist", {0xffff'ffff, 1});
  out.handle("chunk null", {5, 1});
}

void addExchanges(List& out, const Stage& s) {
  const LocalPolygon low = eighths({{0, 0}, {8, 0}, {8, 2}, {0, 2}}), high = eighths({{0, 6}, {8, 6}, {8, 8}, {0, 8}});
  out.exchangeOfNone("exchange of what is gone", kRamp, {s.ramp, s.removed}, 1);
  out.exchangeOfNone("exchange of what is in another cell", kTwo, {s.upper, s.full}, 1);
  out.exchangeOfNone("exchange of the same twice", kTwo, {s.lower, s.upper, s.lower}, 2);
  out.exchangeOfNone("exchange of nothing, in an empty cell", kEmpty, {{}}, 0);
  out.exchange("exchange beyond the range", kTooFar, {}, {low}, ": " + kOutOfRange);
  out.exchange("exchange for what overlaps the other one", kTwo, {s.lower}, {low, high},
               ", polygon 1: " + overlaps(&Stage::upper, 2));
  out.exchange("exchange for two that overlap", kTwo, {s.upper, s.lower}, {low, high, ramp()},
               ", polygon 2: its interior overlaps that of polygon 0");
  out.exchange("exchange for two that overlap, in an empty cell", kEmpty, {}, {unitSquare(), ramp()},
               ", polygon 1: its interior overlaps that of polygon 0");
  out.exchange("exchange for a bad polygon", kTwo, {s.upper, s.lower}, {low, {{0, 0}, {0, U}, {U, U}}},
               ", polygon 1: " + kClockwise);
  out.exchange("exchange for more than fits", kTwo, {s.upper, s.lower}, tooMany(), ": " + kTooMuch);
}

void addShapes(List& out) {
  out.shapeOfReals<DoublePoint>("shape that is no number", {{0, 0}, {1, 0}, {1, kNan}}, "vertex 2" + kNotFinite);
  out.shapeOfReals<FloatPoint>("shape of floats that is too large", {{0, 0}, {kHugeFloat, 0}, {1, 1}},
                               "vertex 1" + kOutside);
  out.shapeOfReals<DoublePoint>("shape of two vertices, one no number", {{kNan, 0}, {1, 0}}, kTooFew);
  out.shape("empty shape", {}, "a shape needs at least one polygon");
  out.shape("shape with a bad polygon", {ramp(), {{0, 0}, {0, 9}, {9, 9}}}, "polygon 1: " + kClockwise);
  out.shape("shape with an overlap", {eighths({{1, 5}, {2, 5}, {2, 6}}), ramp(), unitSquare()},
            "polygon 2: its interior overlaps that of polygon 0");
  out.shape("shape with the same twice", {ramp(), ramp()}, "polygon 1: its interior overlaps that of polygon 0");
  out.shape("shape of three that overlap all", {unitSquare(), ramp(), unitSquare()},
            "polygon 1: its interior overlaps that of polygon 0");
  out.shape("shape of too many", tooMany(), kTooMuch);
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
    List out;
    addVertexFaults(out);
    addRealFaults(out);
    addOverlaps(out);
    addUnknown(out);
    addStaleHandles(out, makeStage());
    addExchanges(out, makeStage());
    addShapes(out);
    return out.edits;
  }();
  return edits;
}

}  // namespace lgs::test
