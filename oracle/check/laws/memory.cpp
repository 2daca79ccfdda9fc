// What goes leaves nothing. In a new world all calls are made that led to this one; then all of it is brought back to be
// cleared, and left: it is as if no edit had ever been there. So the same can be done again, and again, and what the
// world holds then is what it held the times before.
#include "oracle/check/laws/list.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace lgs::oracle {
namespace {

constexpr CellRect kEverywhere{{-kMaxCell, -kMaxCell}, {kMaxCell, kMaxCell}};

// Lists grow in the first rounds. Records of cells come in pages of 2^16 words: what the cells of a chunk that is empty
// again keep, two words each, fills one after 32 rounds.
constexpr int kFirst = 2, kFew = 3, kMany = 44;

// Whether the cells of a chunk may keep lists: it came back empty, and a cell has had more polygons than a word counts.
bool areListsLeft(const Player& player) {
  constexpr std::size_t kCounted = 255;
  return player.past().size() > kCounted && std::ranges::any_of(player.past(), [](const auto& told) {
           return told->call.kind == Call::Kind::reloadEmpty && told->outcome.count > 0;
         });
}

// Of chunks that nobody needs only the rim is known: 12 bytes for a run of its 124 cells, and some more.
std::string wrongSleep(World world) {
  constexpr std::uint64_t kMost = 124 * 12 + 512;
  if (!world.unload(kEverywhere, [](Cell, std::span<const std::byte>) {})) return "not all can leave memory";
  world.commit();
  const Stats asleep = world.stats();
  if (!world.forgetChunks(kEverywhere)) return "what has left memory can not be forgotten";
  const Stats left = world.stats();
  if (left.chunks != 0) return fmt::format("{} chunks that left memory are not forgotten", left.chunks);
  if (asleep.bytes <= left.bytes + asleep.chunks * kMost) return "";
  return fmt::format("{} chunks that nobody needs take {} bytes", asleep.chunks, asleep.bytes - left.bytes);
}

std::string wrongMemory(const Player& player, bool isLong) {
  const int rounds = isLong ? kMany : kFew;
  World world(relationOf(player.preserve()));
  std::uint64_t first = 0;
  for (int round = 1; round <= rounds; ++round) {
    Caller caller(std::move(world));  // with no chunk on its shelf
    for (const auto& told : player.past())
      told->outcome.refusal ? static_cast<void>(caller.makeShapes(told->call))
                            : static_cast<void>(caller.makeResolved(told->call));
    world = std::move(caller.world);
    world.commit();
    if (round == 1)
      if (std::string wrong = wrongSleep(world); !wrong.empty()) return wrong;
    if (!world.reloadEmpty(kEverywhere) || !world.clear(kEverywhere)) return "what stands can not be taken away";
    world.commit();
    if (!world.forgetChunks(kEverywhere)) return "an empty world can not be left";
    const Stats left = world.stats();
    if (left.polygons + left.cells + left.segments + left.chunks != 0)
      return fmt::format("of an empty world that was left {} segments and {} chunks stay", left.segments, left.chunks);
    if (round == kFirst) first = left.bytes;
    if (round == rounds && left.bytes > first)
      return fmt::format("emptied and left, the world holds {} bytes after {} times, and {} after {}", first, kFirst,
                         left.bytes, rounds);
  }
  return "";
}

// As many other polygons each time: they read as they were placed, leave memory, come back or are forgotten, and of those
// before them nothing is left. What is not used any more is looked for once there are 1,024 of it, by a commit, too.
std::string wrongContents() {
  constexpr std::int32_t kSide = 36, kEach = kSide * kSide, kRounds = 4;
  constexpr CellRect kCells{{0, 0}, {kSide - 1, kSide - 1}};
  World world;
  std::uint64_t first = 0;
  for (std::int32_t round = 1; round <= kRounds; ++round) {
    const auto triangle = [&](std::int32_t k) {
      return std::array<LocalPoint, 3>{{{0, 0}, {kUnitsPerCell, round * kEach + k}, {0, kUnitsPerCell}}};
    };
    for (std::int32_t k = 0; k < kEach; ++k)
      if (!world.add({k % kSide, k / kSide}, triangle(k), 1)) return "a good polygon is refused";
    for (std::int32_t k = 0; k < kEach; ++k) {
      const auto there = world.polygons({k % kSide, k / kSide});
      if (there.size() != 1 || !std::ranges::equal(there[0].vertices, triangle(k)))
        return "of many polygons that came after others one is not as it was placed";
    }
    world.commit();
    std::vector<std::vector<std::byte>> away;
    const auto keep = [&](Cell, std::span<const std::byte> bytes) { away.emplace_back(bytes.begin(), bytes.end()); };
    if (!world.unload(kEverywhere, keep)) return "not all can leave memory";
    world.commit();
    if (round % 2 == 0 && !world.forgetChunks(kEverywhere)) return "what has left memory can not be forgotten";
    for (const auto& bytes : away)
      if (round % 2 != 0 && !world.reload(bytes)) return "what has left memory does not come back";
    if (!world.clear(kCells)) return "what stands can not be taken away";
    world.commit();
    if (round == kFirst) first = world.stats().bytes;
  }
  const std::uint64_t last = world.stats().bytes;
  if (!world.add({}, kUnitSquare, 1) || world.stats().bytes < last) return "a commit keeps what is not used any more";
  return last <= first ? ""
                       : fmt::format("emptied, a world holds {} bytes after {} polygons, and {} after {}", first,
                                     kFirst * kEach, last, kRounds * kEach);
}

class MemoryLaw : public Law {
 public:
  Found atEnd(Seen& seen) override {
    const Player& player = seen.library->player();
    constexpr std::size_t kNowAndThen = 16;  // it depends on no call
    if (player.past().size() % kNowAndThen == 0)
      if (std::string wrong = wrongContents(); !wrong.empty())
        return seen.mismatch(Mismatch::Kind::memory, std::move(wrong));
    if (!player.isOfOnePast()) return std::nullopt;
    std::string wrong = wrongMemory(player, areListsLeft(player));
    return wrong.empty() ? std::nullopt : Found(seen.mismatch(Mismatch::Kind::memory, std::move(wrong)));
  }
};

}  // namespace

std::unique_ptr<Law> laws::memory() { return std::make_unique<MemoryLaw>(); }

}  // namespace lgs::oracle
