#include "fuzz/archive.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

namespace lgs::fuzz {
namespace {

constexpr std::size_t kBlock = 512;
constexpr std::size_t kSizeAt = 124;
constexpr std::size_t kSumAt = 148;
constexpr std::size_t kTypeAt = 156;

std::optional<std::uint64_t> octal(std::string_view digits) {
  digits = digits.substr(0, digits.find_first_of(std::string_view("\0 ", 2)));
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 8);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

// The sum of all bytes; those of the sum itself count as blanks.
std::uint64_t sumOf(std::string_view header) {
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < kBlock; ++k) {
    sum += k >= kSumAt && k < kSumAt + 8 ? std::uint64_t{' '} : static_cast<std::uint8_t>(header[k]);
  }
  return sum;
}

}  // namespace

tl::expected<std::vector<std::string>, std::string> filesOf(std::string_view archive) {
  std::vector<std::string> files;
  while (archive.size() >= kBlock) {
    const std::string_view header = archive.substr(0, kBlock);
    if (header.find_first_not_of('\0') == header.npos) return files;  // the end is two empty blocks
    const auto size = octal(header.substr(kSizeAt, 12));
    if (octal(header.substr(kSumAt, 8)) != sumOf(header) || !size)
      return tl::unexpected(std::string("this is no tar archive"));
    archive.remove_prefix(kBlock);
    if (*size > archive.size()) break;
    if (header[kTypeAt] == '0') files.emplace_back(archive.substr(0, *size));
    archive.remove_prefix(std::min<std::size_t>((*size + kBlock - 1) / kBlock * kBlock, archive.size()));
  }
  return tl::unexpected(std::string("the archive is cut off"));
}

}  // namespace lgs::fuzz
