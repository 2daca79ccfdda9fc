// Numbers and lines of a suite's text.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace lgs::oracle {

/// A finite number; nothing, if the word is none.
inline std::optional<double> numberOf(std::string_view word) {
  double number = 0;
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool isWhole = status == std::errc() && end == word.data() + word.size() && !word.empty();
  return isWhole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// Takes the first line of a text, without its end, LF or CR LF.
inline std::string_view takeLine(std::string_view& text) {
  std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(line.size() < text.size() ? line.size() + 1 : line.size());
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace lgs::oracle
