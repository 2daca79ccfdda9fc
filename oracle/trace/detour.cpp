#include "oracle/trace/detour.h"

#include "oracle/calls/caller.h"
#include "oracle/calls/draw.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace lgs::oracle {
namespace {

// Some edits in the cells around one.
std::vector<Call> editsDrawn(Random& choices) {
  Habits habits{.width = 3, .height = 3};
  std::fill(habits.weights.begin() + static_cast<std::size_t>(Call::Kind::commit), habits.weights.end(), 0);
  std::vector<Call> edits;
  for (int k = 1 + choices.below(3); k > 0; --k) edits.push_back(drawCall(choices, habits));
  return edits;
}

std::vector<SegmentId> sorted(std::vector<SegmentId> ids) {
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// Edits, commits and goes back to the mark. What that reports is the reverse of what the commit reported.
std::optional<std::string> commitAndGoBack(Caller& caller, Mark mark, const std::vector<Call>& edits) {
  for (const Call& edit : edits) caller.make(edit);
  const Changes& done = caller.world.commit();
  const ChangeLists reverse{sorted(done.added), sorted(done.removed), sorted(done.relinked)};
  if (!caller.world.rollBack(mark)) return "the world can not go back to a mark";
  if (reverse == copyOf(caller.world.changesOfRollBack())) return std::nullopt;
  return "changesOfRollBack() is not the reverse of the commit that was undone";
}

std::optional<std::string> editAndGoBack(Caller& caller, Random& choices) {
  if (choices.chance(50)) {
    Call group;  // it is not kept
    group.kind = Call::Kind::group;
    group.group = editsDrawn(choices);
    caller.make(group);
    return std::nullopt;
  }
  const Mark mark = caller.world.checkpoint();
  for (int visits = choices.below(2); visits >= 0; --visits)
    if (auto complaint = commitAndGoBack(caller, mark, editsDrawn(choices))) return complaint;
  if (!caller.world.forget(mark)) return "a mark is forgotten too early";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> editAndGoBack(World& world, Cell cell, std::uint64_t chance) {
  Random choices(chance);
  Caller caller(std::move(world), {cell.i - 1, cell.j - 1});
  auto complaint = editAndGoBack(caller, choices);
  world = std::move(caller.world);
  return complaint;
}

std::optional<std::string> saveAndLoad(World& world) {
  std::vector<std::byte> bytes;
  const auto saved =
      world.save([&](std::span<const std::byte> piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); });
  if (!saved) return "the world can not be saved: " + message(saved.error());
  auto loaded = World::load(bytes, world.preserveRelation());
  if (!loaded) return "the world that was saved can not be loaded: " + message(loaded.error());
  world = std::move(*loaded);
  return std::nullopt;
}

std::optional<std::string> unloadAndReload(World& world, Cell cell, std::uint64_t chance) {
  Random choices(chance);
  const Cell corner{cell.i & ~31, cell.j & ~31};
  const std::int32_t i = 32 * choices.below(2), j = 32 * choices.below(2);  // its neighbours, too
  const auto inside = [](std::int32_t k) { return std::clamp(k, -kMaxCell, kMaxCell); };
  const CellRect chunks{{inside(corner.i - i), inside(corner.j - j)},
                        {inside(corner.i + i + 31), inside(corner.j + j + 31)}};
  std::vector<std::vector<std::byte>> bytes;
  bool hasCell = false;
  const auto gone = world.unload(chunks, [&](Cell at, std::span<const std::byte> chunk) {
    bytes.emplace_back(chunk.begin(), chunk.end());
    hasCell |= at == corner;
  });
  if (!gone || *gone != bytes.size()) return "unload() does not hand out each chunk once";
  if (hasCell && (world.firstUnloaded({cell, cell}) != cell || !world.polygons(cell).empty()))
    return "a chunk that was unloaded is still there";
  if (const auto done = world.clear(cell); hasCell && (done || done.error().code != ErrorCode::unloaded))
    return "a cell that is unloaded is cleared";
  choices.shuffle(bytes);
  for (const auto& chunk : bytes)
    if (const auto back = world.reload(chunk); !back) return "a chunk does not come back: " + message(back.error());
  if (world.firstUnloaded(chunks)) return "a chunk that came back is unloaded";
  return std::nullopt;
}

}  // namespace lgs::oracle
