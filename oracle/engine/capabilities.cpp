#include "oracle/engine/capabilities.h"

#include "oracle/engine/answer.h"
#include "oracle/reference/words.h"
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
    Word{"time", &Capabilities::time},       Word{"regions", &Capabilities::regions},
};

// The number after "lattice=", "cells=" or "round="; -1 if there is none.
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
    return isGood ? "" : fmt::format("'{}': N must be a power of two, {} at most", shortened(word), kUnitsPerCell);
  }
  if (word.starts_with("cells=")) {
    can.cells = numberAfter(word, "cells=");
    return can.cells >= 0 && can.cells <= kMaxCell ? ""
                                                   : fmt::format("'{}': N must be 0 to {}", shortened(word), kMaxCell);
  }
  if (word.starts_with("round=")) {
    can.round = numberAfter(word, "round=");
    return can.round > 0 && can.round <= kUnitsPerCell
               ? ""
               : fmt::format("'{}': N must be 1 to {} lattice units", shortened(word), kUnitsPerCell);
  }
  return fmt::format(
      "'{}' is no capability; there are ghosts, blocks, several, slants, squares, preserve, refuses, "
      "merged, islands, delta, time, regions, lattice=N, cells=N and round=N",
      shortened(word));
}

// Words that do not go together.
std::string contradiction(const Capabilities& can) {
  if (!can.regions) return can.round == 0 ? "" : "'round=N' is of engines with 'regions'";
  for (const bool Capabilities::*const flag : {&Capabilities::several, &Capabilities::squares, &Capabilities::refuses,
                                               &Capabilities::merged, &Capabilities::islands, &Capabilities::delta})
    if (can.*flag)
      return fmt::format("'{}' is of engines of cells: with 'regions' there are strokes alone",
                         std::ranges::find(kWords, flag, &Word::flag)->word);
  if (can.slants && can.round == 0)
    return "'regions' with 'slants' needs 'round=N': where slanted edges cross there is no lattice point";
  if (can.blocks != can.preserve)
    return "with 'regions', 'blocks' and 'preserve' go together: the outline of each block is compared by itself";
  return "";
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
  if (std::string wrong = contradiction(can); !wrong.empty()) return tl::unexpected(std::move(wrong));
  return can;
}

std::string print(const Capabilities& can) {
  std::string text;
  const auto add = [&](std::string_view word) { text += fmt::format("{}{}", text.empty() ? "" : " ", word); };
  for (const Word& word : kWords)
    if (can.*word.flag) add(word.word);
  if (can.lattice != kUnitsPerCell) add(fmt::format("lattice={}", can.lattice));
  if (can.cells != kMaxCell) add(fmt::format("cells={}", can.cells));
  if (can.round != 0) add(fmt::format("round={}", can.round));
  return text;
}

std::string worldsInWords(const Capabilities& can) {
  std::string text = can.squares ? "whole squares" : can.regions ? "strokes of brushes" : "polygons";
  if (!can.slants && !can.squares) text += " with axis-parallel edges";
  if (!can.regions) text += can.several && !can.squares ? ", several in a cell" : ", one in a cell";
  if (can.lattice != kUnitsPerCell && !can.squares) text += fmt::format(", on 1/{} of a cell", can.lattice);
  if (can.cells != kMaxCell) text += fmt::format(", cells within ±{}", can.cells);
  text += can.preserve ? "; some with a preserve relation" : "; no preserve relation";
  return text + (can.refuses ? "; some edits must be refused" : "; every edit is good");
}

std::string comparedInWords(const Capabilities& can) {
  std::vector<std::string> words{can.merged ? "joined segments" : "segments"};
  if (can.regions) {
    const auto units = static_cast<std::uint64_t>(can.round);
    words[0] =
        units == 0 ? "exact regions" : fmt::format("regions (within {} of the exact edges)", counted(units, "unit"));
  }
  if (can.ghosts) words.push_back("ghosts");
  if (can.blocks) words.push_back("blocks");
  if (can.islands) words.push_back("islands");
  if (can.delta) words.push_back("lists of changes");
  std::string text = words.front();
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

std::string whyNot(const BrushEdit& stroke, const Capabilities& can) {
  if (!stroke.isEvenOdd) return "it is united, and strokes for engines are even-odd";
  if (!stroke.staying.empty()) return "it goes around blocks, and strokes for engines do not";
  const std::int64_t step = kUnitsPerCell / can.lattice;
  const std::int64_t least = -std::int64_t{can.cells} * kUnitsPerCell, most = kUnitsPerCell - least;
  for (const std::vector<Point>& ring : stroke.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point a = ring[k], b = ring[(k + 1) % ring.size()];
      if (std::min(a.x, a.y) < least || std::max(a.x, a.y) > most)
        return fmt::format("it reaches beyond the cells within ±{}", can.cells);
      if (!can.slants && a.x != b.x && a.y != b.y) return "it has a slanted edge";
      if (a.x % step != 0 || a.y % step != 0) return fmt::format("it is not on 1/{} of a cell", can.lattice);
    }
  }
  return "";
}

}  // namespace lgs::oracle
