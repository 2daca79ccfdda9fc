// Calls in words, and simpler ones: for people who read what a test has found.
#include "oracle/calls/call.h"
#include "oracle/calls/shapes.h"

#include <fmt/format.h>
#include <array>

namespace lgs::oracle {
namespace {

using Kind = Call::Kind;

std::string inWords(Cell cell) { return fmt::format("({}, {})", cell.i, cell.j); }

std::string inWords(const Named& named) {
  switch (named.how) {
    case Named::How::standing:
      return fmt::format("polygon {} of {}", named.nth, inWords(named.cell));
    case Named::How::all:
      return "all of " + inWords(named.cell);
    case Named::How::given:
      return fmt::format("polygon {} of those given", named.nth);
    case Named::How::beside:
      return fmt::format("what comes after polygon {} of those given", named.nth);
    case Named::How::handle:
      break;
  }
  return fmt::format("{}:{}", named.handle.cellRef, named.handle.serial);
}

std::string inWords(const Coming& coming) {
  std::string text = fmt::format("block {}", coming.block);
  if (coming.id != 0) return text + fmt::format(", shape {}", coming.id);
  for (std::size_t k = 0; k < coming.shape.size(); ++k) {
    text += k == 0 ? ":" : " |";
    for (const LocalPoint& p : coming.shape[k]) text += fmt::format(" {} {}", p.x, p.y);
  }
  return text;
}

}  // namespace

std::string inWords(const Call& call) {
  constexpr std::array kNames{"shape",    "add",      "addShape", "addMany", "remove", "removeMany", "replace",
                              "exchange", "setBlock", "fill",     "clear",   "group",  "commit",     "mark",
                              "goBack",   "forget",   "leave",    "copy",    "load"};
  constexpr std::array kNotations{"", " as a list", " in floats", " in doubles"};
  static_assert(kNames.size() == Call::kKinds);
  const Kind kind = call.kind;
  std::string text = kNames[static_cast<std::size_t>(kind)];
  if (kind == Kind::goBack || kind == Kind::forget) text += fmt::format(" {}", call.nth);
  if (kind == Kind::fill || kind == Kind::clear || kind == Kind::leave)
    text += fmt::format(" {} to {}", inWords(call.cells.min), inWords(call.cells.max));
  if (kind == Kind::exchange) text += " " + inWords(call.cells.min);
  for (const Named& named : call.goes)
    text += fmt::format("{} {}", &named == call.goes.data() ? "" : ",", inWords(named));
  for (const Coming& coming : call.comes) {
    const bool isAt = kind == Kind::add || kind == Kind::addShape || kind == Kind::addMany || kind == Kind::replace;
    text += (call.comes.size() > 1 ? "\n  " : " ") + (isAt ? inWords(coming.cell) + " " : "") + inWords(coming);
  }
  if (!call.comes.empty()) text += kNotations[static_cast<std::size_t>(call.notation)];
  if (!call.comes.empty() && isReal(call.notation)) text += fmt::format(", offset {}", call.offset);
  if (!call.comes.empty() && call.room != 0) text += fmt::format(", room {}", call.room);
  for (const Call& part : call.group) text += "\n  " + inWords(part);
  constexpr std::array kEnds{"\n  undone", "\n  kept", "\n  kept if all are accepted"};
  return kind == Kind::group ? text + kEnds[static_cast<std::size_t>(call.keeps)] : text;
}

std::vector<Call> simpler(const Call& call) {
  std::vector<Call> all = call.group;
  const auto with = [&](auto&& change) { change(all.emplace_back(call)); };
  const auto withoutEach = [&](auto Call::*list, std::size_t least) {
    for (std::size_t k = 0; (call.*list).size() > least && k < (call.*list).size(); ++k)
      with([&](Call& c) { (c.*list).erase((c.*list).begin() + static_cast<std::ptrdiff_t>(k)); });
  };
  const bool isOfMany = call.kind == Kind::addMany || call.kind == Kind::exchange || call.kind == Kind::removeMany;
  withoutEach(&Call::group, 1);
  withoutEach(&Call::comes, isOfMany ? 0 : 1);
  withoutEach(&Call::goes, isOfMany ? 0 : 1);
  for (std::size_t k = 0; k < call.comes.size(); ++k) {
    const Coming& coming = call.comes[k];
    for (const std::size_t plain : {0U, 6U}) {  // the full square, and the ramp
      const Shape& shape = degenerateShapes()[plain].polygons;
      if (coming.id == 0 && (coming.shape == shape || coming.shape == degenerateShapes()[0].polygons)) continue;
      with([&](Call& c) { c.comes[k] = {coming.cell, shape, coming.block, 0}; });
    }
    for (const LocalPolygon& p : coming.shape)
      if (coming.shape.size() > 1) with([&](Call& c) { c.comes[k].shape = {p}; });
    if (coming.block != 0) with([&](Call& c) { c.comes[k].block = 0; });
  }
  for (std::size_t k = 0; k < call.goes.size(); ++k)
    if (call.goes[k].nth != 0) with([&](Call& c) { c.goes[k].nth = 0; });
  if (call.cells.min != call.cells.max) with([&](Call& c) { c.cells.max = c.cells.min; });
  if (call.notation != Notation::lattice) with([&](Call& c) { c.notation = {}; });
  if (call.room != 0) with([&](Call& c) { c.room = 0; });
  return all;
}

Call inParts(const Call& call) {
  Call group;
  group.kind = Kind::group;
  group.keeps = Call::Keeps::ifAll;
  const auto part = [&](Kind kind) -> Call& {
    group.group.emplace_back().kind = kind;
    group.group.back().notation = call.notation;
    group.group.back().offset = call.offset;
    return group.group.back();
  };
  const auto place = [&](Cell cell, const Coming& coming, Kind kind) {
    part(kind).comes = {coming};
    group.group.back().comes[0].cell = cell;
  };
  const auto& [min, max] = call.cells;
  if (call.kind == Kind::replace) part(Kind::clear).cells = {call.comes[0].cell, call.comes[0].cell};
  for (const Named& named : call.goes) part(Kind::remove).goes = {named};
  for (std::int32_t j = min.j; j <= max.j; ++j) {
    for (std::int32_t i = min.i; i <= max.i; ++i) {
      if (call.kind == Kind::fill) place({i, j}, call.comes[0], Kind::addShape);
      if (call.kind == Kind::clear) part(Kind::removeMany).goes = {{Named::How::all, {i, j}}};
    }
  }
  for (const Coming& coming : call.comes) {
    if (call.kind == Kind::exchange) {
      part(Kind::add).comes = {{min, coming.shape, coming.block}};
      group.group.back().notation = {};
    } else if (call.kind != Kind::fill) {
      place(coming.cell, coming, Kind::addShape);
    }
  }
  return group;
}

}  // namespace lgs::oracle
