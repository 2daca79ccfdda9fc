// Where files lie by their paths as they are written: links are no matter of these.
#pragma once

#include <filesystem>
#include <string>

namespace lgs::tiled {

/// The folder of a file; "" if its path has none.
std::string folderOf(const std::string& file);

/// Whether a path leads to something below a folder: neither by "..", nor to another root or drive.
bool liesBelow(const std::string& folder, const std::string& path);

/// The path of a folder, normal and without a slash at its end.
std::string withoutSlash(const std::filesystem::path& folder);

/// The nearest folder that holds both files.
std::string folderOfBoth(const std::string& file, const std::string& other);

}  // namespace lgs::tiled
