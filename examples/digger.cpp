// A digger with all of it, for Box2D 2.4 and 3: a world without end that streams in and out, rocks that fall and become
// ground again, undo and redo, save and load, and a second world that follows over a line. It plays by itself, for as many
// frames as it is told and by a seed, and looks whether anybody or anything is lost. `Digger` is the game; what is below
// it watches.
#include "addons/sync/client.h"
#include "addons/sync/server.h"
#include "digger_physics.h"

#include <lgs/box2d/ground.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

namespace {

constexpr lgs::Block kEarth = 1, kStone = 2, kBedrock = 9;
constexpr std::int64_t U = lgs::kUnitsPerCell;

bool isBedrock(lgs::Block block) { return block == kBedrock; }

/// Hills with caves on bedrock. The same for the same chunk, whoever asks when.
void hills(lgs::World& land, const lgs::CellRect& chunk) {
  const lgs::ShapeId square = land.shape(lgs::kUnitSquare).value();
  for (std::int32_t i = chunk.min.i; i <= chunk.max.i; ++i) {
    const std::int32_t top = 20 + std::abs((i & 31) - 16) / 3 + std::abs((i & 127) - 64) / 8;
    for (std::int32_t j = std::max(chunk.min.j, -1); j <= std::min(chunk.max.j, top); ++j) {
      const bool isCave = j > 1 && (i * 13 + j * 7) % 23 < 3 && (i / 4 + j / 3) % 4 == 0;
      const lgs::Block block = j < 1 ? kBedrock : (i + 3 * j) % 17 < 4 ? kStone : kEarth;
      if (!isCave) static_cast<void>(land.add({i, j}, square, block));
    }
  }
}

class Digger {
 public:
  explicit Digger(std::uint32_t seed)
      : seed_(seed),
        ground_(
            {.isAnchor = [](lgs::Block block, lgs::Cell) { return isBedrock(block); },
             .staying = isBedrock,
             .land = hills,
             .chunksAtOnce = 1,
             .undoSteps = 20,
             .follow = [this](const lgs::World&, const lgs::Changes& changes) { server_ ? publish(changes) : void(); }},
            physics_.world(), lgs::box2d::TerrainOptions{.cellSize = kMetres, .merge = true},
            lgs::box2d::FallingOptions{.density = [](lgs::Block b) { return b == kStone ? 2.5F : 1.5F; }}) {
    connect();
    while (!ground_.window(around(0))) continue;
    for (int k = 0; k < kBalls; ++k) physics_.addBall({(k - kBalls / 2) * 1.3, 34 * kMetres});
  }

