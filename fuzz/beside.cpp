#include "fuzz/beside.h"

#include "fuzz/questions.h"
#include "fuzz/same.h"
#include "fuzz/strokes.h"
#include "oracle/calls/caller.h"
#include "oracle/calls/draw.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace lgs::fuzz {
namespace {

using oracle::Random;

void live(World& world, Random& random) {
  editSome(world, random);
  if (random.chance(70)) world.commit();
}

/// A group of edits that is not kept leaves no trace.
void tryInVain(World& world, Random& random) {
  const Transaction group = world.edit();
  const Stroke stroke = drawStroke(world, random);
  static_cast<void>(stroke.make(world));
}

}  // namespace

void editSome(World& world, Random& random) {
  const Cell corner = world.bounds().value_or(CellRect{}).min;
  oracle::Habits habits;
  for (std::size_t k = static_cast<std::size_t>(oracle::Call::Kind::commit); k < habits.weights.size(); ++k)
    habits.weights[k] = 0;
  oracle::Caller caller(std::move(world), {std::min(corner.i, kMaxCell - 3), std::min(corner.j, kMaxCell - 3)});
  for (int k = 1 + random.below(4); k > 0; --k) caller.make(drawCall(random, habits));
  world = std::move(caller.world);
  if (random.chance(40)) static_cast<void>(drawStroke(world, random).make(world));
}

std::string undoAndRedo(World& world, Random& random) {
  const World before = world;
  std::vector<Mark> marks{world.mark()};
  std::vector<World> then{world};
  for (int k = 1 + random.below(3); k > 0; --k) {
    live(world, random);
    marks.push_back(world.mark());
    then.push_back(world);
  }
  Follower follower(world);
  std::size_t at = marks.size() - 1;
  for (int visits = 1 + random.below(5); visits > 0; --visits) {
    const std::size_t to = random.below(marks.size());
    const auto done = to <= at ? world.rollBack(marks[to], Undone::keep) : world.redo(marks[to]);
    if (!done) return "a mark is lost: " + message(done.error());
    at = to;
    if (std::string wrong = follower.follow(world, world.changesOfRollBack()); !wrong.empty())
      return "roll-back and redo: " + wrong;
    if (std::string wrong = differenceOf(then[at], world); !wrong.empty()) return "roll-back and redo: " + wrong;
    if (random.chance(30) && !saved(world).empty()) world.commit();  // nothing is pending
    if (random.chance(30)) tryInVain(world, random);
    if (!random.chance(30)) continue;
    // What comes later is as if it had never rolled back.
    World stayed = then[at], left = world;
    Random same = random;
    live(stayed, same);
    live(left, random);
    if (std::string wrong = differenceOf(stayed, left); !wrong.empty()) return "after roll-back and redo: " + wrong;
  }
  const bool isBack =
      random.chance(50) ? world.rollBack(marks[0]).has_value() : world.rollBack(marks[0], Undone::keep).has_value();
  if (!isBack || !world.forget(marks[0])) return "the first mark is lost";
  return differenceOf(before, world);
}

std::string commitByExecutor(const World& world) {
  World slow = builtAnew(world);
  if (!samePolygons(world, slow)) return "what stands in a world can not be placed in another one";
  World quick = slow;
  const oracle::ChangeLists one = oracle::copyOf(slow.commit());
  const auto backwards = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    while (count-- > 0) job(count);
  };
  if (one != oracle::copyOf(quick.commit(backwards))) return "an executor's commit reports something else";
  const std::string wrong = differenceOf(slow, quick);
  return wrong.empty() ? differenceByLaws(slow) : "an executor's commit leaves " + wrong;
}

std::string beside(World& world, unsigned which, Random& random) {
  switch (which % kBesides) {
    case 0: {
      std::string wrong = wrongReads(world);
      return wrong.empty() ? wrongAnswers(world, random) : wrong;
    }
    case 1:
      return undoAndRedo(world, random);
    case 2:
      return unloadSome(world, random);
    case 3:
      return commitByExecutor(world);
    case 4:
      return followByViews(world, random);
    case 5:
      return strokeAndGoBack(world, random);
    case 6:
      return refuseAll(world);
    default:
      return crowdAndLeave(world, random);
  }
}

}  // namespace lgs::fuzz
