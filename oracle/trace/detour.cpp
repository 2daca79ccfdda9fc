#include "oracle/trace/detour.h"

#include "oracle/trace/step.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace lgs::oracle {
namespace {

using Complaint = std::optional<std::string>;

template <class T>
Complaint complaintOf(const Expected<T>& result, const char* what) {
  if (result) return std::nullopt;
  return fmt::format("{}, which must be undone, is refused: {}", what, message(result.error()));
}

CellRect around(Cell cell) {
  const auto within = [](std::int32_t index) { return std::clamp(index, -kMaxCell, kMaxCell); };
  return {{within(cell.i - 1), within(cell.j - 1)}, {within(cell.i + 1), within(cell.j + 1)}};
}

Complaint editWrongly(World& world, Cell cell, unsigned how) {
  const std::vector<PlacedPolygon> there = world.polygons(cell);
  if (how == 0 && !there.empty()) return complaintOf(world.setBlock(there[0].handle, there[0].block + 1), "setBlock()");
  if (how == 1 && !there.empty()) return complaintOf(world.remove(there[0].handle), "remove()");
  const auto square = world.shape(kUnitSquare);
  if (!square) return complaintOf(square, "shape()");
  if (how == 2) return complaintOf(world.replace(cell, *square, 1), "replace()");
  if (auto complaint = complaintOf(world.clear(around(cell)), "clear()")) return complaint;
  return complaintOf(world.fill(around(cell), *square, 1), "fill()");
}

using Ids = std::vector<SegmentId>;

Ids sorted(Ids ids) {
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// Edits, commits and goes back to the mark. What that reports is the reverse of what the commit reported.
Complaint commitAndGoBack(World& world, Mark mark, Cell cell, unsigned how) {
  if (auto complaint = editWrongly(world, cell, how)) return complaint;
  const Changes& done = world.commit();
  const std::array reverse{sorted(done.added), sorted(done.removed), sorted(done.relinked)};
  if (!world.rollBack(mark)) return "the world can not go back to a mark";
  const Changes& undone = world.changesOfRollBack();
  if (reverse == std::array{undone.removed, undone.added, undone.relinked}) return std::nullopt;
  return "changesOfRollBack() is not the reverse of the commit that was undone";
}

}  // namespace

std::optional<std::string> editAndGoBack(World& world, Cell cell, std::uint64_t chance) {
  const bool commits = bitsOf(chance, 0, 1) != 0, twice = bitsOf(chance, 1, 1) != 0;
  const unsigned how = bitsOf(chance, 2, 2), next = bitsOf(chance, 4, 2);
  if (!commits) {
    const Transaction group = world.edit();
    if (auto complaint = editWrongly(world, cell, how)) return complaint;
    return twice ? editWrongly(world, cell, next) : std::nullopt;
  }
  const Mark mark = world.checkpoint();
  if (auto complaint = commitAndGoBack(world, mark, cell, how)) return complaint;
  if (twice)
    if (auto complaint = commitAndGoBack(world, mark, cell, next)) return complaint;
  if (!world.forget(mark)) return "a mark is forgotten too early";
  return std::nullopt;
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

}  // namespace lgs::oracle
