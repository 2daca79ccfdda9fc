// Holds a view of islands against a union-find over all polygons that share a point, and what it says of an update
// against the definition in <lgs/islands.h>, kin by kin.
#pragma once

#include "oracle/views/loop_check.h"
#include "oracle/views/recompute.h"

#include <lgs/islands.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lgs::oracle {

/// What is wrong with the lists of an update; empty if nothing is. The expected ones may come in any order.
std::string wrongLists(IslandChanges expected, const IslandChanges& changes);

class IslandCheck {
 public:
  explicit IslandCheck(IsAnchor isAnchor) : isAnchor_(std::move(isAnchor)) {}

  /// What is wrong with a view that begins, or with its loops.
  std::optional<std::string> begin(const World& world, const Islands& islands);
  /// What is wrong with it, or with its changes, after an update.
  std::optional<std::string> update(const World& world, const Islands& islands);

 private:
  struct Known {
    IslandFacts facts;
    Scene polygons;
  };
  using ById = std::map<IslandId, Known>;
  struct Kin {
    std::vector<IslandId> olds, news;  ///< the largest first
  };

  std::string read(const World& world, const Islands& islands, ById& out) const;
  std::vector<Kin> kinOf(const ById& now) const;
  std::string checkIds(const std::vector<Kin>& kin, const ById& now) const;
  std::string checkLists(const Islands& islands, const std::vector<Kin>& kin, const ById& now) const;

  IsAnchor isAnchor_;
  LoopCheck loops_;
  ById before_;
};

}  // namespace lgs::oracle
