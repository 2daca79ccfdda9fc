// Lines of a text, and their words.
#pragma once

#include <string_view>
#include <vector>

namespace lgs::oracle {

/// The words of a line, without the comment at its end. Spaces, tabs and commas part them.
std::vector<std::string_view> splitWords(std::string_view line);

/// Takes the first line of a text, without its end, LF or CR LF.
inline std::string_view takeLine(std::string_view& text) {
  std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(line.size() < text.size() ? line.size() + 1 : line.size());
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace lgs::oracle
