#include "oracle/trace/trace.h"

#include "oracle/trace/call_text.h"
#include "oracle/trace/line.h"

#include <fmt/format.h>
#include <array>
#include <span>

namespace lgs::oracle {
namespace {

constexpr std::size_t kMaxLine = std::size_t{1} << 20;

// Every function below that can find fault returns the fault's text, empty if there is none.

Fault checkBytes(std::string_view line) {
  if (line.size() > kMaxLine) return fmt::format("the line is longer than {} bytes", kMaxLine);
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\t') || byte == 0x7f) {
      return fmt::format("byte 0x{:02x} in the line: a trace is plain text", byte);
    }
  }
  return {};
}

Fault readBlock(std::string_view word, Block& out) {
  return readNumber<Block>(word, "block", 0, std::numeric_limits<Block>::max(), out);
}

class Parser {
 public:
  explicit Parser(ParsedTrace& out) : out_(out) {}

  Fault line(std::string_view text, std::size_t number) {
    if (Fault fault = checkBytes(text); !fault.empty()) return fault;
    std::vector<std::string_view> words = splitWords(text);
    if (words.empty()) return {};
    if (!sawHeader_) return header(words);
    if (words[0] == "preserve") return preserve(words);
    if (version_ == 4 && words[0] == "end") return end(words);
    Call call;
    Fault fault = version_ == 4 ? readCall(words, call) : read(words, call);
    call.line = number;
    if (!fault.empty()) return fault;
    if (!open_.empty() && call.kind != Call::Kind::commit && !isEdit(call.kind))
      return fmt::format("{} can not stand in a group", words[0]);
    if (!open_.empty() && open_.back().kind != Call::Kind::repeat && call.kind == Call::Kind::commit)
      return "commit can not stand in a group";
    const bool begins = has(call.kind, KindOfCall::parts);
    begins ? open_.push_back(std::move(call)) : put(std::move(call));
    return {};
  }

  /// At the end of the text.
  Fault end() const {
    if (!sawHeader_) return "the trace ends before its first line, 'lgs-trace 1'";
    return open_.empty() ? Fault() : "the trace ends within a group";
  }

 private:
  Fault header(const std::vector<std::string_view>& words) {
    if (words[0] != "lgs-trace") {
      return fmt::format("not a trace: the first line must be 'lgs-trace 1', not {}", quote(words[0]));
    }
    constexpr std::array<std::string_view, 4> kVersions{"1", "2", "3", "4"};
    if (words.size() != 2 || std::ranges::find(kVersions, words[1]) == kVersions.end()) {
      return "the first line must be 'lgs-trace 1', or 'lgs-trace 2' if brushes paint or carve, or 'lgs-trace 4' if "
             "there are other calls; 'lgs-trace 3' is an older form of it; there are no others";
    }
    sawHeader_ = true;
    version_ = words[1][0] - '0';
    out_.trace.mayRefuse = version_ == 4;
    return {};
  }

  void put(Call call) { (open_.empty() ? out_.trace.calls : open_.back().group).push_back(std::move(call)); }

  Fault end(const std::vector<std::string_view>& words) {
    if (words.size() != 1) return "end stands alone on its line";
    if (open_.empty()) return "end without the begin of a group";
    Call call = std::move(open_.back());
    open_.pop_back();
    put(std::move(call));
    return {};
  }

  // A line of a trace of before version 4.
  Fault read(std::vector<std::string_view>& words, Call& call) const {
    if (version_ == 3) dropWay(words);
    if (words[0] == "add") return add(words, call);
    if (words[0] == "remove") {
      if (words.size() != 2) return fmt::format("remove needs one name; found {}", words.size() - 1);
      call = Call::remove(std::string(words[1]));
    } else if (words[0] == "paint" || words[0] == "carve") {
      if (version_ < 2) return fmt::format("{} needs 'lgs-trace 2' as the first line of the trace", words[0]);
      call.kind = Call::Kind::brush;
      return readBrush(words, call.brush);
    } else if (words[0] != "commit") {
      return fmt::format("unknown word {}; a line starts with preserve, add, remove, commit, {}or #", quote(words[0]),
                         version_ >= 2 ? "paint, carve " : "");
    } else if (words.size() != 1) {
      return fmt::format("commit stands alone on its line; found {} after it", quote(words[1]));
    }
    return {};
  }

