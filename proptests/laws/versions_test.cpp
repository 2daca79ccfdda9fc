// World::version(): it names a state of the ground and its segments, in whichever world, and lists of changes lead from
// one to another.
#include "calls.h"
#include "oracle/trace/call_text.h"
#include "proptests/support/law.h"

#include <lgs/hashes.h>

#include <gtest/gtest.h>

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

/// A world, and the versions that it had at its marks.
struct Timeline {
  Caller caller;
  std::vector<std::uint64_t> marks;
};

class Versions {
 public:
  explicit Versions(const Setting& setting) : now_{setting.start(), {}}, kept_(now_) {}

  void play(const Calls& calls) {
    for (const Call& call : calls.list) make(call);
    commit();
  }
  void keep() { kept_ = now_; }
  void change() { std::swap(now_, kept_); }

 private:
  void make(const Call& call) {
    World& world = now_.caller.world;
    const std::uint64_t before = world.version();
    const std::size_t k = now_.marks.empty() ? 0 : call.nth % now_.marks.size();
    const ChangeLists lists = now_.caller.make(call).changes;
    const bool isSame = lists == ChangeLists();
    switch (call.kind) {
      case Call::Kind::commit:
        EXPECT_TRUE(isSame || world.version() != before);
        if (world.version() != before) {
          EXPECT_FALSE(states_.contains(world.version())) << "another state had this version";
        }
        noteGround();
        break;
      case Call::Kind::mark:
        now_.marks.push_back(before);
        break;
      case Call::Kind::forget:
        if (!now_.marks.empty()) now_.marks.erase(now_.marks.begin() + static_cast<std::ptrdiff_t>(k));
        break;
      case Call::Kind::rollBack:
        if (now_.marks.empty()) break;
        EXPECT_EQ(world.version(), now_.marks[k]);
        EXPECT_EQ(world.changesOfRollBack().before, before);
        EXPECT_EQ(world.changesOfRollBack().after, world.version());
        now_.marks.resize(k + 1);
        break;
      case Call::Kind::load:
        now_.marks.clear();
        EXPECT_FALSE(states_.contains(world.version())) << "a loaded world is another one";
        break;
      default:
        EXPECT_EQ(world.version(), before) << printCall(call);
    }
    note();
  }

  /// What a commit says leads from one version to the next.
  void commit() {
    World& world = now_.caller.world;
    const std::uint64_t before = world.version();
    const Changes& changes = world.commit();
    EXPECT_EQ(changes.before, before);
    EXPECT_EQ(changes.after, world.version());
    noteGround();
    note();
  }

  void note() {
    const State state = stateOf(now_.caller.world);
    EXPECT_EQ(states_.emplace(now_.caller.world.version(), state).first->second, state);
  }

  /// That of a commit.
  void noteGround() {
    const std::uint64_t hash = groundHash(now_.caller.world, {{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}});
    EXPECT_EQ(grounds_.emplace(now_.caller.world.version(), hash).first->second, hash);
  }

  Timeline now_, kept_;
  std::map<std::uint64_t, std::uint64_t> grounds_;  ///< hashes, by version
  std::map<std::uint64_t, State> states_ = {{0, {}}};
};

// Two timelines: one goes on, and the other one is kept for later.
LGS_LAW(Versions, NameTheStatesOfGroundAndSegments, 500,
        (const AnyCalls& first, const AnyCalls& second, const AnyCalls& third, const Setting& setting)) {
  Versions versions(setting);
  versions.play(first);
  versions.keep();
  for (const AnyCalls* calls : {&second, &third, &second}) {
    versions.play(*calls);
    versions.change();
  }
}

}  // namespace
}  // namespace lgs::test
