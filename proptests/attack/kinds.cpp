#include "kinds.h"

#include <limits>

namespace lgs::test {
namespace {

template <class Numbers>
std::string listed(const Numbers& numbers) {
  return fmt::format("({})", fmt::join(numbers, ", "));
}

}  // namespace

// NOLINTBEGIN(readability-identifier-naming): a table
/// The list of a type, and a value of it in words.
#define VALUES(Type, words, ...)                           \
  const std::vector<Type>& Hostile<Type>::values(Scene&) { \
    static const std::vector<Type> all{__VA_ARGS__};       \
    return all;                                            \
  }                                                        \
  std::string Hostile<Type>::told(const Type& v) { return (words); }

VALUES(bool, v ? "true" : "false", false, true)
VALUES(int, fmt::format("{}", v), 32, 0, 1, -1, 7, 8, 9, 4'095, 4'096, 4'097, kLeast, kMost)
VALUES(std::uint32_t, fmt::format("{}", v), 1, 0, 2, 0x7fff'ffff, 0x8000'0000, 0xffff'fffe, 0xffff'ffff)
VALUES(std::int64_t, fmt::format("{}", v), 1, 0, -1, 65'536, kMaxRegionCells / 2 * kUnitsPerCell,
       kMaxRegionCells / 2 * kUnitsPerCell + 1, kMost, kLeast, std::int64_t{1} << 46, INT64_MAX, INT64_MIN,
       INT64_MAX - 1, INT64_MIN + 1)
VALUES(std::uint64_t, fmt::format("{}", v), 1, 0, 0xffff'ffff, 0x1'0000'0000, 0x1'0000'0001, INT64_MAX,
       ~std::uint64_t{0})
VALUES(double, fmt::format("{}", v), 1, 0, -0.0, -1, 0.5, kMaxRadius, kMaxRadius + 1e-9, -1e-300, 5e-324, 1e308, -1e308,
       std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
       -std::numeric_limits<double>::infinity(), 1.0 / kUnitsPerCell)
VALUES(Cell, listed(std::vector{v.i, v.j}), {0, 0}, {2, 0}, {-1, -1}, {1, 1}, {31, 31}, {32, -32}, {kMaxCell, kMaxCell},
       {-kMaxCell, -kMaxCell}, {kMaxCell, -kMaxCell}, {kMaxCell + 1, 0}, {0, -kMaxCell - 1}, {kLeast, kLeast},
       {kMost, kMost}, {kLeast, 0}, {0, kMost}, {kMost, kLeast})
VALUES(CellRect, fmt::format("{} to {}", Hostile<Cell>::told(v.min), Hostile<Cell>::told(v.max)), {{0, 0}, {1, 1}},
       {{0, 0}, {0, 0}}, {{1, 1}, {0, 0}}, {{0, 0}, {1, -1}}, {{-2, -2}, {40, 33}}, {{kMost, kMost}, {kLeast, kLeast}},
       {{kLeast, kLeast}, {kMost, kMost}}, {{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}}, {{0, 0}, {kMaxCell, 0}},
       {{0, 0}, {0, kMaxCell + 1}}, {{-kMaxCell - 1, 0}, {0, 0}}, {{kMaxCell, kMaxCell}, {kMaxCell, kMaxCell}},
       {{kMost, kMost}, {kMost, kMost}}, {{kLeast, kLeast}, {kLeast, kLeast}}, {{kMaxCell, 0}, {kMost, 0}})
VALUES(Point, listed(std::vector{v.x, v.y}), {32'768, 32'768}, {0, 0}, {-1, 65'536}, {kFar, kFar}, {-kFar, -kFar},
       {kFar + 1, 0}, {0, -kFar - 1}, {INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN}, {INT64_MIN, INT64_MAX},
       {0, INT64_MAX}, {INT64_MIN, 0}, {kMaxRay * std::int64_t{kUnitsPerCell}, 0},
       {kMaxRay * std::int64_t{kUnitsPerCell} + 1, 0}, {65'536, 65'535})
VALUES(LocalPoint, listed(std::vector{v.x, v.y}), {0, 0}, {kUnitsPerCell, kUnitsPerCell}, {-1, 0},
       {0, kUnitsPerCell + 1}, {kLeast, kLeast}, {kMost, kMost})
VALUES(DoublePoint, listed(std::vector{v.x, v.y}), {0.5, 0.5}, {0, -0.0}, {5e-324, -5e-324}, {1e308, -1e308},
       {std::numeric_limits<double>::quiet_NaN(), 0}, {0, std::numeric_limits<double>::infinity()},
       {-std::numeric_limits<double>::infinity(), 1}, {1 << 30, -(1 << 30)}, {(1 << 30) + 1.0, 0},
       {(1 << 30) + 1.00001, 0}, {9.3e18, -9.3e18})
VALUES(Room, fmt::format("room {}", v.size), {9}, {0}, {1}, {300})
VALUES(Given, v.isGiven ? "given" : "NULL", {true}, {false})
VALUES(Said, fmt::format("count {}", v.count), {4}, {0}, {1}, {3}, {300})
VALUES(ErrorCode, fmt::format("code {}", static_cast<unsigned>(v)), ErrorCode::overlap, ErrorCode{0},
       ErrorCode::cellOutOfRange, ErrorCode::tooFewVertices, ErrorCode::capacity, ErrorCode::notFinite,
       ErrorCode::repeatedVertex, ErrorCode::selfIntersecting, ErrorCode::staleHandle, ErrorCode::unknownSegment,
       ErrorCode::outOfReach, ErrorCode{18}, ErrorCode{0xffff'ffff})
VALUES(Collinear, v == Collinear::keep ? "keep" : "merge", Collinear::keep, Collinear::merge)
VALUES(Undone, fmt::format("undone {}", static_cast<unsigned>(v)), Undone::drop, Undone::keep, Undone{2}, Undone{255})
VALUES(SvgOverlay, fmt::format("{} by {} from {}", v.over, v.cellsPerUnit, Hostile<Cell>::told(v.origin)), {},
       {"<b>", std::numeric_limits<double>::quiet_NaN(), {kLeast, kMost}}, {"", 0, {kMost, kLeast}},
       {"&", 1e308, {0, 0}}, {"x", -1, {0, kMost}})
VALUES(FillRule, fmt::format("rule {}", static_cast<unsigned>(v)), FillRule::nonZero, FillRule::evenOdd, FillRule{2},
       FillRule{255})
VALUES(PaintMode, fmt::format("mode {}", static_cast<unsigned>(v)), PaintMode::fill, PaintMode::replace, PaintMode{2},
       PaintMode{255})
VALUES(Error, fmt::format("error {}", static_cast<unsigned>(v.code)), {ErrorCode::overlap}, {ErrorCode{0}},
       {ErrorCode::overlap, {kLeast, kMost}, kLeast, kLeast, kLeast, kLeast},
       {ErrorCode::overlap, {0, 0}, kMost, kMost, kMost, kMost, {1, 1}, 1, {1}, kMost, kMost},
       {ErrorCode::staleHandle, {0, 0}, 0, 0, 0, 0, {1, 1}, 1, {1}, 0, 0}, {ErrorCode::staleHandle},
       {ErrorCode{0xffff'ffff}})
VALUES(lgs_error, fmt::format("error {}", v.code),
       {LGS_OVERLAP, {0, 0}, 0, 0, 0, 0, {1, 1}, 1, {1}, 0, 0, 0, {0, 0, 0}}, {},
       {LGS_SAVE_CUT, {}, 0, 0, 0, 0, {}, 0, {}, 0, UINT64_MAX, 0, {}},
       {kLeast, {}, 0, 0, 0, 0, {}, 0, {}, 0, 0, 0, {}},
       {kMost, {}, kMost, kMost, kMost, kMost, {}, 0, {}, kMost, 0, kMost, {1, 1, 1}},
       {99, {}, 0, 0, 0, 0, {}, 0, {}, 0, 0, 0, {}}, {210, {}, 0, 0, 0, 0, {}, 0, {}, 0, 0, 0, {}})
VALUES(SnapshotError, fmt::format("error {}", static_cast<std::uint64_t>(v.what)), {SnapshotError::What::cut, 7},
       {SnapshotError::What{10}, ~std::uint64_t{0}}, {SnapshotError::What{~std::uint64_t{0}}, 0})
VALUES(Segment, fmt::format("{} → {}", Hostile<Point>::told(v.start), Hostile<Point>::told(v.end)),
       Segment{{1}, {0, 0}, {65'536, 0}, {}, {}, {}, {}, 0, {}, {}}, Segment{},
       Segment{{1}, {-kFar, -kFar}, {kFar, kFar}, {}, {}, {}, {}, 0, {}, {}},
       Segment{{1}, {INT64_MIN, INT64_MIN}, {INT64_MAX, INT64_MAX}, {}, {}, {}, {}, 0, {}, {}},
       Segment{{1}, {INT64_MAX, 0}, {INT64_MIN, 0}, {}, {}, {}, {}, 0, {}, {}},
       Segment{{1}, {5, 5}, {5, 5}, {}, {}, {}, {}, 0, {}, {}})
#undef VALUES
// NOLINTEND(readability-identifier-naming)

// The names of the scene.
const std::vector<ShapeId>& Hostile<ShapeId>::values(Scene& scene) { return scene.shapes; }
const std::vector<PolygonHandle>& Hostile<PolygonHandle>::values(Scene& scene) { return scene.polygons; }
const std::vector<SegmentId>& Hostile<SegmentId>::values(Scene& scene) { return scene.segments; }
const std::vector<Mark>& Hostile<Mark>::values(Scene& scene) { return scene.marks; }
const std::vector<lgs_mark>& Hostile<lgs_mark>::values(Scene& scene) {
  static std::vector<lgs_mark> all;
  all.clear();
  for (const Mark mark : scene.marksOfC) all.push_back({mark.value});
  return all;
}

std::string Hostile<ShapeId>::told(const ShapeId& v) { return fmt::format("shape {}", v.value); }
std::string Hostile<PolygonHandle>::told(const PolygonHandle& v) { return fmt::format("{}:{}", v.cellRef, v.serial); }
std::string Hostile<SegmentId>::told(const SegmentId& v) { return fmt::format("segment {}", v.value); }
std::string Hostile<Mark>::told(const Mark& v) { return fmt::format("mark {}", v.value); }
std::string Hostile<lgs_mark>::told(const lgs_mark& v) { return fmt::format("mark {}", v.value); }

}  // namespace lgs::test
