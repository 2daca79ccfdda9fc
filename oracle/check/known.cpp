#include "oracle/check/known.h"

#include "oracle/calls/shapes.h"
#include "oracle/check/shrink.h"
#include "oracle/trace/line.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace lgs::oracle {
namespace {

constexpr int kSymmetries = 8;
constexpr std::int64_t U = kUnitsPerCell;
constexpr std::string_view kHead = "known ";

// As turned() of shapes.h does it with what lies in a cell.
template <class Number>
void turn(Number& x, Number& y, int symmetry, Number mirror) {
  if (symmetry & 1) x = mirror - x;
  if (symmetry & 2) y = mirror - y;
  if (symmetry & 4) std::swap(x, y);
}

Trace turned(Trace trace, int symmetry) {
  for (Call& call : trace.calls) {
    for (Coming& coming : call.comes) {
      turn(coming.cell.i, coming.cell.j, symmetry, -1);
      for (LocalPolygon& polygon : coming.shape) {
        polygon = oracle::turned(polygon, symmetry);
        std::rotate(polygon.begin(), std::ranges::min_element(polygon), polygon.end());
      }
    }
    for (auto& ring : call.brush.rings)
      for (Point& p : ring) turn(p.x, p.y, symmetry, std::int64_t{0});
  }
  return trace;
}

// Moves all so that the least column of cells is 0, or the least row.
void moveToOrigin(Trace& trace, std::int32_t Cell::*line, std::int64_t Point::*coordinate) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  const auto forEach = [&](auto&& visitCell, auto&& visitPoint) {
    for (Call& call : trace.calls) {
      for (Coming& coming : call.comes) visitCell(coming.cell.*line);
      for (auto& ring : call.brush.rings)
        for (Point& p : ring) visitPoint(p.*coordinate);
    }
  };
  const auto cellOf = [](std::int64_t c) { return c / U - (c % U < 0 ? 1 : 0); };
  forEach([&](std::int32_t& c) { least = std::min<std::int64_t>(least, c); },
          [&](std::int64_t& c) { least = std::min(least, cellOf(c)); });
  forEach([&](std::int32_t& c) { c = static_cast<std::int32_t>(c - least); }, [&](std::int64_t& c) { c -= least * U; });
}

// Adds that follow one another come in the order of what they add.
void sortAdds(std::vector<Call>& calls) {
  const auto isAdd = [](const Call& call) { return call.kind == Call::Kind::add; };
  const auto added = [](const Call& call) {
    return std::tuple(call.comes[0].cell, call.comes[0].shape, call.comes[0].block);
  };
  for (auto begin = calls.begin(); begin != calls.end();) {
    begin = std::find_if(begin, calls.end(), isAdd);
    const auto end = std::find_if_not(begin, calls.end(), isAdd);
    std::ranges::stable_sort(begin, end, {}, added);
    begin = end;
  }
}

}  // namespace

std::string identityOf(const KnownMismatch& mismatch) {
  Trace plain = mismatch.trace;
  while (!plain.calls.empty() && plain.calls.back().kind == Call::Kind::commit) plain.calls.pop_back();
  std::string least;
  for (int symmetry = 0; symmetry < kSymmetries; ++symmetry) {
    Trace trace = turned(plain, symmetry);
    moveToOrigin(trace, &Cell::i, &Point::x);
    moveToOrigin(trace, &Cell::j, &Point::y);
    sortAdds(trace.calls);
    std::string text = printTrace(renamed(std::move(trace)));
    if (least.empty() || text < least) least = std::move(text);
  }
  return mismatch.kind + "\n" + least;
}

tl::expected<std::vector<KnownMismatch>, std::string> parseKnown(std::string_view text) {
  std::vector<KnownMismatch> known;
  std::string trace;
  std::size_t line = 0, first = 1;
  const auto finish = [&]() -> tl::expected<void, std::string> {
    auto parsed = parseTrace(trace);
    if (known.empty() && trace.find_first_not_of(" \t\r\n") == std::string::npos) return {};
    if (known.empty()) return tl::unexpected<std::string>("1: a list begins with a line 'known KIND'");
    if (parsed.error) return tl::unexpected(fmt::format("{}: {}", first + parsed.error->line - 1, parsed.error->text));
    known.back().trace = std::move(parsed.trace);
    return {};
  };
  while (!text.empty()) {
    const std::string_view content = takeLine(text);
    ++line;
    if (known.empty() && content.starts_with('#')) continue;
    if (!content.starts_with(kHead)) {
      trace.append(content) += '\n';
      continue;
    }
    if (auto done = finish(); !done) return tl::unexpected(done.error());
    known.push_back({std::string(content.substr(kHead.size())), {}});
    trace.clear();
    first = line + 1;
  }
  if (auto done = finish(); !done) return tl::unexpected(done.error());
  return known;
}

std::string printKnown(std::vector<KnownMismatch> known) {
  std::ranges::sort(known, {}, [](const KnownMismatch& one) {
    return std::tuple(one.kind, editCount(one.trace), printTrace(one.trace));
  });
  std::string text = "# Mismatches that are known: lgs check --known THIS. With --fix it is written anew.\n";
  for (const KnownMismatch& one : known) text += fmt::format("\n{}{}\n{}", kHead, one.kind, printTrace(one.trace));
  return text;
}

}  // namespace lgs::oracle
