// Phase 2 at a corner of the grid, where nothing is preserved.
#pragma once

#include "outline/layout.h"
#include "outline/segment_pool.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace lgs::detail {

/// Goes counter-clockwise around a corner, from cell to cell. Solids do not overlap, and their common edges are gone.
/// So free and solid wedges take turns, and incoming and outgoing half-edges with them. A free wedge begins with an
/// incoming one and ends with the next outgoing one, which is its link. A wedge inside a cell is linked already. So of
/// each cell only two half-edges count: the first, if it ends a wedge; and the last, if one begins there.
///
/// No branch depends on the half-edges, as on random terrain the processor could not foresee it.
class Turn {
 public:
  Turn() { wedges_[0].incoming = kNoSegment; }  // close() reads it, also if no cell was passed

  /// The next cell, which has few segments. To it the vertex is corner q.
  template <unsigned q>
  void pass(CellSegments shown) {
    const std::uint32_t first = shown.layout().firstAt(q), last = shown.layout().lastAt(q);
    wedges_[count_] = {begins_, shown.at(first)};
    count_ += first != 0 ? 1 : 0;
    const std::uint32_t isThere = 0u - (last != 0 ? 1u : 0u);  // compilers make a branch of a conditional here
    begins_ = (shown.at(last) & isThere) | (begins_ & ~isThere);
  }

  /// Back at the first cell: calls link(incoming, outgoing) for each free wedge.
  template <class Link>
  void close(Link&& link) {
    wedges_[0].incoming = wedges_[0].incoming != kNoSegment ? wedges_[0].incoming : begins_;
    for (std::size_t k = 0; k < count_; ++k) link(wedges_[k].incoming, wedges_[k].outgoing);
  }

 private:
  struct Wedge {
    std::uint32_t incoming, outgoing;
  };
  std::array<Wedge, 5> wedges_;  ///< one that is not counted is written, and not read
  std::size_t count_ = 0;
  std::uint32_t begins_ = kNoSegment;  ///< with this half-edge the wedge begins that is not closed yet
};

}  // namespace lgs::detail
