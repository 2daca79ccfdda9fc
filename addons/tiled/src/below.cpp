#include "below.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace lgs::tiled {

namespace fs = std::filesystem;

std::string folderOf(const std::string& file) { return fs::path(file).parent_path().generic_string(); }

bool liesBelow(const std::string& folder, const std::string& path) {
  const fs::path root = fs::path(folder).lexically_normal(), to = fs::path(path).lexically_normal();
  const auto isUp = [](const fs::path& step) { return step == ".."; };
  const auto ups = [&](const fs::path& p) { return std::find_if_not(p.begin(), p.end(), isUp); };
  if (root == "." || ups(root) == root.end()) {  // "", ".", "..", "../..": what goes no further up lies below it
    const auto up = root == "." ? 0 : std::distance(root.begin(), root.end());
    const auto its = std::distance(to.begin(), ups(to)), steps = std::distance(to.begin(), to.end());
    return !to.has_root_name() && !to.has_root_directory() && steps > its && to != "." && its <= up;
  }
  const fs::path from = to.lexically_relative(root);
  return !from.empty() && from != "." && !isUp(*from.begin());
}

std::string withoutSlash(const fs::path& folder) {
  const fs::path plain = folder.lexically_normal();
  return plain.empty() ? "." : (plain.has_filename() ? plain : plain.parent_path()).generic_string();
}

std::string folderOfBoth(const std::string& file, const std::string& other) {
  fs::path folder = fs::path(file).parent_path().lexically_normal();
  if (fs::path(other).has_root_directory() != folder.has_root_directory()) return folderOf(other);
  while (!liesBelow(folder.generic_string(), other)) {
    const fs::path up = (folder / "..").lexically_normal();
    if (up == folder) break;
    folder = up;
  }
  return withoutSlash(folder);
}

}  // namespace lgs::tiled
