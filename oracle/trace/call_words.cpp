// What the lines of calls are read from: words, integers, coordinates; and the region of a brush.
#include "oracle/trace/call_text.h"

#include "oracle/trace/coordinate.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>

namespace lgs::oracle {

std::string quote(std::string_view word) {
  constexpr std::size_t kShown = 40;
  return word.size() <= kShown ? fmt::format("'{}'", word) : fmt::format("'{}…'", word.substr(0, kShown));
}

Fault readInteger(std::string_view word, std::string_view what, std::int64_t min, std::int64_t max, std::int64_t& out) {
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

namespace {

template <class Vertex, class Parse>
Fault readPointsBy(Words words, std::string_view of, Parse parse, std::vector<Vertex>& out) {
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

Fault readRing(Words words, std::size_t number, std::vector<Point>& out) {
  if (words.empty()) return fmt::format("ring {} has no coordinates", number);
  if (words.size() % 2 != 0)
    return fmt::format("ring {} has {} coordinates: they come in pairs x y, so one is missing or one too many", number,
                       words.size());
  return readPoints(words, fmt::format(" of ring {}", number), out);
}

}  // namespace

Fault readPoints(Words words, std::string_view of, std::vector<LocalPoint>& out) {
  if (words.size() % 2 != 0)
    return fmt::format("{} coordinates: they come in pairs x y, so one is missing or one too many", words.size());
  return readPointsBy(words, of, parseCoordinate, out);
}

Fault readPoints(Words words, std::string_view of, std::vector<Point>& out) {
  return readPointsBy(words, of, parseWorldCoordinate, out);
}

Fault readBrush(Words words, BrushEdit& brush) {
  std::size_t first = 1;
  if (words[0] == "paint") {
    if (words.size() < 3) return "paint needs a block, and fill or replace, before its coordinates";
    if (Fault fault = readAny(words[1], "block", brush.block); !fault.empty()) return fault;
    if (words[2] != "fill" && words[2] != "replace")
      return fmt::format("paint is in the mode fill or replace, not {}", quote(words[2]));
    brush.deed = words[2] == "fill" ? BrushEdit::Deed::fill : BrushEdit::Deed::replace;
    first = 3;
  }
  for (std::size_t k = first; k <= words.size();) {
    const std::size_t end = static_cast<std::size_t>(
        std::find(words.begin() + static_cast<std::ptrdiff_t>(k), words.end(), "|") - words.begin());
    const Words ring = words.subspan(k, end - k);
    const std::size_t number = brush.rings.size();
    if (Fault fault = readRing(ring, number, brush.rings.emplace_back()); !fault.empty()) return fault;
    k = end + 1;
  }
  return {};
}

}  // namespace lgs::oracle
