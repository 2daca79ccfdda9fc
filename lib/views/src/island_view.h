// The islands of a world. island_view.cpp finds out which are kin, island_names.cpp gives them their ids.
#pragma once

#include "kin.h"
#include "walk.h"

#include <lgs/islands.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lgs::detail {

class IslandView {
 public:
  explicit IslandView(IsAnchor isAnchor) : isAnchor_(std::move(isAnchor)) {}

  void load(const World& world, const Loops& loops);
  /// After the loops were updated.
  void update(const World& world, const Loops& loops);

  const IslandChanges& changes() const { return changes_; }
  bool isIsland(IslandId id) const { return id.value < islands_.size() && islands_[id.value].outer; }
  std::optional<IslandFacts> facts(const Loops& loops, IslandId id) const;
  IslandId of(LoopId outer) const { return outer.value < ofLoop_.size() ? ofLoop_[outer.value] : IslandId{}; }
  std::vector<IslandId> all() const;
  std::uint64_t walked() const { return walk_.walked(); }

 private:
  struct Island {
    LoopId outer;           ///< null: no island has this id
    std::uint32_t old = 0;  ///< in an update: its place in olds_, if it is there
    std::uint64_t anchors = 0;
  };
  /// An island of before that may be no more, or of now that may be new, with its kin.
  struct Old {
    Kin::Node kin;
    IslandFacts facts;
  };
  struct New {
    Kin::Node kin;
    LoopFacts outer;
    IslandId id;
    std::uint64_t anchors = 0;
    const Old* old = nullptr;  ///< what has its id; null: it is new
  };
  /// Where the number of anchors has changed, and by how much.
  struct Shift {
    Cell cell;
    std::vector<LocalPoint> vertices;
    std::int64_t by;
  };
  struct KinShift {
    Kin::Node kin;
    std::int64_t by;
  };

  void begin();
  void readCells(const World& world);
  void readCell(const CellChange& change);
  bool isAnchor(const PlacedPolygon& p, Cell cell) const { return isAnchor_ && isAnchor_(p.block, cell); }
  void collect(const Loops& loops, Kin& kin);
  void nameAll(const World& world, const Loops& loops);
  const Old* oldOf(LoopId outer) const;
  void nameKin(std::span<const Old> olds, std::span<New> news);
  void countAnchors(const World& world, const Loops& loops, std::span<const Old> olds, std::span<New> news);
  void tellKin(const Loops& loops, std::span<const Old> olds, std::span<const New> news);
  std::uint64_t anchorsIn(const World& world, const Loops& loops, LoopId outer);
  void set(IslandId id, LoopId outer, std::uint64_t anchors);
  IslandId newId();

  IsAnchor isAnchor_;
  std::vector<Island> islands_ = std::vector<Island>(1);  ///< by IslandId
  std::vector<IslandId> ofLoop_;                          ///< by LoopId
  std::vector<IslandId> free_;                            ///< ids that can be given out
  std::vector<IslandId> ended_;                           ///< by the last update: free with the next one
  IslandChanges changes_;
  Walk walk_;
  // Working memory of an update.
  std::vector<Taken> taken_;
  bool hasAdded_ = false;  ///< whether polygons were added
  std::vector<Shift> shifts_;
  std::vector<KinShift> kinShifts_;
  std::vector<Old> olds_;
  std::vector<New> news_;
};

}  // namespace lgs::detail
