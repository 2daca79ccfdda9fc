// The bridge between JavaScript and the engine. JavaScript calls functions that take and return numbers. What is longer
// goes through memory: arguments through an input buffer, answers through an answer buffer, both shared by all worlds;
// lists of segments through buffers of their world. JavaScript checks that its arguments are numbers of the right kind;
// the engine checks everything else.
//
// Every number fits a double. A polygon's handle takes 53 bits: the build defines LGS_HANDLES_IN_53_BITS (lgs/world.h).
//
// A function that can be refused returns 0, or -1 where 0 is an answer; failure() then says why.
#pragma once

#include <lgs/brush.h>
#include <lgs/world.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A function that JavaScript calls by this name. Floating-point numbers are for what does not fit 32 bits.
#define LGS_EXPORT(name) __attribute__((export_name(name)))

namespace lgs::web {

/// Lists of segments, as arrays: what a commit or a question gives out.
struct Lists {
  std::vector<SegmentId> ids;  ///< removed, then added, then relinked
  std::vector<double> geometry;
  std::vector<float> geometryFloat;
  std::vector<Block> blocks;
  std::vector<Cell> cells;
  std::vector<double> owners;
  std::vector<SegmentId> predecessors;
  std::vector<SegmentId> successors;

  /// What JavaScript reads first. Addresses and lengths; the arrays begin with `added`.
  struct Header {
    std::uint64_t before, after;
    std::uint32_t removed, added, relinked;
    const void *ids, *geometry, *blocks, *cells, *owners, *predecessors, *successors;
  } header{};
};
// web/package/src/lists.ts reads it by words of 32 bits.
static_assert(offsetof(Lists::Header, removed) == 4 * 4 && offsetof(Lists::Header, ids) == 4 * 7 &&
              offsetof(Lists::Header, successors) == 4 * 13);

/// A world, and the lists that it last handed out.
struct Bridge {
  World world;
  bool isFloat = false;                     ///< geometry is handed out as float
  Lists changes = {};                       ///< of the last commit or roll-back
  Lists segments = {};                      ///< of the last question for segments
  std::vector<DoubleSegment> doubles = {};  ///< working memory of the lists
  std::vector<FloatSegment> floats = {};
};

constexpr int kSerialBits = 23;

/// A handle as a whole number below 2^53, and back. A number that no handle gave makes a null handle, or a stale one.
inline double toNumber(PolygonHandle h) {
  return static_cast<double>(std::uint64_t{h.cellRef} << kSerialBits | h.serial);
}
inline PolygonHandle toHandle(double v) {
  if (!(v >= 0 && v < 0x1p53)) return {};
  const auto bits = static_cast<std::uint64_t>(v);
  if (static_cast<double>(bits) != v) return {};
  return {static_cast<std::uint32_t>(bits >> kSerialBits),
          static_cast<std::uint32_t>(bits & ((1u << kSerialBits) - 1))};
}

inline double cellsOf(std::int64_t units) { return static_cast<double>(units) / kUnitsPerCell; }

/// The arguments of the call: JavaScript wrote them into the input buffer.
template <class T>
std::span<const T> input(std::size_t count);

/// The answer of the call: numbers that JavaScript reads next.
std::vector<double>& answer();

/// The same for bytes.
std::vector<std::byte>& answerBytes();

/// Keeps why a call was refused.
void keepFailure(const Error& error);
void keepFailure(const SnapshotError& error);

/// The same, and returns `result`.
template <class Result>
Result refused(const Error& error, Result result) {
  keepFailure(error);
  return result;
}

/// The relation that JavaScript knows by this number; none for 0.
PreserveRelation relation(std::uint32_t number);

template <>
std::span<const double> input<double>(std::size_t count);
template <>
std::span<const std::int32_t> input<std::int32_t>(std::size_t count);
template <>
std::span<const std::byte> input<std::byte>(std::size_t count);

/// Vertices in cells: pairs of the numbers in the input buffer.
std::span<const DoublePoint> inputPoints(std::size_t count);

}  // namespace lgs::web
