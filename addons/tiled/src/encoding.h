// TMX writes the tile numbers of a layer as text. These functions read it back. Each returns exactly `count` numbers,
// or says what is wrong.
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

/// `compression` is "", "zlib", "gzip" or "zstd". Takes memory in proportion to `count` and to the text, whatever the
/// text announces.
tl::expected<Gids, std::string> decodeBase64(std::string_view text, std::string_view compression, std::size_t count);

}  // namespace lgs::tiled
