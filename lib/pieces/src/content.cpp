#include "content.h"

#include "geometry/sort.h"

#include <algorithm>
#include <utility>

namespace lgs::pieces {
namespace {

/// The sides that the edges of a piece lie on: at most one edge on each, since no three vertices are on a line.
void addOpenings(std::array<std::vector<Opening>, detail::kSides>& openings, const Ring& ring, Index piece) {
  LocalPoint a = ring.back();
  for (const LocalPoint b : ring) {
    for (unsigned side = 0; side < detail::kSides; ++side) {
      const auto [low, high] = std::minmax({detail::along(side, a), detail::along(side, b)});
      if (a == detail::pointAt(side, detail::along(side, a)) && b == detail::pointAt(side, detail::along(side, b)))
        openings[side].push_back({low, high, piece});
    }
    a = b;
  }
}

bool areAlike(std::span<const Piece> a, std::span<const Piece> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Piece& p, const Piece& q) {
    return p.polygon == q.polygon &&
           std::equal(p.vertices.begin(), p.vertices.end(), q.vertices.begin(), q.vertices.end());
  });
}

}  // namespace

Content::Content(std::span<const Ring> polygons, std::size_t maxVertices)
    : parts(convexParts(triangulate(polygons), maxVertices)) {
  for (const ConvexParts::Part& part : parts.parts)
    (part.label == kFree ? free : solid).push_back({part.label, part.vertices});
  const auto solids = static_cast<Index>(solid.size());  // free ones come last
  for (const Contact& c : parts.contacts)
    if (c.piece >= solids) contacts.push_back({c.piece - solids, c.other - solids, c.from, c.to});
  for (Index k = 0; k < free.size(); ++k) addOpenings(openings, parts.parts[solids + k].vertices, k);
  for (std::vector<Opening>& side : openings)
    detail::sort(side, [](const Opening& a, const Opening& b) { return a.low < b.low; });
}

bool samePieces(const Content& a, const Content& b) { return areAlike(a.solid, b.solid) && areAlike(a.free, b.free); }

}  // namespace lgs::pieces
