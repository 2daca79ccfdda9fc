#include "server.h"

namespace in_step {

Server::Server(const lgs::World& world) : world_(world), hashes_(world) {}

News Server::news(News::Kind kind, const Square& square) const { return {kind, turn_, hashes_.hash(), square, {}, {}}; }

Bytes Server::update() {
  hashes_.update(world_.cellChanges());
  ++turn_;
  const lgs::HashedSquare whole = hashes_.whole();
  News news = this->news(News::Kind::edits, {whole.level, whole.cells.min});
  if (world_.cellChanges().size() <= kMaxCells)
    for (const lgs::CellChange& change : world_.cellChanges())
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
  News answer = news(isOfParts ? News::Kind::parts : News::Kind::ground, question->square);
  if (isOfParts)
    answer.parts = partsOf(world_, hashes_, question->square);
  else
    answer.ground = groundIn(world_, cellsOf(question->square));
  return bytesOf(answer);
}

}  // namespace in_step
