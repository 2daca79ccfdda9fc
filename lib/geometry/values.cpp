// What the public value types work out.
#include <lgs/questions.h>
#include <lgs/segment.h>
#include <lgs/version.h>

#include <cmath>

namespace lgs {

Version version() { return kVersion; }

Point latticePoint(DoublePoint position) {
  const auto nearest = [](double cells) {
    constexpr auto kMost = static_cast<double>(kMaxCoordinate);
    const double units = std::round(cells * kUnitsPerCell);
    return units >= -kMost && units <= kMost ? static_cast<std::int64_t>(units) : kMaxCoordinate + 1;
  };
  return {nearest(position.x), nearest(position.y)};
}

// In the range of a world all of this is exact but for the root, which is rounded once and everywhere alike.
// std::hypot() is not.
double Segment::length() const {
  const double x = static_cast<double>(end.x) - static_cast<double>(start.x);
  const double y = static_cast<double>(end.y) - static_cast<double>(start.y);
  return std::sqrt(x * x + y * y) / kUnitsPerCell;
}

DoublePoint Segment::normal() const {
  const double x = static_cast<double>(end.y) - static_cast<double>(start.y);
  const double y = static_cast<double>(start.x) - static_cast<double>(end.x);
  const double length = std::sqrt(x * x + y * y);
  return {x / length, y / length};
}

}  // namespace lgs
