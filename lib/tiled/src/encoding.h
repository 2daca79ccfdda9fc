// The ways in which TMX writes a layer's tile numbers as text. All return exactly `count` numbers or say what is wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::tiled {

using Gids = std::vector<std::uint32_t>;

tl::expected<Gids, std::string> decodeCsv(std::string_view text, std::size_t count);

/// `compression` is "", "zlib", "gzip" or "zstd". Never takes more memory than `count` numbers and the text need.
tl::expected<Gids, std::string> decodeBase64(std::string_view text, std::string_view compression, std::size_t count);

}  // namespace lgs::tiled
