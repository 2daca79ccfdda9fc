// Any calls, by the one maker: what the bytes choose is what each operation does. Between traces of calls is done, by
// other records, what nobody may notice (beside.h).
#include "fuzz/beside.h"
#include "fuzz/check_edits.h"
#include "oracle/trace/player.h"

namespace lgs::fuzz {
namespace calls_target {
namespace {

constexpr std::size_t kMaxCalls = 200;
constexpr std::size_t kMaxBesides = 12;  // they take their time
constexpr std::uint8_t kBeside = 216;

bool isBeside(Bytes record) { return !record.empty() && record[0] >= kBeside; }

// The records that make calls; the first is the seed of habits.
oracle::Trace traceOf(Bytes input) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t at = 0; at < input.size(); at += kRecord) {
    const Bytes record = input.subspan(at, std::min(kRecord, input.size() - at));
    if (at == 0 || !isBeside(record)) bytes.insert(bytes.end(), record.begin(), record.end());
  }
  return oracle::caseOf(bytes, {.edits = kMaxCalls, .isOfCalls = true});
}

std::optional<Finding> checkTrace(const oracle::Trace& trace, oracle::CheckStats& stats) {
  return checkEdits(trace, {.unionAtEnd = true}, stats);
}

std::optional<Finding> check(Bytes input, oracle::CheckStats& stats) {
  const oracle::Trace trace = traceOf(input);
  if (auto finding = checkTrace(trace, stats)) return finding;
  oracle::Player player(trace.preserve);
  static_cast<void>(play(trace, player));
  if (!player.model().isWhole()) return std::nullopt;
  World world = player.world();
  std::size_t besides = 0;
  for (std::size_t at = kRecord; at < input.size() && besides < kMaxBesides; at += kRecord) {
    const Bytes record = input.subspan(at, std::min(kRecord, input.size() - at));
    if (!isBeside(record)) continue;
    ++besides;
    oracle::Random random = seededBy(record);
    if (const std::string wrong = beside(world, record[0], random); !wrong.empty())
      return Finding{"beside the calls: " + wrong + "\n"};
  }
  return std::nullopt;
}

constexpr Target kTarget{"calls", "calls of every kind against the model", check, traceOf, checkTrace};

}  // namespace
}  // namespace calls_target

const Target kCalls = calls_target::kTarget;

}  // namespace lgs::fuzz
