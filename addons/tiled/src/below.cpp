#include "below.h"

#include <filesystem>

namespace lgs::tiled {

namespace fs = std::filesystem;

std::string folderOf(const std::string& file) { return fs::path(file).parent_path().generic_string(); }

bool liesBelow(const std::string& folder, const std::string& path) {
  const fs::path root = fs::path(folder).lexically_normal(), to = fs::path(path).lexically_normal();
  const fs::path here(".");
  const bool isHere = root.empty() || root == here;  // then the path must be one without a root, such as "a/b"
  if (isHere && (to.has_root_name() || to.has_root_directory())) return false;
  const fs::path from = isHere ? to : to.lexically_relative(root);
  return !from.empty() && from != here && *from.begin() != "..";
}

}  // namespace lgs::tiled
