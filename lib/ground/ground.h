// The ground: its cells, and the journal of what they held before. Every edit ends in
// put(), by set(): this cell holds these polygons from now on; or by setSole(), for one polygon in an empty cell. Two quick
// ways beside it, setSoleAgain() and Edit::addSoles(), write the word of a cell themselves.
//
// The ground says which cells changed since the last commit. Views, such as the outline, are brought up to date by
// that.
#pragma once

#include "ground/cells.h"
#include "storage/journal.h"

#include <lgs/world.h>

#include <cassert>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {

class Ground : public Cells {
 public:
  explicit Ground(PreserveRelation relation) : Cells(std::move(relation)) {}
  Ground(const Ground&) = default;
  Ground& operator=(const Ground&) = delete;
  ~Ground() = default;

  /// As Grid::obtain(), for edits.
  CellAt obtain(Cell cell) {
    const std::size_t before = grid.count();
    const CellAt at = grid.obtain(cell);
    if (grid.count() != before) [[unlikely]]
      beginChunk(*at.chunk);
    return at;
  }
  /// From now on nothing has changed. Contents without users may be forgotten.
  void endCommit();

  // --- The primitive

  /// Gives a cell these polygons, by slot of this content, and notes that it changed.
  void set(CellAt at, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons);
  /// The same with a shape of one polygon, placed last, whose serial fits a word.
  void setSole(CellAt at, const InternedShape& shape, Placed sole) {
    assert(shape.isSole && sole.serial <= kLowMask);
    put(at, wordOf(shape.content, sole.serial), sole.block, shape.facts);
  }
  /// The same in a chunk that has changed already and has room for the block, while nothing is noted. Such an edit
  /// needs no call. False, and nothing is done, if it is not so.
  bool setSoleAgain(CellAt at, const InternedShape& shape, Placed sole) {
    if (journal.isOn() || at.chunk->dirtyRows == 0 || !at.chunk->hasRoomFor(sole.block)) return false;
    at.word() = wordOf(shape.content, sole.serial);
    at.chunk->setBlock(at.local, sole.block);
    setDirty(at, shape.facts);
    return true;
  }
  /// The same for many, in two steps, while nothing is noted: the words are written first, and may be put back.
  void completeSole(CellAt at, const InternedShape& shape, Block block) {
    at.chunk->setBlock(at.local, block);
    touch(at, shape.facts);
  }

  // --- Roll-back and redo (roll_back.cpp)

  /// One for all things that can roll back: of the outline, too.
  Journal journal;
  /// A note of the ground and the ground exchange what they hold. Which cells have changed is not touched.
  void exchange(Note& note);
  /// Lets go of what a note holds, whatever it is of.
  void drop(const Note& note);
  /// What a cell held, as a note of it says.
  using Cells::held;
  Held held(const Note& note) const {
    return {note.value, note.block, isListed(note.value) ? journal.kept(note.value & ~kListBit).data() : nullptr};
  }
  /// Undoes the edits since a moment. No commit has found something since.
  void takeBack(Journal::Moment moment);
  /// The mark of a moment goes.
  void letGo(Journal::Moment moment) {
    journal.letGo(moment, [this](const Note& note) { drop(note); });
  }
  using Cells::clearChanges;
  using Cells::setChangedCells;

  /// Whether something changed since the last commit, or a chunk came or went.
  bool hasChanged() const { return !changedChunks().empty() || !streamed_.empty(); }

  // --- Chunks that are not in memory (unloaded.cpp)

  /// Forgets the chunks that lie in a rectangle as a whole and hold nothing, and the unloaded ones that no loaded one
  /// is beside. Returns their numbers. There is no mark, and nothing has changed since the last commit.
  std::vector<std::uint32_t> forgetChunks(const CellRect& cells);
  /// The loaded chunks, or the unloaded ones, that lie in a rectangle as a whole: their numbers, by rows.
  std::vector<std::uint32_t> chunksWithin(const CellRect& cells, bool areUnloaded) const;
  /// The first unloaded cell of a rectangle, by rows; nothing if it has none.
  std::optional<Cell> firstUnloaded(const CellRect& cells) const;
  /// A loaded chunk leaves. The checksum is that of the bytes with which it can come back.
  void unload(std::uint32_t number, std::uint32_t checksum);
  /// An unloaded chunk comes back. Some of its cells are `known`; the others, which hold nothing, are for the caller to
  /// bringBack().
  Chunk& load(std::uint32_t number, CellMask& known);
  /// What a cell that comes back holds. It is not noted.
  void bringBack(CellAt at, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons) {
    lay(at, wordFor(content, lastSerial, polygons), polygons.empty() ? 0 : polygons[0].block);
  }
  /// An unloaded chunk comes back, and holds nothing, now and whatever a roll-back or redo leads to. No serial of
  /// before is given out again.
  void loadEmpty(std::uint32_t number);
  /// What a cell holds that there is a note of, also if it is unloaded.
  Held heldNow(std::uint32_t ref);
  /// The outline of a chunk is to be renewed as a whole.
  void stream(std::uint32_t number) { streamed_.push_back(number); }
  /// The first part of a commit: cells of chunks that came or went, and of unloaded ones beside, count as changed.
  void streamChunks() {
    if (!streamed_.empty() || !rims_.empty() || !spare_.empty()) [[unlikely]]
      doStreaming();
  }
  /// The Chunk of a number in use.
  Chunk& wake(std::uint32_t number) {
    if (grid.stateOf(number) == ChunkState::asleep) refreshLater(number);
    return grid.wake(number);
  }
  /// The last part of a commit: frees the Chunk of unloaded chunks with no loaded one beside. Returns their numbers.
  std::vector<std::uint32_t> sleep();
  bool isSleepy() const { return !sleepy_.empty(); }

  std::uint64_t bytes() const;

 private:
  /// Gives a cell this word, which has its content in use already. The block is that of a word with a polygon.
  void put(CellAt at, CellWord word, Block block, Facts facts) {
    if (journal.isOn()) [[unlikely]]
      noteOrDrop(at);
    else
      drop(at.word());
    write(at, word, block, facts);
  }
  void noteOrDrop(CellAt at);
  CellWord wordFor(ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons);
  void beginChunk(const Chunk& chunk);
  void exchangeCell(Note& note);
  void exchangeChunk(Note& note);
  void dropCell(const Note& note);
  using Cells::drop;
  std::vector<std::uint32_t> byRows(std::vector<std::uint32_t> numbers) const;
  CellMask notedCells(std::uint32_t number) const;
  std::uint32_t lastSerialIn(std::uint32_t number);
  void wakeRim(std::uint32_t number);
  void putRimToSleep(std::uint32_t number);
  void trim(std::uint32_t number);
  void refreshLater(std::uint32_t number) { rims_.push_back(number); }
  void refreshAround(std::uint32_t number);
  void refreshRim(std::uint32_t number);
  void doStreaming();
  void noteStreamed(std::uint32_t number);

  // The work of the next commit, as numbers of chunks, which may be there twice or name none any more.
  std::vector<std::uint32_t> streamed_;  ///< those that came, went, or whose outline is of another time
  std::vector<std::uint32_t> rims_;      ///< unloaded ones: whether a loaded one is beside may have changed
  std::vector<std::uint32_t> spare_;     ///< unloaded ones: of what is kept there may be fewer notes
  std::vector<std::uint32_t> sleepy_;    ///< during a commit: unloaded ones without a loaded one beside
};

}  // namespace lgs::detail
