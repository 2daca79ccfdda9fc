#include <lgs/tiled/import.h>

#include <algorithm>
#include <string_view>

namespace lgs::tiled {
namespace {

bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

bool isPlain(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         std::string_view("_-./,:=+@%").find(c) != std::string_view::npos;
}

/// "\033": three digits, so that a digit that follows is no part of it.
std::string octal(char c) {
  const auto digit = [&](int shift) { return static_cast<char>('0' + (c >> shift & 7)); };
  return {'\\', digit(6), digit(3), digit(0)};
}

}  // namespace

std::string shellWord(std::string_view argument) {
  if (!argument.empty() && std::all_of(argument.begin(), argument.end(), isPlain)) return std::string(argument);
  const bool hasControls = std::any_of(argument.begin(), argument.end(), isControl);
  std::string text = hasControls ? "$'" : "'";
  for (const char c : argument) {
    if (isControl(c)) {
      text += octal(c);
    } else if (c == '\'') {
      text += hasControls ? "\\'" : "'\\''";
    } else {
      text += hasControls && c == '\\' ? "\\\\" : std::string(1, c);
    }
  }
  return text + "'";
}

}  // namespace lgs::tiled
