// Numbers for moments of a world: versions of its segments, and marks. No two worlds of a process give the same one.
#pragma once

#include <atomic>
#include <cstdint>

namespace lgs::detail {

class Versions {
 public:
  Versions() = default;
  Versions(const Versions& /*other*/) {}  // a copy of a world goes its own way
  Versions& operator=(const Versions&) = delete;
  ~Versions() = default;

  /// Greater than all that this world, and those that it is a copy of, had before.
  std::uint64_t next() {
    if (left_ == 0) {
      static std::atomic<std::uint64_t> blocks = 0;
      last_ = blocks++ * kBlock;
      left_ = kBlock;
    }
    --left_;
    return ++last_;
  }

 private:
  /// A world takes numbers by blocks, from 1 on. So 0 is the version of a world that never had segments.
  static constexpr std::uint64_t kBlock = 1 << 20;

  std::uint64_t last_ = 0;
  std::uint64_t left_ = 0;  ///< numbers of the block that are not given out
};

}  // namespace lgs::detail
