// Calls of the alphabet (oracle/calls): each comes to what the model says, and after each commit the outline is the
// naive reference's. Here are the calls that no trace has: groups, marks, saves, exchanges, many at once, reals that
// are none. Between them is done what the calls may not notice (beside.h).
//
//   header  byte 0     where in the world the cells lie
//           byte 1, 2  preserve pairs of the blocks 0 to 3, a bit each, if byte 3 is odd
//   record  a call: each choice takes the next byte, and then there are zeros (oracle/calls/draw.h). From kBeside on
//           the first byte says what is done beside, and all others are the seed of that
#include "fuzz/beside.h"
#include "fuzz/target.h"
#include "oracle/calls/draw.h"
#include "oracle/check/call_check.h"

#include <algorithm>
#include <array>

namespace lgs::fuzz {
namespace calls_target {
namespace {

constexpr std::size_t kMaxCalls = 200;

constexpr std::size_t kMaxBesides = 12;  // they take their time
constexpr std::uint8_t kBeside = 216;

oracle::Call callOf(Bytes record) {
  static const oracle::Habits habits = oracle::withLoads(oracle::withMarks({}));
  auto choices = oracle::Random::of(record);
  return drawCall(choices, habits);
}

std::optional<std::string> doBeside(World& world, Bytes record) {
  oracle::Random random = seededBy(record);
  std::string wrong = beside(world, record[0], random);
  return wrong.empty() ? std::nullopt : std::optional(std::move(wrong));
}

std::optional<Finding> check(Bytes input, oracle::CheckStats& stats) {
  constexpr std::array<Cell, 5> kCorners{{{0, 0}, {-2, -2}, {30, -34}, {kMaxCell - 3, 30}, {-kMaxCell, kMaxCell - 3}}};
  std::array<std::uint8_t, kRecord> header{};
  std::copy_n(input.begin(), std::min(input.size(), kRecord), header.begin());
  oracle::PreservePairs preserve;
  unsigned bits = header[3] % 2 == 0 ? 0U : header[1] | unsigned{header[2]} << 8U;
  for (Block a = 0; a < 4; ++a)
    for (Block b = a; b < 4; ++b, bits >>= 1)
      if (bits & 1U) preserve.add(a, b);
  oracle::CallCheck world(kCorners[header[0] % kCorners.size()], preserve);
  std::string before;
  std::size_t calls = 0, besides = 0;
  const auto next = [&](Bytes record) -> std::optional<Finding> {
    const bool isBeside = !record.empty() && record[0] >= kBeside;
    if (isBeside ? ++besides > kMaxBesides : ++calls > kMaxCalls) return std::nullopt;
    ++stats.edits;
    const oracle::Call call = record.empty() ? oracle::Call() : callOf(record);  // a commit
    const auto wrong = isBeside ? doBeside(world.world(), record) : world.make(call);
    if (wrong) return Finding{before + *wrong + "\n"};
    before += (isBeside ? "something beside" : inWords(call)) + "\n";
    return std::nullopt;
  };
  for (Bytes rest = input.subspan(std::min(kRecord, input.size())); !rest.empty();) {
    const Bytes record = rest.first(std::min(kRecord, rest.size()));
    if (auto finding = next(record)) return finding;
    rest = rest.subspan(record.size());
  }
  return next({});
}

oracle::Trace noTrace(Bytes) { return {}; }
std::string whyEmpty(Bytes) { return "no trace has all calls"; }

constexpr Target kTarget{"calls", "calls of every kind against the model", check, noTrace, nullptr, {}, whyEmpty};

}  // namespace
}  // namespace calls_target

const Target kCalls = calls_target::kTarget;

}  // namespace lgs::fuzz
