// The links of an outline as turns at vertices.
#pragma once

#include "oracle/reference/outline.h"

#include <vector>

namespace lgs::oracle::drawing {

/// A turn of a chain, which arrives along from→at and goes on along at→to.
struct Link {
  Point from;
  Point at;
  Point to;
  friend auto operator<=>(const Link&, const Link&) = default;
};

struct Links {
  std::vector<Link> mutual;    ///< both segments name each other
  std::vector<Link> oneSided;  ///< only one names the other, which a preserve relation allows
};

/// All links that the segments name by their ghosts: each once, sorted.
Links linksOf(const Outline& outline);

}  // namespace lgs::oracle::drawing
