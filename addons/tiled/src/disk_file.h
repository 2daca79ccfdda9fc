// One file of the disk.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

namespace lgs::tiled {

/// Reads a regular file. Its path has no symbolic links in it; if it has now, that is an error. It opens nothing that
/// could block.
tl::expected<std::string, std::string> readRegularFile(const std::filesystem::path& path);

}  // namespace lgs::tiled
