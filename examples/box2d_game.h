// The whole game, once, for both generations of Box2D: dig, paint, undo, redo, save, load, one-way platforms, materials
// and picking, with 30 bodies and 2,000 frames, in which nobody is lost. What needs Box2D is in box2d_2_game.cpp and
// box2d_3_game.cpp: a class that this one is given.
#pragma once

#include "box2d_recipes.h"

#include <lgs/box2d/cut_out.h>
#include <lgs/brush.h>
#include <lgs/debug.h>

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace game {

inline constexpr lgs::Block kStone = 1, kIce = 2, kConveyor = 3, kPlatform = 4, kBedrock = 9;
inline constexpr std::int32_t kWidth = 40, kHeight = 20;  // cells between the walls
inline constexpr double kCellSize = 0.5;                  // metres
inline constexpr int kBodies = 30, kFrames = 2'000;

/// Brushes go around these.
inline bool stays(lgs::Block block) { return block == kBedrock || block == kPlatform; }

inline bool build(lgs::World& world) {
  constexpr std::int32_t kEnd = lgs::kUnitsPerCell;
  const auto square = world.shape(lgs::kUnitSquare);
  const auto plank = world.shape({{0, kEnd / 2}, {kEnd, kEnd / 2}, {kEnd, kEnd}, {0, kEnd}});
  const auto fill = [&](lgs::CellRect cells, const lgs::Expected<lgs::ShapeId>& shape, lgs::Block block) {
    return shape && world.fill(cells, *shape, block);
  };
  const bool isBuilt =
      fill({{-1, -1}, {kWidth, -1}}, square, kBedrock) && fill({{-1, kHeight}, {kWidth, kHeight}}, square, kBedrock) &&
      fill({{-1, 0}, {-1, kHeight - 1}}, square, kBedrock) &&
      fill({{kWidth, 0}, {kWidth, kHeight - 1}}, square, kBedrock) && fill({{0, 0}, {kWidth - 1, 4}}, square, kStone) &&
      fill({{4, 5}, {9, 5}}, square, kIce) && fill({{22, 5}, {27, 5}}, square, kConveyor) &&
      fill({{12, 9}, {17, 9}}, plank, kPlatform) && fill({{26, 12}, {31, 12}}, plank, kPlatform);
  world.commit();
  return isBuilt;
}

/// `Physics` has the bodies, the terrain, the listener for platforms and conveyors, and what is saved.
template <class Physics>
class Game {
 public:
  Game() : isBuilt_(build(world_)), physics_(world_) {
    for (int k = 0; k < kBodies; ++k) physics_.add({0.8 + 0.62 * k, 5.0 + 0.9 * (k % 5)}, k % 3);
    marks_ = {world_.mark()};
  }

  /// Returns how many bodies are lost.
  int play() {
    for (int frame = 0; frame < kFrames && isBuilt_; ++frame) {
      input(frame);
      physics_.terrain().beforeStep();
      physics_.step();
      physics_.terrain().afterStep();
    }
    return isBuilt_ ? lost() : kBodies;
  }

  std::string picture() { return lgs::writeSvg(world_, {.over = physics_.drawn(), .cellsPerUnit = 1 / kCellSize}); }
  void print() const {
    std::printf("%d edits, %d undone, %d done again, %d clicks on ground, %d pushed, %d held\n", edits_, undone_,
                redone_, picked_, pushed_, held_);
  }

 private:
  void input(int frame) {
    if (frame == 700) physics_.save(world_);
    if (frame == 1'400) load();
    if (frame % 40 == 36 || frame % 40 == 37) return undo();
    if (frame % 40 == 38 || frame % 80 == 39) return redo();
    if (frame % 5 == 0) edit(frame);
    if (frame % 50 == 0) pick(frame % kBodies);
  }

  // A player digs and builds where the bodies are.
  void edit(int frame) {
    const lgs::Point at = physics_.terrain().latticePoint(physics_.placeOf(random() % kBodies));
    const std::int64_t radius = lgs::kUnitsPerCell * (1 + random() % 4) / 2;
    const bool digs = frame % 15 != 0;
    const auto done = digs ? lgs::carve(world_, lgs::circle(at, radius, 16), stays)
                           : lgs::paint(world_, lgs::circle(at, radius, 16), kStone, lgs::PaintMode::fill, stays);
    if (!done) return;  // a cell is full to its limits: nothing has changed
    show(world_.commit());
    marks_.resize(++now_);
    marks_.push_back(world_.mark());
    ++edits_;
  }

  void undo() {
    if (now_ == 0 || !world_.rollBack(marks_[now_ - 1], lgs::Undone::keep)) return;
    --now_;
    ++undone_;
    show(world_.changesOfRollBack());
  }

  void redo() {
    if (now_ + 1 == marks_.size() || !world_.redo(marks_[now_ + 1])) return;
    ++now_;
    ++redone_;
    show(world_.changesOfRollBack());
  }

  void load() {
    if (!physics_.load(world_)) return;
    marks_ = {world_.mark()};  // those of before belong to another world
    now_ = 0;
    count();
  }

  void pick(int body) {
    auto at = physics_.placeOf(body);
    at.y -= static_cast<decltype(at.y)>(kCellSize);
    const lgs::Spot spot = world_.at(physics_.terrain().latticePoint(at));
    if (spot.where != lgs::Spot::Where::outside && world_.polygon(spot.polygon)) ++picked_;
  }

  void show(const lgs::Changes& changes) {
    if (!physics_.terrain().sync(changes)) std::puts("changes were left out");  // a mistake of the program
    count();
  }

  void count() {
    for (const auto& overlap : physics_.terrain().overlaps()) ++(overlap.isFree ? pushed_ : held_);
  }

  /// In the ground, or out of the world.
  int lost() {
    int count = 0;
    for (int k = 0; k < kBodies; ++k) {
      const auto at = physics_.placeOf(k);
      const lgs::Spot spot = world_.at(physics_.terrain().latticePoint(at));
      const bool isBuried = spot.where != lgs::Spot::Where::outside && spot.block != kPlatform && !physics_.isHeld(k);
      const lgs::Cell cell = physics_.terrain().cellAt(at);
      if (isBuried || !contains(lgs::CellRect{{0, 0}, {kWidth - 1, kHeight - 1}}, cell)) ++count;
    }
    return count;
  }

  int random() { return static_cast<int>((seed_ = seed_ * 1'103'515'245U + 12'345U) >> 16 & 0x7fff); }

  lgs::World world_{[](lgs::Block a, lgs::Block b) { return (a == kPlatform) != (b == kPlatform); }};
  bool isBuilt_;
  Physics physics_;
  std::vector<lgs::Mark> marks_;  // at the begin, and after each edit
  std::size_t now_ = 0;           // at which of them the world is
  std::uint32_t seed_ = 1;
  int edits_ = 0, undone_ = 0, redone_ = 0, picked_ = 0, pushed_ = 0, held_ = 0;
};

/// The programs take a name for the picture, or none.
template <class Physics>
int run(int count, const char* const* arguments) {
  Game<Physics> game;
  const int lost = game.play();
  game.print();
  std::printf("%d of %d bodies lost after %d frames\n", lost, kBodies, kFrames);
  if (count > 1) std::ofstream(arguments[1]) << game.picture();
  return lost == 0 ? 0 : 1;
}

}  // namespace game
