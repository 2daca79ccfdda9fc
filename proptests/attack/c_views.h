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

template <>
struct Hostile<WorldOfC> {
  static const std::vector<WorldOfC>& values(Scene&) {
    static const std::vector<WorldOfC> all{{WorldOfC::own}, {WorldOfC::other}, {WorldOfC::none}};
    return all;
  }
  static std::string told(const WorldOfC& v) { return fmt::format("world {}", static_cast<int>(v.which)); }
};

template <>
struct Hostile<ListOfC> {
  static const std::vector<ListOfC>& values(Scene&) {
    static const std::vector<ListOfC> all{{0}, {1}, {2}, {3}, {4}, {5}, {-1}, {kLeast}, {kMost}};
    return all;
  }
  static std::string told(const ListOfC& v) { return fmt::format("list {}", v.number); }
};

inline lgs_islands* islandsOf(const FollowedC& f, Given given) { return given.isGiven ? f.islands.get() : nullptr; }

/// Its own island, or a number.
inline lgs_island_id islandOf(const FollowedC& f, std::uint32_t number) {
  return number == 1 ? f.anIsland() : lgs_island_id{number};
}

}  // namespace lgs::test
