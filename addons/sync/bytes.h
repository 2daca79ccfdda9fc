// Messages as bytes: whole numbers in groups of 7 bits, the lowest first, and signed ones zigzag before that. A reader
// believes nothing: what is cut or too long gives zeros, and `isGood()` is false from then on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace in_step {

using Bytes = std::vector<std::byte>;

inline void put(Bytes& out, std::uint64_t number) {
  for (; number >= 128; number >>= 7) out.push_back(static_cast<std::byte>(number | 128));
  out.push_back(static_cast<std::byte>(number));
}
inline void putSigned(Bytes& out, std::int64_t number) {
  put(out, static_cast<std::uint64_t>(number) << 1 ^ static_cast<std::uint64_t>(number >> 63));
}
/// A hash: all of its 64 bits.
inline void putHash(Bytes& out, std::uint64_t hash) {
  for (int shift = 0; shift < 64; shift += 8) out.push_back(static_cast<std::byte>(hash >> shift));
}

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

  std::uint64_t number() {
    std::uint64_t result = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const std::uint8_t group = byte();
      result |= std::uint64_t{group & 127U} << shift;
      if (group < 128) return result;
    }
    fail();
    return 0;
  }
  /// At most `most`.
  std::uint64_t number(std::uint64_t most) {
    const std::uint64_t result = number();
    if (result <= most) return result;
    fail();
    return 0;
  }
  std::int64_t signedNumber() {
    const std::uint64_t number = this->number();
    return static_cast<std::int64_t>(number >> 1 ^ (0 - (number & 1)));
  }
  /// From -most to most.
  std::int32_t signedNumber(std::int32_t most) {
    const std::int64_t result = signedNumber();
    if (result >= -most && result <= most) return static_cast<std::int32_t>(result);
    fail();
    return 0;
  }
  std::uint64_t hash() {
    std::uint64_t result = 0;
    for (int shift = 0; shift < 64; shift += 8) result |= std::uint64_t{byte()} << shift;
    return result;
  }

  bool isGood() const { return isGood_; }
  bool isAtEnd() const { return rest_.empty(); }
  std::size_t left() const { return rest_.size(); }
  void fail() {
    isGood_ = false;
    rest_ = {};
  }

 private:
  std::uint8_t byte() {
    if (rest_.empty()) return fail(), std::uint8_t{0};
    const auto first = std::to_integer<std::uint8_t>(rest_.front());
    rest_ = rest_.subspan(1);
    return first;
  }

  std::span<const std::byte> rest_;
  bool isGood_ = true;
};

}  // namespace in_step
