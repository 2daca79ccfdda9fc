#include "message.h"

namespace regions {
namespace {

constexpr std::int64_t pair(std::int32_t high, std::int32_t low) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(static_cast<std::uint32_t>(high)) << 32 |
                                   static_cast<std::uint32_t>(low));
}
constexpr std::int32_t high(std::int64_t word) { return static_cast<std::int32_t>(word >> 32); }
constexpr std::int32_t low(std::int64_t word) { return static_cast<std::int32_t>(word & 0xffff'ffff); }

constexpr std::size_t kNamingWords = 5;

}  // namespace

// Kind and number of vertices; cell; block; vertices.
void append(Message& message, const Edit& edit) {
  message.push_back(pair(static_cast<std::int32_t>(edit.kind), static_cast<std::int32_t>(edit.polygon.size())));
  message.push_back(pair(edit.cell.i, edit.cell.j));
  message.push_back(edit.block);
  for (const lgs::LocalPoint p : edit.polygon) message.push_back(pair(p.x, p.y));
}

std::vector<Edit> readEdits(const Message& message) {
  std::vector<Edit> edits;
  for (auto word = message.begin(); word != message.end();) {
    Edit& edit = edits.emplace_back();
    edit.kind = static_cast<Edit::Kind>(high(*word));
    edit.polygon.resize(static_cast<std::size_t>(low(*word++)));
    edit.cell = {high(*word), low(*word)};
    ++word;
    edit.block = static_cast<lgs::Block>(*word++);
    for (lgs::LocalPoint& p : edit.polygon) {
      p = {high(*word), low(*word)};
      ++word;
    }
  }
  return edits;
}

void append(Message& message, const Naming& naming) {
  const auto& [start, end] = naming.ends;
  message.insert(message.end(), {start.x, start.y, end.x, end.y, naming.id.value});
}

std::vector<Naming> readNamings(const Message& message) {
  std::vector<Naming> namings;
  namings.reserve(message.size() / kNamingWords);
  for (auto word = message.begin(); word != message.end(); word += kNamingWords)
    namings.push_back({{{word[0], word[1]}, {word[2], word[3]}}, {static_cast<std::uint32_t>(word[4])}});
  return namings;
}

}  // namespace regions
