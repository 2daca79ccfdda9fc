// Fans of half-edges around a vertex, and law 2 on them, word for word, on integer vectors.
#pragma once

#include "oracle/reference/vector.h"
#include "proptests/support/arbitrary.h"

#include <iosfwd>
#include <optional>
#include <vector>

namespace lgs::test {

/// A segment as seen from one of its ends.
struct HalfEdge {
  oracle::Vector towards;  ///< from the vertex to the other end
  bool isOutgoing = false;
  friend bool operator==(const HalfEdge&, const HalfEdge&) = default;
};

bool pointAlike(const HalfEdge& a, const HalfEdge& b);

/// In any order, unless it is said otherwise; no two that are both outgoing or both incoming point alike.
using HalfEdges = std::vector<HalfEdge>;

/// The one of the other kind met first, turning clockwise from an outgoing one and counter-clockwise from an incoming
/// one. Those that point alike are skipped.
std::optional<HalfEdge> metFirst(const HalfEdges& around, const HalfEdge& from);

/// Any half-edges in counter-clockwise order, beginning anywhere: even between two that point alike.
struct Fan {
  HalfEdges edges;
  static rc::Gen<Fan> arbitrary();
};
void showValue(const Fan& fan, std::ostream& out);

}  // namespace lgs::test
