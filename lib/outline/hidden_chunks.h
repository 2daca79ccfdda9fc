// The chunks whose segments are hidden, since they are unloaded: these segments are there to be linked to. During an
// update it is known, too, which were hidden before it.
#pragma once

#include "storage/held_bytes.h"
#include "storage/owned.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lgs::detail {

class HiddenChunks {
 public:
  bool any() const { return count_ != 0; }
  /// By their numbers, which need not be in use.
  bool are(std::uint32_t chunk) const { return has(chunk, kNow); }
  bool were(std::uint32_t chunk) const { return has(chunk, kBefore); }

  /// The update under way finds a chunk that was loaded or unloaded since the one before.
  void stream(std::uint32_t chunk) {
    toggle(chunk);
    bits_[chunk] ^= kBefore;
    streamed_.push_back(chunk);
  }
  /// From now on were() says what are() says.
  void endUpdate() {
    for (const std::uint32_t chunk : streamed_) bits_[chunk] ^= kBefore;
    streamed_.clear();
  }
  /// Without an update.
  void toggle(std::uint32_t chunk) {
    if (bits_.size() <= chunk) bits_.resize(std::size_t{chunk} + 1);
    bits_[chunk] ^= kNow | kBefore;
    are(chunk) ? ++count_ : --count_;
  }
  /// The number may name another chunk from now on.
  void forget(std::uint32_t chunk) {
    if (are(chunk)) toggle(chunk);
    while (!bits_.empty() && bits_.back() == 0) bits_.pop_back();
    giveBackSpare(bits_);
  }

  std::uint64_t bytes() const { return heldBytes(bits_, streamed_); }

 private:
  static constexpr std::uint8_t kNow = 1, kBefore = 2;
  bool has(std::uint32_t chunk, std::uint8_t bit) const { return chunk < bits_.size() && (bits_[chunk] & bit) != 0; }

  std::vector<std::uint8_t> bits_;  ///< by number of a chunk
  std::size_t count_ = 0;           ///< of those that are hidden now
  std::vector<std::uint32_t> streamed_;
};

}  // namespace lgs::detail
