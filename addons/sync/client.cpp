#include "client.h"

namespace in_step {
namespace {

constexpr lgs::CellRect kNoCells{{0, 0}, {-1, -1}};

}  // namespace

Client::Client(lgs::World& world) : world_(world), hashes_(world) {}

/// All of it or nothing.
void Client::set(const Ground& ground, const lgs::CellRect& cells) {
  if (!setGround(world_, ground, cells)) return;  // the hashes tell that something is missing
  update(world_.commit());
}

std::vector<Bytes> Client::receive(std::span<const std::byte> message) {
  const auto news = readNews(message);
  if (!news || news->turn < turn_) return {};
  const bool isOfParts = news->kind == News::Kind::parts;
  if (news->kind != News::Kind::edits &&
      open_.erase({isOfParts ? Question::Kind::parts : Question::Kind::ground, news->square}) == 0)
    return {};  // nobody asked, or it was answered
  const bool isNewTurn = news->turn > turn_;
  turn_ = news->turn;
  theirHash_ = news->hash;
  switch (news->kind) {
    case News::Kind::edits:
      theirWhole_ = news->square;
      if (isNewTurn) set(news->ground, kNoCells);
      return open_.empty() ? tick() : std::vector<Bytes>();
    case News::Kind::parts:
      return compare(*news);
    case News::Kind::ground:
      set(news->ground, cellsOf(news->square));
  }
  return {};
}

/// Asks for what differs in a square, and empties what the server has nothing of.
std::vector<Bytes> Client::compare(const News& news) {
  std::vector<Bytes> questions;
  Parts own = partsOf(world_, hashes_, news.square);
  for (const auto& [part, hash] : news.parts) {
    const auto found = own.find(part);
    const bool hasNothing = found == own.end();
    if (hasNothing || found->second != hash) {
      const bool isWhole = part.level == kLeaf || (part.level == 0 && hasNothing);
      ask({isWhole ? Question::Kind::ground : Question::Kind::parts, part}, questions);
    }
    if (!hasNothing) own.erase(found);
  }
  for (const auto& [part, hash] : own) set({}, cellsOf(part));
  return questions;
}

std::vector<Bytes> Client::tick() {
  std::vector<Bytes> questions;
  if (turn_ == 0) return questions;
  if (isInStep()) open_.clear();
  for (const Question& question : open_) questions.push_back(bytesOf(question));
  if (isInStep()) return questions;
  const lgs::HashedSquare whole = hashes_.whole();
  ask({Question::Kind::parts, around({whole.level, whole.cells.min}, theirWhole_)}, questions);
  return questions;
}

void Client::ask(const Question& question, std::vector<Bytes>& out) {
  if (open_.insert(question).second) out.push_back(bytesOf(question));
}

}  // namespace in_step
