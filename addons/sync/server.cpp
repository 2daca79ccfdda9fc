#include "server.h"

#include <lgs/unloaded.h>

#include <utility>

namespace in_step {

Server::Server(const lgs::World& world, lgs::GroundHashes hashes)
    : world_(world), hashes_(std::move(hashes)), version_(world.version()) {
  for (const lgs::CellRect& chunk : lgs::unloadedChunks(world)) away_.insert(chunk.min);
}

News Server::news(News::Kind kind, const Square& square) const { return {kind, turn_, hashes_.hash(), square, {}, {}}; }

/// What the last commit or roll-back changed, without what only left memory or came back. What came back as something
/// else, since an undo went over it, clients find out by its hash.
std::vector<lgs::CellChange> Server::edits() {
  std::vector<lgs::CellChange> edits;
  for (const lgs::CellChange& change : world_.cellChanges()) {
    const lgs::CellRect chunk = lgs::GroundHashes::square(change.cell, 0).cells;
    if (world_.firstUnloaded(chunk))
      away_.insert(chunk.min);
    else if (!away_.contains(chunk.min))
      edits.push_back(change);
  }
  return edits;
}

/// Reads the chunks that came back; whether there are any.
bool Server::readWhatCameBack() {
  return std::erase_if(away_, [this](lgs::Cell corner) {
           const lgs::CellRect chunk = lgs::GroundHashes::square(corner, 0).cells;
           if (world_.firstUnloaded(chunk)) return false;
           hashes_.set(corner, groundHash(world_, chunk));
           return true;
         }) > 0;
}

void Server::beginAgain() {
  const lgs::GroundHashes told = std::exchange(hashes_, lgs::GroundHashes(world_));
  away_.clear();
  for (const lgs::CellRect& chunk : lgs::unloadedChunks(world_)) {
    away_.insert(chunk.min);
    for (const lgs::HashedSquare& square : told.hashes({chunk.min, chunk.min})) hashes_.set(chunk.min, square.hash);
  }
}

Bytes Server::update(const lgs::Changes& changes) {
  const bool isMissed = changes.before != version_ || changes.after != world_.version() || !world_.followsCells() ||
                        changes.before != world_.versionBeforeCellChanges();
  if (isMissed || changes.before != changes.after) ++turn_;
  const std::vector<lgs::CellChange> edits = isMissed ? std::vector<lgs::CellChange>() : this->edits();
  if (isMissed) beginAgain();
  const bool isReadAnew = readWhatCameBack() || isMissed;
  hashes_.update(edits);
  // After a roll-back edits may be pending, which were read with the rest: so it begins again at the next commit, too.
  const bool mayHavePending = world_.changesOfRollBack().after == world_.version();
  version_ = isReadAnew && mayHavePending ? UINT64_MAX : world_.version();
  const lgs::HashedSquare whole = hashes_.whole();
  News news = this->news(News::Kind::edits, {whole.level, whole.cells.min});
  std::size_t vertices = 0;
  for (const lgs::CellChange& change : edits)
    for (const lgs::PlacedPolygon& polygon : change.now) vertices += polygon.vertices.size();
  if (edits.size() <= kMaxCells && vertices <= kMaxVertices)
    for (const lgs::CellChange& change : edits)
      news.ground[change.cell] = contentOf({change.now.begin(), change.now.end()});
  return bytesOf(news);
}

Bytes Server::signOfLife() const {
  const lgs::HashedSquare whole = hashes_.whole();
  return bytesOf(news(News::Kind::edits, {whole.level, whole.cells.min}));
}

std::optional<Bytes> Server::answer(std::span<const std::byte> bytes) const {
  const auto question = readQuestion(bytes);
  if (!question) return {};
  const bool isOfParts = question->kind == Question::Kind::parts;
  if (!(isOfParts && question->square.level > 0) && world_.firstUnloaded(cellsOf(question->square))) return {};
  News answer = news(isOfParts ? News::Kind::parts : News::Kind::ground, question->square);
  if (isOfParts)
    answer.parts = partsOf(world_, hashes_, question->square);
  else
    answer.ground = groundIn(world_, cellsOf(question->square));
  return bytesOf(answer);
}

}  // namespace in_step
