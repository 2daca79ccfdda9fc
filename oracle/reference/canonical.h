// The canonical form of closed chains: equal exactly if two outlines have the same boundaries and the same adjacency,
// however they are cut.
#pragma once

#include "oracle/reference/outline.h"

#include <optional>
#include <vector>

namespace lgs::oracle {

/// Closed chains, each as its vertices in order; the last leads back to the first.
using Loops = std::vector<std::vector<Point>>;

/// The chains of an outline, found by following each segment's successor. Nothing if they do not close: where a segment
/// has no successor or no predecessor, one that is not there, or where successor and predecessor are not mutual. (With
/// an empty preserve relation all outlines close.) The outline must be sorted.
std::optional<Loops> followLinks(const Outline& outline);

/// Drops the vertices of degree 2 (visited once by all loops together) in straight runs, starts every loop at its
/// lexicographically least rotation and sorts the loops.
Loops canonical(Loops loops);

}  // namespace lgs::oracle
