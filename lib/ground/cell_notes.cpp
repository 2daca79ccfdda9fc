#include "ground/cell_notes.h"

#include "storage/hash_index.h"
#include "storage/held_bytes.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace lgs::detail {
namespace {

/// A set of numbers.
class NumberSet {
 public:
  explicit NumberSet(const void* where) : index_(where) {}
  bool contains(std::uint32_t number) const {
    return index_.find(hashOf(number), [&](std::uint32_t other) { return other == number; }) != HashIndex::kNone;
  }
  /// Whether it was not in it yet.
  bool insert(std::uint32_t number) {
    if (contains(number)) return false;
    index_.insert(hashOf(number), number);
    return true;
  }
  void erase(std::uint32_t number) { index_.erase(hashOf(number), number); }

 private:
  std::uint64_t hashOf(std::uint32_t number) const { return mix(index_.seed(), number); }
  HashIndex index_;
};

}  // namespace

// A copy begins to squeeze anew.
CellNotes::CellNotes(const CellNotes& other, Cells& cells)
    : cells_(cells),
      takenFor_(other.takenFor_),
      notes_(other.notes_),
      lists_(other.lists_),
      committed_(other.committed_),
      undone_(other.undone_),
      undoneShapes_(other.undoneShapes_),
      cellChanges_(other.cellChanges_) {}

void CellNotes::start(For whom) {
  takenFor_ = static_cast<std::uint8_t>(takenFor_ | static_cast<std::uint8_t>(whom));
  if (whom == For::followers) committed_ = notes_.next();
}

void CellNotes::stop(For whom) {
  takenFor_ = static_cast<std::uint8_t>(takenFor_ & ~static_cast<std::uint8_t>(whom));
  if (whom == For::followers) cellChanges_.clear();
  if (!areTaken(For::marks)) forget(areTaken(For::followers) ? committed_ : notes_.next());
  constexpr std::size_t kMost = 4'096;
  if (areTaken() || (notes_.capacity() <= kMost && noted_.bytes() == 0)) return;
  notes_.giveBack();
  lists_ = RecordArena();
  noted_ = BitSet();
}

// --- Taking them

CellNotes::Note CellNotes::noteOf(CellAt at, Note::Of of) {
  return {at.ref(), cells_.moveOut(at, lists_), at.chunk->block(at.local), of};
}

void CellNotes::ofCell(CellAt at) {
  const bool hasChanged = (at.chunk->dirty[at.row()] & at.bit()) != 0;
  notes_.add(noteOf(at, hasChanged ? Note::Of::changedCell : Note::Of::cell));
}

void CellNotes::ofNewChunk(const Chunk& chunk) {
  notes_.add(
      {chunk.index, static_cast<std::uint32_t>(chunk.ci), static_cast<std::uint32_t>(chunk.cj), Note::Of::chunk});
}

void CellNotes::ofTurn(const Cells::Turning& back) { notes_.add(noteOf(back)); }

void CellNotes::ofCommit() {
  if (areTaken(For::followers)) tell(committed_, notes_.next(), Way::commit);
  const std::span<Chunk* const> changed = cells_.changedChunks();
  for (std::size_t k = changed.size(); k-- != 0;) {  // backwards, so that going back meets them in order
    const Chunk& chunk = *changed[k];
    for (RowMask rows = chunk.dirtyRows; rows != 0; rows &= rows - 1) {
      const auto row = static_cast<std::uint32_t>(std::countr_zero(rows));
      notes_.add({chunk.index * kChunkSize + row, chunk.dirty[row], 0, Note::Of::row});
    }
  }
  committedBefore_ = std::exchange(committed_, notes_.next());
  if (!areTaken(For::marks)) forget(committed_);
}

// --- Going back, and forward

CellNotes::Moment CellNotes::now() const {
  return {notes_.next(), committed_, cells_.catalogue.shapeCount(), cells_.changedChunks().empty()};
}

