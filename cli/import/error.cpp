#include "cli/import/error.h"

#include "lib/text/words.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace lgs::cli {

std::string withCommands(std::string text, const std::string& map) {
  constexpr auto kTrust = std::to_array<std::pair<std::string_view, const char*>>(
      {{": Options::filesIn = ", " --files-in "}, {": Options::filesAnywhere", " --files-anywhere"}});
  for (const auto& [field, option] : kTrust) {
    for (std::size_t at = text.find(field); at != std::string::npos; at = text.find(field, at + 1)) {
      const std::size_t begin = at + field.size(), end = std::min(text.find_first_of(";\n", begin), text.size());
      const std::string folder = text.substr(begin, end - begin);
      const std::string word = folder.empty() ? "" : text::shellWord(folder);
      text.replace(at, end - at, ": lgs import " + text::shellWord(map) + option + word);
    }
  }
  return text;
}

std::string complaint(tiled::ImportError error, const std::string& map) {
  const std::string field = std::exchange(error.option, {}), text = withCommands(tiled::message(error), map);
  if (field.empty()) return text;
  // The command has checked all other fields by itself, or has no options for them.
  return text + (field == "layers" ? " (--layer)" : "; no option of lgs changes it");
}

}  // namespace lgs::cli
