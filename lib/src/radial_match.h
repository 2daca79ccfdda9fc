// Phase 2 as a pure function: law 2 on the half-edges around one vertex.
#pragma once

#include <cstdint>
#include <span>

namespace lgs::detail {

/// A half-edge at a vertex: a segment that starts there (outgoing) or ends there (incoming).
struct Spoke {
  std::uint32_t segment = 0;
  std::uint32_t direction = 0;  ///< equal exactly where two spokes of one fan point the same way
  bool outgoing = false;
};

/// The spokes around one vertex in counter-clockwise order, coincident ones side by side. Calls
/// `predecessor(segment, other)` for every outgoing spoke and `successor(segment, other)` for every incoming one, with
/// the segment met first when turning clockwise and counter-clockwise respectively; `none` where there is no candidate.
///
/// Under the empty preserve relation incoming and outgoing spokes alternate, so the first spoke looked at is the match
/// and the cost is linear.
template <class Predecessor, class Successor>
void radialMatch(std::span<const Spoke> fan, std::uint32_t none, Predecessor&& predecessor, Successor&& successor) {
  const std::size_t n = fan.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Spoke& spoke = fan[k];
    std::uint32_t match = none;
    for (std::size_t step = 1, at = k; step < n; ++step) {
      at = spoke.outgoing ? (at == 0 ? n - 1 : at - 1) : (at + 1 == n ? 0 : at + 1);
      if (fan[at].outgoing == spoke.outgoing || fan[at].direction == spoke.direction) continue;
      match = fan[at].segment;
      break;
    }
    if (spoke.outgoing)
      predecessor(spoke.segment, match);
    else
      successor(spoke.segment, match);
  }
}

}  // namespace lgs::detail