void CellNotes::goBack(const Moment& moment, Undone undone) {
  undoTo(moment.notes, undone);
  committed_ = moment.committed;
  while (cells_.catalogue.shapeCount() > moment.shapes) {
    InternedShape shape = cells_.catalogue.takeShape();
    if (undone == Undone::keep) undoneShapes_.push_back(std::move(shape));
  }
}

void CellNotes::rollBack(const Moment& moment, Undone undone) {
  endSqueezing();
  if (areTaken(For::followers)) {
    // Followers never saw the edits that are pending. Without a commit since the mark there is nothing to tell them.
    if (moment.committed != committed_) undoTo(committed_, undone);
    tell(moment.committed, committed_, Way::back);
  }
  goBack(moment, undone);
}

void CellNotes::undoTo(std::uint64_t number, Undone undone) {
  while (notes_.next() > number) undo(notes_.takeBack(), undone);
}

void CellNotes::undo(const Note& note, Undone undone) {
  if (note.isOfCell()) return undoCell(note, undone);
  const Note again = note.of == Note::Of::turn ? turn(note) : note;
  if (undone == Undone::keep) undone_.push_back(again);
  if (note.of == Note::Of::row) setRow(note, note.word);
  if (note.of == Note::Of::chunk) cells_.grid.forget(note.ref);
}

void CellNotes::undoCell(const Note& note, Undone undone) {
  const CellAt at = cells_.grid.find(note.ref);
  if (undone == Undone::keep)
    undone_.push_back(noteOf(at, note.of));
  else
    cells_.drop(at.word());
  cells_.moveIn(at, note.word, note.block, lists_);
  if (note.of == Note::Of::cell) cells_.setChanged(*at.chunk, at.row(), at.chunk->dirty[at.row()] & ~at.bit());
}

/// The cells of a noted row that have changed.
void CellNotes::setRow(const Note& note, RowMask cells) {
  cells_.setChanged(cells_.grid.chunk(note.ref / kChunkSize), note.ref % kChunkSize, cells);
}

void CellNotes::rollForward(const Moment& moment) {
  endSqueezing();
  for (; cells_.catalogue.shapeCount() < moment.shapes; undoneShapes_.pop_back())
    cells_.catalogue.putShape(std::move(undoneShapes_.back()));
  if (areTaken(For::followers)) {
    // As above: edits that were pending at the moment are told by the next commit.
    if (moment.committed != committed_) redoTo(moment.committed);
    tell(committed_, moment.committed, Way::forth);
  }
  redoTo(moment.notes);
  committed_ = moment.committed;
}

void CellNotes::redoTo(std::uint64_t number) {
  for (; notes_.next() < number; undone_.pop_back()) redo(undone_.back());
}

// The same edits again: a note of each is made anew, and finds the cells changed or not as it did then.
void CellNotes::redo(const Note& note) {
  if (note.isOfCell()) return redoCell(note);
  notes_.add(note.of == Note::Of::turn ? turn(note) : note);
  if (note.of == Note::Of::row) setRow(note, 0);  // the commit noted the last one first
  if (note.of == Note::Of::chunk)                 // the same number is the least that is free
    cells_.grid.obtain(
        {static_cast<std::int32_t>(note.word) * kChunkSize, static_cast<std::int32_t>(note.block) * kChunkSize});
}

void CellNotes::redoCell(const Note& note) {
  const CellAt at = cells_.grid.find(note.ref);
  ofCell(at);
  cells_.moveIn(at, note.word, note.block, lists_);
  if (note.of == Note::Of::settledCell)
    notes_.back().of = note.of;
  else
    cells_.touch(at, at.chunk->facts[at.local]);
}

void CellNotes::forgetUndone() {
  for (const Note& note : undone_)
    if (note.isOfCell()) cells_.drop(note.word, lists_);
  undone_ = {};
  undoneShapes_ = {};
}

