#include "oracle/trace/call_text.h"

#include "oracle/trace/coordinate.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace lgs::oracle {

using Kind = Call::Kind;

namespace {

constexpr std::array<const char*, 4> kNotations{"lattice", "list", "floats", "doubles"};
constexpr std::array<const char*, 3> kKeeps{"drop", "keep", "all"};

// --- Printing

std::string print(Cell cell) { return fmt::format(" {} {}", cell.i, cell.j); }

std::string print(const Named& named) {
  switch (named.how) {
    case Named::How::standing:
      return fmt::format(" {}:{}#{}", named.cell.i, named.cell.j, named.nth);
    case Named::How::all:
      return fmt::format(" {}:{}#all", named.cell.i, named.cell.j);
    case Named::How::given:
      return fmt::format(" given#{}", named.nth);
    case Named::How::beside:
      return fmt::format(" beside#{}", named.nth);
    case Named::How::handle:
      return fmt::format(" handle#{}:{}", named.handle.cellRef, named.handle.serial);
    case Named::How::name:
      break;
  }
  return " " + named.name;
}

std::string print(const Shape& shape) {
  std::string text;
  for (std::size_t k = 0; k < shape.size(); ++k) {
    text += k == 0 ? " " : "  | ";
    if (shape[k].empty()) text += " none";
    for (const LocalPoint& p : shape[k]) text += fmt::format(" {} {}", printCoordinate(p.x), printCoordinate(p.y));
  }
  return text;
}

std::string print(const Coming& coming, Kind kind) {
  std::string text;
  if (has(kind, KindOfCall::cell)) text += print(coming.cell);
  if (kind != Kind::shape) text += fmt::format(" {}", coming.block);
  const bool isBare = kind == Kind::add && coming.shape[0].empty();
  if (!isBare) text += coming.id != 0 ? fmt::format("  id {}", coming.id) : print(coming.shape);
  if (kind == Kind::add || coming.names.empty()) return text;
  text += "  as";
  for (const std::string& name : coming.names) text += " " + name;
  return text;
}

std::string print(const BrushEdit& brush) {
  std::string text = "carve ";
  if (brush.deed != BrushEdit::Deed::carve)
    text = fmt::format("paint {} {} ", brush.block, brush.deed == BrushEdit::Deed::fill ? "fill" : "replace");
  for (std::size_t k = 0; k < brush.rings.size(); ++k) {
    if (k != 0) text += "  |";
    for (const Point p : brush.rings[k]) text += fmt::format(" {} {}", printCoordinate(p.x), printCoordinate(p.y));
  }
  if (!brush.isEvenOdd) text += " united";
  if (!brush.staying.empty()) text += " around";
  for (const Block block : brush.staying) text += fmt::format(" {}", block);
  return text;
}

// --- Reading

Fault readName(std::string_view word) {
  constexpr std::array<std::string_view, 8> kOthers{"-", "|", ";", "as", "id", "in", "room", "with"};
  const bool isOther = std::ranges::find(kOthers, word) != kOthers.end() || word.find('#') != std::string_view::npos;
  return isOther ? fmt::format("{} is no name of a polygon", quote(word)) : Fault();
}

template <std::size_t N>
Fault readOneOf(std::string_view word, std::string_view what, const std::array<const char*, N>& names,
                std::size_t& which) {
  const auto found = std::ranges::find(names, word);
  which = static_cast<std::size_t>(found - names.begin());
  if (found != names.end()) return {};
  return fmt::format("the {} is one of {}, not {}", what, fmt::join(names, ", "), quote(word));
}

Fault readNamed(std::string_view word, Named& out) {
  const std::size_t sign = word.find('#');
  if (sign == std::string_view::npos) {
    out.how = Named::How::name;
    out.name = word;
    return readName(word);
  }
  const std::string_view of = word.substr(0, sign), which = word.substr(sign + 1);
  const auto two = [](std::string_view pair, auto& a, auto& b) {
    const std::size_t colon = std::min(pair.find(':'), pair.size());
    Fault fault = readAny(pair.substr(0, colon), "number before ':'", a);
    return fault.empty() ? readAny(pair.substr(std::min(colon + 1, pair.size())), "number after ':'", b) : fault;
  };
  if (of == "handle") {
    out.how = Named::How::handle;
    return two(which, out.handle.cellRef, out.handle.serial);
  }
  if (of == "given" || of == "beside") {
    out.how = of == "given" ? Named::How::given : Named::How::beside;
    return readAny(which, "number after '#'", out.nth);
  }
  if (Fault fault = two(of, out.cell.i, out.cell.j); !fault.empty()) return fault;
  out.how = which == "all" ? Named::How::all : Named::How::standing;
  return which == "all" ? Fault() : readAny(which, "number after '#'", out.nth);
}

/// Reads the words of a line one after the other. The first fault stays.
class Reader {
 public:
  explicit Reader(Words words) : words_(words) {}

