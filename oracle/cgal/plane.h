// The plane that closed curves of straight pieces cut into faces, and how often each curve runs around each face. All of
// it is exact: where pieces cross is computed in rational numbers.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <lgs/lattice.h>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace lgs::oracle::plane {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = Kernel::Point_2;

inline ExactPoint exact(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

/// Closed curves by number, each in pieces. What runs to and fro is no curve.
class Curves {
 public:
  void add(std::size_t curve, Point from, Point to);
  void addRing(std::size_t curve, const std::vector<Point>& ring);

  using Counts = std::map<std::size_t, int>;  ///< curve, how often it runs there
  /// Each piece from its lesser end.
  const std::map<std::pair<Point, Point>, Counts>& pieces() const { return pieces_; }

 private:
  std::map<std::pair<Point, Point>, Counts> pieces_;
};

struct Triangle {
  std::array<ExactPoint, 3> corners;
  std::size_t face = 0;
};

/// A part of a piece, between two faces.
struct Border {
  ExactPoint from, to;  ///< from < to
  std::size_t left = 0, right = 0;
  std::vector<std::size_t> curves;  ///< that run there
};

struct Faces {
  std::vector<std::vector<int>> windings;  ///< of each face around each curve; face 0 is the outside
  std::vector<Triangle> triangles;         ///< of the faces, as far as they lie between the curves
  std::vector<Border> borders;
};

/// The faces of so many curves.
Faces facesOf(const Curves& curves, std::size_t count);

}  // namespace lgs::oracle::plane
