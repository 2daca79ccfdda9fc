// Sequences of single edits, the same for every subject. Each edit is timed by itself.
//
// Each edit is undone `lag` edits later: a cell that was dug is refilled, one with another content gets its own again.
// So the world is the same in the end, and almost the same all the time. With a long lag, the memory that undoing an
// edit needs has left the cache again.
#pragma once

#include "bench/subjects/subject.h"
#include "bench/times.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace lgs::bench {

enum class Where {
  anywhere,  ///< each cell is random in the whole world, so nothing is in the cache
  nearby,    ///< each cell is some cells from the one before, as a player digs
};

struct EditPlan {
  std::vector<std::uint32_t> cells;  ///< no cell occurs again before it is back
  std::size_t lag = 0;
};

/// Plans `count` edits, and as many that undo them, in cells that are not empty.
EditPlan planEdits(const Tiles& tiles, std::size_t count, Where where, std::uint64_t seed);

/// Picks random cells that are not empty, none twice.
std::vector<std::uint32_t> distinctCells(const Tiles& tiles, std::size_t count, std::uint64_t seed);

struct EditTimes {
  Times first;  ///< removing
  Times back;   ///< adding
};

/// Removes and adds. `afterEdit` is called after each edit, and is not timed.
void timeRemovesAndAdds(Incremental& subject, const Tiles& tiles, const EditPlan& plan, EditTimes& times,
                        const std::function<void()>& afterEdit = {});

}  // namespace lgs::bench
