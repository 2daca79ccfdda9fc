// Notes of what cells held before they were edited. With them the ground goes back to where a mark was made, and forward
// again to marks that it went back beyond.
#pragma once

#include "ground/cell_changes.h"
#include "ground/cells.h"
#include "storage/bit_set.h"
#include "storage/journal.h"
#include "storage/record_arena.h"

#include <lgs/world.h>

#include <cstdint>
#include <vector>

namespace lgs::detail {

class CellNotes {
 public:
  explicit CellNotes(Cells& cells) : cells_(cells) {}
  /// Those of a copy, with its own cells.
  CellNotes(const CellNotes& other, Cells& cells);
  CellNotes(const CellNotes&) = delete;
  CellNotes& operator=(const CellNotes&) = delete;
  ~CellNotes() = default;

  /// Who needs notes. They are taken while there is anybody.
  enum class For : std::uint8_t { marks = 1, group = 2, followers = 4 };
  bool areTaken() const { return takenFor_ != 0; }
  bool areTaken(For whom) const { return (takenFor_ & static_cast<std::uint8_t>(whom)) != 0; }
  /// Followers begin and stop where nothing has changed since the last commit, and there are no marks.
  void start(For whom);
  /// Forgets the notes that nobody else needs.
  void stop(For whom);

  // --- Going back, and forward

  struct Moment {
    std::uint64_t notes = 0;      ///< the number of the next one
    std::uint64_t committed = 0;  ///< the same at the last commit
    std::uint64_t shapes = 0;
    bool isClean = true;  ///< whether nothing had changed since that commit
  };
  Moment now() const;
  /// In silence: for groups of edits, which know that there was no commit since.
  void goBack(const Moment& moment, Undone undone = Undone::drop);
  /// For marks: the same, and cellChanges() says what it did.
  void rollBack(const Moment& moment, Undone undone);
  /// To a moment that rollBack() left behind, where all is as it left it. cellChanges() says what this did.
  void rollForward(const Moment& moment);
  void forgetUndone();
  /// For marks: there is none from before this moment any more.
  void forgetBefore(const Moment& moment);
  /// After a commit: nobody will go back to a moment between this one and now. One note for each cell is enough then.
  void squeeze(const Moment& moment);
  /// The cells with notes since, each once.
  std::vector<Cell> editedSince(const Moment& moment) const;
  /// What the last commit, rollBack() or rollForward() changed, while notes are taken for followers.
  const CellChanges& cellChanges() const { return cellChanges_; }

  std::uint64_t bytes() const;

 private:
  friend class Ground;  // which takes them as it edits

  // --- Taking them

  /// Before a cell gets another word. The note takes over what its word stands for.
  void ofCell(CellAt at);
  void ofNewChunk(const Chunk& chunk);
  /// What undoes a turn.
  void ofTurn(const Cells::Turning& back);
  /// Before a commit says that no cell has changed.
  void ofCommit();

  /// A cell before an edit, with all that its word stands for; a row of changed cells before a commit; a chunk that an
  /// edit made; or what undoes that a chunk was unloaded or came back.
  struct Note {
    // changedCell: since the commit before; settledCell: commits have followed, which have no notes of their own
    enum class Of : std::uint32_t { cell, changedCell, settledCell, row, chunk, turn };
    std::uint32_t ref = 0;   ///< of the cell; of a row 32 * Chunk::index + row; number of the chunk
    std::uint32_t word = 0;  ///< of the cell; the bits of the row; column of the chunk; checksum of the turn
    Block block = 0;         ///< of the cell; row of the chunk; last serial of the turn
    Of of = Of::cell;
    bool isOfCell() const { return of <= Of::settledCell; }
  };
  enum class Way { commit, back, forth };

  static Note noteOf(const Cells::Turning& turn) {
    return {turn.number, turn.checksum, turn.lastSerial, Note::Of::turn};
  }
  Note noteOf(CellAt at, Note::Of of);
  /// Does, or undoes, what the note of a turn says. Returns a note of the opposite.
  Note turn(const Note& note) { return noteOf(cells_.turn({note.ref, note.word, note.block})); }
  void undo(const Note& note, Undone undone);
  void undoCell(const Note& note, Undone undone);
  void undoTo(std::uint64_t number, Undone undone);
  void redo(const Note& note);
  void redoCell(const Note& note);
  void redoTo(std::uint64_t number);
  void setRow(const Note& note, RowMask cells);
  void forget(std::uint64_t end);
  void endSqueezing();
  void tell(std::uint64_t begin, std::uint64_t end, Way way);

  Cells& cells_;
  std::uint8_t takenFor_ = 0;  ///< bits of For
  Journal<Note> notes_;
  RecordArena lists_;                  ///< of the words in notes: so that of the cells does not grow with them
  std::uint64_t committed_ = 0;        ///< the number of the next note at the last commit
  std::uint64_t committedBefore_ = 0;  ///< the same for the commit before that one
  // The cells of the notes from squeezedFrom_ on, up to squeezed_.
  BitSet noted_;
  std::uint64_t squeezedFrom_ = 0;
  std::uint64_t squeezed_ = 0;
  // What was undone and can come back, the first to come last.
  std::vector<Note> undone_;
  std::vector<InternedShape> undoneShapes_;
  CellChanges cellChanges_;
};

}  // namespace lgs::detail
