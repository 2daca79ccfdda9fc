// A random game in a closed world: bodies, and ground that changes under them. Law 13 is looked at after each sync and
// each step.
#pragma once

#include "crowd.h"
#include "oracle/calls/random.h"

#include <lgs/box2d/terrain.h>
#include <lgs/brush.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace lgs::box2d_test {

/// What a player does. The numbers mean something else for each kind.
struct Move {
  enum class Kind { body, paint, line, carve, tile, dig, shot, portal, undo, redo, save, load, origin, kick, count };
  Kind kind = Kind::body;
  int x = 0, y = 0;  ///< where, in sixteenths of a cell from the lower left corner
  int size = 0;      ///< 0 … 15
  int which = 0;     ///< 0 … 255
};
std::ostream& operator<<(std::ostream& out, const Move& move);

/// Where it is played.
struct Arena {
  int width = 24, height = 14;  ///< cells within the walls
  int cellSize = 1;             ///< in halves of a metre
  int chunkCells = 16;
  bool merge = false;
  int steps = 4;           ///< of the physics after each move
  bool announces = false;  ///< says moved() of each body that is new or elsewhere, instead of calling beforeStep()
};
std::ostream& operator<<(std::ostream& out, const Arena& arena);

Move randomMove(oracle::Random& random, const Arena& arena);

class Turmoil {
 public:
  explicit Turmoil(const Arena& arena);

  /// What is wrong after a move and the steps after it, if anything is.
  std::optional<std::string> play(const Move& move);

  /// Bodies that are inside the ground or out of the world, but for those that are disabled.
  std::size_t lost() const;
  std::size_t bodyCount() const { return crowd_.bodies.size(); }
  std::size_t disabledCount() const { return terrain_->disabled().size(); }
  std::size_t pushes() const { return pushes_; }      ///< so far
  std::size_t holds() const { return holds_; }        ///< so far
  std::size_t putBacks() const { return putBacks_; }  ///< so far

 private:
  using Body = Crowd::Body;
  using Position = Crowd::Position;
  struct Watched {
    std::vector<bool> isFree;  // of each middle
    bool isHeld = false;
    Point at;    // where it is
    Point free;  // where it was free last
  };
  void edit(const Move& move);
  void act(const Move& move);
  void undo(int steps);
  void redo(int steps);
  void load();
  bool addBody(const Move& move);
  void shoot(const Move& move);
  void portal(const Move& move);
  void shove(Body body, const Move& move);
  void step();
  Region regionOf(const Move& move) const;
  Point pointOf(const Move& move) const;
  bool isFree(const Position& middle) const;
  bool isFree(Body body) const;  // each of its middles
  bool isOut(Point p) const;     // of the world
  void sync(const Changes& changes);
  void count();
  std::optional<std::string> look(const char* after);
  std::optional<std::string> lookAtPutBacks() const;

  Arena arena_;
  World world_;
  ShapeId square_;
  Crowd crowd_;
  std::optional<box2d::Terrain> terrain_;
  Cell origin_;
  std::vector<Watched> watched_;
  std::vector<Mark> marks_;  // at the begin, and after each edit
  std::size_t now_ = 0;      // at which of them the world is
  std::vector<std::byte> file_;
  std::vector<Body> putBack_;  // by the last step
  std::size_t pushes_ = 0, holds_ = 0, putBacks_ = 0;
};

}  // namespace lgs::box2d_test
