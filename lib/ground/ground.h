// What stands where: the cells of a world and the polygons in them. It knows no segment. Every edit, whatever its door,
// ends in one primitive, set(): this cell holds these polygons from now on.
//
// The ground says which cells changed since the last commit. Views, such as the outline, are brought up to date by
// that.
#pragma once

#include "ground/catalogue.h"
#include "ground/cell.h"
#include "ground/cell_changes.h"
#include "ground/grid.h"
#include "storage/bit_set.h"
#include "storage/record_arena.h"

#include <lgs/world.h>

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace lgs::detail {

class Ground {
 public:
  explicit Ground(PreserveRelation relation) : preserve(std::move(relation)) {}
  Ground(const Ground& other);
  Ground& operator=(const Ground&) = delete;
  ~Ground() = default;

  // --- What stands where. A cell may be without chunk: then it holds nothing.

  ContentId contentId(CellAt at) const {
    if (!at) return kEmptyContent;
    return isListed(at) ? list(at.word()).content() : at.word() >> kLowBits;
  }
  const Content& content(CellAt at) const { return catalogue.content(contentId(at)); }
  /// What a cell holds, or held when a note was made of it.
  struct Held {
    std::uint32_t ref = 0;  ///< of the cell
    CellWord word = 0;
    Block block = 0;                     ///< of the only polygon, if the word has one
    const RecordArena* lists = nullptr;  ///< where the list is, if the word refers to one
  };
  Held held(CellAt at) const { return {at.ref(), at.word(), at.chunk->block(at.local), &lists_}; }
  /// Of a cell that holds polygons.
  PlacedBySlot placed(CellAt at) const {
    if (isListed(at)) return PlacedBySlot(list(at.word()));
    return PlacedBySlot(Placed{at.word() & kLowMask, at.chunk->block(at.local)});
  }
  /// By handle, behind what is in `out`. Valid until the next edit.
  void read(const Held& held, std::vector<PlacedPolygon>& out) const;
  /// The serial given out last in the cell.
  std::uint32_t lastSerial(CellAt at) const {
    if (!at) return 0;
    return isListed(at) ? list(at.word()).lastSerial() : at.word() & kLowMask;
  }
  static bool isListed(CellAt at) { return (at.word() & kListBit) != 0; }
  std::optional<Slot> slotOf(PolygonHandle handle) const;
  /// Why slotOf() finds none.
  Error noPolygon(PolygonHandle handle) const;
  bool keeps(Block a, Block b) const { return preserve && (a < b ? preserve(a, b) : preserve(b, a)); }

  PreserveRelation preserve;
  Catalogue catalogue;
  Grid grid;

  /// As Grid::obtain(), for edits.
  CellAt obtain(Cell cell) {
    const std::size_t before = grid.count();
    const CellAt at = grid.obtain(cell);
    if (grid.count() != before) [[unlikely]]
      noteNewChunk(*at.chunk);
    return at;
  }
  /// Forgets the chunks that lie in a rectangle as a whole and hold nothing, and the unloaded ones that no loaded one
  /// is beside. Returns their numbers. Nothing may be noted for marks, and nothing may have changed since the last
  /// commit.
  std::vector<std::uint32_t> forget(const CellRect& cells);

  // --- Chunks that are not in memory (unloaded.cpp). Their cells hold what the loaded chunks beside them need.

  /// The loaded chunks, or the unloaded ones, that lie in a rectangle as a whole: their numbers, by rows.
  std::vector<std::uint32_t> chunksWithin(const CellRect& cells, bool areUnloaded) const;
  /// The first unloaded cell of a rectangle, by rows; nothing if it has none.
  std::optional<Cell> firstUnloaded(const CellRect& cells) const;
  /// A loaded chunk leaves. The checksum is that of the bytes with which it can come back.
  void unload(std::uint32_t number, std::uint32_t checksum);
  /// An unloaded chunk comes back. Its cells are for the caller to set(), with and without polygons; then
  /// settleAround().
  Chunk& load(std::uint32_t number);
  /// The same, and its cells hold nothing. No serial of before is given out again.
  void loadEmpty(std::uint32_t number);
  /// After a chunk came: the unloaded ones beside it hold what it needs.
  void settleAround(const Chunk& chunk);
  /// What forget() left to be done, before a commit.
  void settle() {
    if (!unsettled_.empty()) [[unlikely]]
      settleAll();
  }
  /// After a commit, without marks: chunks that nobody needs are no Chunk any more. Returns their numbers.
  std::vector<std::uint32_t> sleep();
  /// Whether that may find any.
  bool isSleepy() const { return !sleepy_.empty(); }

  // --- The primitive

  /// Gives a cell these polygons, by slot of this content, and notes that it changed.
  void set(CellAt at, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons);
  /// The same with a shape of one polygon, placed last, whose serial fits a word.
  void setSole(CellAt at, const InternedShape& shape, Placed sole) {
    put(at, wordOf(shape.content, sole.serial), sole.block, static_cast<Facts>(shape.facts));
  }

  /// The same in a chunk that has changed already and has room for the block, while nothing is noted. Such an edit
  /// needs no call. False, and nothing is done, if it is not so.
  bool setSoleAgain(CellAt at, const InternedShape& shape, Placed sole) {
    if (isNoting() || at.chunk->dirtyRows == 0 || !at.chunk->hasRoomFor(sole.block)) return false;
    at.word() = wordOf(shape.content, sole.serial);
    at.chunk->setBlockThere(at.local, sole.block);
    mark(at, static_cast<Facts>(shape.facts));
    return true;
  }
  /// The same for many, in two steps, while nothing is noted: the words are written first, and may be put back.
  void settleSole(CellAt at, const InternedShape& shape, Block block) {
    at.chunk->setBlock(at.local, block);
    touch(at, static_cast<Facts>(shape.facts));
  }

  // --- What changed since the last commit

  /// The chunks with changed cells, in the order of their first change. Chunk::dirty says which cells these are.
  std::span<Chunk* const> changedChunks() const { return changed_; }
  /// From now on nothing has changed. If somebody follows, cellChanges() says what had.
  void commit();
  /// What the last commit or rollBack() changed, while it notes for followers.
  const CellChanges& cellChanges() const { return cellChanges_; }

  // --- Going back: while it notes, the ground can go back to any moment since it began to.

  struct Moment {
    std::uint64_t notes = 0;      ///< how many there ever were
    std::uint64_t committed = 0;  ///< how many there were at the last commit
    std::uint64_t shapes = 0;
    bool isClean = true;  ///< whether nothing had changed since that commit
  };
  Moment now() const { return {noteCount(), committed_, catalogue.shapeCount(), changed_.empty()}; }
  /// Who needs notes. The ground notes while there is anybody.
  enum class For : std::uint8_t { marks = 1, group = 2, followers = 4 };
  bool isNoting() const { return notesFor_ != 0; }
  bool isNoting(For whom) const { return (notesFor_ & static_cast<std::uint8_t>(whom)) != 0; }
  /// Followers begin and stop where nothing has changed since the last commit, and there are no marks.
  void startNoting(For whom);
  /// And forgets the notes that nobody else needs.
  void stopNoting(For whom);
  /// For marks: there is none from before this moment any more.
  void forgetBefore(const Moment& moment);
  /// After a commit: nobody will go back to a moment between this one and now. One note for each cell is enough then.
  void squeeze(const Moment& moment);
  /// In silence: for groups of edits, which know that there was no commit since.
  void goBack(const Moment& moment, Undone undone = Undone::drop);
  /// For marks: the same, and cellChanges() says what it did.
  void rollBack(const Moment& moment, Undone undone);
  /// To a moment that rollBack() left behind, where all is as it left it. cellChanges() says what this did.
  void rollForward(const Moment& moment);
  void forgetUndone();
  /// The cells with notes since, each once.
  std::vector<Cell> editedSince(const Moment& moment) const;

  std::uint64_t bytes() const;

 private:
  /// A cell before an edit, with all that its word stands for; a row of changed cells before a commit; a chunk that an
  /// edit made; or the border of a chunk before it was unloaded or came back.
  struct Note {
    // changedCell: since the commit before; settledCell: commits have followed, which have no notes of their own
    enum class Of : std::uint32_t { cell, changedCell, settledCell, row, chunk, turn };
    std::uint32_t ref = 0;   ///< of the cell; of a row 32 * Chunk::index + row; number of the chunk
    std::uint32_t word = 0;  ///< of the cell; the bits of the row; column of the chunk; checksum of the border, or 0
    Block block = 0;         ///< of the cell; row of the chunk; last serial of the border, or 0
    Of of = Of::cell;
    bool isOfCell() const { return of <= Of::settledCell; }
  };

  /// Gives a cell this word, which has its content in use already. The block is that of a word with a polygon.
  void put(CellAt at, CellWord word, Block block, Facts facts) {
    if (isNoting()) [[unlikely]]
      note(at);
    else
      drop(at.word(), lists_);
    at.word() = word;
    if (hasSole(word)) at.chunk->setBlock(at.local, block);
    touch(at, facts);
  }
  bool holdsNothing(CellWord word) const {
    return word <= kLowMask || (isListed(word) && list(word).content() == kEmptyContent);
  }
  static bool isListed(CellWord word) { return (word & kListBit) != 0; }
  static PolygonList list(CellWord word, const RecordArena& lists) { return PolygonList(lists.at(word & ~kListBit)); }
  PolygonList list(CellWord word) const { return list(word, lists_); }
  CellWord makeList(ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons);
  /// Lets go of what a word stands for, whose list would be in this arena.
  void drop(CellWord word, RecordArena& lists) {
    if (word <= kLowMask) return;  // it had no polygons
    if (isListed(word))
      dropList(word, lists);
    else
      catalogue.release(word >> kLowBits);
  }
  void dropList(CellWord word, RecordArena& lists);
  void touch(CellAt at, Facts facts) {
    if (at.chunk->dirtyRows == 0) changed_.push_back(at.chunk);
    mark(at, facts);
  }
  static void mark(CellAt at, Facts facts) {
    Chunk& chunk = *at.chunk;
    chunk.dirtyRows |= RowMask{1} << at.row();
    chunk.dirty[at.row()] |= at.bit();
    chunk.facts[at.local] = facts;
    chunk.everFacts |= facts;
  }
  void noteNewChunk(const Chunk& chunk);
  void note(CellAt at);
  void noteCommit();
  CellWord copyOf(CellWord word);
  void touchAgain(CellAt at);
  Border borderOf(const Chunk& chunk, const Note& as);
  Note turn(const Note& note);
  void settle(std::uint32_t number, bool isNeeded);
  void settleIfUnloaded(std::uint32_t number);
  void settleAll();
  bool isUnloaded(CellAt at) const { return at && at.chunk->isUnloaded; }
  static CellWord moveList(CellWord word, RecordArena& from, RecordArena& to);
  void undo(const Note& note, Undone undone);
  void undoCell(const Note& note, Undone undone);
  void undoRow(const Note& note);
  void undoTo(std::uint64_t notes, Undone undone);
  void redo(const Note& note);
  void redoTo(std::uint64_t notes);
  void giveBack(CellAt at, const Note& note);
  void forgetNotes(std::uint64_t end);
  void endSqueezing();
  enum class Way { commit, back, forth };
  void tell(std::uint64_t begin, std::uint64_t end, Way way);
  std::uint64_t noteCount() const { return forgotten_ + notes_.size(); }

  RecordArena lists_;
  std::vector<Chunk*> changed_;
  std::vector<Note> notes_;
  RecordArena notedLists_;             ///< of the words in notes: so the other arena does not grow with them
  std::size_t dropped_ = 0;            ///< notes at the front of the vector that are forgotten already
  std::uint64_t forgotten_ = 0;        ///< notes that are gone from the front of the vector
  std::uint64_t committed_ = 0;        ///< how many notes there were at the last commit
  std::uint64_t committedBefore_ = 0;  ///< the same for the commit before that one
  // The cells of the notes from squeezedFrom_ on, up to squeezed_.
  BitSet noted_;
  std::uint64_t squeezedFrom_ = 0;
  std::uint64_t squeezed_ = 0;
  std::uint8_t notesFor_ = 0;             ///< bits of For
  std::vector<std::uint32_t> unsettled_;  ///< numbers of chunks that forget() left for the next commit
  std::vector<std::uint32_t> sleepy_;     ///< numbers of unloaded chunks that may have become empty
  // What was undone and can come back, the first to come last.
  std::vector<Note> undoneNotes_;
  std::vector<InternedShape> undoneShapes_;
  CellChanges cellChanges_;
};

}  // namespace lgs::detail
