// The part of a world that one rank has: the polygons of its region and of the halo around it, the segments of its
// region, and the names of the segments to which they are linked across the border.
//
// A round, in which each message from one rank to another one stays behind those that were sent before it:
//
//   1. Whoever wants to edit sends the edit to the owner of its cell. The owner calls decide(): it checks the edit,
//      and if it is good passes it on to the ranks whose halo has the cell.
//   2. These call follow(). So each cell has the same edits in the same order, wherever it is held.
//   3. Each rank calls commit(), whenever it likes. This says which segments near the border have come and gone.
//   4. The ranks whose halo has their cells call learn().
//
// Once all that was sent has arrived and all have committed since, everything is as it would be in one world.
#pragma once

#include "cutting.h"
#include "message.h"

#include <lgs/world.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace regions {

/// A segment in the whole world: its id in the world of its owner. Null if the id is.
struct Name {
  int rank = 0;
  lgs::SegmentId id;
  friend bool operator==(const Name&, const Name&) = default;
};

/// What a commit did to the segments of the own cells: see lgs::Changes.
struct OwnChanges {
  std::vector<lgs::SegmentId> removed;
  std::vector<lgs::SegmentId> added;
  std::vector<lgs::SegmentId> relinked;
};

class Region {
 public:
  /// `preserve` is the same in all ranks.
  Region(Cutting cutting, int rank, lgs::PreserveRelation preserve = {});

  /// An edit of an own cell. It is refused, or made, and passed on to whom it concerns.
  lgs::Expected<void> decide(const Edit& edit, Outbox& edits);

  /// An edit that the owner of its cell has passed on.
  void follow(const Edit& edit);

  /// Brings the own segments up to date with the edits so far, and tells the neighbours of those near the border.
  const OwnChanges& commit(Outbox& names);

  /// What another rank's commit told.
  void learn(int from, const Message& names);

  /// The name of a segment that `id`, a link of an own segment, leads to. Null if there is no link, or if the owner of
  /// the segment has not told of it yet.
  Name nameOf(lgs::SegmentId id) const;

  /// Whether the id is that of a segment in an own cell, as of the last commit.
  bool isOwn(lgs::SegmentId id) const { return id.value < own_.size() && own_[id.value]; }

  /// How many segments of the halo have a name: as many as their owners have there.
  std::size_t namesOfNeighbours() const { return neighbour_.size(); }

  /// The polygons that this rank needs, and their segments. Those of the halo's segments are not right: nobody may look
  /// at them. Through it each rank can load the ground that it knows without being told: all that it needs().
  lgs::World& world() { return world_; }
  const lgs::World& world() const { return world_; }

 private:
  struct HashOfEnds {
    std::size_t operator()(const Ends& ends) const;
  };
  struct OnBorder {
    Ends ends;
    lgs::Cell cell;
  };

  lgs::Expected<void> play(const Edit& edit);
  template <class Item>
  void tell(lgs::Cell cell, const Item& item, Outbox& out) const;

  Cutting cutting_;
  int rank_;
  std::vector<std::size_t> neighbours_;  // the ranks whose halo has own cells
  lgs::CellRect inner_;                  // the own cells that are in no other rank's halo, or fewer
  lgs::World world_;
  OwnChanges changes_;
  std::vector<bool> own_;                                 // by id
  std::unordered_map<std::uint32_t, OnBorder> border_;    // own segments that others know, by id
  std::unordered_map<Ends, Name, HashOfEnds> neighbour_;  // the names of the segments of the halo
};

}  // namespace regions