  void frame(int frame) {
    otherSeconds_ = 0;
    const std::int32_t x =
        static_cast<std::int32_t>(160 * std::abs((frame / 20 % 64) - 32) / 32);  // it walks to and fro
    ground_.window(around(x));
    if (frame % 6 == 0) {
      const std::int64_t radius = U * (2 + random(4)) / 2;  // drawn first: compilers differ in the order of arguments
      ground_.dig(lgs::circle({(x + random(40) - 20) * U, (2 + random(26)) * U}, radius, 16));
    }
    if (frame % 90 == 45) ground_.paint(lgs::circle({(x + random(20) - 10) * U, 32 * U}, 2 * U, 16), kEarth);
    if (frame % 40 >= 36) frame % 40 < 38 ? ground_.undo() : ground_.redo();
    if (frame % 1'000 == 700) save();
    if (frame % 1'000 == 999) load();
    ground_.step([&] {
      physics_.step();
      otherSeconds_ += physics_.seconds();
    });
    drawn_ += ground_.draw().size();
  }

  lgs::box2d::Ground& ground() { return ground_; }
  Physics& physics() { return physics_; }
  /// What the physics and the other end of the line took of the last frame.
  double otherSeconds() const { return otherSeconds_; }
  /// Whether the second world has the same ground, once all of it is in memory to be asked for.
  bool isInStep() {
    while (!ground_.window({{-128, -64}, {288, 95}})) continue;
    for (int k = 0; k < 10 && !client_->isInStep(); ++k) heartbeat();
    return client_->isInStep();
  }
  std::size_t drawn() const { return drawn_; }

 private:
  static lgs::CellRect around(std::int32_t x) { return {{x - 48, -16}, {x + 48, 47}}; }
  void save() {
    saved_.clear();
    static_cast<void>(ground_.save([&](auto bytes) { saved_.insert(saved_.end(), bytes.begin(), bytes.end()); }));
  }
  /// Another server counts its turns from 1 on, so the other end begins anew as well, with the ground that it has. What
  /// differs then it asks for.
  void load() {
    server_.reset();
    if (!ground_.load(saved_)) return;
    const auto all = lgs::loadGround(saved_, {}, {{-lgs::kMaxCell, -lgs::kMaxCell}, {lgs::kMaxCell, lgs::kMaxCell}},
                                     lgs::shelfInMemory());
    server_.emplace(ground_.world(), lgs::GroundHashes(all->world));
    client_.emplace(theirs_);
    heartbeat();
  }
  /// The second world hears of each commit.
  void connect() {
    server_.emplace(ground_.world());
    if (theirs_.followCells(true)) client_.emplace(theirs_);
  }
  void publish(const lgs::Changes& changes) { talk(server_->update(changes)); }
  void heartbeat() { talk(server_->signOfLife()); }
  /// What the other end does is not the terrain's part of the frame.
  void talk(const in_step::Bytes& message) {
    const double begin = processorSeconds();
    std::vector<in_step::Bytes> questions = client_->receive(message);
    for (const in_step::Bytes& again : client_->tick()) questions.push_back(again);
    while (!questions.empty()) {
      const auto answer = server_->answer(questions.back());
      questions.pop_back();
      if (!answer) continue;  // that chunk is not in memory
      for (const in_step::Bytes& more : client_->receive(*answer)) questions.push_back(more);
    }
    otherSeconds_ += processorSeconds() - begin;
  }
  std::int32_t random(std::int32_t n) {
    seed_ = seed_ * 1'103'515'245U + 12'345U;
    return static_cast<std::int32_t>((seed_ >> 16) % static_cast<std::uint32_t>(n));
  }

  static constexpr float kMetres = 0.5F;  // to a cell
  static constexpr int kBalls = 24;
  std::uint32_t seed_;
  Physics physics_;
  std::optional<in_step::Server> server_;
  lgs::World theirs_;
  std::optional<in_step::Client> client_;
  lgs::box2d::Ground ground_;
  std::vector<std::byte> saved_;
  std::size_t drawn_ = 0;
  double otherSeconds_ = 0;
};

/// What the terrain takes of a frame: all of it but the physics' own step.
class Times {
 public:
  void add(double seconds) { all_.push_back(seconds * 1e6); }
  void print() {
    std::ranges::sort(all_);
    const auto at = [this](double part) {
      return all_[static_cast<std::size_t>(part * static_cast<double>(all_.size() - 1))];
    };
    std::printf("the terrain's part of a frame: p50 %.0f us, p99 %.0f us, worst %.0f us\n", at(0.5), at(0.99), at(1));
  }

 private:
  std::vector<double> all_;
};

}  // namespace

int main(int count, char** arguments) {
  const char* const scale = std::getenv("LGS_TEST_SCALE");  // of a long run of the tests it is 1 or more
  const int frames = count > 1 ? std::atoi(arguments[1]) : scale != nullptr && std::atof(scale) >= 1 ? 30'000 : 3'000;
  Digger digger(count > 2 ? static_cast<std::uint32_t>(std::atoi(arguments[2])) : 1);
  Times times;
  std::uint64_t early = 0, late = 0;  // the most memory of the world in the first and in the last third
  for (int frame = 0; frame < frames; ++frame) {
    const double begin = processorSeconds();
    digger.frame(frame);
    const double all = processorSeconds() - begin;
    if (frame % 1'000 != 700 && frame % 1'000 != 999) times.add(all - digger.otherSeconds());  // no save or load
    const std::uint64_t bytes = digger.ground().world().stats().bytes;
    if (frame < frames / 3) early = std::max(early, bytes);
    if (frame > 2 * frames / 3) late = std::max(late, bytes);
  }
  int lost = 0, held = 0;  // a ball that new ground leaves no way out is held until it is dug out: that is not lost
  auto& terrain = digger.ground().host().terrain();
  for (const lgs::box2d::BodyHandle ball : digger.physics().balls()) {
    const auto at = Physics::placeOf(ball);
    const lgs::Spot spot = digger.ground().world().at(terrain.latticePoint(at));
    const auto isBall = [&](auto other) { return lgs::box2d::GroundHost::isSame(ball, other); };
    if (std::ranges::any_of(terrain.disabled(), isBall))
      ++held;
    else if (spot.where == lgs::Spot::Where::inside || terrain.cellAt(at).j < 0)
      ++lost;
  }
  int rocks = 0;
  digger.ground().forEachRock([&](auto, const lgs::Body&) { ++rocks; });
  const bool isInStep = digger.isInStep();
  times.print();
  std::printf("%d frames, %zu squares drawn, %d rocks in the air, %s, %.1f MB at first and %.1f MB at last\n", frames,
              digger.drawn(), rocks, isInStep ? "both worlds in step" : "the worlds differ",
              static_cast<double>(early) / 1e6, static_cast<double>(late) / 1e6);
  std::printf("%d of %zu balls lost, %d held in new ground\n", lost, digger.physics().balls().size(), held);
  return lost == 0 && isInStep && late < 2 * early ? 0 : 1;
}
