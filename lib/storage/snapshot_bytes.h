// The letters of a snapshot: numbers of varying length, runs of them, and the checksum. docs/internals/snapshot.md says
// the same in words. Nothing here depends on the byte order of the machine.
#pragma once

#include <lgs/snapshot.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lgs::detail {

using Magic = std::array<std::uint8_t, 7>;
inline constexpr Magic kSnapshotMagic{'l', 'g', 's', 's', 'n', 'a', 'p'};
inline constexpr Magic kChunkMagic{'l', 'g', 's', 'c', 'h', 'n', 'k'};
inline constexpr std::uint8_t kSnapshotVersion = 1;          ///< of a world whose chunks have the numbers from 1 on
inline constexpr std::uint8_t kSnapshotWithFreeNumbers = 2;  ///< some of them are free, and are listed
inline constexpr std::uint8_t kChunkVersion = 1;

/// CRC-32 as in Ethernet and zlib (IEEE 802.3, section 3.2.9): reflected, polynomial 0xedb88320.
class Checksum {
 public:
  void add(std::byte byte) { state_ = state_ >> 8 ^ kTable[(state_ ^ std::to_integer<std::uint32_t>(byte)) & 0xffu]; }
  std::uint32_t value() const { return ~state_; }

 private:
  static constexpr std::array<std::uint32_t, 256> kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t k = 0; k < 256; ++k) {
      std::uint32_t rest = k;
      for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ ((rest & 1u) != 0 ? 0xedb8'8320u : 0u);
      table[k] = rest;
    }
    return table;
  }();
  std::uint32_t state_ = 0xffff'ffff;
};

/// Signed numbers near zero as small unsigned ones: 0, -1, 1, -2, 2, …
constexpr std::uint64_t folded(std::int64_t v) {
  return v < 0 ? ~(static_cast<std::uint64_t>(v) << 1) : static_cast<std::uint64_t>(v) << 1;
}
constexpr std::int64_t unfolded(std::uint64_t v) {
  const auto half = static_cast<std::int64_t>(v >> 1);
  return (v & 1u) != 0 ? ~half : half;
}

class SnapshotWriter {
 public:
  explicit SnapshotWriter(const ByteSink& sink) : sink_(sink) {}

  void byte(std::uint8_t value) {
    buffer_.push_back(std::byte{value});
    checksum_.add(buffer_.back());
    if (buffer_.size() == kBuffer) flush();
  }
  /// Seven bits a byte, the lowest first; the eighth says that more follow.
  void number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) byte(static_cast<std::uint8_t>(value | 0x80u));
    byte(static_cast<std::uint8_t>(value));
  }
  /// Numbers whose count the reader knows. Each run begins with a number 2n + s: where s is 1 one number follows, which
  /// occurs n times; where it is 0, n numbers follow.
  void runs(std::span<const std::uint64_t> values) {
    std::size_t literal = 0;  // where the numbers begin that stand for themselves
    for (std::size_t k = 0; k < values.size();) {
      const auto different = std::find_if(values.begin() + static_cast<std::ptrdiff_t>(k), values.end(),
                                          [&](std::uint64_t v) { return v != values[k]; });
      const auto end = static_cast<std::size_t>(different - values.begin());
      if (end - k >= kShortestRun) {
        literals(values.subspan(literal, k - literal));
        number((end - k) << 1 | 1u);
        number(values[k]);
        literal = end;
      }
      k = end;
    }
    literals(values.subspan(literal));
  }
  void end() {
    const std::uint32_t sum = checksum_.value();
    for (unsigned k = 0; k < 4; ++k) byte(static_cast<std::uint8_t>(sum >> 8 * k));
    flush();
  }

 private:
  static constexpr std::size_t kBuffer = 4096;
  static constexpr std::size_t kShortestRun = 4;  ///< shorter ones save nothing

  void literals(std::span<const std::uint64_t> values) {
    if (values.empty()) return;
    number(values.size() << 1);
    for (const std::uint64_t value : values) number(value);
  }
  void flush() {
    if (!buffer_.empty() && sink_) sink_(buffer_);
    buffer_.clear();
  }

  const ByteSink& sink_;
  std::vector<std::byte> buffer_;
  Checksum checksum_;
};

/// Reads what SnapshotWriter wrote. After the first error every number is 0, so a loop over a count ends.
class SnapshotReader {
 public:
  explicit SnapshotReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::uint64_t offset() const { return at_; }
  std::uint64_t left() const { return bytes_.size() - at_; }
  bool failed() const { return failed_; }
  SnapshotError error() const { return error_; }
  void fail(SnapshotError::What what) {
    if (!failed_) error_ = {what, at_};
    failed_ = true;
  }

  std::uint8_t byte() {
    if (failed_) return 0;
    if (at_ == bytes_.size()) {
      fail(SnapshotError::What::cut);
      return 0;
    }
    return std::to_integer<std::uint8_t>(bytes_[at_++]);
  }
  /// At most `most`.
  std::uint64_t number(std::uint64_t most) {
    std::uint64_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
      const std::uint64_t piece = byte();
      if (shift > 56 || (piece & 0x7fu) > most >> shift) {
        fail(SnapshotError::What::badNumber);
        return 0;
      }
      value |= (piece & 0x7fu) << shift;
      if ((piece & 0x80u) == 0) break;
    }
    if (value > most) fail(SnapshotError::What::badNumber);
    return failed_ ? 0 : value;
  }
  /// A count of things that take a byte each at least. No count is believed that the bytes left can not hold.
  std::size_t count(std::uint64_t most) {
    return static_cast<std::size_t>(number(std::min<std::uint64_t>(most, left())));
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  SnapshotError error_;
  bool failed_ = false;
};

/// Hands out the numbers of a sequence of runs one by one.
class RunReader {
 public:
  RunReader(SnapshotReader& in, std::uint64_t most) : in_(in), most_(most) {}

  std::uint64_t next() {
    if (left_ == 0) {
      const std::uint64_t head = in_.number(std::uint64_t{1} << 33);
      left_ = head >> 1;
      repeats_ = (head & 1u) != 0;
      if (left_ == 0) in_.fail(SnapshotError::What::badNumber);
      if (repeats_) value_ = in_.number(most_);
    }
    if (in_.failed()) return 0;
    --left_;
    return repeats_ ? value_ : in_.number(most_);
  }
  /// After the last number of the sequence: no run goes on.
  void end() {
    if (left_ != 0) in_.fail(SnapshotError::What::badNumber);
  }

 private:
  SnapshotReader& in_;
  std::uint64_t most_;
  std::uint64_t left_ = 0;
  std::uint64_t value_ = 0;
  bool repeats_ = false;
};

}  // namespace lgs::detail
