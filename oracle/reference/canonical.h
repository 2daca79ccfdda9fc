// The canonical form of closed chains. It is the same for two outlines exactly if they have the same boundaries and the
// same adjacency, however their edges are cut.
#pragma once

#include "oracle/reference/outline.h"

#include <optional>
#include <vector>

namespace lgs::oracle {

/// Closed chains, each as its vertices in order; the last leads back to the first.
using Loops = std::vector<std::vector<Point>>;

/// Follows each segment's successor and returns the chains. Returns nothing if a chain does not close, because a link
/// is missing, leads to no segment of the outline, or is not mutual. (With an empty preserve relation all chains
/// close.) The outline must be sorted.
std::optional<Loops> followLinks(const Outline& outline);

/// Drops the vertices of degree 2 (visited once by all loops together) in straight runs, starts every loop at its
/// lexicographically least rotation and sorts the loops.
Loops canonical(Loops loops);

}  // namespace lgs::oracle
