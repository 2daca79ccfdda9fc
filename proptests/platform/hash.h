// One number for all that a part of the program saw. It is 64-bit FNV-1a over bytes in a fixed order, so that it is the
// same on machines of either byte order.
#pragma once

#include "oracle/calls/caller.h"

#include <lgs/error.h>
#include <lgs/segment.h>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <string_view>

namespace platform {

namespace oracle = lgs::oracle;

class Hash {
 public:
  /// If `isVerbose`, every step prints the hash so far: two outputs differ from the first step on that went wrong.
  explicit Hash(const char* part, bool isVerbose) : part_(part), isVerbose_(isVerbose) {}

  void byte(std::uint8_t value) { state_ = (state_ ^ value) * 0x0000'0100'0000'01b3; }
  void number(std::uint64_t value) {
    for (int shift = 0; shift < 64; shift += 8) byte(static_cast<std::uint8_t>(value >> shift));
  }
  void sign(std::int64_t value) { number(static_cast<std::uint64_t>(value)); }
  /// All bits of it. What is no number, and either zero, may have several.
  void real(double value) { number(value == 0 ? 0 : std::bit_cast<std::uint64_t>(value)); }
  void text(std::string_view value) {
    for (const char c : value) byte(static_cast<std::uint8_t>(c));
    number(value.size());
  }

  void step() {
    if (isVerbose_) std::printf("%s %u %s\n", part_, ++steps_, text().data);
  }

  struct Text {
    char data[17];
  };
  Text text() const {
    Text text{};
    std::snprintf(text.data, sizeof text.data, "%08x%08x", static_cast<unsigned>(state_ >> 32),
                  static_cast<unsigned>(state_ & 0xffff'ffff));
    return text;
  }
  std::uint64_t value() const { return state_; }

 private:
  const char* part_;
  bool isVerbose_;
  unsigned steps_ = 0;
  std::uint64_t state_ = 0xcbf2'9ce4'8422'2325;
};

// What the engine gives out, field by field.

inline void put(Hash& hash, lgs::Cell cell) {
  hash.sign(cell.i);
  hash.sign(cell.j);
}
inline void put(Hash& hash, lgs::Point point) {
  hash.sign(point.x);
  hash.sign(point.y);
}
inline void put(Hash& hash, lgs::DoublePoint point) {
  hash.real(point.x);
  hash.real(point.y);
}
inline void put(Hash& hash, lgs::PolygonHandle handle) { hash.number(handle.packed()); }
inline void put(Hash& hash, lgs::SegmentId id) { hash.number(id.value); }
inline void put(Hash& hash, lgs::ShapeId id) { hash.number(id.value); }

void put(Hash& hash, const lgs::Error& error);
void put(Hash& hash, const lgs::Segment& segment);
void put(Hash& hash, const oracle::ChangeLists& changes);
void put(Hash& hash, const oracle::Outcome& outcome);

template <class Value>
void putAll(Hash& hash, const Value& values) {
  hash.number(values.size());
  for (const auto& value : values) put(hash, value);
}

/// Whether it was refused, and what came of it. Nothing has to be given out.
template <class Value>
bool putResult(Hash& hash, const lgs::Expected<Value>& result) {
  hash.byte(result ? 1 : 0);
  if (!result) put(hash, result.error());
  return result.has_value();
}

}  // namespace platform
