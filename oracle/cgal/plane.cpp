#include "oracle/cgal/plane.h"

#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <algorithm>
#include <limits>

namespace lgs::oracle::plane {
namespace {

using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<std::size_t, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, FaceBase>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_triangulation_2<Kernel, Structure, CGAL::Exact_intersections_tag>>;
using Face = Triangulation::Face_handle;
using CountsOf = std::map<Triangulation::Constraint_id, const Curves::Counts*>;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// The ends of a side of a triangle that lies on its left.
std::pair<Triangulation::Vertex_handle, Triangulation::Vertex_handle> endsOf(Face face, int side) {
  return {face->vertex(Triangulation::ccw(side)), face->vertex(Triangulation::cw(side))};
}

// Across a side, to the right of what runs along it.
std::vector<int> across(std::vector<int> windings, const Triangulation& plane, const CountsOf& countsOf, Face face,
                        int side) {
  const auto [from, to] = endsOf(face, side);
  const int sign = from->point() < to->point() ? 1 : -1;
  for (auto at = plane.contexts_begin(from, to); at != plane.contexts_end(from, to); ++at)
    for (const auto& [curve, count] : *countsOf.at(at->id())) windings[curve] -= sign * count;
  return windings;
}

void flood(Triangulation& plane, const CountsOf& countsOf, std::vector<std::vector<int>>& windings) {
  for (const Face face : plane.all_face_handles()) face->info() = kNone;
  std::vector<std::pair<Face, std::vector<int>>> found{{plane.infinite_face(), std::move(windings[0])}};
  windings.clear();
  while (!found.empty()) {
    const auto [first, here] = std::move(found.back());
    found.pop_back();
    if (first->info() != kNone) continue;
    std::vector<Face> same{first};
    while (!same.empty()) {
      const Face face = same.back();
      same.pop_back();
      if (face->info() != kNone) continue;
      face->info() = windings.size();
      for (int side = 0; side < 3; ++side) {
        const Face next = face->neighbor(side);
        if (next->info() != kNone) continue;
        if (!face->is_constrained(side))
          same.push_back(next);
        else
          found.emplace_back(next, across(here, plane, countsOf, face, side));
      }
    }
    windings.push_back(here);
  }
}

}  // namespace

void Curves::add(std::size_t curve, Point from, Point to) {
  if (from == to) return;
  pieces_[std::minmax(from, to)][curve] += from < to ? 1 : -1;
}

void Curves::addRing(std::size_t curve, const std::vector<Point>& ring) {
  for (std::size_t k = 0; k < ring.size(); ++k) add(curve, ring[k], ring[(k + 1) % ring.size()]);
}

Faces facesOf(const Curves& curves, std::size_t count) {
  Triangulation plane;
  CountsOf countsOf;
  for (const auto& [ends, counts] : curves.pieces()) {
    const auto runs = [](const auto& entry) { return entry.second != 0; };
    if (std::ranges::any_of(counts, runs))
      countsOf[plane.insert_constraint(exact(ends.first), exact(ends.second))] = &counts;
  }
  Faces faces{{std::vector<int>(count, 0)}, {}, {}};
  if (plane.dimension() < 2) return faces;
  flood(plane, countsOf, faces.windings);
  for (const Face face : plane.finite_face_handles())
    faces.triangles.push_back(
        {{face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point()}, face->info()});
  for (const auto& [face, side] : plane.constrained_edges()) {
    const auto [from, to] = endsOf(face, side);
    Border border{from->point(), to->point(), face->info(), face->neighbor(side)->info(), {}};
    for (auto at = plane.contexts_begin(from, to); at != plane.contexts_end(from, to); ++at)
      for (const auto& entry : *countsOf.at(at->id())) border.curves.push_back(entry.first);
    if (border.to < border.from) {
      std::swap(border.from, border.to);
      std::swap(border.left, border.right);
    }
    faces.borders.push_back(std::move(border));
  }
  return faces;
}

}  // namespace lgs::oracle::plane
