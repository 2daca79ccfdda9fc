// What bodies weigh, and how they come back into the ground.
#include "exact.h"

#include <lgs/body.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace lgs {
namespace {

using detail::Exact;

/// Sums over polygons, exact, from which all else follows. A polygon is in a cell (i, j), whose corner is (U·i, U·j)
/// for U units a cell; x and y are counted from that corner. Area, moments of it and so on are in units.
struct Sums {
  Int128 a;    ///< 2 × area
  Int128 ai;   ///< 2 × area × i
  Int128 aj;   ///< 2 × area × j
  Int128 aii;  ///< 2 × area × (i² + j²)
  Int128 x;    ///< 6 × ∫x
  Int128 y;    ///< 6 × ∫y
  Int128 xi;   ///< 6 × (i × ∫x + j × ∫y)
  Int128 xx;   ///< 12 × ∫(x² + y²)

  void add(const BodyPolygon& p);
};

/// Of what no world hands out the sums could overflow.
bool isOfAWorld(const BodyPolygon& p) {
  constexpr std::int32_t kBeyond = std::numeric_limits<std::int32_t>::min();
  return p.cell.i != kBeyond && p.cell.j != kBeyond && p.vertices.size() <= kMaxVerticesPerCell &&
         std::ranges::all_of(p.vertices, [](LocalPoint v) {
           return v.x >= 0 && v.y >= 0 && v.x <= kUnitsPerCell && v.y <= kUnitsPerCell;
         });
}

void Sums::add(const BodyPolygon& p) {
  if (!isOfAWorld(p)) return;
  std::int64_t area = 0, mx = 0, my = 0;
  Int128 squares;
  for (std::size_t k = 0; k < p.vertices.size(); ++k) {
    const LocalPoint u = p.vertices[k], v = p.vertices[k + 1 == p.vertices.size() ? 0 : k + 1];
    const std::int64_t ux = u.x, uy = u.y, vx = v.x, vy = v.y;
    const std::int64_t cross = ux * vy - uy * vx;
    area += cross;
    mx += cross * (ux + vx);
    my += cross * (uy + vy);
    squares += multiply(cross, ux * ux + ux * vx + vx * vx + uy * uy + uy * vy + vy * vy);
  }
  if (area <= 0) return;
  const std::int64_t i = p.cell.i, j = p.cell.j;
  a += Int128(area);
  ai += multiply(area, i);
  aj += multiply(area, j);
  aii += multiply(area, i * i + j * j);
  x += Int128(mx);
  y += Int128(my);
  xx += squares;
  xi += multiply(mx, i) + multiply(my, j);
}

/// 6 × ∫ of a coordinate over all, counted from the body's origin.
Int128 firstMoment(Int128 cells, Int128 local) {
  for (int k = 0; k < kCellBits; ++k) cells += cells;
  return cells + cells + cells + local;
}

double signedRatio(Int128 a, const Exact& b) {
  const double magnitude = Exact::ratio(Exact::of(a), b);
  return a.isNegative() ? -magnitude : magnitude;
}

}  // namespace

MassOfPolygons massOf(const std::vector<BodyPolygon>& polygons) noexcept {
  Sums s;
  for (const BodyPolygon& p : polygons) s.add(p);
  if (s.a == Int128(0)) return {};
  const Exact a = Exact::of(s.a), one(1), three(3);
  const Int128 mx = firstMoment(s.ai, s.x), my = firstMoment(s.aj, s.y);
  // 12 × ∫(X² + Y²), of which only one part may be negative, and the whole is not.
  Exact polar = (Exact(6) * Exact::of(s.aii) << 2 * kCellBits);
  polar += Exact::of(s.xx);
  const Exact mixed = Exact::of(s.xi) << (kCellBits + 2);
  if (s.xi.isNegative())
    polar -= mixed;
  else
    polar += mixed;
  // About the centroid: (3 × polar × a - 2 × (mx² + my²)) / (36 × a).
  Exact central = three * polar * a;
  Exact squares = Exact::of(mx) * Exact::of(mx);
  squares += Exact::of(my) * Exact::of(my);
  central -= squares << 1;
  const Exact scale = three * a << kCellBits;
  return {.area = Exact::ratio(a, one << (2 * kCellBits + 1)),
          .centroid = {signedRatio(mx, scale), signedRatio(my, scale)},
          .secondMoment = Exact::ratio(central, Exact(36) * a << 4 * kCellBits)};
}

Expected<std::vector<PolygonHandle>> put(World& world, const Body& body, Cell cell) noexcept {
  Transaction group = world.edit();
  std::vector<PolygonHandle> handles;
  for (std::size_t k = 0; k < body.polygons.size(); ++k) {
    const BodyPolygon& p = body.polygons[k];
    const std::int64_t i = std::int64_t{cell.i} + p.cell.i, j = std::int64_t{cell.j} + p.cell.j;
    // A cell that no number of 32 bits can name is as far out of range as the last one that it can.
    const auto named = [](std::int64_t n) {
      return static_cast<std::int32_t>(std::clamp<std::int64_t>(n, -kMaxCell - 1, kMaxCell + 1));
    };
    const auto placed = world.add({named(i), named(j)}, std::span<const LocalPoint>(p.vertices), p.block);
    if (!placed) {
      Error error = placed.error();
      error.index = static_cast<std::int32_t>(k);
      if (const auto own = std::ranges::find(handles, error.other); own != handles.end()) {
        error.index2 = static_cast<std::int32_t>(own - handles.begin());
        error.other = {};  // it is undone
      }
      return tl::unexpected(error);
    }
    handles.push_back(*placed);
  }
  group.keep();
  return handles;
}

}  // namespace lgs
