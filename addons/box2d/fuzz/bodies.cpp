#include "addons/box2d/fuzz/bodies.h"

#include "addons/box2d/fuzz/body_watch.h"
#include "fuzz/units.h"
#include "oracle/calls/random.h"
#include "oracle/calls/shapes.h"

#include <fmt/format.h>
#include <lgs/box2d/cut_out.h>
#include <lgs/box2d/falling.h>
#include <lgs/box2d/falling_ground.h>
#include <lgs/brush.h>
#include <lgs/islands.h>
#include <algorithm>
#include <array>

namespace lgs::fuzz {
namespace {

using box2d::Terrain;
using oracle::Random;

constexpr std::int32_t kWidth = 6, kHeight = 4;  // cells within the walls
constexpr std::size_t kMostBodies = 12, kMaxMoves = 40, kMostUndo = 6;

bool isBedrock(Block block, Cell cell) { return block == 1 || cell.j < 1; }

class Game {
 public:
  explicit Game(std::uint8_t habits) : options_(optionsOf(habits)) {
    const ShapeId square = world_.shape(kUnitSquare).value();
    for (const CellRect& wall : {CellRect{{-1, -1}, {kWidth, -1}}, CellRect{{-1, kHeight}, {kWidth, kHeight}},
                                 CellRect{{-1, 0}, {-1, kHeight - 1}}, CellRect{{kWidth, 0}, {kWidth, kHeight - 1}}})
      static_cast<void>(world_.fill(wall, square, 1));
    world_.commit();
    begin();
    terrain_.emplace(physics_, world_, options_);
    falling_.emplace(physics_, world_, *terrain_);
    watch_.emplace(physics_, world_, *terrain_);
  }

  std::string play(Random& choices) {
    move(choices);
    std::string wrong = wrong_.empty() ? watch_->look("after the move") : wrong_;
    for (int k = choices.below(3); k >= 0 && wrong.empty(); --k) {
      terrain_->beforeStep();
      physics_.Step(1.0F / 60, 8, 3);
      terrain_->afterStep();
      wrong = watch_->look("after a step");
    }
    const Point p = pointOf(choices);
    return wrong.empty() ? watch_->ask(p, pointOf(choices), 2 * options_.cellSize) : wrong;
  }

 private:
  static box2d::TerrainOptions optionsOf(std::uint8_t habits) {
    constexpr std::array kOnOverlap{box2d::OnOverlap::push, box2d::OnOverlap::push, box2d::OnOverlap::disable};
    constexpr std::array kSizes{1.0, 0.5, 2.0};
    box2d::TerrainOptions options;
    options.cellSize = kSizes[habits % 3];
    options.chunkCells = habits % 2 == 0 ? 16 : 2;
    options.merge = habits % 5 < 2;
    options.onOverlap = kOnOverlap[habits / 16 % 3];
    options.material = [](Block block) {
      box2d::Material material;
      material.friction = block == 2 ? 0.9F : 0.2F;
      material.isPassable = block == BodyWatch::kPassable;
      if (block == BodyWatch::kFiltered) material.filter.maskBits = 0;
      return material;
    };
    return options;
  }

  /// Of a world that has just been made, or loaded.
  void begin() {
    static_cast<void>(world_.followCells(true));
    islands_.emplace(world_, isBedrock);
    marks_ = {world_.mark()};
    now_ = 0;
  }

  Point pointOf(Random& choices) {
    const std::int64_t x = choices.below(kWidth * 16), y = choices.below(kHeight * 16);
    return {x * (kCell / 16), y * (kCell / 16)};
  }

  void addBody(Point at, Random& choices) {
    const float h = static_cast<float>((0.1 + 0.1 * choices.below(8)) * options_.cellSize);
    const b2Vec2 place = terrain_->position(at);
    if (physics_.GetBodyCount() > 40 || watch_->bodies().size() >= kMostBodies || !watch_->isFree(place) ||
        terrain_->nearest(place, 1.5F * h))
      return;
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = place;
    definition.angle = static_cast<float>(choices.below(32)) / 10;
    b2Body* const body = physics_.CreateBody(&definition);
    b2CircleShape circle;
    circle.m_radius = h;
    b2PolygonShape box;
    switch (choices.below(4)) {
      case 0:
        body->CreateFixture(&circle, 1);
        return;
      case 1:
        box.SetAsBox(h, h);
        break;
      case 2:
        box.SetAsBox(h, h / 8);
        break;
      default:  // two shapes
        circle.m_p = {-h / 2, 0};
        circle.m_radius = h / 2;
        body->CreateFixture(&circle, 1);
        box.SetAsBox(h / 3, h / 3, {h / 2, 0}, 0);
    }
    body->CreateFixture(&box, 1);
  }

  Region regionOf(Point at, Random& choices) {
    const std::int64_t radius = kCell / 4 + choices.below(6) * (kCell / 4);
    const auto within = [&](std::int64_t x, int cells) { return std::clamp(x, kCell / 8, cells * kCell - kCell / 8); };
    if (choices.chance(40)) {
      const std::array line{at, Point{within(at.x + radius, kWidth), within(at.y - radius, kHeight)}};
      return thickLine(line, kCell / 8, 8);
    }
    Region region = circle(at, radius, 8 + choices.below(9));
    for (Ring& ring : region.rings)
      for (Point& p : ring) p = {within(p.x, kWidth), within(p.y, kHeight)};  // the walls stay
    return region;
  }

