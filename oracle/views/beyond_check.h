// Islands over the edge of memory, found the slow way: from all polygons of the ground, unloaded or not, and from which of
// its chunks are unloaded.
#pragma once

#include "oracle/reference/scene.h"

#include <lgs/islands.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace lgs::oracle {

/// Ground as it is, whether it is in memory or not.
struct WholeGround {
  std::vector<ScenePolygon> polygons;
  std::set<Cell> away;            ///< the lower-left cells of unloaded chunks, those without ground included
  std::set<Cell> forgotten = {};  ///< and of those that were unloaded at the last update, and were forgotten since
};

/// Holds a view of a world with unloaded chunks against all of the ground, and what it tells against the definitions in
/// <lgs/islands.h>.
class BeyondCheck {
 public:
  explicit BeyondCheck(IsAnchor isAnchor) : isAnchor_(std::move(isAnchor)) {}

  /// What is wrong with a view; nothing, if nothing is.
  std::string begin(const World& part, const WholeGround& whole, const Islands& islands);
  /// The same, and with its changes if these are to be `isTold`, after an update.
  std::string update(const World& part, const WholeGround& whole, const Islands& islands, bool isTold = true);

 private:
  struct Moment {
    std::vector<ScenePolygon> polygons;
    std::vector<IslandId> islandOf;  ///< of each polygon
    std::map<IslandId, IslandFacts> known;
    std::set<Cell> away;   ///< the lower-left cells of unloaded chunks with ground
    std::set<Cell> empty;  ///< and of those without, or that were forgotten: they may count or not
    std::set<Cell> forgotten;
  };
  struct Kin {
    std::set<IslandId> olds, news;
    bool isBeyond = false;
  };

  std::string read(const World& part, const WholeGround& whole, const Islands& islands, Moment& out) const;
  static bool stands(const ScenePolygon& p, const Moment& now);
  bool isLost(const ScenePolygon& p, const Moment& now) const;
  std::vector<Cell> mayCount(const Moment& now) const;
  std::vector<Kin> kinOf(const Moment& now, const std::set<Cell>& counting) const;
  std::string compare(const Islands& islands, const Moment& now, const std::set<Cell>& counting) const;

  IsAnchor isAnchor_;
  Moment before_;
};

}  // namespace lgs::oracle
