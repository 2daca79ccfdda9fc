#include "layers.h"

#define ZLIB_CONST  // zlib then takes its input as const
#include <zlib.h>
#include <zstd.h>
#include <algorithm>
#include <charconv>

namespace lgs::tiled {
namespace {

using Bytes = std::vector<unsigned char>;

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

std::string wrongCount(std::size_t found, std::size_t count) {
  return concat("holds ", found, " tiles where its size asks for ", count);
}

std::string tooMany(std::size_t count) { return concat("holds more than the ", count, " tiles of its size"); }

tl::expected<Bytes, std::string> base64Bytes(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text.substr(0, text.find_last_not_of("= \t\r\n") + 1)) {
    if (isBlank(c)) continue;
    const std::size_t value = kDigits.find(c);
    if (value == std::string_view::npos) return tl::unexpected<std::string>("is not valid base64");
    bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xFFFFFF;
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<unsigned char>(bits >> held));
  }
  return bytes;
}

/// zlib and gzip streams, told apart by zlib itself.
tl::expected<Bytes, std::string> inflated(const Bytes& packed, std::size_t size) {
  constexpr std::size_t kBestRatio = 1'032;  // of deflate. A stream that is too short for `size` gets no memory
  if (size / kBestRatio > packed.size()) return tl::unexpected<std::string>("is too short for its size");
  Bytes bytes(size + 1);  // a stream that fills the extra byte is too long
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK) return tl::unexpected<std::string>("cannot be decompressed: no memory");
  stream.next_in = packed.data();
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = bytes.data();
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int status = inflate(&stream, Z_FINISH);
  const std::size_t made = bytes.size() - stream.avail_out;
  inflateEnd(&stream);
  if (status != Z_STREAM_END && made <= size) return tl::unexpected<std::string>("cannot be decompressed: damaged");
  bytes.resize(made);
  return bytes;
}

tl::expected<Bytes, std::string> unzstd(const Bytes& packed, std::size_t size) {
  const auto announced = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (announced == ZSTD_CONTENTSIZE_ERROR) return tl::unexpected<std::string>("is not zstd data");
  if (announced != ZSTD_CONTENTSIZE_UNKNOWN && announced != size) {
    return tl::unexpected(wrongCount(static_cast<std::size_t>(announced / 4), size / 4));
  }
  constexpr std::size_t kBestRatio = 1 << 15;  // a block of 4 bytes may stand for 128 KiB
  if (size / kBestRatio > packed.size()) return tl::unexpected<std::string>("is too short for its size");
  Bytes bytes(size + 1);
  const std::size_t made = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (ZSTD_isError(made)) return tl::unexpected(concat("cannot be decompressed: ", ZSTD_getErrorName(made)));
  bytes.resize(made);
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
    if (status != std::errc{}) return tl::unexpected(concat("tile ", gids.size() + 1, " is not a tile number"));
    if (gids.size() == count) return tl::unexpected(tooMany(count));
    gids.push_back(gid);
    at = next;
    skipBlanks();
    if (at == end) break;
    if (*at++ != ',') return tl::unexpected(concat("has no comma after tile ", gids.size()));
  }
  if (gids.size() != count) return tl::unexpected(wrongCount(gids.size(), count));
  return gids;
}

tl::expected<Gids, std::string> decodeBase64(std::string_view text, std::string_view compression, std::size_t count) {
  auto bytes = base64Bytes(text);
  if (!bytes) return tl::unexpected(bytes.error());
  if (compression == "zlib" || compression == "gzip") {
    bytes = inflated(*bytes, count * 4);
  } else if (compression == "zstd") {
    bytes = unzstd(*bytes, count * 4);
  }
  if (!bytes) return tl::unexpected(bytes.error());
  if (bytes->size() > count * 4) return tl::unexpected(tooMany(count));
  if (bytes->size() < count * 4) return tl::unexpected(wrongCount(bytes->size() / 4, count));
  Gids gids(count);
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned char* b = bytes->data() + 4 * i;
    gids[i] = std::uint32_t{b[0]} | std::uint32_t{b[1]} << 8 | std::uint32_t{b[2]} << 16 | std::uint32_t{b[3]} << 24;
  }
  return gids;
}

}  // namespace lgs::tiled