  // Version 3 has the way of an edit after `by`, where that may stand.
  static void dropWay(std::vector<std::string_view>& words) {
    const std::size_t first = words[0] == "add"      ? 5
                              : words[0] == "remove" ? 2
                              : words[0] == "commit" ? 1
                                                     : words.size();
    const auto by =
        std::find(words.begin() + static_cast<std::ptrdiff_t>(std::min(first, words.size())), words.end(), "by");
    words.erase(by, words.end());
  }

  Fault preserve(const std::vector<std::string_view>& words) {
    if (!out_.trace.calls.empty() || !open_.empty()) return "preserve must stand before the first edit";
    if (words.size() != 3) return fmt::format("preserve needs two blocks; found {}", words.size() - 1);
    Block a = 0;
    Block b = 0;
    if (Fault fault = readBlock(words[1], a); !fault.empty()) return fault;
    if (Fault fault = readBlock(words[2], b); !fault.empty()) return fault;
    out_.trace.preserve.add(a, b);
    return {};
  }

  static Fault add(const std::vector<std::string_view>& words, Call& call) {
    constexpr std::size_t kFirstCoordinate = 5;
    if (words.size() < kFirstCoordinate) {
      return fmt::format("add needs a name, a cell i j and a block before its coordinates; found only {} of these 4",
                         words.size() - 1);
    }
    ScenePolygon polygon;
    Cell& cell = polygon.cell;
    if (Fault fault = readNumber(words[2], "cell index", -kMaxCell, kMaxCell, cell.i); !fault.empty()) return fault;
    if (Fault fault = readNumber(words[3], "cell index", -kMaxCell, kMaxCell, cell.j); !fault.empty()) return fault;
    if (Fault fault = readBlock(words[4], polygon.block); !fault.empty()) return fault;
    Fault fault = readPoints(std::span(words).subspan(kFirstCoordinate), "", polygon.vertices);
    call = Call::add(std::string(words[1]), std::move(polygon));
    return fault;
  }

  ParsedTrace& out_;
  bool sawHeader_ = false;
  int version_ = 1;
  std::vector<Call> open_;  // groups and what is repeated, which have not ended
};

}  // namespace

std::string message(const TraceError& error, std::string_view file) {
  return error.line == 0 ? fmt::format("{}: {}", file, error.text)
                         : fmt::format("{}:{}: {}", file, error.line, error.text);
}

ParsedTrace parseTrace(std::string_view text) {
  ParsedTrace parsed;
  Parser parser(parsed);
  std::size_t number = 0;
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // some editors on Windows begin a file with it
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  while (!text.empty()) {
    ++number;
    if (Fault fault = parser.line(takeLine(text), number); !fault.empty()) {
      parsed.error = TraceError{number, std::move(fault), {}};
      return parsed;
    }
  }
  if (Fault fault = parser.end(); !fault.empty())
    parsed.error = TraceError{std::max<std::size_t>(number, 1), std::move(fault), {}};
  return parsed;
}

std::string printTrace(const Trace& trace) {
  const auto isOfTwo = [](const Call& call) {
    return isPlain(call) || (call.kind == Call::Kind::brush && call.brush.isEvenOdd && call.brush.staying.empty());
  };
  const bool isOld = !trace.mayRefuse && std::ranges::all_of(trace.calls, isOfTwo);
  std::string text = fmt::format("lgs-trace {}\n", !isOld ? 4 : hasBrushes(trace) ? 2 : 1);
  for (const auto& [a, b] : trace.preserve.pairs()) text += fmt::format("preserve {} {}\n", a, b);
  for (const Call& call : trace.calls) text += printCall(call) + '\n';
  return text;
}

}  // namespace lgs::oracle
