#include "twins.h"

#include "oracle/trace/call_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace lgs::test {

void expectNoDifference(Caller& stayed, Caller& left, const Calls& calls) {
  for (const Call& call : calls.list)
    ASSERT_TRUE(stayed.make(call) == left.make(call)) << "another answer: " << printCall(call);
  EXPECT_EQ(stayed.given, left.given);
  EXPECT_EQ(copyOf(stayed.world.commit()), copyOf(left.world.commit()));
  EXPECT_EQ(snapshotOf(stayed.world, {}), snapshotOf(left.world, {}));
  EXPECT_TRUE(samePolygons(stayed.world, left.world));
  EXPECT_TRUE(saved(stayed.world) == saved(left.world)) << "saved, they are different bytes";
}

Call groupOf(const Calls& calls, Call::Keeps keeps) {
  Call group;
  group.kind = Call::Kind::group;
  group.keeps = keeps;
  std::ranges::copy_if(calls.list, std::back_inserter(group.group),
                       [](const Call& call) { return call.kind < Call::Kind::commit; });
  return group;
}

Follower::Follower(const World& world) {
  for (const SegmentId id : world.segments()) segments_[id] = fieldsOf(*world.segment(id));
}

void Follower::follow(const World& world, const ChangeLists& changes) {
  for (const SegmentId id : changes.removed) EXPECT_EQ(segments_.erase(id), 1U) << "removed: " << id.value;
  for (const SegmentId id : changes.added) EXPECT_TRUE(segments_.emplace(id, SegmentFields{}).second) << id.value;
  for (const auto* ids : {&changes.added, &changes.relinked})
    for (const SegmentId id : *ids) segments_.at(id) = fieldsOf(*world.segment(id));
}

// The lists do not tell the ids of predecessor and successor: a link may go to another segment with the same end.
bool Follower::agrees(const World& world) const {
  const auto told = [](SegmentFields fields) {
    fields.predecessor = fields.successor = {};
    return fields;
  };
  const std::vector<SegmentId> ids = world.segments();
  if (ids.size() != segments_.size()) return false;
  return std::all_of(ids.begin(), ids.end(), [&](SegmentId id) {
    const auto found = segments_.find(id);
    return found != segments_.end() && told(found->second) == told(fieldsOf(*world.segment(id)));
  });
}

void seal(std::vector<std::byte>& bytes) {
  std::uint32_t sum = 0xffff'ffff;
  for (std::size_t k = 0; k + 4 < bytes.size(); ++k) {
    sum ^= std::to_integer<std::uint32_t>(bytes[k]);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (0xedb8'8320u & (0u - (sum & 1u)));
  }
  for (std::size_t k = 0; k < 4; ++k) bytes[bytes.size() - 4 + k] = static_cast<std::byte>(~sum >> 8 * k & 0xffu);
}

}  // namespace lgs::test
