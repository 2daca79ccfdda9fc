#include "oracle/trace/trace.h"

#include "oracle/trace/coordinate.h"
#include "oracle/trace/line.h"

#include <fmt/format.h>
#include <charconv>
#include <span>
#include <tl/expected.hpp>

namespace lgs::oracle {
namespace {

constexpr std::size_t kMaxLine = std::size_t{1} << 20;

// Every function below that can find fault returns the fault's text, empty if there is none.
using Fault = std::string;

std::string quote(std::string_view word) {
  constexpr std::size_t kShown = 40;
  return word.size() <= kShown ? fmt::format("'{}'", word) : fmt::format("'{}…'", word.substr(0, kShown));
}

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

template <class Integer>
Fault readInteger(std::string_view word, std::string_view what, Integer min, Integer max, Integer& out) {
  const std::string_view digits = word.starts_with('-') ? word.substr(1) : word;
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos) {
    return fmt::format("the {} {} is not an integer", what, quote(word));
  }
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), out);
  if (status != std::errc() || end != word.data() + word.size() || out < min || out > max) {
    return fmt::format("the {} {} is out of range, which is {} to {}", what, quote(word), min, max);
  }
  return {};
}

Fault readBlock(std::string_view word, Block& out) {
  return readInteger<Block>(word, "block", 0, std::numeric_limits<Block>::max(), out);
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
    Edit edit;
    edit.line = number;
    const std::vector<std::string_view> way = version_ < 3 ? std::vector<std::string_view>() : takeWay(words);
    Fault fault;
    if (words[0] == "add") {
      fault = add(words, edit);
    } else if (words[0] == "remove") {
      fault = remove(words, edit);
    } else if (words[0] == "paint" || words[0] == "carve") {
      fault = version_ >= 2 ? brush(words, edit)
                            : fmt::format("{} needs 'lgs-trace 2' as the first line of the trace", words[0]);
    } else if (words[0] != "commit") {
      fault = fmt::format("unknown word {}; a line starts with preserve, add, remove, commit, {}or #", quote(words[0]),
                          version_ >= 2 ? "paint, carve " : "");
    } else if (words.size() != 1) {
      fault = fmt::format("commit stands alone on its line; found {} after it", quote(words[1]));
    }
    edit.way = Edit::plainWay(edit.kind);
    for (std::size_t k = 0; fault.empty() && k < way.size(); ++k) fault = readWay(way[k], edit);
    if (fault.empty()) out_.trace.edits.push_back(std::move(edit));
    return fault;
  }

  bool sawHeader() const { return sawHeader_; }

 private:
  Fault header(const std::vector<std::string_view>& words) {
    if (words[0] != "lgs-trace") {
      return fmt::format("not a trace: the first line must be 'lgs-trace 1', not {}", quote(words[0]));
    }
    if (words.size() != 2 || (words[1] != "1" && words[1] != "2" && words[1] != "3")) {
      return "the first line must be 'lgs-trace 1', or 'lgs-trace 2' if brushes paint or carve, or 'lgs-trace 3' if "
             "lines say how edits are made; there are no others";
    }
    sawHeader_ = true;
    version_ = words[1][0] - '0';
    return {};
  }

  // Takes what comes after `by` away from a line, where that may stand.
  static std::vector<std::string_view> takeWay(std::vector<std::string_view>& words) {
    const std::size_t first = words[0] == "add"      ? 5
                              : words[0] == "remove" ? 2
                              : words[0] == "commit" ? 1
                                                     : words.size();
    const auto by =
        std::find(words.begin() + static_cast<std::ptrdiff_t>(std::min(first, words.size())), words.end(), "by");
    if (by == words.end()) return {};
    std::vector<std::string_view> way(by + 1, words.end());
    words.erase(by, words.end());
    return way;
  }

  static Fault readWay(std::string_view word, Edit& edit) {
    if (word[0] >= '0' && word[0] <= '9')
      return readInteger<std::uint32_t>(word, "number of a call", 0, UINT32_MAX, edit.way.number);
    return oracle::readWay(word, edit.way) ? Fault()
                                           : fmt::format("by {}: there is no such door or detour", quote(word));
  }

  Fault preserve(const std::vector<std::string_view>& words) {
    if (!out_.trace.edits.empty()) return "preserve must stand before the first edit";
    if (words.size() != 3) return fmt::format("preserve needs two blocks; found {}", words.size() - 1);
    Block a = 0;
    Block b = 0;
    if (Fault fault = readBlock(words[1], a); !fault.empty()) return fault;
    if (Fault fault = readBlock(words[2], b); !fault.empty()) return fault;
    out_.trace.preserve.add(a, b);
    return {};
  }

  static Fault add(const std::vector<std::string_view>& words, Edit& edit) {
    constexpr std::size_t kFirstCoordinate = 5;
    if (words.size() < kFirstCoordinate) {
      return fmt::format("add needs a name, a cell i j and a block before its coordinates; found only {} of these 4",
                         words.size() - 1);
    }
    edit.kind = Edit::Kind::add;
    edit.name = words[1];
    Cell& cell = edit.polygon.cell;
    if (Fault fault = readInteger(words[2], "cell index", -kMaxCell, kMaxCell, cell.i); !fault.empty()) return fault;
    if (Fault fault = readInteger(words[3], "cell index", -kMaxCell, kMaxCell, cell.j); !fault.empty()) return fault;
    if (Fault fault = readBlock(words[4], edit.polygon.block); !fault.empty()) return fault;
    const std::size_t coordinates = words.size() - kFirstCoordinate;
    if (coordinates % 2 != 0) {
      return fmt::format("{} coordinates: they come in pairs x y, so one is missing or one too many", coordinates);
    }
    return readPoints(std::span(words).subspan(kFirstCoordinate), "", parseCoordinate, edit.polygon.vertices);
  }

  template <class Parse, class Vertex>
  static Fault readPoints(std::span<const std::string_view> words, std::string_view of, Parse parse,
                          std::vector<Vertex>& out) {
    for (std::size_t k = 0; k < words.size(); ++k) {
      const auto units = parse(words[k]);
      if (!units) {
        return fmt::format("the {} of vertex {}{}, {}: {}", k % 2 == 0 ? 'x' : 'y', k / 2, of, quote(words[k]),
                           units.error());
      }
      if (k % 2 == 0) {
        out.push_back({*units, 0});
      } else {
        out.back().y = *units;
      }
    }
    return {};
  }

  static Fault brush(const std::vector<std::string_view>& words, Edit& edit) {
    edit.kind = Edit::Kind::brush;
    std::size_t first = 1;
    if (words[0] == "paint") {
      if (words.size() < 3) return "paint needs a block, and fill or replace, before its coordinates";
      if (Fault fault = readBlock(words[1], edit.brush.block); !fault.empty()) return fault;
      if (words[2] != "fill" && words[2] != "replace")
        return fmt::format("paint is in the mode fill or replace, not {}", quote(words[2]));
      edit.brush.deed = words[2] == "fill" ? BrushEdit::Deed::fill : BrushEdit::Deed::replace;
      first = 3;
    }
    for (std::size_t k = first; k <= words.size();) {
      const std::size_t end = static_cast<std::size_t>(
          std::find(words.begin() + static_cast<std::ptrdiff_t>(k), words.end(), "|") - words.begin());
      const std::span ring = std::span(words).subspan(k, end - k);
      const std::size_t number = edit.brush.rings.size();
      if (Fault fault = readRing(ring, number, edit.brush.rings.emplace_back()); !fault.empty()) return fault;
      k = end + 1;
    }
    return {};
  }

  static Fault readRing(std::span<const std::string_view> words, std::size_t number, std::vector<Point>& out) {
    if (words.empty()) return fmt::format("ring {} has no coordinates", number);
    if (words.size() % 2 != 0)
      return fmt::format("ring {} has {} coordinates: they come in pairs x y, so one is missing or one too many",
                         number, words.size());
    return readPoints(words, fmt::format(" of ring {}", number), parseWorldCoordinate, out);
  }

  static Fault remove(const std::vector<std::string_view>& words, Edit& edit) {
    if (words.size() != 2) return fmt::format("remove needs one name; found {}", words.size() - 1);
    edit.kind = Edit::Kind::remove;
    edit.name = words[1];
    return {};
  }

  ParsedTrace& out_;
  bool sawHeader_ = false;
  int version_ = 1;
};

