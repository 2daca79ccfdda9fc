// Islands over the edge of memory, found the slow way: all polygons of a world of which nothing is ever unloaded, and
// which of its chunks another world has unloaded.
#pragma once

#include "oracle/views/touching.h"

#include <lgs/islands.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace lgs::test {

/// Holds a view of a world with unloaded chunks against a world with the same ground that has all of them, and what it
/// tells against the definitions in <lgs/islands.h>.
class BeyondCheck {
 public:
  explicit BeyondCheck(IsAnchor isAnchor) : isAnchor_(std::move(isAnchor)) {}

  /// What is wrong with a view; nothing, if nothing is.
  std::string begin(const World& part, const World& whole, const Islands& islands);
  /// The same, and with its changes, after an update.
  std::string update(const World& part, const World& whole, const Islands& islands);

 private:
  struct Moment {
    std::vector<oracle::ScenePolygon> polygons;
    std::vector<IslandId> islandOf;  ///< of each polygon
    std::map<IslandId, IslandFacts> known;
    std::set<Cell> away;   ///< the lower-left cells of unloaded chunks with ground
    std::set<Cell> empty;  ///< and of those near without
  };
  struct Kin {
    std::set<IslandId> olds, news;
    bool isBeyond = false;
  };

  std::string read(const World& part, const World& whole, const Islands& islands, Moment& out) const;
  std::vector<Kin> kinOf(const Moment& now, bool withEmpty) const;
  std::string compare(const Islands& islands, const Moment& now, bool withEmpty) const;

  IsAnchor isAnchor_;
  Moment before_;
};

}  // namespace lgs::test