std::vector<Cell> CellNotes::editedSince(const Moment& moment) const {
  std::vector<Cell> cells;
  NumberSet known(this);
  for (std::uint64_t k = moment.notes; k < notes_.next(); ++k)
    if (notes_[k].isOfCell() && known.insert(notes_[k].ref)) cells.push_back(cells_.grid.cellOf(notes_[k].ref));
  return cells;
}

// --- Telling followers

/// What changed between two commits, of which these are the notes. The ground is as of the later one. The first note of
/// a cell says what it held at the earlier one. Of a chunk that is, or was, unloaded nothing is told.
void CellNotes::tell(std::uint64_t begin, std::uint64_t end, Way way) {
  NumberSet told(this), turned(this);
  for (std::uint64_t k = begin; k < end; ++k)
    if (notes_[k].of == Note::Of::turn && !turned.insert(notes_[k].ref)) turned.erase(notes_[k].ref);
  std::vector<PlacedPolygon> before, now;
  cellChanges_.clear();
  for (std::uint64_t k = begin; k < end; ++k) {
    const Note& note = notes_[k];
    if (!note.isOfCell() || note.of == Note::Of::changedCell) continue;
    if (way != Way::commit && !told.insert(note.ref)) continue;
    const CellAt at = cells_.grid.find(note.ref);
    before.clear();
    now.clear();
    const bool isUnloaded = at.chunk->isUnloaded, wasUnloaded = isUnloaded != turned.contains(at.chunk->index);
    if (isUnloaded && wasUnloaded) continue;
    if (!wasUnloaded) cells_.read({note.ref, note.word, note.block, &lists_}, way == Way::back ? now : before);
    if (!isUnloaded) cells_.read(cells_.held(at), way == Way::back ? before : now);
    cellChanges_.add(at.cell(), before, now);
  }
  cellChanges_.own();
}

// --- Forgetting

void CellNotes::forgetBefore(const Moment& moment) {
  forget(areTaken(For::followers) ? moment.committed : moment.notes);
}

void CellNotes::forget(std::uint64_t end) {
  if (end > squeezedFrom_) endSqueezing();
  notes_.forgetBefore(end, [&](const Note& note) {
    if (note.isOfCell()) cells_.drop(note.word, lists_);
  });
}

/// Which of the notes since two commits are needed: of each cell the first one. Where nothing had changed since a commit
/// at the moment, no row is, either. What was unloaded in between, and came back, is undone step by step.
void CellNotes::squeeze(const Moment& moment) {
  const std::uint64_t begin = std::max(moment.notes, committedBefore_);
  const bool isClean = begin > moment.notes || moment.isClean;
  if (squeezed_ != begin || squeezedFrom_ < moment.notes) {
    endSqueezing();
    squeezedFrom_ = squeezed_ = begin;
  }
  const std::span<Note> notes = notes_.from(begin);
  if (std::ranges::find(notes, Note::Of::turn, &Note::of) != notes.end()) {
    endSqueezing();
    squeezedFrom_ = squeezed_ = committed_;
    return;
  }
  std::uint64_t end = begin;
  for (Note& note : notes) {
    if (note.of == Note::Of::row && isClean) continue;
    if (note.isOfCell()) {
      if (!noted_.insert(note.ref)) {
        cells_.drop(note.word, lists_);
        continue;
      }
      if (isClean) note.of = Note::Of::settledCell;
    }
    notes_[end++] = note;
  }
  notes_.cut(end);
  squeezed_ = committed_ = end;
}

void CellNotes::endSqueezing() {
  for (std::uint64_t k = squeezedFrom_; k < squeezed_; ++k)
    if (notes_[k].isOfCell()) noted_.erase(notes_[k].ref);
  squeezed_ = squeezedFrom_;
}

std::uint64_t CellNotes::bytes() const {
  return notes_.bytes() + lists_.bytes() + noted_.bytes() + heldBytes(undone_) + cellChanges_.bytes();
}

}  // namespace lgs::detail