std::string printBrush(const BrushEdit& brush) {
  std::string text = "carve ";
  if (brush.deed != BrushEdit::Deed::carve)
    text = fmt::format("paint {} {} ", brush.block, brush.deed == BrushEdit::Deed::fill ? "fill" : "replace");
  for (std::size_t k = 0; k < brush.rings.size(); ++k) {
    if (k != 0) text += "  |";
    for (const Point p : brush.rings[k]) text += fmt::format(" {} {}", printCoordinate(p.x), printCoordinate(p.y));
  }
  return text;
}

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
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (Fault fault = parser.line(line, number); !fault.empty()) {
      parsed.error = TraceError{number, std::move(fault), {}};
      return parsed;
    }
  }
  if (!parser.sawHeader()) {
    number = std::max<std::size_t>(number, 1);
    parsed.error = TraceError{number, "the trace ends before its first line, 'lgs-trace 1'", {}};
  }
  return parsed;
}

std::string printEdit(const Edit& edit) {
  if (edit.kind == Edit::Kind::commit) return "commit" + print(edit.way, Edit::plainWay(edit.kind));
  if (edit.kind == Edit::Kind::brush) return printBrush(edit.brush);
  if (edit.kind == Edit::Kind::remove) return "remove " + edit.name + print(edit.way, Edit::plainWay(edit.kind));
  const ScenePolygon& polygon = edit.polygon;
  std::string text = fmt::format("add {} {} {} {} ", edit.name, polygon.cell.i, polygon.cell.j, polygon.block);
  for (const LocalPoint& p : polygon.vertices) {
    for (const std::int32_t units : {p.x, p.y}) (text += ' ') += printCoordinate(units);
  }
  return text + print(edit.way, Edit::plainWay(edit.kind));
}

std::string printTrace(const Trace& trace) {
  const auto isPlain = [](const Edit& edit) { return edit.way == Edit::plainWay(edit.kind); };
  const int version = !std::ranges::all_of(trace.edits, isPlain) ? 3 : hasBrushes(trace) ? 2 : 1;
  std::string text = fmt::format("lgs-trace {}\n", version);
  for (const auto& [a, b] : trace.preserve.pairs()) text += fmt::format("preserve {} {}\n", a, b);
  for (const Edit& edit : trace.edits) text += printEdit(edit) + '\n';
  return text;
}

}  // namespace lgs::oracle
