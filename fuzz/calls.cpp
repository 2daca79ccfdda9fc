// Calls of the alphabet (oracle/calls): each comes to what the model says, and after each commit the outline is the
// naive reference's. Here are the calls that no trace has: groups, marks, saves, exchanges, many at once, reals that
// are none.
//
//   header  byte 0     where in the world the cells lie
//           byte 1, 2  preserve pairs of the blocks 0 to 3, a bit each, if byte 3 is odd
//   record  a call: each choice takes the next byte, and then there are zeros (oracle/calls/draw.h)
#include "fuzz/target.h"
#include "oracle/calls/draw.h"
#include "oracle/check/call_check.h"

#include <algorithm>
#include <array>

namespace lgs::fuzz {
namespace calls_target {
namespace {

constexpr std::size_t kMaxCalls = 200;

std::vector<oracle::Call> callsOf(Bytes records) {
  static const oracle::Habits habits = oracle::withLoads(oracle::withMarks({}));
  std::vector<oracle::Call> calls;
  for (; !records.empty() && calls.size() < kMaxCalls; records = records.subspan(std::min(kRecord, records.size()))) {
    auto choices = oracle::Random::of(records.first(std::min(kRecord, records.size())));
    calls.push_back(drawCall(choices, habits));
  }
  return calls;
}

std::optional<Finding> check(Bytes input, oracle::CheckStats& stats) {
  constexpr std::array<Cell, 5> kCorners{{{0, 0}, {-2, -2}, {30, -34}, {kMaxCell - 3, 30}, {-kMaxCell, kMaxCell - 3}}};
  std::array<std::uint8_t, kRecord> header{};
  std::copy_n(input.begin(), std::min(input.size(), kRecord), header.begin());
  oracle::PreservePairs preserve;
  unsigned bits = header[3] % 2 == 0 ? 0 : header[1] | header[2] << 8U;
  for (Block a = 0; a < 4; ++a)
    for (Block b = a; b < 4; ++b, bits >>= 1)
      if (bits & 1U) preserve.add(a, b);
  oracle::CallCheck world(kCorners[header[0] % kCorners.size()], preserve);
  auto calls = callsOf(input.subspan(std::min(kRecord, input.size())));
  calls.emplace_back();  // a commit
  std::string before;
  for (const oracle::Call& call : calls) {
    ++stats.edits;
    if (const auto wrong = world.make(call)) return Finding{before + *wrong + "\n"};
    before += inWords(call) + "\n";
  }
  return std::nullopt;
}

oracle::Trace noTrace(Bytes) { return {}; }
std::string whyEmpty(Bytes) { return "no trace has all calls"; }

constexpr Target kTarget{"calls", "calls of every kind against the model", check, noTrace, nullptr, {}, whyEmpty};

}  // namespace
}  // namespace calls_target

const Target kCalls = calls_target::kTarget;

}  // namespace lgs::fuzz
