// The bridge between JavaScript and the engine. JavaScript calls functions that take and return numbers. What is longer
// goes through memory: arguments through an input buffer, answers through an answer buffer, both shared by all worlds;
// lists of segments through blocks of their world. JavaScript checks that its arguments are numbers of the right kind;
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
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A function that JavaScript calls by this name. Floating-point numbers are for what does not fit 32 bits.
#define LGS_EXPORT(name) __attribute__((export_name(name)))

namespace lgs::web {

/// Arrays one after the other in one block of memory. JavaScript copies the block as a whole, and looks at what it
/// needs.
class Block64 {
 public:
  /// Room for so many bytes; what is in it is whatever was there before.
  void open(std::size_t bytes) {
    words_.resize((bytes + 7) / 8);
    next_ = reinterpret_cast<std::byte*>(words_.data());
  }
  /// The next array. Those of the larger types come first, so none needs a gap before it.
  template <class T>
  T* array(std::size_t count) {
    T* const here = reinterpret_cast<T*>(next_);
    next_ += count * sizeof(T);
    return here;
  }
  const std::uint64_t* data() const { return words_.data(); }

 private:
  std::vector<std::uint64_t> words_;
  std::byte* next_ = nullptr;
};

/// The head of a block with segments. web/package/src/lists.ts reads it.
struct SegmentHead {
  double before, after;  ///< World::version() before and after
  std::uint32_t removed, added, relinked, words;
};
static_assert(sizeof(SegmentHead) == 32);

struct Terrain;
struct DropTerrain {
  void operator()(Terrain* terrain) const;
};

inline const Changes kNoChanges;

/// Numbers of shapes: those of different worlds differ in their upper bits, so a shape of another world names nothing. A
/// world that was loaded takes any: the numbers are those of the world that was saved.
class ShapeNumbers {
 public:
  static ShapeNumbers ofNewWorld() {
    static std::uint32_t worlds = 0;
    return {worlds++ % kWorlds << kBits, ~0u};
  }
  static ShapeNumbers ofLoadedWorld() { return {0, (1u << kBits) - 1}; }
  std::uint32_t number(ShapeId shape) const { return shape.value ^ world_; }
  ShapeId shape(std::uint32_t number) const { return {(number ^ world_) & taken_}; }

 private:
  ShapeNumbers(std::uint32_t world, std::uint32_t taken) : world_(world), taken_(taken) {}

  static constexpr std::uint32_t kBits = 24, kWorlds = 128;  // a world has at most 2^23 shapes; addMany() takes 31 bits
  std::uint32_t world_, taken_;
};

/// A world, and what it last handed out.
struct Bridge {
  World world;
  ShapeNumbers shapes;
  bool isFloat = false;                   ///< geometry is handed out as float
  const Changes* last = &kNoChanges;      ///< of the last commit or roll-back
  std::uint64_t moment = 0;               ///< how many of them have changed anything
  bool isLastNews = false;                ///< whether the last one did, so that it leads here from the moment before
  bool isEdited = false;                  ///< whether edits wait for their commit
  std::vector<Mark> marksInEdits = {};    ///< those that were made while edits waited
  std::optional<Transaction> group = {};  ///< edits that are undone together if one of them is refused
  Block64 changes = {};                   ///< the same, as JavaScript reads it
  Block64 segments = {};                  ///< of the last question for segments
  BrushResult brushed = {};               ///< what the last brush did
  std::vector<SegmentId> ids = {};        ///< working memory of the lists
  std::vector<DoubleSegment> doubles = {};
  std::vector<FloatSegment> floats = {};
  std::vector<std::unique_ptr<Terrain, DropTerrain>> terrains = {};
};

/// A view of a world: which moment of it it shows.
struct Follower {
  std::uint64_t moment;  ///< Bridge::moment that it shows
  bool hasNews = false;  ///< whether what it tells is of the last update

  /// Takes over what the last commit or roll-back did, by `update`, which may find that it can not. 0: done. 1: a
  /// commit was left out. 2: there are edits that are not committed.
  template <class Update>
  std::int32_t follow(const Bridge& bridge, const Update& update) {
    if (bridge.isEdited) return 2;
    const bool wasOther = moment != bridge.moment;
    if (wasOther && (moment + 1 != bridge.moment || !bridge.isLastNews || !update())) return 1;
    moment = bridge.moment;
    hasNews = wasOther;
    return 0;
  }

  /// Whether it shows the last commit or roll-back: 0 if not, 1 if there was no edit since, 2 if there was.
  std::int32_t isOfNow(const Bridge& bridge) const { return moment != bridge.moment ? 0 : bridge.isEdited ? 2 : 1; }
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

/// A mark from its number. Those of marks and versions are counted up from 1, so a double holds them.
inline Mark markOf(double v) { return Mark{v >= 0 && v < 0x1p53 ? static_cast<std::uint64_t>(v) : 0}; }

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
