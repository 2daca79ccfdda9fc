// The byte format: total, local, and able to hold every trace.
#include "fuzz/format.h"
#include "oracle/calls/random.h"
#include "oracle/generate/generator.h"

#include <gtest/gtest.h>
#include <map>
#include <set>

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

TEST(FuzzFormat, HoldsRandomTraces) {
  constexpr std::uint64_t kCases = 200;
  std::size_t encoded = 0;
  for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
    const Trace trace = oracle::randomCase({.edits = 60}, seed);
    const auto bytes = encode(trace);
    if (!bytes) continue;  // a polygon far outside its cell, tried in order to be refused
    ++encoded;
    EXPECT_EQ(renamed(decode(*bytes)), renamed(trace)) << "seed " << seed;
  }
  EXPECT_GT(encoded, kCases * 9 / 10);
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

// What a record makes: the edits that the bytes up to its end have more than those up to its beginning.
std::pair<std::size_t, std::size_t> editsOf(const std::vector<std::uint8_t>& bytes, std::size_t record) {
  const auto before = [&](std::size_t n) { return decode(Bytes(bytes).first(n * kRecord)).edits.size(); };
  return {before(record), before(record + 1)};
}

// The adds and commits of all other records stay. So do their removes, except in cells that the changed record edits:
// there a remove may take another polygon.
TEST(FuzzFormat, AFlippedByteChangesOneEdit) {
  Random random(2);
  std::size_t removes = 0;
  for (int round = 0; round < 5'000; ++round) {
    const std::vector<std::uint8_t> bytes = randomBytes(random, 320);
    const std::size_t at = kRecord + random.below(bytes.size() - kRecord);
    const std::size_t record = at / kRecord;
    if (at % kRecord == 0) continue;  // another action may take, or leave, the vertices kept for the next polygon
    if (static_cast<Action>(bytes[record * kRecord] % 16) == Action::vertices) continue;
    const std::vector<std::uint8_t> flipped = [&] {
      auto other = bytes;
      other[at] = static_cast<std::uint8_t>(other[at] ^ (1U << random.below(8U)));
      return other;
    }();

    std::map<std::string, Cell> cellOf;
    std::set<Cell> touched;
    for (const auto* input : {&bytes, &flipped}) {
      const Trace trace = decode(*input);
      const auto [first, last] = editsOf(*input, record);
      for (const Edit& edit : trace.edits)
        if (edit.kind == Edit::Kind::add) cellOf[edit.name] = edit.polygon.cell;
      for (std::size_t k = first; k < last; ++k)
        if (cellOf.contains(trace.edits[k].name)) touched.insert(cellOf[trace.edits[k].name]);
    }
    const auto others = [&](const std::vector<std::uint8_t>& input) {
      const Trace trace = decode(input);
      const auto [first, last] = editsOf(input, record);
      std::vector<Edit> edits;
      for (std::size_t k = 0; k < trace.edits.size(); ++k) {
        const Edit& edit = trace.edits[k];
        if (k >= first && k < last) continue;
        if (edit.kind == Edit::Kind::remove && cellOf.contains(edit.name) && touched.contains(cellOf[edit.name]))
          continue;
        removes += edit.kind == Edit::Kind::remove ? 1 : 0;
        edits.push_back(edit);
      }
      return edits;
    };
    EXPECT_EQ(others(bytes), others(flipped)) << "round " << round << ", byte " << at;
  }
  EXPECT_GT(removes, 30'000U);
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
