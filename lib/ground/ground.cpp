#include "ground/ground.h"

#include "geometry/sort.h"
#include "storage/held_bytes.h"

#include <algorithm>
#include <bit>

namespace lgs::detail {
namespace {

/// A set of numbers.
class NumberSet {
 public:
  explicit NumberSet(const Ground& ground) : index_(&ground) {}
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

Ground::Ground(const Ground& other)
    : preserve(other.preserve),
      catalogue(other.catalogue),
      grid(other.grid),
      lists_(other.lists_),
      changed_(other.changed_),
      notes_(other.notes_),
      notedLists_(other.notedLists_),
      dropped_(other.dropped_),
      forgotten_(other.forgotten_),
      committed_(other.committed_),
      notesFor_(other.notesFor_),
      unsettled_(other.unsettled_),
      sleepy_(other.sleepy_),
      undoneNotes_(other.undoneNotes_),
      undoneShapes_(other.undoneShapes_),
      cellChanges_(other.cellChanges_) {
  for (Chunk*& chunk : changed_) chunk = &grid.chunk(chunk->index);
}

std::optional<Slot> Ground::slotOf(PolygonHandle handle) const {
  const CellAt at = grid.find(handle.cellRef);
  if (isUnloaded(at)) return std::nullopt;
  const std::size_t count = content(at).polygons.size();
  for (Slot slot = 0; slot < count; ++slot)
    if (placed(at)[slot].serial == handle.serial) return slot;
  return std::nullopt;
}

void Ground::set(CellAt at, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons) {
  const Facts facts = catalogue.use(content);
  const bool fits = fitsWord(lastSerial, polygons);
  put(at, fits ? wordOf(content, lastSerial) : makeList(content, lastSerial, polygons),
      polygons.empty() ? 0 : polygons[0].block, facts);
}

CellWord Ground::makeList(ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons) {
  const RecordArena::Ref ref = lists_.allocate(PolygonList::sizeOf(polygons.size()));
  std::uint32_t* out = lists_.at(ref);
  *out++ = wordOf(content, static_cast<std::uint32_t>(polygons.size()));
  *out++ = lastSerial;
  for (const Placed& placed : polygons) {
    *out++ = placed.serial;
    *out++ = placed.block;
  }
  return kListBit | ref;
}

void Ground::dropList(CellWord word, RecordArena& lists) {
  const PolygonList old = list(word, lists);
  catalogue.release(old.content());
  lists.release(word & ~kListBit, PolygonList::sizeOf(old.size()));
}

/// The same word, with its list, if it has one, in another arena.
CellWord Ground::moveList(CellWord word, RecordArena& from, RecordArena& to) {
  if (!isListed(word)) return word;
  const std::uint32_t size = PolygonList::sizeOf(list(word, from).size());
  const RecordArena::Ref ref = to.allocate(size);
  std::copy_n(from.at(word & ~kListBit), size, to.at(ref));
  from.release(word & ~kListBit, size);
  return kListBit | ref;
}

void Ground::read(const Held& held, std::vector<PlacedPolygon>& out) const {
  const bool hasList = isListed(held.word);
  const PolygonList listed = hasList ? list(held.word, *held.lists) : PolygonList(nullptr);
  const ContentId content = hasList ? listed.content() : held.word >> kLowBits;
  const std::span<const PolygonId> polygons = catalogue.content(content).polygons;
  const std::size_t first = out.size();
  for (std::size_t slot = 0; slot < polygons.size(); ++slot) {
    const Placed placed = hasList ? listed[static_cast<Slot>(slot)] : Placed{held.word & kLowMask, held.block};
    out.push_back({{held.ref, placed.serial}, placed.block, catalogue.vertices(polygons[slot])});
  }
  detail::sort(std::span(out).subspan(first), [](const auto& a, const auto& b) { return a.handle < b.handle; });
}

void Ground::commit() {
  if (isNoting()) [[unlikely]]
    noteCommit();
  for (Chunk* chunk : changed_) {
    for (RowMask rows = chunk->dirtyRows; rows != 0; rows &= rows - 1)
      chunk->dirty[static_cast<std::size_t>(std::countr_zero(rows))] = 0;
    chunk->dirtyRows = 0;
  }
  changed_.clear();
  catalogue.collect();
}

void Ground::noteCommit() {
  if (isNoting(For::followers)) tell(committed_, noteCount(), Way::commit);
  for (std::size_t k = changed_.size(); k-- != 0;) {  // backwards, so that going back meets them in order
    const Chunk& chunk = *changed_[k];
    for (RowMask rows = chunk.dirtyRows; rows != 0; rows &= rows - 1) {
      const auto row = static_cast<std::uint32_t>(std::countr_zero(rows));
      notes_.push_back({chunk.index * kChunkSize + row, chunk.dirty[row], 0, Note::Of::row});
    }
  }
  committedBefore_ = std::exchange(committed_, noteCount());
  if (!isNoting(For::marks)) forgetNotes(committed_);
}

void Ground::noteNewChunk(const Chunk& chunk) {
  if (isNoting())
    notes_.push_back(
        {chunk.index, static_cast<std::uint32_t>(chunk.ci), static_cast<std::uint32_t>(chunk.cj), Note::Of::chunk});
  settleAround(chunk);
}

// The note takes over what the word stands for.
void Ground::note(CellAt at) {
  const bool isChanged = (at.chunk->dirty[at.row()] & at.bit()) != 0;
  const Note::Of of = isChanged ? Note::Of::changedCell : Note::Of::cell;
  notes_.push_back({at.ref(), moveList(at.word(), lists_, notedLists_), at.chunk->block(at.local), of});
}

/// A cell gets back what the note took over.
void Ground::giveBack(CellAt at, const Note& note) {
  at.word() = moveList(note.word, notedLists_, lists_);
  if (hasSole(at.word())) at.chunk->setBlock(at.local, note.block);
}

void Ground::undo(const Note& note, Undone undone) {
  if (note.isOfCell()) return undoCell(note, undone);
  if (note.of == Note::Of::turn) {
    const Note again = turn(note);
    if (undone == Undone::keep) undoneNotes_.push_back(again);
    return;
  }
  if (undone == Undone::keep) undoneNotes_.push_back(note);
  note.of == Note::Of::row ? undoRow(note) : grid.forget(note.ref);
}

void Ground::undoCell(const Note& note, Undone undone) {
  const CellAt at = grid.find(note.ref);
  if (undone == Undone::keep)
    undoneNotes_.push_back({note.ref, moveList(at.word(), lists_, notedLists_), at.chunk->block(at.local), note.of});
  else
    drop(at.word(), lists_);
  giveBack(at, note);
  at.chunk->facts[at.local] = catalogue.facts(contentId(at));
  if (note.of != Note::Of::cell) return;
  at.chunk->dirty[at.row()] &= ~at.bit();
  if (at.chunk->dirty[at.row()] == 0) at.chunk->dirtyRows &= ~(RowMask{1} << at.row());
  if (at.chunk->dirtyRows == 0) changed_.pop_back();  // the edit was the first in its chunk
}

void Ground::undoRow(const Note& note) {
  Chunk& chunk = grid.chunk(note.ref / kChunkSize);
  if (chunk.dirtyRows == 0) changed_.push_back(&chunk);
  chunk.dirtyRows |= RowMask{1} << note.ref % kChunkSize;
  chunk.dirty[note.ref % kChunkSize] = note.word;
}

void Ground::undoTo(std::uint64_t notes, Undone undone) {
  for (; noteCount() > notes; notes_.pop_back()) undo(notes_.back(), undone);
}

void Ground::goBack(const Moment& moment, Undone undone) {
  undoTo(moment.notes, undone);
  committed_ = moment.committed;
  while (catalogue.shapeCount() > moment.shapes) {
    InternedShape shape = catalogue.takeShape();
    if (undone == Undone::keep) undoneShapes_.push_back(std::move(shape));
  }
}

void Ground::rollBack(const Moment& moment, Undone undone) {
  endSqueezing();
  if (isNoting(For::followers)) {
    // Followers never saw the edits that are pending. Without a commit since the mark there is nothing to tell them.
    if (moment.committed != committed_) undoTo(committed_, undone);
    tell(moment.committed, committed_, Way::back);
  }
  goBack(moment, undone);
}

// The same edits again: a note of each is made anew, and finds the cells changed or not as it did then.
void Ground::redo(const Note& note) {
  if (note.of == Note::Of::row) {
    notes_.push_back(note);
    Chunk& chunk = grid.chunk(note.ref / kChunkSize);
    chunk.dirty[note.ref % kChunkSize] = 0;
    chunk.dirtyRows &= ~(RowMask{1} << note.ref % kChunkSize);
    if (chunk.dirtyRows == 0) changed_.pop_back();  // the commit noted the last one first
    return;
  }
  if (note.of == Note::Of::chunk) {  // the same number is the least that is free
    grid.obtain(
        {static_cast<std::int32_t>(note.word) * kChunkSize, static_cast<std::int32_t>(note.block) * kChunkSize});
    notes_.push_back(note);
    return;
  }
  if (note.of == Note::Of::turn) {
    notes_.push_back(turn(note));
    return;
  }
  const CellAt at = grid.find(note.ref);
  this->note(at);
  giveBack(at, note);
  if (note.of != Note::Of::settledCell) return touch(at, catalogue.facts(contentId(at)));
  notes_.back().of = note.of;
  at.chunk->facts[at.local] = catalogue.facts(contentId(at));
  at.chunk->everFacts |= at.chunk->facts[at.local];
}

void Ground::redoTo(std::uint64_t notes) {
  for (; noteCount() < notes; undoneNotes_.pop_back()) redo(undoneNotes_.back());
}

void Ground::rollForward(const Moment& moment) {
  endSqueezing();
  for (; catalogue.shapeCount() < moment.shapes; undoneShapes_.pop_back())
    catalogue.putShape(std::move(undoneShapes_.back()));
  if (isNoting(For::followers)) {
    // As above: edits that were pending at the moment are told by the next commit.
    if (moment.committed != committed_) redoTo(moment.committed);
    tell(committed_, moment.committed, Way::forth);
  }
  redoTo(moment.notes);
  committed_ = moment.committed;
}

void Ground::forgetUndone() {
  for (const Note& note : undoneNotes_)
    if (note.isOfCell()) drop(note.word, notedLists_);
  undoneNotes_ = {};
  undoneShapes_ = {};
}

/// Tells followers what changed between two commits, of which these are the notes. The ground is as of the later one.
/// The first note of a cell says what it held at the earlier one. Of a chunk that is, or was, unloaded nothing is told.
void Ground::tell(std::uint64_t begin, std::uint64_t end, Way way) {
  NumberSet told(*this), turned(*this);
  for (std::uint64_t k = begin; k < end; ++k)
    if (const Note& note = notes_[static_cast<std::size_t>(k - forgotten_)];
        note.of == Note::Of::turn && !turned.insert(note.ref))
      turned.erase(note.ref);
  std::vector<PlacedPolygon> before, now;
  cellChanges_.clear();
  for (std::uint64_t k = begin; k < end; ++k) {
    const Note& note = notes_[static_cast<std::size_t>(k - forgotten_)];
    if (!note.isOfCell() || note.of == Note::Of::changedCell) continue;
    if (way != Way::commit && !told.insert(note.ref)) continue;
    const CellAt at = grid.find(note.ref);
    before.clear();
    now.clear();
    const bool isUnloaded = at.chunk->isUnloaded, wasUnloaded = isUnloaded != turned.contains(at.chunk->index);
    if (isUnloaded && wasUnloaded) continue;
    if (!wasUnloaded) read({note.ref, note.word, note.block, &notedLists_}, way == Way::back ? now : before);
    if (!isUnloaded) read(held(at), way == Way::back ? before : now);
    cellChanges_.add(at.cell(), before, now);
  }
  cellChanges_.own();
}

std::vector<Cell> Ground::editedSince(const Moment& moment) const {
  std::vector<Cell> cells;
  NumberSet known(*this);
  for (std::uint64_t k = moment.notes; k < noteCount(); ++k) {
    const Note& note = notes_[static_cast<std::size_t>(k - forgotten_)];
    if (note.isOfCell() && known.insert(note.ref)) cells.push_back(grid.cellOf(note.ref));
  }
  return cells;
}

void Ground::startNoting(For whom) {
  notesFor_ = static_cast<std::uint8_t>(notesFor_ | static_cast<std::uint8_t>(whom));
  if (whom == For::followers) committed_ = noteCount();
}

void Ground::stopNoting(For whom) {
  notesFor_ = static_cast<std::uint8_t>(notesFor_ & ~static_cast<std::uint8_t>(whom));
  if (whom == For::followers) cellChanges_.clear();
  if (!isNoting(For::marks)) forgetNotes(isNoting(For::followers) ? committed_ : noteCount());
  constexpr std::size_t kMost = 4'096;
  if (isNoting() || (notes_.capacity() <= kMost && noted_.bytes() == 0)) return;
  notes_ = std::vector<Note>();
  notedLists_ = RecordArena();
  noted_ = BitSet();
}

void Ground::forgetBefore(const Moment& moment) {
  forgetNotes(isNoting(For::followers) ? moment.committed : moment.notes);
}

/// Which of the notes since two commits are needed: of each cell the first one. Where nothing had changed since a commit
/// at the moment, no row is, either. What was unloaded in between, and came back, is undone step by step.
void Ground::squeeze(const Moment& moment) {
  const std::uint64_t begin = std::max(moment.notes, committedBefore_);
  const bool isClean = begin > moment.notes || moment.isClean;
  if (squeezed_ != begin || squeezedFrom_ < moment.notes) {
    endSqueezing();
    squeezedFrom_ = squeezed_ = begin;
  }
  const auto first = notes_.begin() + static_cast<std::ptrdiff_t>(begin - forgotten_);
  if (std::any_of(first, notes_.end(), [](const Note& note) { return note.of == Note::Of::turn; })) {
    endSqueezing();
    squeezedFrom_ = squeezed_ = committed_;
    return;
  }
  auto end = first;
  for (auto note = first; note != notes_.end(); ++note) {
    if (note->of == Note::Of::row && isClean) continue;
    if (note->isOfCell()) {
      if (!noted_.insert(note->ref)) {
        drop(note->word, notedLists_);
        continue;
      }
      if (isClean) note->of = Note::Of::settledCell;
    }
    *end++ = *note;
  }
  notes_.erase(end, notes_.end());
  squeezed_ = committed_ = noteCount();
}

void Ground::endSqueezing() {
  for (std::uint64_t k = squeezedFrom_; k < squeezed_; ++k)
    if (const Note& note = notes_[static_cast<std::size_t>(k - forgotten_)]; note.isOfCell()) noted_.erase(note.ref);
  squeezed_ = squeezedFrom_;
}

void Ground::forgetNotes(std::uint64_t end) {
  if (end > squeezedFrom_) endSqueezing();
  for (; forgotten_ + dropped_ < end; ++dropped_)
    if (notes_[dropped_].isOfCell()) drop(notes_[dropped_].word, notedLists_);
  if (dropped_ < notes_.size() / 2) return;  // the rest moves to the front seldom
  notes_.erase(notes_.begin(), notes_.begin() + static_cast<std::ptrdiff_t>(dropped_));
  forgotten_ += std::exchange(dropped_, 0);
}

std::uint64_t Ground::bytes() const {
  return grid.bytes() + catalogue.bytes() + lists_.bytes() + notedLists_.bytes() + cellChanges_.bytes() +
         heldBytes(changed_, notes_, undoneNotes_, unsettled_, sleepy_) + noted_.bytes();
}

}  // namespace lgs::detail
