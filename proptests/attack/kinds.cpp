#include "kinds.h"

#include <limits>

namespace lgs::test {
// NOLINTBEGIN(readability-identifier-naming): a table
#define VALUES(Type, ...)                                  \
  const std::vector<Type>& Hostile<Type>::values(Scene&) { \
    static const std::vector<Type> all{__VA_ARGS__};       \
    return all;                                            \
  }

VALUES(bool, false, true)
VALUES(int, 32, 0, 1, -1, 7, 8, 9, 4'095, 4'096, 4'097, kLeast, kMost)
VALUES(std::uint32_t, 1, 0, 2, 0x7fff'ffff, 0x8000'0000, 0xffff'fffe, 0xffff'ffff)
VALUES(std::int64_t, 1, 0, -1, 65'536, kMaxRegionCells / 2 * kUnitsPerCell, kMaxRegionCells / 2 * kUnitsPerCell + 1,
       kMost, kLeast, std::int64_t{1} << 46, INT64_MAX, INT64_MIN, INT64_MAX - 1, INT64_MIN + 1)
VALUES(std::uint64_t, 1, 0, 0xffff'ffff, 0x1'0000'0000, 0x1'0000'0001, INT64_MAX, ~std::uint64_t{0})
VALUES(double, 1, 0, -0.0, -1, 0.5, kMaxRadius, kMaxRadius + 1e-9, -1e-300, 5e-324, 1e308, -1e308,
       std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
       -std::numeric_limits<double>::infinity(), 1.0 / kUnitsPerCell)
VALUES(Cell, {0, 0}, {2, 0}, {-1, -1}, {1, 1}, {31, 31}, {32, -32}, {kMaxCell, kMaxCell}, {-kMaxCell, -kMaxCell},
       {kMaxCell, -kMaxCell}, {kMaxCell + 1, 0}, {0, -kMaxCell - 1}, {kLeast, kLeast}, {kMost, kMost}, {kLeast, 0},
       {0, kMost}, {kMost, kLeast})
VALUES(CellRect, {{0, 0}, {1, 1}}, {{0, 0}, {0, 0}}, {{1, 1}, {0, 0}}, {{0, 0}, {1, -1}}, {{-2, -2}, {40, 33}},
       {{kMost, kMost}, {kLeast, kLeast}}, {{kLeast, kLeast}, {kMost, kMost}},
       {{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}}, {{0, 0}, {kMaxCell, 0}}, {{0, 0}, {0, kMaxCell + 1}},
       {{-kMaxCell - 1, 0}, {0, 0}}, {{kMaxCell, kMaxCell}, {kMaxCell, kMaxCell}}, {{kMost, kMost}, {kMost, kMost}},
       {{kLeast, kLeast}, {kLeast, kLeast}}, {{kMaxCell, 0}, {kMost, 0}})
VALUES(Point, {32'768, 32'768}, {0, 0}, {-1, 65'536}, {kFar, kFar}, {-kFar, -kFar}, {kFar + 1, 0}, {0, -kFar - 1},
       {INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN}, {INT64_MIN, INT64_MAX}, {0, INT64_MAX}, {INT64_MIN, 0},
       {kMaxRay * std::int64_t{kUnitsPerCell}, 0}, {kMaxRay * std::int64_t{kUnitsPerCell} + 1, 0}, {65'536, 65'535})
VALUES(LocalPoint, {0, 0}, {kUnitsPerCell, kUnitsPerCell}, {-1, 0}, {0, kUnitsPerCell + 1}, {kLeast, kLeast},
       {kMost, kMost})
VALUES(DoublePoint, {0.5, 0.5}, {0, -0.0}, {5e-324, -5e-324}, {1e308, -1e308},
       {std::numeric_limits<double>::quiet_NaN(), 0}, {0, std::numeric_limits<double>::infinity()},
       {-std::numeric_limits<double>::infinity(), 1}, {1 << 30, -(1 << 30)}, {(1 << 30) + 1.0, 0},
       {(1 << 30) + 1.00001, 0}, {9.3e18, -9.3e18})
VALUES(Room, {9}, {0}, {1}, {300})
VALUES(Given, {true}, {false})
VALUES(Said, {4}, {0}, {1}, {3}, {300})
VALUES(ErrorCode, ErrorCode::overlap, ErrorCode{0}, ErrorCode::cellOutOfRange, ErrorCode::tooFewVertices,
       ErrorCode::capacity, ErrorCode::notFinite, ErrorCode::repeatedVertex, ErrorCode::selfIntersecting,
       ErrorCode::staleHandle, ErrorCode::unknownSegment, ErrorCode::outOfReach, ErrorCode{18}, ErrorCode{0xffff'ffff})
VALUES(Collinear, Collinear::keep, Collinear::merge)
VALUES(Undone, Undone::drop, Undone::keep, Undone{2}, Undone{255})
VALUES(SvgOverlay, {}, {"<b>", std::numeric_limits<double>::quiet_NaN(), {kLeast, kMost}}, {"", 0, {kMost, kLeast}},
       {"&", 1e308, {0, 0}}, {"x", -1, {0, kMost}})
VALUES(FillRule, FillRule::nonZero, FillRule::evenOdd, FillRule{2}, FillRule{255})
VALUES(PaintMode, PaintMode::fill, PaintMode::replace, PaintMode{2}, PaintMode{255})
VALUES(Error, {ErrorCode::overlap}, {ErrorCode{0}},
       {ErrorCode::overlap, {kLeast, kMost}, kLeast, kLeast, kLeast, kLeast},
       {ErrorCode::overlap, {0, 0}, kMost, kMost, kMost, kMost, {1, 1}, 1, {1}, kMost, kMost},
       {ErrorCode::staleHandle, {0, 0}, 0, 0, 0, 0, {1, 1}, 1, {1}, 0, 0}, {ErrorCode::staleHandle},
       {ErrorCode{0xffff'ffff}})
VALUES(lgs_error, {LGS_OVERLAP, {0, 0}, 0, 0, 0, 0, {1, 1}, 1, {1}, 0, 0, 0, {0, 0, 0}}, {},
       {LGS_SAVE_CUT, {}, 0, 0, 0, 0, {}, 0, {}, 0, UINT64_MAX, 0, {}},
       {kLeast, {}, 0, 0, 0, 0, {}, 0, {}, 0, 0, 0, {}},
       {kMost, {}, kMost, kMost, kMost, kMost, {}, 0, {}, kMost, 0, kMost, {1, 1, 1}},
       {99, {}, 0, 0, 0, 0, {}, 0, {}, 0, 0, 0, {}}, {210, {}, 0, 0, 0, 0, {}, 0, {}, 0, 0, 0, {}})
VALUES(SnapshotError, {SnapshotError::What::cut, 7}, {SnapshotError::What{10}, ~std::uint64_t{0}},
       {SnapshotError::What{~std::uint64_t{0}}, 0})
VALUES(Segment, Segment{{1}, {0, 0}, {65'536, 0}, {}, {}, {}, {}, 0, {}, {}}, Segment{},
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

// --- In words

namespace {

template <class Numbers>
std::string listed(const Numbers& numbers) {
  return fmt::format("({})", fmt::join(numbers, ", "));
}

}  // namespace

std::string Hostile<bool>::told(const bool& v) { return v ? "true" : "false"; }
std::string Hostile<int>::told(const int& v) { return fmt::format("{}", v); }
std::string Hostile<std::uint32_t>::told(const std::uint32_t& v) { return fmt::format("{}", v); }
std::string Hostile<std::int64_t>::told(const std::int64_t& v) { return fmt::format("{}", v); }
std::string Hostile<std::uint64_t>::told(const std::uint64_t& v) { return fmt::format("{}", v); }
std::string Hostile<double>::told(const double& v) { return fmt::format("{}", v); }
std::string Hostile<Cell>::told(const Cell& v) { return listed(std::vector{v.i, v.j}); }
std::string Hostile<CellRect>::told(const CellRect& v) {
  return fmt::format("{} to {}", Hostile<Cell>::told(v.min), Hostile<Cell>::told(v.max));
}
std::string Hostile<Point>::told(const Point& v) { return listed(std::vector{v.x, v.y}); }
std::string Hostile<LocalPoint>::told(const LocalPoint& v) { return listed(std::vector{v.x, v.y}); }
std::string Hostile<DoublePoint>::told(const DoublePoint& v) { return listed(std::vector{v.x, v.y}); }
std::string Hostile<ShapeId>::told(const ShapeId& v) { return fmt::format("shape {}", v.value); }
std::string Hostile<PolygonHandle>::told(const PolygonHandle& v) { return fmt::format("{}:{}", v.cellRef, v.serial); }
std::string Hostile<SegmentId>::told(const SegmentId& v) { return fmt::format("segment {}", v.value); }
std::string Hostile<Mark>::told(const Mark& v) { return fmt::format("mark {}", v.value); }
std::string Hostile<lgs_mark>::told(const lgs_mark& v) { return fmt::format("mark {}", v.value); }
std::string Hostile<Room>::told(const Room& v) { return fmt::format("room {}", v.size); }
std::string Hostile<Given>::told(const Given& v) { return v.isGiven ? "given" : "NULL"; }
std::string Hostile<Said>::told(const Said& v) { return fmt::format("count {}", v.count); }
std::string Hostile<ErrorCode>::told(const ErrorCode& v) { return fmt::format("code {}", static_cast<unsigned>(v)); }
std::string Hostile<Collinear>::told(const Collinear& v) { return v == Collinear::keep ? "keep" : "merge"; }
std::string Hostile<Undone>::told(const Undone& v) { return fmt::format("undone {}", static_cast<unsigned>(v)); }
std::string Hostile<SvgOverlay>::told(const SvgOverlay& v) {
  return fmt::format("{} by {} from {}", v.over, v.cellsPerUnit, Hostile<Cell>::told(v.origin));
}
std::string Hostile<FillRule>::told(const FillRule& v) { return fmt::format("rule {}", static_cast<unsigned>(v)); }
std::string Hostile<PaintMode>::told(const PaintMode& v) { return fmt::format("mode {}", static_cast<unsigned>(v)); }
std::string Hostile<Error>::told(const Error& v) { return fmt::format("error {}", static_cast<unsigned>(v.code)); }
std::string Hostile<lgs_error>::told(const lgs_error& v) { return fmt::format("error {}", v.code); }
std::string Hostile<SnapshotError>::told(const SnapshotError& v) {
  return fmt::format("error {}", static_cast<std::uint64_t>(v.what));
}
std::string Hostile<Segment>::told(const Segment& v) {
  return fmt::format("{} → {}", Hostile<Point>::told(v.start), Hostile<Point>::told(v.end));
}

}  // namespace lgs::test
