// Holds a view of loops against a walk along all links, and what it says of an update against the definition in
// <lgs/loops.h>, loop by loop.
#pragma once

#include "oracle/views/recompute.h"

#include <lgs/loops.h>

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace lgs::oracle {

class LoopCheck {
 public:
  /// What is wrong with a view that begins.
  std::optional<std::string> begin(const World& world, const Loops& loops);
  /// What is wrong with it, or with its changes, after an update.
  std::optional<std::string> update(const World& world, const Loops& loops);

 private:
  /// Segments with their ids, and those that follow.
  using Links = std::vector<std::tuple<Edge, SegmentId, SegmentId>>;
  struct Known {
    LoopFacts facts;
    std::vector<Edge> edges;  ///< sorted
    Links links;              ///< sorted
  };
  using ById = std::map<LoopId, Known>;
  using Shares = std::map<LoopPair, std::size_t>;  ///< how many edges of a loop of before one of now has

  std::string read(const World& world, const Loops& loops, ById& out) const;
  std::string checkIds(const ById& now, const Shares& shares) const;
  std::string checkLists(const LoopChanges& changes, const ById& now, const Shares& shares) const;

  ById before_;
};

}  // namespace lgs::oracle
