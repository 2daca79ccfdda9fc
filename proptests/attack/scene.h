// Where the attack takes place: a world in the middle of its life, another one whose names mean nothing in the first,
// and the first once more behind the C interface. And all names that lead somewhere, nowhere, or elsewhere.
#pragma once

#include "proptests/support/worlds.h"

#include <lgs/lgs.h>

#include <memory>

namespace lgs::test {

/// A world of the C interface. It is freed at the end.
struct FreeWorld {
  void operator()(lgs_world* world) const { lgs_free(world); }
};
using CWorld = std::unique_ptr<lgs_world, FreeWorld>;

struct Ground;     // of a physics engine: doors_box2d.cpp
struct Followed;   // a world with its views: followed.h
struct FollowedC;  // the same in C

struct Scene {
  Scene();

  World world, other;
  CWorld c;
  std::vector<std::byte> file;  ///< the world as it was saved
  // The first one of each is alive, as long as there is one.
  std::vector<PolygonHandle> polygons;
  std::vector<SegmentId> segments;
  std::vector<ShapeId> shapes;
  std::vector<Mark> marks, marksOfC;
  Changes reported;                        ///< by an early commit of the world
  std::shared_ptr<Ground> ground;          ///< made when it is asked for; it goes before the world
  std::shared_ptr<Followed> followed;      ///< made when it is asked for
  std::shared_ptr<FollowedC> followedInC;  ///< made when it is asked for

  /// Looks anew for who is alive.
  void refresh();
  bool isAlive(PolygonHandle polygon) const;
  bool isAlive(SegmentId segment) const;
};

/// What nobody may change who is refused.
struct Seen {
  std::vector<std::pair<Cell, PolygonFields>> polygons;
  std::vector<SegmentFields> segments;
  std::uint32_t maxSegmentId = 0;
  std::uint64_t version = 0, shapes = 0, chunks = 0;
  friend bool operator==(const Seen&, const Seen&) = default;
};
Seen seenOf(const World& world);
Seen seenOf(const lgs_world* world);

}  // namespace lgs::test
