// Which edits of a trace get a step of their own on the page.
#pragma once

#include "oracle/page/page.h"

#include <lgs/lattice.h>
#include <optional>
#include <vector>

namespace lgs::oracle::paging {

struct Excerpt {
  enum class Part : char {
    hidden,  ///< in none of the cells
    early,   ///< shown together with others, as the world in which the page begins
    step
  };
  std::vector<Part> parts;        ///< for each edit that was played
  std::optional<CellRect> cells;  ///< the only ones to be shown; nothing: all
};

/// All edits of a trace of usual length. Of a longer one those in the cells around its end, and the last of these one
/// by one.
Excerpt excerptOf(const Trace& trace, const std::optional<PageEnd>& end);

}  // namespace lgs::oracle::paging
