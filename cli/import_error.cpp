#include "cli/import_error.h"

#include <string_view>
#include <utility>

namespace lgs::cli {

std::string complaint(tiled::ImportError error, const std::string& before) {
  const std::string field = std::exchange(error.option, {});
  std::string text = tiled::message(error);
  constexpr std::string_view kAnywhere = "Options::filesAnywhere";
  if (const std::size_t at = text.find(kAnywhere); at != std::string::npos) {
    text.replace(at, kAnywhere.size(), before + "--files-anywhere");
  }
  if (field.empty()) return text;
  const char* const option = field == "layers"              ? "--layer"
                             : field == "tolerance"         ? "--tolerance"
                             : field == "polylineThickness" ? "--polyline-thickness"
                                                            : nullptr;
  return text + (option ? " (" + before + option + ")" : "; no option of lgs changes it");
}

}  // namespace lgs::cli
