// World::version(): it names a state of the segments, in whichever world, and lists of changes lead from one to
// another.
#include "proptests/support/law.h"
#include "proptests/support/traces.h"
#include "twins.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

namespace lgs::test {
namespace {

/// The segments without what no list tells: a link may go to another segment with the same end.
using State = std::map<SegmentId, SegmentFields>;
State stateOf(const World& world) {
  State state;
  for (const SegmentId id : world.segments()) {
    SegmentFields fields = fieldsOf(*world.segment(id));
    fields.predecessor = fields.successor = {};
    state.emplace(id, fields);
  }
  return state;
}

bool isEmpty(const Changes& changes) {
  return changes.removed.empty() && changes.added.empty() && changes.relinked.empty();
}

/// A world, and the marks that it knows with the versions that it had there.
struct Timeline {
  World world;
  std::vector<std::pair<Mark, std::uint64_t>> marks;
};

class Versions {
 public:
  explicit Versions(bool preserves) : preserves_(preserves), now_{grown(preserves, {}), {}}, kept_(now_) {}

  void move(Chance& chance) {
    const int what = chance.below(100);
    if (what < 50) return static_cast<void>(makeEdit(now_.world, editOf(chance)));
    if (what < 70) return commit();
    if (what < 80) return now_.marks.emplace_back(now_.world.checkpoint(), now_.world.version()), void();
    if (what < 90) return goBack(chance);
    if (what < 94) return static_cast<void>(kept_ = now_);
    if (what < 98) return std::swap(now_, kept_), note();
    load();
  }

 private:
  AnyEdit editOf(Chance& chance) const {
    AnyEdit edit = randomEdit(now_.world, chance);
    if (edit.kind == AnyEdit::Kind::commit) edit.kind = AnyEdit::Kind::clear;
    return edit;
  }

  void commit() {
    const std::uint64_t before = now_.world.version();
    const Changes& changes = now_.world.commit();
    EXPECT_EQ(changes.before, before);
    EXPECT_EQ(changes.after, now_.world.version());
    EXPECT_EQ(changes.before == changes.after, isEmpty(changes));
    if (!isEmpty(changes)) {
      EXPECT_FALSE(states_.contains(changes.after)) << "another state had this version";
    }
    note();
  }

  void goBack(Chance& chance) {
    if (now_.marks.empty()) return;
    const std::size_t k = chance.below(now_.marks.size());
    const std::uint64_t before = now_.world.version();
    EXPECT_TRUE(now_.world.rollBack(now_.marks[k].first));
    const Changes& changes = now_.world.changesOfRollBack();
    EXPECT_EQ(changes.before, before);
    EXPECT_EQ(changes.after, now_.world.version());
    EXPECT_EQ(changes.after, isEmpty(changes) ? before : now_.marks[k].second);
    now_.marks.resize(k + 1);
    note();
  }

  void load() {
    now_.world.commit();
    note();
    auto loaded = World::load(saved(now_.world), relation(preserves_));
    ASSERT_TRUE(loaded);
    now_ = {std::move(*loaded), {}};
    EXPECT_FALSE(states_.contains(now_.world.version())) << "a loaded world is another one";
    note();
  }

  void note() {
    const State state = stateOf(now_.world);
    EXPECT_EQ(states_.emplace(now_.world.version(), state).first->second, state);
  }

  bool preserves_;
  Timeline now_, kept_;
  std::map<std::uint64_t, State> states_ = {{0, {}}};
};

LGS_LAW(Versions, NameTheStatesOfTheSegments, 500, (const Seeds& seeds, bool preserves)) {
  Versions versions(preserves);
  for (const std::uint32_t seed : seeds) {
    Chance chance(seed);
    for (int k = 0; k < 4; ++k) versions.move(chance);
  }
}

}  // namespace
}  // namespace lgs::test
