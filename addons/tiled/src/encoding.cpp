#include "layers.h"

#define ZLIB_CONST  // zlib then takes its input as const
#include <zlib.h>
#include <zstd.h>
#include <zstd_errors.h>
#include <algorithm>
#include <charconv>

namespace lgs::tiled {
namespace {

using Bytes = std::vector<unsigned char>;
using Error = tl::unexpected<std::string>;

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

Error wrongCount(std::size_t found, std::size_t count) {
  return Error(found > count ? concat("holds more than the ", count, " tiles of its size")
                             : concat("holds ", found, " tiles where its size asks for ", count));
}

tl::expected<Bytes, std::string> base64Bytes(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text.substr(0, text.find_last_not_of("= \t\r\n") + 1)) {
    if (isBlank(c)) continue;
    const std::size_t value = kDigits.find(c);
    if (value == std::string_view::npos) return Error("is not valid base64");
    bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xFFFFFF;
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<unsigned char>(bits >> held));
  }
  return bytes;
}

/// Unpacks zlib and gzip streams, told apart by zlib itself, or those of zstd. It takes memory for `size` bytes and one
/// more, which only a stream that is too long fills; and none for a stream that is too short for its size.
tl::expected<Bytes, std::string> unpacked(const Bytes& packed, bool isZstd, std::size_t size) {
  const std::size_t bestRatio = isZstd ? 1 << 15 : 1'032;  // a block of zstd of 4 bytes may stand for 128 KiB
  if (size / bestRatio > packed.size()) return Error("is too short for its size");
  Bytes bytes(size + 1);
  if (isZstd) {
    const std::size_t made = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
    if (ZSTD_getErrorCode(made) == ZSTD_error_dstSize_tooSmall) return bytes;
    if (ZSTD_isError(made)) return Error(concat("cannot be decompressed: ", ZSTD_getErrorName(made)));
    bytes.resize(made);
    return bytes;
  }
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK) return Error("cannot be decompressed: no memory");
  stream.next_in = packed.data();
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = bytes.data();
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int status = inflate(&stream, Z_FINISH);
  bytes.resize(bytes.size() - stream.avail_out);
  inflateEnd(&stream);
  if (status != Z_STREAM_END && bytes.size() <= size) return Error("cannot be decompressed: damaged");
  return bytes;
}

}  // namespace

tl::expected<Gids, std::string> decodeCsv(std::string_view text, std::size_t count) {
  Gids gids;
  gids.reserve(std::min(count, text.size() / 2 + 1));
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto skipBlanks = [&] {
    while (at != end && isBlank(*at)) ++at;
  };
  for (skipBlanks(); at != end; skipBlanks()) {
    std::uint32_t gid = 0;
    const auto [next, status] = std::from_chars(at, end, gid);
    if (status != std::errc{}) return Error(concat("tile ", gids.size() + 1, " is not a tile number"));
    if (gids.size() == count) return wrongCount(count + 1, count);
    gids.push_back(gid);
    at = next;
    skipBlanks();
    if (at == end) break;
    if (*at++ != ',') return Error(concat("has no comma after tile ", gids.size()));
  }
  if (gids.size() != count) return wrongCount(gids.size(), count);
  return gids;
}

tl::expected<Gids, std::string> decodeBase64(std::string_view text, std::string_view compression, std::size_t count) {
  auto bytes = base64Bytes(text);
  if (!bytes) return Error(bytes.error());
  if (!compression.empty()) bytes = unpacked(*bytes, compression == "zstd", count * 4);
  if (!bytes) return Error(bytes.error());
  const bool isTooLong = bytes->size() > count * 4;
  if (bytes->size() != count * 4) return wrongCount(isTooLong ? count + 1 : bytes->size() / 4, count);
  Gids gids(count);
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned char* b = bytes->data() + 4 * i;
    gids[i] = std::uint32_t{b[0]} | std::uint32_t{b[1]} << 8 | std::uint32_t{b[2]} << 16 | std::uint32_t{b[3]} << 24;
  }
  return gids;
}

}  // namespace lgs::tiled
