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

  std::uint64_t next() { return ++last_; }

 private:
  /// Worlds are numbered in the upper half, from 1. So 0 is the version of a world that never had segments.
  static std::uint64_t first() {
    static std::atomic<std::uint32_t> worlds = 0;
    return std::uint64_t{++worlds} << 32;
  }

  std::uint64_t last_ = first();
};

}  // namespace lgs::detail
