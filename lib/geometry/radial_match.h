// Phase 2 as a pure function: law 2 on the half-edges around one vertex.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace lgs::detail {

inline constexpr std::uint32_t kMaxDirection = (1u << 31) - 1;

/// A half-edge at a vertex: a segment that starts there (outgoing) or ends there (incoming).
struct Spoke {
  std::uint32_t segment = 0;
  std::uint32_t direction : 31 = 0;  ///< equal exactly for two spokes of one fan that point the same way
  std::uint32_t outgoing : 1 = 0;
};
static_assert(sizeof(Spoke) == 8);

/// What was passed so far on a turn around a vertex: the last half-edge, and the last one before it that points another
/// way.
class Passed {
 public:
  explicit Passed(std::uint32_t none) : last_(none), before_(none) {}

  void pass(const Spoke& spoke) {
    if (spoke.direction != direction_) before_ = last_;
    last_ = spoke.segment;
    direction_ = spoke.direction;
  }
  /// The last one that does not point this way.
  std::uint32_t besides(std::uint32_t direction) const { return direction == direction_ ? before_ : last_; }

 private:
  std::uint32_t last_, before_;
  std::uint32_t direction_ = kMaxDirection + 1;  // no spoke has it
};

/// The fan is the spokes around one vertex, counter-clockwise, coincident ones side by side. Calls
/// `predecessor(segment, other)` for every outgoing spoke, with the incoming one met first when turning clockwise, and
/// `successor(segment, other)` for every incoming spoke, with the outgoing one met first when turning
/// counter-clockwise. `other` is `none` if there is no candidate. Cost: O(n).
template <class Predecessor, class Successor>
void radialMatch(std::span<const Spoke> fan, std::uint32_t none, Predecessor&& predecessor, Successor&& successor) {
  // What is met first clockwise is what was met last counter-clockwise, and the other way around. The first of two
  // turns only shows what lies before the spoke that the second one begins with.
  Passed incoming(none), outgoing(none);
  for (const bool isFirst : {true, false}) {
    for (const Spoke& spoke : fan) {
      if (!spoke.outgoing)
        incoming.pass(spoke);
      else if (!isFirst)
        predecessor(spoke.segment, incoming.besides(spoke.direction));
    }
    for (std::size_t k = fan.size(); k-- > 0;) {
      if (fan[k].outgoing)
        outgoing.pass(fan[k]);
      else if (!isFirst)
        successor(fan[k].segment, outgoing.besides(fan[k].direction));
    }
  }
}

/// The same if nothing is preserved. Then solids do not overlap and their common edges are gone. So free and solid
/// sectors alternate around the vertex, and incoming and outgoing spokes with them. An outgoing spoke and the incoming
/// one before it bound one free sector: calls link(incoming, outgoing) for each such pair. No branch depends on the
/// spokes, as on random terrain the processor could not foresee it.
template <class Link>
void radialMatchAlternating(std::span<const Spoke> fan, Link&& link) {
  if (fan.empty()) return;
  const std::size_t first = fan[0].outgoing;  // fan[first] is incoming
  const std::size_t n = fan.size();
  for (std::size_t k = first; k + 1 < n; k += 2) link(fan[k].segment, fan[k + 1].segment);
  if (first == 1) link(fan[n - 1].segment, fan[0].segment);
}

}  // namespace lgs::detail
