#include "message.h"

namespace in_step {

Bytes bytesOf(const Question& question) {
  Bytes out;
  put(out, static_cast<std::uint64_t>(question.kind));
  put(out, question.square);
  return out;
}

std::optional<Question> readQuestion(std::span<const std::byte> bytes) {
  Reader in(bytes);
  Question question;
  question.kind = static_cast<Question::Kind>(in.number(1));
  question.square = readSquare(in);
  const int level = question.square.level;
  const bool isAsked = question.kind == Question::Kind::parts ? level > kLeaf : level <= 0;
  if (!in.isGood() || !in.isAtEnd() || !isAsked) return {};
  return question;
}

Bytes bytesOf(const News& news) {
  Bytes out;
  put(out, static_cast<std::uint64_t>(news.kind));
  put(out, news.turn);
  putHash(out, news.hash);
  put(out, news.square);
  if (news.kind == News::Kind::parts)
    put(out, news.square, news.parts);
  else
    put(out, news.ground);
  return out;
}

std::optional<News> readNews(std::span<const std::byte> bytes) {
  Reader in(bytes);
  News news;
  news.kind = static_cast<News::Kind>(in.number(2));
  news.turn = in.number();
  news.hash = in.hash();
  news.square = readSquare(in);
  if (news.kind == News::Kind::parts) {
    if (news.square.level == kLeaf) in.fail();
    news.parts = readParts(in, news.square);
  } else {
    news.ground = readGround(in);
  }
  if (!in.isGood() || !in.isAtEnd()) return {};
  if (news.kind == News::Kind::ground)
    for (const auto& [cell, content] : news.ground)
      if (!lgs::contains(cellsOf(news.square), cell)) return {};
  return news;
}

}  // namespace in_step
