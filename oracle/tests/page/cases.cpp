#include "oracle/tests/page/cases.h"

#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/model.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle::test {
namespace {

constexpr std::int64_t kUnit = kUnitsPerCell;

Scene endOf(const Trace& trace) {
  Model model;
  for (const Call& call : trace.calls) model.play(call);
  return model.scene(trace.preserve);
}

// The end of a trace at which everything is right so far.
PageEnd rightEnd(const Trace& trace) {
  const Scene scene = endOf(trace);
  const Outline outline = naiveOutline(scene);
  return {trace.calls.size(), true, scene.polygons.size(), outline, outline, {}};
}

OutlineSegment& segmentOf(Outline& outline, Point start, Point end) {
  return *std::ranges::find_if(outline, [&](const OutlineSegment& s) { return s.start == start && s.end == end; });
}

void finish(PageCase& made) {
  PageEnd& end = *made.options.end;
  std::sort(end.actual.begin(), end.actual.end());
  made.options.report += describe(compare(end.expected, end.actual));
}

}  // namespace

PageCase uncutWall() {
  PageCase made{"uncut-wall",
                parseTrace("lgs-trace 1\n"
                           "add floor 0 0 1  0 0 1 0 1 1 0 1\n"
                           "commit\n"
                           "add wall 1 0 3  0 0 1 0 1 1 0 1\n"
                           "add bad 1 0 3  0 0 1 0 1 1\n"
                           "add tooth 0 1 2  0 1 0.5 0 1 0.5\n"
                           "remove wall\n"
                           "commit\n")
                    .trace,
                {"the outline differs from the naive reference's", "", "naive reference", "engine", {}}};
  made.options.end = rightEnd(made.trace);
  Outline& actual = made.options.end->actual;
  const Point half{kUnit / 2, kUnit};
  const Point corner{kUnit, kUnit};
  const Point left{0, kUnit};
  // The engine sees one wall from corner to corner, so the two halves are not there, and no link leads to the tooth.
  segmentOf(actual, left, {0, 0}).ghost1 = corner;
  segmentOf(actual, {kUnit, 0}, corner).ghost2 = left;
  segmentOf(actual, {0, 2 * kUnit}, half).ghost2.reset();
  segmentOf(actual, half, {kUnit, kUnit + kUnit / 2}).ghost1.reset();
  OutlineSegment& wall = segmentOf(actual, corner, half);
  wall.end = left;
  wall.ghost2 = Point{0, 0};
  std::erase_if(actual, [&](const OutlineSegment& s) { return s.start == half && s.end == left; });
  finish(made);
  return made;
}

PageCase markup() {
  const std::string name = "</script><img/src=x/onerror=window.broken=1>&amp;\"'`${1}{{data}}";
  PageCase made{"markup",
                parseTrace(fmt::format("lgs-trace 1\nadd {} 0 0 1  0 0 1 0 0 1\n", name)).trace,
                {name + " <!-- \x01\xff ü",
                 "the report: " + name + "\nits second line\n",
                 "<b>expected</b>",
                 "<i>actual</i>",
                 {}}};
  return made;
}

PageCase endsOfTheWorld() {
  PageCase made{"ends-of-the-world",
                parseTrace(fmt::format("lgs-trace 1\n"
                                       "add west {0} {0} 1  0 0 1 0 1 1 0 1\n"
                                       "add east {1} {1} 2  1/65536 0 1 0 1 1 1/65536 1\n",
                                       -kMaxCell, kMaxCell))
                    .trace,
                {"the outline differs from CGAL's", "", "CGAL", "engine", {}}};
  made.options.end = rightEnd(made.trace);
  made.options.end->actual.pop_back();
  finish(made);
  return made;
}

PageCase wrongRefusal() {
  PageCase made{"wrong-refusal",
                parseTrace("lgs-trace 1\n"
                           "preserve 1 2\n"
                           "add a 0 0 1  0 0 1 0 1 1 0 1\n"
                           "add b 1 0 2  0 0 1 0 1 1 0 1\n"
                           "commit\n"
                           "add c 1 1 2  0 0 1 0 1 1\n")
                    .trace,
                {"the engine refuses a good edit", "add c is refused: overlap\n", "engine", "", {}}};
  made.options.end = rightEnd(made.trace);
  PageEnd& end = *made.options.end;
  end.committed = false;
  end.marked = {end.expected.front()};
  return made;
}

PageCase longTrace() {
  std::string text = "lgs-trace 1\n";
  constexpr int kWide = 60;
  for (int k = 0; k < kWide * kWide; ++k)
    text += fmt::format("add p{} {} {} {}  0 0 1 0 1 1 0 1\n", k, k % kWide, k / kWide, k % 4);
  text += "commit\n";
  for (int k = 0; k < 1'500; ++k) {
    const int at = 30 * kWide + 20 + k % 20;
    text += fmt::format("{} p{}{}\ncommit\n", k % 40 < 20 ? "remove" : "add", at,
                        k % 40 < 20 ? "" : fmt::format(" {} 30 7  0 0 1 0 0 1", 20 + k % 20));
    if (k % 10 == 0) text += fmt::format("add far{} 70 {} 1  0 0 1 0 0 1\ncommit\n", k, k);
  }
  PageCase made{"long", parseTrace(text).trace, {"a long trace", "", "naive reference", "engine", {}}};
  made.options.end = rightEnd(made.trace);
  Outline& actual = made.options.end->actual;
  std::erase_if(actual, [&](const OutlineSegment& s) { return cellAt(s.start) == Cell{30, 30}; });
  finish(made);
  return made;
}

PageCase crash() {
  return {"crash", uncutWall().trace, {"the engine crashed with SIGSEGV", "", "naive reference", "", {}}};
}

std::vector<PageCase> pageCases() {
  return {uncutWall(), markup(), endsOfTheWorld(), wrongRefusal(), longTrace(), crash()};
}

}  // namespace lgs::oracle::test
