#include "oracle/engine/answer.h"

#include <fmt/format.h>
#include <charconv>

namespace lgs::oracle {
namespace {

// Takes the next word of a line of words that single spaces part. Empty if there is none.
std::string_view nextWord(std::string_view& line) {
  const std::size_t end = std::min(line.find(' '), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(std::min(end + 1, line.size()));
  return word;
}

template <class Integer>
bool readInteger(std::string_view word, Integer& out) {
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), out);
  return !word.empty() && status == std::errc() && end == word.data() + word.size();
}

bool readPoint(std::string_view& line, Point& out) {
  const std::string_view x = nextWord(line), y = nextWord(line);
  return readInteger(x, out.x) && readInteger(y, out.y);
}

bool readGhost(std::string_view& line, std::optional<Point>& out) {
  if (line.starts_with("- - ")) {
    line.remove_prefix(4);
    return true;
  }
  out.emplace();
  return readPoint(line, *out);
}

bool isInTheWorld(Point p) {
  constexpr std::int64_t kFar = (std::int64_t{kMaxCell} + 1) * kUnitsPerCell;
  return -kFar <= p.x && p.x <= kFar && -kFar <= p.y && p.y <= kFar;
}

constexpr const char* kIsland = "an island needs a point and twice its area: three integers";
constexpr const char* kChange = "a change is '- ID', '+ ID segment …' or '~ ID segment …'";
constexpr const char* kTime = "there is one line 'time NANOSECONDS', a whole number";
constexpr const char* kSegment = "a segment needs four points of two integers, ghosts may be - -, and a block";

}  // namespace

std::string shortened(std::string_view words) {
  constexpr std::size_t kShown = 80;
  std::size_t shown = std::min(words.size(), kShown);
  const auto isInside = [&](std::size_t k) { return (static_cast<unsigned char>(words[k]) & 0xc0U) == 0x80; };
  while (shown > 0 && shown < words.size() && isInside(shown)) --shown;  // no half of a character
  std::string text(words.substr(0, shown));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return words.size() > kShown ? text + "…" : text;
}

tl::expected<Hello, std::string> parseHello(std::string_view line) {
  constexpr std::string_view kWord = "lgs-engine ";
  if (!line.starts_with(kWord))
    return tl::unexpected<std::string>("the first line must be 'lgs-engine 1 NAME [CAPABILITY …]'");
  line.remove_prefix(kWord.size());
  if (nextWord(line) != "1") return tl::unexpected<std::string>("there is only version 1 of the protocol");
  Hello hello;
  hello.name = shortened(nextWord(line));
  if (hello.name.empty()) return tl::unexpected<std::string>("a name must follow 'lgs-engine 1'");
  auto can = parseCapabilities(line);
  if (!can) return tl::unexpected(can.error());
  hello.can = *can;
  return hello;
}

tl::expected<bool, std::string> AnswerReader::takeSegment(std::string_view line, OutlineSegment& s) const {
  const bool isRead =
      readPoint(line, s.start) && readPoint(line, s.end) && readGhost(line, s.ghost1) && readGhost(line, s.ghost2);
  const bool isWord = !line.empty() && line.find(' ') == std::string_view::npos;
  const bool hasBlock = can_.blocks ? readInteger(line, s.block) : isWord;
  if (!isRead || !hasBlock) return tl::unexpected<std::string>(kSegment);
  if (std::string fault = faultOf(s, can_); !fault.empty()) return tl::unexpected(std::move(fault));
  keepDeclared(s, can_);
  return false;
}

tl::expected<bool, std::string> AnswerReader::takeChange(char sign, std::string_view line) {
  SegmentChange change{sign, std::string(nextWord(line)), {}};
  const bool hasSegment = sign != '-';
  if (change.id.empty() || (hasSegment ? nextWord(line) != "segment" : !line.empty()))
    return tl::unexpected<std::string>(kChange);
  if (hasSegment)
    if (auto read = takeSegment(line, change.segment); !read) return read;
  changes.push_back(std::move(change));
  return false;
}

tl::expected<bool, std::string> AnswerReader::take(std::string_view line) {
  std::string_view rest = line;
  const std::string_view word = nextWord(rest);
  if (line == "end") return true;
  if (word == "segment" && !can_.delta) {
    outline.emplace_back();
    return takeSegment(rest, outline.back());
  }
  if (can_.delta && (word == "-" || word == "+" || word == "~")) return takeChange(word[0], rest);
  if (can_.islands && word == "island") {
    NamedIsland island;
    if (!readPoint(rest, island.west) || !readInteger(rest, island.doubleArea))
      return tl::unexpected<std::string>(kIsland);
    islands.push_back(island);
    return false;
  }
  if (can_.time && word == "time") {
    std::int64_t count = 0;
    if (time || !readInteger(rest, count) || count < 0) return tl::unexpected<std::string>(kTime);
    time = std::chrono::nanoseconds(count);
    return false;
  }
  if (word != "refused")
    return tl::unexpected(fmt::format("a line of an answer begins with refused, {}, {}{}end or #",
                                      can_.delta ? "-, +, ~" : "segment", can_.islands ? "island, " : "",
                                      can_.time ? "time, " : ""));
  if (!outline.empty() || !islands.empty() || !changes.empty())
    return tl::unexpected<std::string>("refusals come before the segments");
  const std::string name(nextWord(rest));
  if (name.empty() || rest.empty()) return tl::unexpected<std::string>("a refusal needs a name and a reason");
  refused.push_back({name, std::string(rest)});
  return false;
}

std::string faultOf(const OutlineSegment& segment, const Capabilities& can) {
  const auto isFarGhost = [&](const std::optional<Point>& ghost) {
    return can.ghosts && ghost && !isInTheWorld(*ghost);
  };
  const bool isFar = !isInTheWorld(segment.start) || !isInTheWorld(segment.end) || isFarGhost(segment.ghost1) ||
                     isFarGhost(segment.ghost2);
  return isFar ? "beyond the end of the world, which is 2^30 cells away" : "";
}

void keepDeclared(OutlineSegment& segment, const Capabilities& can) {
  if (!can.ghosts) segment.ghost1 = segment.ghost2 = std::nullopt;
  if (!can.blocks) segment.block = 0;
}

}  // namespace lgs::oracle
