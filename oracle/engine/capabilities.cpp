#include "oracle/engine/capabilities.h"

#include "oracle/trace/line.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

namespace lgs::oracle {
namespace {

struct Word {
  std::string_view word;
  bool Capabilities::*flag;
};
constexpr std::array kWords{
    Word{"ghosts", &Capabilities::ghosts},   Word{"blocks", &Capabilities::blocks},
    Word{"several", &Capabilities::several}, Word{"slants", &Capabilities::slants},
    Word{"squares", &Capabilities::squares}, Word{"preserve", &Capabilities::preserve},
    Word{"refuses", &Capabilities::refuses}, Word{"merged", &Capabilities::merged},
    Word{"islands", &Capabilities::islands}, Word{"delta", &Capabilities::delta},
    Word{"time", &Capabilities::time},
};

// The number after "lattice=" or "cells="; -1 if there is none.
std::int32_t numberAfter(std::string_view word, std::string_view key) {
  std::int32_t number = -1;
  const std::string_view digits = word.substr(key.size());
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool isNumber = status == std::errc() && end == digits.data() + digits.size() && !digits.starts_with('-');
  return isNumber ? number : -1;
}

// What is wrong with a word; empty if it was taken.
std::string take(std::string_view word, Capabilities& can) {
  const auto known = std::ranges::find(kWords, word, &Word::word);
  if (known != kWords.end()) {
    can.*known->flag = true;
    return "";
  }
  if (word.starts_with("lattice=")) {
    can.lattice = numberAfter(word, "lattice=");
    const bool isGood =
        can.lattice > 0 && can.lattice <= kUnitsPerCell && std::has_single_bit(static_cast<std::uint32_t>(can.lattice));
    return isGood ? "" : fmt::format("'{}': N must be a power of two, {} at most", word, kUnitsPerCell);
  }
  if (word.starts_with("cells=")) {
    can.cells = numberAfter(word, "cells=");
    return can.cells >= 0 && can.cells <= kMaxCell ? "" : fmt::format("'{}': N must be 0 to {}", word, kMaxCell);
  }
  return fmt::format(
      "'{}' is no capability; there are ghosts, blocks, several, slants, squares, preserve, refuses, "
      "merged, islands, delta, time, lattice=N and cells=N",
      word);
}

bool isWholeSquare(const std::vector<LocalPoint>& polygon) {
  constexpr std::int32_t U = kUnitsPerCell;
  std::vector<LocalPoint> sorted = polygon;
  std::ranges::sort(sorted);
  return sorted == std::vector<LocalPoint>{{0, 0}, {0, U}, {U, 0}, {U, U}};
}

bool isSlanted(const std::vector<LocalPoint>& polygon) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const LocalPoint a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    if (a.x != b.x && a.y != b.y) return true;
  }
  return false;
}

}  // namespace

tl::expected<Capabilities, std::string> parseCapabilities(std::string_view words) {
  Capabilities can;
  for (const std::string_view word : splitWords(words)) {
    if (std::string wrong = take(word, can); !wrong.empty()) return tl::unexpected(std::move(wrong));
  }
  return can;
}

std::string print(const Capabilities& can) {
  std::string text;
  const auto add = [&](std::string_view word) { text += fmt::format("{}{}", text.empty() ? "" : " ", word); };
  for (const Word& word : kWords)
    if (can.*word.flag) add(word.word);
  if (can.lattice != kUnitsPerCell) add(fmt::format("lattice={}", can.lattice));
  if (can.cells != kMaxCell) add(fmt::format("cells={}", can.cells));
  return text;
}

std::string worldsInWords(const Capabilities& can) {
  std::string text = can.squares ? "whole squares" : can.slants ? "polygons" : "polygons with axis-parallel edges";
  text += can.several && !can.squares ? ", several in a cell" : ", one in a cell";
  if (can.lattice != kUnitsPerCell && !can.squares) text += fmt::format(", on 1/{} of a cell", can.lattice);
  if (can.cells != kMaxCell) text += fmt::format(", cells within ±{}", can.cells);
  text += can.preserve ? "; some with a preserve relation" : "; no preserve relation";
  return text + (can.refuses ? "; some edits must be refused" : "; every edit is good");
}

std::string comparedInWords(const Capabilities& can) {
  std::vector<std::string_view> words{can.merged ? "joined segments" : "segments"};
  if (can.ghosts) words.push_back("ghosts");
  if (can.blocks) words.push_back("blocks");
  if (can.islands) words.push_back("islands");
  if (can.delta) words.push_back("lists of changes");
  std::string text(words.front());
  for (std::size_t k = 1; k < words.size(); ++k)
    text += fmt::format("{}{}", k + 1 < words.size() ? ", " : " and ", words[k]);
  return text;
}

std::string whyNot(const ScenePolygon& polygon, const Capabilities& can) {
  const auto& [cell, block, vertices] = polygon;
  const auto isBeyond = [&](std::int32_t index) { return index < -can.cells || index > can.cells; };
  if (isBeyond(cell.i) || isBeyond(cell.j)) return fmt::format("its cell is beyond ±{}", can.cells);
  if (can.squares && !isWholeSquare(vertices)) return "it is no whole square";
  if (!can.slants && isSlanted(vertices)) return "it has a slanted edge";
  const std::int32_t step = kUnitsPerCell / can.lattice;
  const auto isOff = [&](LocalPoint p) { return p.x % step != 0 || p.y % step != 0; };
  return std::ranges::any_of(vertices, isOff) ? fmt::format("it is not on 1/{} of a cell", can.lattice) : "";
}

}  // namespace lgs::oracle
