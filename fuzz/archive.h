// A corpus is a tar archive (ustar), as fuzz/corpus.sh and any tar write it.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::fuzz {

/// The contents of all files in an archive, in its order; or why it is none.
tl::expected<std::vector<std::string>, std::string> filesOf(std::string_view archive);

}  // namespace lgs::fuzz