  void edit(Point at, Random& choices) {
    const Cell cell = cellAt(at);
    const Block block = 2 + choices.below(5U);
    const auto& shape = oracle::degenerateShapes()[choices.below(oracle::degenerateShapes().size())].polygons;
    switch (choices.below(5)) {
      case 0:
      case 1:
        static_cast<void>(paint(world_, regionOf(at, choices), block, PaintMode::fill));
        break;
      case 2:
        static_cast<void>(carve(world_, regionOf(at, choices)));
        break;
      case 3:
        if (const auto id = world_.shape(std::span(shape))) static_cast<void>(world_.replace(cell, *id, block));
        break;
      default:
        world_.clear(cell);
        break;
    }
  }

  void note() {
    marks_.resize(now_ + 1);
    if (now_ == kMostUndo) {
      static_cast<void>(world_.forget(marks_.front()));
      marks_.erase(marks_.begin());
    }
    marks_.push_back(world_.mark());
    now_ = marks_.size() - 1;
  }

  void show(const Changes& changes) {
    static_cast<void>(islands_->update(world_, changes));
    if (!terrain_->sync(changes) && !terrain_->isCurrent()) wrong_ = "changes that are the next ones are refused";
  }

  void undo(std::size_t to) {
    const auto done = to <= now_ ? world_.rollBack(marks_[to], Undone::keep) : world_.redo(marks_[to]);
    if (!done) wrong_ = "a mark is lost";
    now_ = to;
    show(world_.changesOfRollBack());
  }

  void fall(Random& choices) {
    const auto all = islands_->all();
    if (all.empty()) return;
    const IslandId island = choices.pick(all);
    if (islands_->island(island)->anchors > 0 || !falling_->takeAsBody(*islands_, island)) return;
    show(world_.commit());
    falling_->afterSync();
    note();
  }

  void settle(Random& choices) {
    if (falling_->bodies().empty()) return;
    b2Body* const body = choices.pick(falling_->bodies()).body;
    if (!falling_->settle(body)) return;
    watch_->leave(body);
    show(world_.commit());
    note();
  }

  void load() {
    const std::vector<std::byte> bytes = oracle::saved(world_);
    if (bytes.empty()) return;
    world_ = World::load(bytes).value();
    begin();
    terrain_->resync();
  }

  void moveOrigin(Random& choices) {
    const std::int32_t i = choices.below(40) - 20, j = choices.below(40) - 20;
    physics_.ShiftOrigin(terrain_->position(toWorld({i, j}, {})));
    terrain_->moveOrigin({i, j});
  }

  void move(Random& choices) {
    const int kind = choices.below(16);
    const Point at = pointOf(choices);
    const auto all = watch_->bodies();
    b2Body* const body = all.empty() ? nullptr : all[choices.below(all.size())];
    switch (kind) {
      case 0:
        return undo(choices.below(marks_.size()));
      case 1:
        return fall(choices);
      case 2:
        return settle(choices);
      case 3:
        return load();
      case 4:
        return moveOrigin(choices);
      case 5:
        return choices.chance(50) ? terrain_->materialsChanged() : terrain_->resync();
      case 6:  // new ground goes around bodies
        if (const auto room = box2d::withoutBodies(*terrain_, regionOf(at, choices)))
          static_cast<void>(paint(world_, *room, 3, PaintMode::fill));
        show(world_.commit());
        return note();
      case 7: {  // bodies are cut out of it
        edit(at, choices);
        const Changes changes = world_.commit();
        static_cast<void>(islands_->update(world_, changes));
        const auto version = world_.version();
        if (!box2d::cutOut(*terrain_, world_, changes)) wrong_ = "cutOut() is refused";
        if (version != world_.version()) islands_.emplace(world_, isBedrock);  // it has committed
        return note();
      }
      case 8:
      case 9:
      case 10:
        return addBody(at, choices);
      case 11:
        if (!body || !body->IsEnabled()) return;
        body->SetLinearVelocity(
            {static_cast<float>(choices.below(61) - 30), static_cast<float>(choices.below(61) - 30)});
        return body->SetAwake(true);
      case 12:
        if (!body || !body->IsEnabled() || !terrain_->fits(*body, b2Transform(terrain_->position(at), b2Rot(0))))
          return;
        body->SetTransform(terrain_->position(at), 0);
        watch_->leave(body);
        return terrain_->moved(*body);
      default:
        edit(at, choices);
        show(world_.commit());
        return note();
    }
  }

  box2d::TerrainOptions options_;
  World world_;
  b2World physics_{{0, -10}};
  std::optional<Islands> islands_;
  std::optional<Terrain> terrain_;
  std::optional<box2d::FallingGround> falling_;
  std::optional<BodyWatch> watch_;
  std::vector<Mark> marks_;
  std::size_t now_ = 0;
  std::string wrong_;
};

}  // namespace

std::optional<Finding> checkBodies(Bytes input, oracle::CheckStats& stats) {
  Game game(input.size() > 1 ? input[1] : 0);
  std::size_t moves = 0;
  for (std::size_t at = kRecord; at < input.size() && moves < kMaxMoves; at += kRecord) {
    auto choices = Random::of(input.subspan(at, std::min(kRecord, input.size() - at)));
    ++moves;
    ++stats.edits;
    if (const std::string wrong = game.play(choices); !wrong.empty())
      return Finding{fmt::format("a game with bodies, move {}: {}\n", moves, wrong)};
  }
  return std::nullopt;
}

}  // namespace lgs::fuzz
