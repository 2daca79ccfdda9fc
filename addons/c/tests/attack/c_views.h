// What doors of views of the C interface share.
#pragma once

#include "c_values.h"
#include "followed.h"

namespace lgs::test {

/// A world that a view is handed.
struct WorldOfC {
  enum { own, other, none } which = own;
  lgs_world* operator()(const FollowedC& f) const {
    return which == own ? f.world.get() : which == other ? f.other.get() : nullptr;
  }
};

/// The number of a list, or of a kind of pieces.
struct ListOfC {
  std::int32_t number = 0;
};

LGS_VALUES(WorldOfC, fmt::format("world {}", static_cast<int>(v.which)), {WorldOfC::own}, {WorldOfC::other},
           {WorldOfC::none})
LGS_VALUES(ListOfC, fmt::format("list {}", v.number), {0}, {1}, {2}, {3}, {4}, {5}, {-1}, {kLeast}, {kMost})

inline lgs_islands* islandsOf(const FollowedC& f, Given given) { return given ? f.islands.get() : nullptr; }

/// Its own island, or a number.
inline lgs_island_id islandOf(const FollowedC& f, std::uint32_t number) {
  return number == 1 ? f.anIsland() : lgs_island_id{number};
}

}  // namespace lgs::test
