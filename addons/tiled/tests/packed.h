// Tile numbers packed as Tiled packs them, to write layers in the tests.
#pragma once

#include "maps.h"

#include <gtest/gtest.h>
#include <zlib.h>
#include <zstd.h>
#include <cstdint>
#include <string>
#include <vector>

namespace lgs::tiled {

/// Tile numbers as TMX packs them: four bytes each, the lowest first.
inline std::string rawTiles(const std::vector<std::uint32_t>& gids) {
  std::string bytes;
  for (std::uint32_t gid : gids) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(gid >> shift & 0xFF));
  }
  return bytes;
}

inline std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// `windowBits` is 15 for zlib, 15 + 16 for gzip.
inline std::string deflated(const std::string& bytes, int windowBits) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()) + 32, '\0');
  std::string in = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

inline std::string zstdPacked(const std::string& bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 3));
  return packed;
}

/// A tileset of one full tile and a layer of 3×2 tiles.
inline std::string dataLayer(const std::string& data) {
  return tilesetXml({kFullTile}) + "<layer name='L' width='3' height='2'>" + data + "</layer>";
}

}  // namespace lgs::tiled
