// The byte format: total, local, and able to hold every trace.
#include "fuzz/format.h"
#include "oracle/check/generator.h"
#include "oracle/check/random.h"

#include <gtest/gtest.h>
#include <map>

namespace lgs::fuzz {
namespace {

using oracle::Edit;
using oracle::Random;
using oracle::Trace;

std::vector<std::uint8_t> randomBytes(Random& random, std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  return bytes;
}

// Names in order of first use, one that is removed but not there included.
Trace renamed(Trace trace) {
  std::map<std::string, std::string> names;
  std::size_t count = 0;
  for (Edit& edit : trace.edits) {
    if (edit.kind == Edit::Kind::add) names[edit.name] = std::to_string(++count);
    if (edit.kind != Edit::Kind::commit) edit.name = names.contains(edit.name) ? names[edit.name] : "none";
  }
  return trace;
}

std::size_t recordOf(const Edit& edit) { return std::stoul(edit.name.substr(1)); }

TEST(FuzzFormat, HoldsRandomTraces) {
  constexpr std::uint64_t kCases = 200;
  for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
    const Trace trace = oracle::randomCase({.edits = 60}, seed);
    const auto bytes = encode(trace);
    if (!bytes) continue;  // a polygon far outside its cell, tried in order to be refused
    EXPECT_EQ(renamed(decode(*bytes)), renamed(trace)) << "seed " << seed;
  }
}

TEST(FuzzFormat, WhatIsDecodedCanBeEncoded) {
  Random random(1);
  std::size_t encoded = 0;
  for (int round = 0; round < 200; ++round) {
    const Trace trace = decode(randomBytes(random, 400));
    const auto bytes = encode(trace);
    if (!bytes) continue;
    ++encoded;
    EXPECT_EQ(renamed(decode(*bytes)), renamed(trace)) << "round " << round;
  }
  EXPECT_GT(encoded, 100U);
}

TEST(FuzzFormat, AFlippedByteChangesOneEdit) {
  Random random(2);
  for (int round = 0; round < 500; ++round) {
    std::vector<std::uint8_t> bytes = randomBytes(random, 320);
    const Trace before = decode(bytes);
    const std::size_t at = kRecord + random.below(bytes.size() - kRecord);
    if (at % kRecord == 0) continue;  // another action may take, or leave, the vertices kept for the next polygon
    if (static_cast<Action>(bytes[at / kRecord * kRecord] % 16) == Action::vertices) continue;
    bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1U << random.below(8U)));
    const Trace after = decode(bytes);
    const auto othersAdds = [&](const Trace& trace) {
      std::map<std::string, oracle::ScenePolygon> adds;
      for (const Edit& edit : trace.edits) {
        if (edit.kind == Edit::Kind::add && recordOf(edit) != at / kRecord) adds[edit.name] = edit.polygon;
      }
      return adds;
    };
    EXPECT_EQ(othersAdds(before), othersAdds(after)) << "round " << round << ", byte " << at;
  }
}

TEST(FuzzFormat, SaysWhatItCanNotHold) {
  Trace trace;
  trace.edits.push_back(Edit::add("far", {{0, 0}, 1, {{0, 0}, {9 * kUnitsPerCell, 0}, {0, 1}}}));
  EXPECT_EQ(encode(trace).error(), "'far' has a vertex more than 8 cells away from its cell");
  trace.edits[0].polygon.vertices.assign(kMaxVertices + 1, {0, 0});
  EXPECT_EQ(encode(trace).error(), "'far' has more than 512 vertices");
  trace.edits.assign(kMaxEdits, Edit::remove("p"));
  EXPECT_EQ(encode(trace).error(), "2048 edits or more");
  trace.edits.pop_back();
  trace.edits.push_back(Edit::commit());
  const auto most = encode(trace);
  ASSERT_TRUE(most) << most.error();
  const Trace back = decode(*most);
  EXPECT_EQ(editCount(back), kMaxEdits - 1);
  EXPECT_EQ(back.edits.back().kind, Edit::Kind::commit);
}

TEST(FuzzFormat, AnyBytesDecode) {
  EXPECT_TRUE(decode({}).edits.empty());
  Random random(3);
  for (std::size_t size = 0; size < 200; ++size) decode(randomBytes(random, size));
  const Trace large = decode(std::vector<std::uint8_t>(1 << 20, 4));
  EXPECT_GE(editCount(large), kMaxEdits);
  EXPECT_LT(editCount(large), 2 * kMaxEdits);
}

}  // namespace
}  // namespace lgs::fuzz
