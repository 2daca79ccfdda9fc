#include "cli/import_error.h"

#include <utility>

namespace lgs::cli {

std::string complaint(tiled::ImportError error, const std::string& before) {
  const std::string field = std::exchange(error.option, {});
  const std::string text = tiled::message(error);
  if (field.empty()) return text;
  const char* const option = field == "layers"              ? "--layer"
                             : field == "tolerance"         ? "--tolerance"
                             : field == "polylineThickness" ? "--polyline-thickness"
                                                            : nullptr;
  return text + (option ? " (" + before + option + ")" : "; no option of lgs changes it");
}

}  // namespace lgs::cli
