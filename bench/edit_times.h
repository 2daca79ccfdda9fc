// Sequences of single edits, the same for every subject, each edit timed by itself.
//
// An edit comes back: the cell that was dug is refilled, the one that was given another content gets its own again,
// `lag` edits later. So the world is the same in the end, and almost the same all the time; and a cell is not edited
// while all it needs is still in the cache from just before, unless the lag says so.
#pragma once

#include "bench/sample.h"
#include "bench/subjects/subject.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace lgs::bench {

enum class Where {
  anywhere,  ///< each cell at random in the whole world: nothing is in the cache
  nearby,    ///< each cell some cells from the one before, as a player digs
};

struct EditPlan {
  std::vector<std::uint32_t> cells;  ///< none occurs again while it is away
  std::size_t lag = 0;
};

/// Of cells that are not empty. `count` edits and as many that undo them.
EditPlan planEdits(const Tiles& tiles, std::size_t count, Where where, std::uint64_t seed);

/// Cells that are not empty, anywhere, none twice.
std::vector<std::uint32_t> distinctCells(const Tiles& tiles, std::size_t count, std::uint64_t seed);

struct EditTimes {
  Sample first;  ///< removing, or replacing by another kind
  Sample back;   ///< adding, or replacing by the original kind
};

/// Removes and adds. `afterEdit`, if given, is called after each edit, outside its time.
void timeRemovesAndAdds(Incremental& subject, const Tiles& tiles, const EditPlan& plan, EditTimes& times,
                        const std::function<void()>& afterEdit = {});

/// Replaces by another kind that is not empty, and back.
void timeReplaces(Incremental& subject, const Tiles& tiles, const EditPlan& plan, EditTimes& times,
                  const std::function<void()>& afterEdit = {});

}  // namespace lgs::bench
