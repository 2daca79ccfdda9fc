// Words that come from files, as they are shown to people and given to shells. For all rooms above: the importer, the
// references and the command.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace lgs::text {

/// A control character would do something to a terminal.
inline bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

/// A text with a blank for each control character.
inline std::string withoutControls(std::string_view text) {
  std::string result(text);
  std::replace_if(result.begin(), result.end(), isControl, ' ');
  return result;
}

namespace detail {

/// Whether a shell takes a character as it is, wherever it stands.
inline bool isPlain(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         std::string_view("_-./,:=+@%").find(c) != std::string_view::npos;
}

/// "\033": three digits, so that a digit that follows is no part of it.
inline std::string octal(char c) {
  const auto digit = [&](int shift) { return static_cast<char>('0' + (c >> shift & 7)); };
  return {'\\', digit(6), digit(3), digit(0)};
}

}  // namespace detail

/// A word as a shell takes it: in quotes if it has to be. If it has control characters, they have escapes.
inline std::string shellWord(std::string_view word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), detail::isPlain)) return std::string(word);
  const bool hasControls = std::any_of(word.begin(), word.end(), isControl);
  std::string result = hasControls ? "$'" : "'";
  for (const char c : word) {
    if (isControl(c)) {
      result += detail::octal(c);
    } else if (c == '\'') {
      result += hasControls ? "\\'" : "'\\''";
    } else {
      result += hasControls && c == '\\' ? "\\\\" : std::string(1, c);
    }
  }
  return result + "'";
}

}  // namespace lgs::text