  bool isAtEnd() const { return at_ == words_.size(); }
  bool is(std::string_view word) const { return !isAtEnd() && words_[at_] == word; }
  bool take(std::string_view word) {
    const bool isIt = is(word);
    at_ += isIt ? 1 : 0;
    return isIt;
  }
  std::string_view word(std::string_view what) {
    if (isAtEnd()) {
      fail(fmt::format("{} ends before the {}", words_[0], what));
      return "";
    }
    return words_[at_++];
  }
  template <class Integer>
  void number(std::string_view what, Integer& out) {
    const std::string_view next = word(what);
    if (isGood()) fail(readAny(next, what, out));
  }
  void cell(Cell& out) {
    number("cell index", out.i);
    number("cell index", out.j);
  }
  void rect(CellRect& out) {
    cell(out.min);
    cell(out.max);
  }
  template <std::size_t N>
  std::size_t oneOf(std::string_view what, const std::array<const char*, N>& names) {
    std::size_t which = 0;
    const std::string_view next = word(what);
    if (isGood()) fail(readOneOf(next, what, names, which));
    return isGood() ? which : 0;
  }
  void named(Named& out) {
    const std::string_view next = word("polygon");
    if (isGood()) fail(readNamed(next, out));
  }
  /// Polygons up to another word.
  void shape(Shape& out) {
    const auto isCoordinate = [&] {
      return !isAtEnd() && (words_[at_][0] == '-' || words_[at_][0] == '+' || words_[at_][0] == '.' ||
                            (words_[at_][0] >= '0' && words_[at_][0] <= '9'));
    };
    while (isGood() && (isCoordinate() || is("none"))) {
      LocalPolygon& polygon = out.emplace_back();
      const std::size_t begin = at_;
      if (!take("none")) {
        while (isCoordinate()) ++at_;
        fail(readPoints(words_.subspan(begin, at_ - begin), "", polygon));
      }
      if (!take("|")) return;
      if (!isCoordinate() && !is("none")) fail("a polygon is missing after |");
    }
  }
  void coming(Coming& out, Kind kind) {
    if (kind == Kind::add) {
      const std::string_view name = word("name");
      if (isGood() && name != "-") {
        fail(readName(name));
        out.names.emplace_back(name);
      }
    }
    if (has(kind, KindOfCall::cell)) cell(out.cell);
    if (kind != Kind::shape) number("block", out.block);
    if (kind == Kind::setBlock) return;
    if (kind != Kind::add && take("id"))
      number("id", out.id);
    else
      shape(out.shape);
    const bool isOne = kind == Kind::add || kind == Kind::exchange;
    if (isGood() && isOne && out.shape.empty()) out.shape.emplace_back();
    if (isGood() && isOne && out.shape.size() > 1) fail("only one polygon can come here");
    if (kind == Kind::add || !take("as")) return;
    while (isGood() && !isAtEnd() && !is(";") && !is("in") && !is("room")) {
      const std::string_view name = word("name");
      fail(readName(name));
      out.names.emplace_back(name);
    }
    if (out.names.size() > out.shape.size()) fail("more names than polygons");
  }
  Words rest() {
    const Words left = words_.subspan(at_);
    at_ = words_.size();
    return left;
  }
  void fail(Fault fault) {
    if (fault_.empty()) fault_ = std::move(fault);
  }
  bool isGood() const { return fault_.empty(); }
  Fault end() {
    if (isGood() && !isAtEnd()) fail(fmt::format("{} is too much for {}", quote(words_[at_]), words_[0]));
    return fault_;
  }

 private:
  Words words_;
  std::size_t at_ = 1;
  Fault fault_;
};

}  // namespace

std::string wordFor(Kind kind) { return kKindsOfCalls[static_cast<std::size_t>(kind)].word; }

