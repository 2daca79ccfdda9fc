#include "world/validate.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <map>
#include <vector>

namespace lgs::detail {
namespace {

/// Some of it is used by assert() alone.
class Validation {
 public:
  explicit Validation(const World::Impl& world) : ground_(world.ground), outline_(world.outline) {}

  void run() {
    ground_.grid.forEachChunk([this](Chunk& chunk) {
      lookAtChunk(chunk);
      for (CellAt at{&chunk, 0}; at.local < kChunkCells; ++at.local) {
        lookAtCell(at);
        lookAtSegments(at);
      }
    });
    for (std::uint32_t number = 1; number <= ground_.grid.highest(); ++number)
      if (const Border* border = ground_.grid.border(number)) lookAtBorder(number, *border);
    for (const auto notes : {ground_.journal.notes(), ground_.journal.undone()})
      for (const Note& note : notes) lookAtNote(note);
    lookAtUsers();
    lookAtIds();
    assert(ground_.journal.isValid());
  }

 private:
  void lookAtChunk([[maybe_unused]] const Chunk& chunk) const {
    assert(&ground_.grid.chunk(chunk.index) == &chunk && chunk.self() == &chunk);
    assert(chunk.isUnloaded == (ground_.grid.border(chunk.index) != nullptr));
    assert(outline_.hides(chunk.index) == chunk.isUnloaded);
    assert(chunk.dirtyRows == 0);
    for (std::int32_t k = 0; k < 9; ++k) {
      const std::int32_t di = k % 3 - 1, dj = k / 3 - 1;
      [[maybe_unused]] const std::uint32_t number = ground_.grid.numberAt(chunk.ci + di, chunk.cj + dj);
      [[maybe_unused]] const Chunk* beside = chunk.neighbour(di, dj);
      assert(!beside || (beside->index == number && beside->neighbour(-di, -dj) == &chunk));
    }
  }

  void lookAtBorder([[maybe_unused]] std::uint32_t number, const Border& border) {
    assert(border.isRimInChunk == border.runs.empty());
    assert(border.isRimInChunk || ground_.grid.stateOf(number) == ChunkState::asleep);
    assert(std::ranges::is_sorted(border.kept, {}, &Border::Kept::local));
    for (const Border::Run& run : border.runs) use(ground_.held(run.word).content());
    for (const Border::Kept& kept : border.kept) use(ground_.held(kept.word).content());
  }

  /// Of an unloaded chunk each cell is known that there is a note of.
  void lookAtNote(const Note& note) {
    if (note.thing != Thing::cell) return;
    use(ground_.held(note).content());
    if ([[maybe_unused]] const Border* border = ground_.grid.border(note.key / kChunkCells))
      assert(std::ranges::binary_search(border->kept, note.key % kChunkCells, {}, &Border::Kept::local));
  }

  void lookAtCell(CellAt at) {
    const Held held = ground_.held(at);
    use(held.content());
    [[maybe_unused]] const Content& content = ground_.content(at);
    assert(held.size() == content.polygons.size());
    assert(at.chunk->facts[at.local] == content.facts && (content.facts & ~at.chunk->everFacts) == 0);
    assert(at.word() == 0 || inRange(at.cell()));
    for (std::size_t slot = 0; slot < held.size(); ++slot)
      assert(held[slot].serial != 0 && held[slot].serial <= held.lastSerial());
  }

  /// Each is alive, and says where it is; its links lead to segments that are alive, and back.
  void lookAtSegments(CellAt at) {
    const CellSegments list = outline_.lists.of(at);
    assert(outline_.lists.isLive(at) == static_cast<bool>(list));
    for (const std::uint32_t id : list.all()) {
      ++live_;
      [[maybe_unused]] const SegmentRecord& s = outline_.segments[id];
      assert(outline_.segments.isLive(id) && s.cellRef == at.ref() && s.listed == 0);
      for (const std::uint32_t other : {s.predecessor, std::uint32_t{s.successor}})
        if (other != kNoSegment) assert(outline_.segments.isLive(other));
      if (ground_.preserve) continue;
      assert(s.predecessor != kNoSegment && outline_.segments[s.predecessor].successor == id);
      assert(s.successor != kNoSegment && outline_.segments[s.successor].predecessor == id);
    }
  }

  void lookAtUsers() const {
    for ([[maybe_unused]] const auto& [content, users] : users_)
      assert(ground_.catalogue.users(content).value_or(users) == users);
  }

  /// Each id names a segment or is free.
  void lookAtIds() const {
    std::vector<bool> isFree(std::size_t{outline_.segments.maxId()} + 1);
    for (const std::uint32_t id : outline_.segments.free()) {
      assert(!isFree[id] && !outline_.segments.isLive(id));
      isFree[id] = true;
    }
    assert(live_ + outline_.segments.free().size() == outline_.segments.maxId());
  }

  void use(ContentId content) {
    if (content != kEmptyContent) ++users_[content];
  }

  const Ground& ground_;
  const Outline& outline_;
  std::map<ContentId, std::uint32_t> users_;
  std::size_t live_ = 0;
};

}  // namespace

bool isValid(const World::Impl& world) {
  Validation(world).run();
  return true;
}

}  // namespace lgs::detail
