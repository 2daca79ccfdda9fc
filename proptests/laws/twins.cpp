#include "twins.h"

#include "oracle/trace/call_text.h"

#include <gtest/gtest.h>

#include <algorithm>

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

void seal(std::vector<std::byte>& bytes) {
  std::uint32_t sum = 0xffff'ffff;
  for (std::size_t k = 0; k + 4 < bytes.size(); ++k) {
    sum ^= std::to_integer<std::uint32_t>(bytes[k]);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (0xedb8'8320u & (0u - (sum & 1u)));
  }
  for (std::size_t k = 0; k < 4; ++k) bytes[bytes.size() - 4 + k] = static_cast<std::byte>(~sum >> 8 * k & 0xffu);
}

}  // namespace lgs::test
