// The kinds of arguments, by their types, and of each the values that a stranger would try: none, one, the least, the
// greatest, one beyond each limit that the documents name, every number that means something inside; what is no number;
// lists that are empty, huge, or have the same twice. The first value is plain.
#pragma once

#include "scene.h"

#include <lgs/brush.h>
#include <lgs/debug.h>
#include <lgs/radial_match.h>

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace lgs::test {

// Numbers that the lists share: the ends of 32 bits, and the end of the world.
inline constexpr std::int32_t kLeast = INT32_MIN;
inline constexpr std::int32_t kMost = INT32_MAX;
inline constexpr std::int64_t kFar = kMaxCoordinate;

/// How much room there is for what a call writes.
struct Room {
  std::size_t size = 0;
};

/// A pointer that may be NULL.
struct Given {
  bool isGiven = true;
  explicit operator bool() const { return isGiven; }
  template <class T>
  T* operator()(T& value) const {
    return isGiven ? &value : nullptr;
  }
  /// Where the elements of a list are, or NULL; and whether that is as many as is said.
  auto of(auto& list) const { return isGiven ? list.data() : nullptr; }
  bool hasAll(const auto& list) const { return isGiven || list.empty(); }
};

/// Where a call writes a T, or NULL. What is there comes last, so that the sanitizers see who writes beyond it.
template <class T>
struct Out {
  bool isGiven = true;
  T there{};
  operator T*() { return isGiven ? &there : nullptr; }
};

/// An array that a call fills, or NULL with a size all the same.
template <class T>
struct Space {
  std::vector<T> items;
  bool isGiven = true;
  T* data() { return isGiven ? items.data() : nullptr; }
  const T* data() const { return isGiven ? items.data() : nullptr; }
  std::size_t size() const { return items.size(); }
  /// Whether there is as much room as is said.
  bool isThere() const { return isGiven || items.empty(); }
};

/// How long an array is said to be. It has so many elements, and more.
struct Said {
  std::size_t count = 0;
};

using Points = std::vector<LocalPoint>;
template <class Real>
using Reals = std::vector<RealPoint<Real>>;

/// What is tried as an argument of this type. There is a list for each, so that a door with an argument of another type
/// does not compile until there is one for it.
template <class T>
struct Hostile;

#define LGS_HOSTILE(Type)                                 \
  template <>                                             \
  struct Hostile<Type> {                                  \
    static const std::vector<Type>& values(Scene& scene); \
    static std::string told(const Type& value);           \
  }

LGS_HOSTILE(bool);
LGS_HOSTILE(int);
LGS_HOSTILE(std::uint32_t);
LGS_HOSTILE(std::int64_t);
LGS_HOSTILE(std::uint64_t);
LGS_HOSTILE(double);
LGS_HOSTILE(Cell);
LGS_HOSTILE(CellRect);
LGS_HOSTILE(Point);
LGS_HOSTILE(LocalPoint);
LGS_HOSTILE(DoublePoint);
LGS_HOSTILE(ShapeId);
LGS_HOSTILE(PolygonHandle);
LGS_HOSTILE(SegmentId);
LGS_HOSTILE(Mark);
LGS_HOSTILE(lgs_mark);
LGS_HOSTILE(Room);
LGS_HOSTILE(Given);
LGS_HOSTILE(Said);
LGS_HOSTILE(Points);
LGS_HOSTILE(Reals<float>);
LGS_HOSTILE(Reals<double>);
LGS_HOSTILE(std::vector<Points>);
LGS_HOSTILE(std::vector<Reals<double>>);
LGS_HOSTILE(std::vector<Point>);
LGS_HOSTILE(std::vector<PolygonHandle>);
LGS_HOSTILE(std::vector<SegmentId>);
LGS_HOSTILE(std::vector<Placement>);
LGS_HOSTILE(std::vector<DirectedEdge>);
LGS_HOSTILE(std::vector<EdgeLinks>);
LGS_HOSTILE(std::vector<std::byte>);
LGS_HOSTILE(Segment);
LGS_HOSTILE(Error);
LGS_HOSTILE(SnapshotError);
LGS_HOSTILE(ErrorCode);
LGS_HOSTILE(Collinear);
LGS_HOSTILE(FillRule);
LGS_HOSTILE(PaintMode);
LGS_HOSTILE(Region);
LGS_HOSTILE(PreserveRelation);
LGS_HOSTILE(Executor);
LGS_HOSTILE(ByteSink);
LGS_HOSTILE(World::PolygonVisitor);
LGS_HOSTILE(lgs_error);
LGS_HOSTILE(Undone);
LGS_HOSTILE(StayingBlocks);
LGS_HOSTILE(SvgOverlay);
#undef LGS_HOSTILE

/// The list of a type that the doors of one library alone have, and a value of it in words.
#define LGS_VALUES(Type, words, ...)                           \
  template <>                                                  \
  struct Hostile<Type> {                                       \
    static const std::vector<Type>& values(Scene&) {           \
      static const std::vector<Type> all{__VA_ARGS__};         \
      return all;                                              \
    }                                                          \
    static std::string told(const Type& v) { return (words); } \
  };

template <class T>
struct Hostile<Out<T>> {
  static const std::vector<Out<T>>& values(Scene&) {
    static const std::vector<Out<T>> kBoth{{true}, {false}};
    return kBoth;
  }
  static std::string told(const Out<T>& out) { return out.isGiven ? "a pointer" : "NULL"; }
};

template <class T>
struct Hostile<Space<T>> {
  static const std::vector<Space<T>>& values(Scene& scene) {
    static const std::vector<Space<T>> kAll = [&] {
      std::vector<Space<T>> all;
      for (const Room room : Hostile<Room>::values(scene)) all.push_back({std::vector<T>(room.size), true});
      all.push_back({std::vector<T>(9), false});
      all.push_back({{}, false});
      return all;
    }();
    return kAll;
  }
  static std::string told(const Space<T>& space) {
    return fmt::format("room {}{}", space.size(), space.isGiven ? "" : " at NULL");
  }
};

}  // namespace lgs::test
