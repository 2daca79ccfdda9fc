#include "oracle/trace/line.h"

#include <algorithm>

namespace lgs::oracle {

std::vector<std::string_view> splitWords(std::string_view line) {
  constexpr std::string_view kBlanks = " \t,";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    if (line[at] == '#') break;
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

}  // namespace lgs::oracle
