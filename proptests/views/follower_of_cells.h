// A world that is followed, cell by cell, through edits, commits, marks, roll-backs, groups, copies and loads. Beside
// it stands what the follower must be told, kept by reading the world through its public calls alone; and a view that
// is told nothing else.
#pragma once

#include "examples/area/area_by_block.h"
#include "proptests/laws/twins.h"

#include <lgs/world.h>

namespace lgs::test {

/// The cells that hold something.
using Cells = std::map<Cell, std::vector<PolygonFields>>;
Cells cellsIn(const World& world);

/// Twice the area of each block, recomputed from all polygons.
std::map<Block, std::int64_t> recomputedAreas(const World& world);

class FollowerOfCells {
 public:
  explicit FollowerOfCells(const Setting& setting);

  void make(const Call& call);
  /// Commits, and expects all that must hold then.
  void commit();

 private:
  /// A cell that an edit changed, and the number of that edit: one edit may change several cells, in any order.
  struct Edited {
    std::size_t edit = 0;
    Cell cell;
  };
  struct Marked {
    Mark mark;
    Cells told;
    std::size_t committed = 0, edits = 0, given = 0;  ///< how long lists were: at the commit before, and then
  };

  bool edit(const Call& call);
  void group(const Call& call);
  void rollBack(std::size_t k);
  void load();
  void expectTold(std::span<const Edited> edited, const Cells& now);

  Caller caller_;
  World& world_ = caller_.world;
  examples::AreaByBlock view_;
  Cells told_;                 ///< as the follower knows them
  std::vector<Edited> log_;    ///< of edits that are not undone
  std::size_t edits_ = 0;      ///< made so far
  std::size_t committed_ = 0;  ///< how long the log was at the last commit
  std::vector<Marked> marks_;
};

}  // namespace lgs::test
