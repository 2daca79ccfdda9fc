// Views follow a copy of a world through edits, commits and roll-backs; bodies leave its ground and come back.
#include "fuzz/beside.h"
#include "fuzz/same.h"
#include "fuzz/views.h"
#include "oracle/views/ground_hashes.h"
#include "oracle/views/island_check.h"
#include "oracle/views/piece_check.h"

#include <lgs/falling.h>
#include <cmath>
#include <utility>

namespace lgs::fuzz {
namespace {

using oracle::Random;

bool isAnchor(Block block, Cell cell) { return block % 3 == 1 || (std::int64_t{cell.i} + cell.j) % 5 == 0; }

class Following {
 public:
  explicit Following(World world)
      : world_(std::move(world)),
        views_{Islands(world_, isAnchor), Pieces(world_), GroundHashes(world_)},
        islandCheck_(isAnchor) {}

  std::string run(Random& random) {
    if (auto wrong = islandCheck_.begin(world_, views_.islands)) return *wrong;
    if (auto wrong = pieceCheck_.begin(world_, views_.pieces)) return *wrong;
    const GroundHashes before = views_.hashes;
    const Mark mark = world_.mark();
    for (int days = 1 + random.below(3); days > 0; --days) {
      editSome(world_, random);
      if (std::string wrong = update(world_.commit()); !wrong.empty()) return wrong;
    }
    if (differences(before, views_.hashes).empty() != (before.hash() == views_.hashes.hash()))
      return "differences() finds none";
    if (std::string wrong = wrongViewReads(world_, views_, random); !wrong.empty()) return wrong;
    if (std::string wrong = foreseen(random); !wrong.empty()) return wrong;
    if (std::string wrong = fall(random); !wrong.empty()) return wrong;
    if (!world_.rollBack(mark, Undone::keep)) return "a mark is lost";
    if (std::string wrong = update(world_.changesOfRollBack()); !wrong.empty()) return wrong;
    return views_.hashes.hash() == before.hash() ? "" : "what rolled back has another hash";
  }

 private:
  std::string update(const Changes& changes) {
    if (!views_.islands.update(world_, changes) || !views_.hashes.update(world_, changes) ||
        !views_.pieces.update(world_, changes))
      return "the views refuse what was committed";
    auto wrong = islandCheck_.update(world_, views_.islands);
    if (!wrong) wrong = pieceCheck_.update(world_, views_.pieces, views_.pieces.changed());
    if (!wrong) wrong = oracle::faultOf(views_.hashes, world_);
    return wrong.value_or("");
  }

  /// What an edit would do leaves no trace, and is what it then does.
  std::string foreseen(Random& random) {
    const World before = world_;
    const std::vector<IslandId> all = views_.islands.all();
    Random same = random;
    const auto edit = [](Random& choices) {
      return [&choices](World& world) {
        editSome(world, choices);
        return true;
      };
    };
    const Foreseen would = foresee(world_, views_.islands, edit(random));
    if (std::string wrong = differenceOf(before, world_); !wrong.empty()) return "foresee() leaves " + wrong;
    if (views_.islands.all().size() != all.size()) return "foresee() leaves other islands";
    islandCheck_ = oracle::IslandCheck(isAnchor);  // which knows them by their ids of before
    if (auto wrong = islandCheck_.begin(world_, views_.islands)) return *wrong;
    edit(same)(world_);
    if (std::string wrong = update(world_.commit()); !wrong.empty()) return wrong;
    const IslandChanges& did = views_.islands.changes();
    const bool isSame =
        would.changes.added.size() == did.added.size() && would.changes.removed.size() == did.removed.size() &&
        would.changes.changed.size() == did.changed.size() && would.changes.cutOff.size() == did.cutOff.size() &&
        would.changes.joined.size() == did.joined.size();
    return isSame ? "" : "foresee() foresees something else";
  }

  /// An island leaves the ground, and comes back where it was, or lies elsewhere.
  std::string fall(Random& random) {
    const std::vector<IslandId> all = views_.islands.all();
    if (all.empty()) return "";
    const World before = world_;
    const auto body = take(world_, views_.islands, random.pick(all));
    if (!body) return "an island can not be taken: " + message(body.error());
    const auto parts = convexParts(*body, 3 + random.below(6U));
    if (!parts) return "a body has no convex parts: " + message(parts.error());
    if (std::abs(areaOf(*parts) - body->mass.area) > 1e-9 * (1 + body->mass.area))
      return "the convex parts of a body are not all of it";
    if (std::string wrong = update(world_.commit()); !wrong.empty()) return wrong;
    if (random.chance(50)) {
      if (!put(world_, *body, body->origin)) return "a body does not fit where it was";
      if (!samePolygons(before, world_)) return "a body that came back is another one";
    } else {
      const double angle = random.below(63) / 10.0;
      const Placing placing{{body->origin.i + random.below(20) / 10.0, body->origin.j + random.below(20) / 10.0},
                            std::cos(angle),
                            std::sin(angle)};
      const auto done = putAsItLies(world_, *body, placing);
      if (!done && message(done.error()).empty()) return "a body is refused without a word";
    }
    return update(world_.commit());
  }

  static double areaOf(const std::vector<ConvexPart>& parts) {
    double area = 0;
    for (const ConvexPart& part : parts) {
      for (std::size_t k = 0; k < part.vertices.size(); ++k) {
        const Point a = part.vertices[k], b = part.vertices[(k + 1) % part.vertices.size()];
        const auto of = [](std::int64_t units) { return static_cast<double>(units) / kUnitsPerCell; };
        area += (of(a.x) * of(b.y) - of(a.y) * of(b.x)) / 2;
      }
    }
    return area;
  }

  World world_;
  Followed views_;
  oracle::IslandCheck islandCheck_;
  oracle::PieceCheck pieceCheck_;
};

}  // namespace

std::string followByViews(const World& world, Random& random) {
  constexpr std::uint64_t kMostPolygons = 60;  // the checks take their time
  if (world.stats().polygons > kMostPolygons) return "";
  World twin = builtAnew(world);  // without marks it can be followed
  twin.commit();
  const bool isThere = samePolygons(world, twin) && twin.followCells(true);
  return isThere ? Following(std::move(twin)).run(random) : "what stands in a world can not be placed in another one";
}

}  // namespace lgs::fuzz
