// The islands of a world. island_view.cpp finds out which are kin, island_names.cpp gives them their ids.
#pragma once

#include "beyond.h"
#include "kin.h"
#include "walk.h"

#include <lgs/islands.h>

#include <cstdint>
#include <optional>
#include <set>
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
  IslandId of(LoopId outer) const { return isOpen(outer) ? kBeyond : islandOf(outer); }
  /// As a locator names the island of a polygon.
  IslandId ofLocated(LoopId outer) const { return outer || away_.empty() ? of(outer) : kBeyond; }
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
  /// What became of a chunk.
  enum class Passage : std::uint8_t { stays, left, came };

  void begin();
  void readCells(const World& world);
  void readCell(const CellChange& change, Passage passage);
  Passage passageOf(const World& world, Cell cell);
  std::vector<LoopId> changedOuters(const Loops& loops) const;
  void findOpen(const World& world, const Loops& loops, std::span<const LoopId> outers);
  void uniteBeyond(const World& world, const Loops& loops, Kin& kin) const;
  IslandId islandOf(LoopId outer) const { return outer.value < ofLoop_.size() ? ofLoop_[outer.value] : IslandId{}; }
  bool isOpen(LoopId outer) const { return open_.contains(outer); }
  bool isAnchor(const PlacedPolygon& p, Cell cell) const { return isAnchor_ && isAnchor_(p.block, cell); }
  void collect(const World& world, const Loops& loops, std::span<const LoopId> outers, Kin& kin);
  void dropForgotten(const World& world);
  void nameAll(const World& world, const Loops& loops, Kin::Node beyond);
  const Old* oldOf(LoopId outer) const;
  void nameKin(std::span<const Old> olds, std::span<New> news, bool isBeyond);
  void countAnchors(const World& world, const Loops& loops, std::span<const Old> olds, std::span<New> news,
                    bool isBeyond);
  void tellKin(const Loops& loops, std::span<const Old> olds, std::span<const New> news, bool isBeyond);
  const std::vector<Standing>& walk(const World& world, const Loops& loops, LoopId outer);
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
  std::set<Cell> away_;    ///< unloaded chunks that are known, by their lower-left cells; some may be forgotten
  std::size_t kept_ = 0;   ///< how many there were when those were dropped
  std::set<LoopId> wide_;  ///< outer loops that a chunk may lie in
  std::set<LoopId> open_;  ///< those of them whose islands reach an unloaded chunk
  // Working memory of an update.
  std::vector<Taken> taken_;
  std::vector<CellRect> left_, back_;  ///< chunks that were unloaded, and that were loaded again
  std::vector<std::size_t> came_;      ///< which changes of cells are of the latter
  std::set<LoopId> wasOpen_;           ///< open_ of before
  bool hasAdded_ = false;              ///< whether polygons were added
  std::vector<Shift> shifts_;
  std::vector<KinShift> kinShifts_;
  std::vector<Old> olds_;
  std::vector<New> news_;
};

}  // namespace lgs::detail
