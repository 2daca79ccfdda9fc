#include "cli/import/error.h"

#include "lib/text/words.h"

#include <array>
#include <string_view>
#include <utility>

namespace lgs::cli {

std::string complaint(tiled::ImportError error, const std::string& map) {
  const std::string field = std::exchange(error.option, {});
  std::string text = tiled::message(error);
  constexpr auto kTrust = std::to_array<std::pair<std::string_view, const char*>>(
      {{": Options::filesIn = ", " --files-in "}, {": Options::filesAnywhere", " --files-anywhere"}});
  for (const auto& [fieldOfOptions, option] : kTrust) {
    const std::size_t at = text.find(fieldOfOptions);
    if (at == std::string::npos) continue;
    const std::string folder = text.substr(at + fieldOfOptions.size());
    text.resize(at);
    text += ":\n  lgs import " + text::shellWord(map) + option + (folder.empty() ? "" : text::shellWord(folder));
  }
  if (field.empty()) return text;
  // The command has checked all other fields by itself, or has no options for them.
  return text + (field == "layers" ? " (--layer)" : "; no option of lgs changes it");
}

}  // namespace lgs::cli