std::string printCall(const Call& call) {
  const Kind kind = call.kind;
  if (kind == Kind::brush) return print(call.brush);
  std::string text = wordFor(kind);
  if (kind == Kind::add) text += " " + (call.name().empty() ? "-" : call.name());
  if (kind == Kind::group) text += fmt::format(" {}", kKeeps[static_cast<std::size_t>(call.keeps)]);
  if (kind == Kind::exchange) text += print(call.cells.min);
  if (has(kind, KindOfCall::rect)) text += print(call.cells.min) + print(call.cells.max);
  for (const Named& named : call.goes) text += print(named);
  if (kind == Kind::exchange && !call.comes.empty()) text += " with";
  for (const Coming& coming : call.comes)
    if (kind != Kind::put) text += (&coming == call.comes.data() ? "" : " ;") + print(coming, kind);
  if (call.notation != Notation::lattice) {
    text += fmt::format("  in {}", kNotations[static_cast<std::size_t>(call.notation)]);
    if (call.offset != 0) text += fmt::format(" {}", call.offset);
  }
  if (call.room != 0) text += fmt::format("  room {}", call.room);
  const bool mayLackNumber = kind == Kind::commit || kind == Kind::reload || kind == Kind::take;
  if (has(kind, KindOfCall::number) && (call.nth != 0 || !mayLackNumber)) text += fmt::format(" {}", call.nth);
  if (call.lies.by != Cell{}) text += " by" + print(call.lies.by);
  if (call.lies.symmetry != 0) text += fmt::format(" turned {}", call.lies.symmetry);
  if (kind == Kind::rollBack && call.keeps != Call::Keeps::never) text += " keep";
  for (const Call& part : call.group) text += "\n" + printCall(part);
  return has(kind, KindOfCall::parts) ? text + "\nend" : text;
}

Fault readCall(Words words, Call& call) {
  const std::string_view first = words[0];
  if (first == "paint" || first == "carve") {
    call.kind = Kind::brush;
    const auto around = std::ranges::find(words, "around");
    for (auto at = around; at != words.end() && ++at != words.end();)
      if (Fault fault = readAny(*at, "block", call.brush.staying.emplace_back()); !fault.empty()) return fault;
    Words region = words.first(static_cast<std::size_t>(around - words.begin()));
    call.brush.isEvenOdd = region.back() != "united";
    if (!call.brush.isEvenOdd) region = region.first(region.size() - 1);
    return readBrush(region, call.brush);
  }
  const auto found = std::ranges::find(kKindsOfCalls, first, &KindOfCall::word);
  if (found == kKindsOfCalls.end()) {
    std::string known;
    for (const KindOfCall& each : kKindsOfCalls) known += fmt::format("{}, ", each.word);
    return fmt::format("unknown word {}; a line starts with one of {}carve, end or #", quote(first), known);
  }
  call.kind = static_cast<Kind>(found - kKindsOfCalls.begin());
  const Kind kind = call.kind;
  Reader in(words);
  if (kind == Kind::group) call.keeps = static_cast<Call::Keeps>(in.oneOf("end of a group", kKeeps));
  if (kind == Kind::exchange) {
    in.cell(call.cells.min);
    call.cells.max = call.cells.min;
  }
  if (has(kind, KindOfCall::rect)) in.rect(call.cells);
  if (kind == Kind::remove || kind == Kind::setBlock || kind == Kind::take) in.named(call.goes.emplace_back());
  if (kind == Kind::removeMany || kind == Kind::exchange)
    while (in.isGood() && !in.isAtEnd() && !in.is("with") && !in.is("room")) in.named(call.goes.emplace_back());
  const bool isOfMany = (kind == Kind::addMany && !in.isAtEnd() && !in.is("in") && !in.is("room")) ||
                        (kind == Kind::exchange && in.take("with"));
  if (isOfMany || has(kind, KindOfCall::one)) {
    do in.coming(call.comes.emplace_back(), kind);
    while (in.isGood() && isOfMany && in.take(";"));
  }
  if (in.isGood() && !call.comes.empty() && kind != Kind::setBlock && in.take("in")) {
    call.notation = static_cast<Notation>(in.oneOf("notation", kNotations));
    if (!in.isAtEnd() && !in.is("room")) in.number("offset", call.offset);
    if (in.isGood() && call.offset >= kOffsets) in.fail(fmt::format("offsets are 0 to {}", kOffsets - 1));
  }
  if (in.isGood() && has(kind, KindOfCall::room) && in.take("room")) {
    in.number("room", call.room);
    if (in.isGood() && call.room > 3) in.fail("the room for handles is 0 to 3");
  }
  if (has(kind, KindOfCall::number) && !in.isAtEnd()) in.number("number", call.nth);
  if (in.isGood() && kind == Kind::repeat && call.nth > 1'000) in.fail("calls are repeated 1000 times at most");
  if (in.isGood() && kind == Kind::put && in.take("by")) in.cell(call.lies.by);
  if (in.isGood() && kind == Kind::put && in.take("turned")) in.number("number of a symmetry", call.lies.symmetry);
  if (in.isGood() && call.lies.symmetry > 7) in.fail("the symmetries of a cell are 0 to 7");
  if (in.isGood() && kind == Kind::rollBack && in.take("keep")) call.keeps = Call::Keeps::always;
  if (Fault fault = in.end(); !fault.empty()) return fault;
  call = tidied(std::move(call));
  return {};
}

}  // namespace lgs::oracle
