// Law 13, nobody is buried: for whichever Box2D there is.
#include "proptests/support/law.h"
#include "proptests/support/scale.h"
#include "turmoil.h"

namespace lgs::box2d_test {
namespace {

using oracle::Random;

rc::Gen<Move> moves(const Arena& arena) {
  using rc::gen::inRange;
  return rc::gen::build<Move>(
      rc::gen::set(&Move::kind, rc::gen::map(inRange(0, 24),
                                             [](int k) {
                                               constexpr int kKinds = static_cast<int>(Move::Kind::count);
                                               return static_cast<Move::Kind>(k < kKinds ? k : k % 5);
                                             })),
      rc::gen::set(&Move::x, inRange(0, arena.width * 16)), rc::gen::set(&Move::y, inRange(0, arena.height * 16)),
      rc::gen::set(&Move::size, inRange(0, 16)), rc::gen::set(&Move::which, inRange(0, 256)));
}

rc::Gen<Arena> arenas() {
  using rc::gen::element;
  return rc::gen::build<Arena>(
      rc::gen::set(&Arena::width, element(3, 6, 12)), rc::gen::set(&Arena::height, element(3, 7)),
      rc::gen::set(&Arena::cellSize, element(2, 1, 4)), rc::gen::set(&Arena::chunkCells, element(16, 1, 3)),
      rc::gen::set(&Arena::merge, rc::gen::arbitrary<bool>()), rc::gen::set(&Arena::steps, element(1, 4, 8)),
      rc::gen::set(&Arena::announces, rc::gen::arbitrary<bool>()));
}

// A body is added, and ground changes around it: the smallest random game in which somebody is lost.
TEST(Box2dBuried, NobodyIsBuriedInSmallGames) {
  test::forAll(
      400,
      [](const Arena& arena, const std::vector<Move>& played) {
        Turmoil game(arena);
        for (const Move& move : played) test::failIf(game.play(move));
      },
      arenas(), rc::gen::container<std::vector<Move>>(moves({.width = 12, .height = 7})));
}

struct Played {
  std::size_t lost = 0, pushes = 0, holds = 0, held = 0, putBacks = 0;
  std::string wrong;
};

Played playLong(std::uint64_t seed, int bodies, std::int64_t moves) {
  Random random(seed);
  const Arena arena{.chunkCells = 8, .merge = random.chance(50), .announces = random.chance(50)};
  Turmoil game(arena);
  for (int tries = 0; game.bodyCount() < static_cast<std::size_t>(bodies) && tries < 10'000; ++tries) {
    Move move = randomMove(random, arena);
    move.kind = Move::Kind::body;
    game.play(move);
  }
  Played played;
  for (std::int64_t k = 0; k < moves; ++k) {
    const auto wrong = game.play(randomMove(random, arena));
    if (wrong && played.wrong.empty()) played.wrong = "move " + std::to_string(k) + ": " + *wrong;
  }
  played.lost = game.lost();
  played.pushes = game.pushes();
  played.holds = game.holds();
  played.held = game.disabledCount();
  played.putBacks = game.putBacks();
  return played;
}

void expectNobodyIsLost(int bodies) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Played played = playLong(seed, bodies, test::scaled(50));
    EXPECT_EQ(played.wrong, "") << bodies << " bodies, seed " << seed;
    EXPECT_EQ(played.lost, 0U) << bodies << " bodies, seed " << seed;
    std::printf("%3d bodies, seed %d: %zu lost, %zu pushed, %zu held, %zu of them at the end, %zu put back\n", bodies,
                static_cast<int>(seed), played.lost, played.pushes, played.holds, played.held, played.putBacks);
    std::fflush(stdout);  // a long run takes its time
  }
}

// At scale 100 these are 20,000 steps each.
TEST(Box2dBuried, NobodyIsLostInALongGame) { expectNobodyIsLost(50); }
TEST(Box2dBuried, NobodyIsLostInALongGameOfACrowd) { expectNobodyIsLost(150); }

}  // namespace
}  // namespace lgs::box2d_test
