// Watches the bodies of a physics world, and what a terrain says of them.
#pragma once

#include <box2d/box2d.h>
#include <lgs/box2d/terrain.h>

#include <map>
#include <string>
#include <vector>

namespace lgs::fuzz {

class BodyWatch {
 public:
  static constexpr Block kPassable = 5, kFiltered = 6;  ///< blocks that hold nobody

  BodyWatch(b2World& physics, const World& world, box2d::Terrain& terrain)
      : physics_(physics), world_(world), terrain_(terrain) {}

  bool isFree(b2Vec2 middle) const;
  std::vector<b2Body*> bodies() const;                ///< the dynamic ones
  void leave(b2Body* body) { watched_.erase(body); }  ///< it is elsewhere, or no more

  /// Law 13: a middle that was free is free, unless the body is disabled; then it does not move. Says what is wrong.
  std::string look(const char* after);

  /// What the terrain is asked is what the world says of the same places; `reach` is in metres, two cells.
  std::string ask(Point p, Point q, double reach) const;

 private:
  struct Watched {
    std::vector<bool> free;  // each of its middles
    bool isDisabled = false;
    Point at;
  };

  b2World& physics_;
  const World& world_;
  box2d::Terrain& terrain_;
  std::map<b2Body*, Watched> watched_;
};

}  // namespace lgs::fuzz
