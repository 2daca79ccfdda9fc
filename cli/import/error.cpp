#include "cli/import/error.h"

#include <string_view>
#include <utility>

namespace lgs::cli {

std::string complaint(tiled::ImportError error) {
  const std::string field = std::exchange(error.option, {});
  std::string text = tiled::message(error);
  constexpr std::string_view kAnywhere = "Options::filesAnywhere";
  if (const std::size_t at = text.find(kAnywhere); at != std::string::npos) {
    text.replace(at, kAnywhere.size(), "--files-anywhere");
  }
  if (field.empty()) return text;
  // The command has checked all other fields by itself, or has no options for them.
  return text + (field == "layers" ? " (--layer)" : "; no option of lgs changes it");
}

}  // namespace lgs::cli
