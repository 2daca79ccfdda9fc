// Kinds of arguments that are lists, regions, files and functions.
#include "kinds.h"

#include <algorithm>
#include <limits>

namespace lgs::test {
namespace {

/// A saw with so many vertices, an even number; simple, in its cell.
Points saw(std::int32_t count) {
  Points points;
  for (std::int32_t k = 0; k < count / 2; ++k) points.push_back({4 * k, k % 2 == 0 ? 0 : 9});
  for (std::int32_t k = count / 2; k-- > 0;) points.push_back({4 * k + 1, k % 2 == 0 ? 20 : 29});
  return points;
}

const std::vector<Points>& polygonsToTry() {
  static const std::vector<Points> all{
      unitSquare(),
      ramp(),
      {},
      {{0, 0}},
      {{0, 0}, {U, 0}},
      {{0, 0}, {U, 0}, {U, 0}},
      {{0, 0}, {U / 2, 0}, {U, 0}},
      {{0, 0}, {0, U}, {U, U}},
      {{0, 0}, {U, U}, {U, 0}, {0, U}},
      {{0, 0}, {U, 0}, {U, U + 1}},
      {{-1, 0}, {U, 0}, {U, U}},
      {{kLeast, kLeast}, {kMost, kLeast}, {kMost, kMost}},
      {{kMost, 0}, {kLeast, 0}, {0, kLeast}},
      {{0, 0}, {1, 0}, {0, 1}},
      {{0, 0}, {U, 0}, {U, U}, {0, U}, {0, 0}},
      saw(200),
      saw(4'096),
      Points(4'097, LocalPoint{1, 1}),
      Points(100'000, LocalPoint{kMost, 1}),
  };
  return all;
}

template <class Real>
std::vector<Reals<Real>> realsToTry() {
  using Limits = std::numeric_limits<Real>;
  std::vector<Reals<Real>> all;
  for (const Points& points : polygonsToTry()) {
    all.emplace_back();
    for (const LocalPoint p : points)
      all.back().push_back({static_cast<Real>(p.x) / kUnitsPerCell, static_cast<Real>(p.y) / kUnitsPerCell});
  }
  for (const Real bad : {Limits::quiet_NaN(), Limits::signaling_NaN(), Limits::infinity(), -Limits::infinity(),
                         Limits::max(), Limits::lowest(), Limits::denorm_min(), -Limits::denorm_min(), Real{-0.0}})
    all.push_back({{0, 0}, {1, bad}, {1, 1}});
  return all;
}

template <class T>
std::string counted(const std::vector<T>& list, const char* what) {
  std::string text = fmt::format("{} {}", list.size(), what);
  if constexpr (requires(const T& v) { Hostile<T>::told(v); })
    for (std::size_t k = 0; k < std::min<std::size_t>(list.size(), 4); ++k)
      text += (k == 0 ? ": " : ", ") + Hostile<T>::told(list[k]);
  return text;
}

}  // namespace

const std::vector<Points>& Hostile<Points>::values(Scene&) { return polygonsToTry(); }
const std::vector<Reals<float>>& Hostile<Reals<float>>::values(Scene&) {
  static const auto all = realsToTry<float>();
  return all;
}
const std::vector<Reals<double>>& Hostile<Reals<double>>::values(Scene&) {
  static const auto all = realsToTry<double>();
  return all;
}

const std::vector<std::vector<Points>>& Hostile<std::vector<Points>>::values(Scene&) {
  static const std::vector<std::vector<Points>> all = [] {
    std::vector<std::vector<Points>> lists{shapeNamed("two halves"), {}, {unitSquare(), unitSquare()}};
    for (const Points& points : polygonsToTry()) lists.push_back({points});
    lists.push_back({ramp(), {}});
    lists.emplace_back(254, Points{{0, 0}, {1, 0}, {0, 1}});
    lists.emplace_back(255, Points{{0, 0}, {1, 0}, {0, 1}});
    lists.emplace_back(255, Points());
    return lists;
  }();
  return all;
}

const std::vector<std::vector<Reals<double>>>& Hostile<std::vector<Reals<double>>>::values(Scene&) {
  static const std::vector<std::vector<Reals<double>>> all = [] {
    std::vector<std::vector<Reals<double>>> lists{{{{0, 0}, {1, 0}, {1, 1}}}, {}, {{}, {}}};
    for (const Reals<double>& points : realsToTry<double>()) lists.push_back({points});
    return lists;
  }();
  return all;
}

const std::vector<std::vector<Point>>& Hostile<std::vector<Point>>::values(Scene&) {
  static const std::vector<std::vector<Point>> all{
      {{0, 0}, {99'999, 0}, {99'999, 77'777}},
      {},
      {{0, 0}},
      {{0, 0}, {0, 0}},
      {{kFar, kFar}, {kFar, 0}, {0, kFar}},
      {{kFar + 1, 0}, {0, 0}},
      {{-kFar, -kFar}, {kFar, kFar}},
      {{INT64_MIN, INT64_MAX}, {INT64_MAX, INT64_MIN}, {0, 0}},
      {{0, 0}, {kMaxRegionCells * kUnitsPerCell, 5}, {7, 7}},
      {{0, 0}, {kMaxRegionCells * kUnitsPerCell + 1, 5}, {7, 7}},
      {{-kFar, -kFar}, {-kFar + 1, -kFar}, {-kFar, -kFar + 1}},
      std::vector<Point>(5'000, Point{3, 3}),
  };
  return all;
}

const std::vector<std::vector<PolygonHandle>>& Hostile<std::vector<PolygonHandle>>::values(Scene& scene) {
  static std::vector<std::vector<PolygonHandle>> all;
  const PolygonHandle live = scene.polygons[0], other = scene.polygons[1];
  all = {{live}, {}, {live, other}, {live, live}, {other, live, PolygonHandle()}};
  for (std::size_t k = 2; k < scene.polygons.size(); ++k) all.push_back({live, scene.polygons[k]});
  all.push_back(scene.polygons);
  all.emplace_back(3'000, live);
  return all;
}

const std::vector<std::vector<SegmentId>>& Hostile<std::vector<SegmentId>>::values(Scene& scene) {
  static std::vector<std::vector<SegmentId>> all;
  const SegmentId live = scene.segments[0];
  all = {{live}, {}, {live, live}};
  for (std::size_t k = 1; k < scene.segments.size(); ++k) all.push_back({live, scene.segments[k]});
  all.emplace_back(3'000, live);
  return all;
}

const std::vector<std::vector<Placement>>& Hostile<std::vector<Placement>>::values(Scene& scene) {
  static std::vector<std::vector<Placement>> all;
  const ShapeId square = scene.shapes[0];
  all = {{{{9, 9}, square, 1}}, {}, {{{9, 9}, square, 1}, {{9, 9}, square, 1}}};
  for (const Cell cell : Hostile<Cell>::values(scene))
    all.push_back({{{50, 50}, square, 0}, {cell, square, 0xffff'ffff}});
  for (const ShapeId shape : scene.shapes) all.push_back({{{-50, 50}, square, 0}, {{9, 9}, shape, 1}});
  all.emplace_back();
  for (std::int32_t k = 0; k < 600; ++k) all.back().push_back({{k % 70, 100 + k / 70}, square, 5});
  return all;
}

const std::vector<std::vector<DirectedEdge>>& Hostile<std::vector<DirectedEdge>>::values(Scene&) {
  static const std::vector<std::vector<DirectedEdge>> all{
      {{0, 1}, {1, 2}, {2, 0}},
      {},
      {{0, 0}},
      {{0, 1}, {0, 1}, {1, 0}},
      {{0, 3}},
      {{0xffff'ffff, 0}},
      {{0, 0xffff'fffe}, {0x8000'0000, 1}},
      std::vector<DirectedEdge>(5'000, DirectedEdge{0, 1}),
  };
  return all;
}

const std::vector<std::vector<EdgeLinks>>& Hostile<std::vector<EdgeLinks>>::values(Scene&) {
  static const std::vector<std::vector<EdgeLinks>> all{
      {{1, 1}, {0, 0}},
      {},
      {{0, 0}},
      {{kNoEdge, kNoEdge}},
      {{1, 1}},
      {{0, 0x7fff'ffff}, {0, 0xffff'fffe}},
      {{2, 1}, {0, 1}, {9, 9}},
      std::vector<EdgeLinks>(5'000, EdgeLinks{0, 4'999}),
  };
  return all;
}

const std::vector<std::vector<std::byte>>& Hostile<std::vector<std::byte>>::values(Scene& scene) {
  static std::vector<std::vector<std::byte>> all;
  const std::vector<std::byte>& file = scene.file;
  all = {file, {}, {std::byte{0}}, std::vector<std::byte>(1'000, std::byte{0xff})};
  for (const std::size_t cut : {std::size_t{4}, file.size() / 2, file.size() - 1})
    all.emplace_back(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(cut));
  for (std::size_t k = 0; k < file.size(); k += 7) {
    all.push_back(file);
    all.back()[k] ^= std::byte{0x81};
  }
  all.push_back(file);
  all.back().push_back(std::byte{0});
  return all;
}

const std::vector<Region>& Hostile<Region>::values(Scene& scene) {
  static const std::vector<Region> all = [&] {
    std::vector<Region> regions{circle({40'000, 40'000}, 70'000), {}, {{{}}}};
    for (const auto& ring : Hostile<std::vector<Point>>::values(scene)) regions.push_back({{ring}});
    for (const FillRule rule : Hostile<FillRule>::values(scene))
      regions.push_back({{{{0, 0}, {90'000, 0}, {90'000, 90'000}}, {{9, 9}, {9, 999}, {999, 9}}}, rule});
    regions.push_back(circle({kFar - 5, kFar - 5}, 4));
    regions.push_back(circle({kFar, -kFar}, 99'999));
    regions.push_back({{std::vector<Point>(5'000, Point{3, 3}), {{0, 0}, {9, 0}, {0, 9}}}});
    regions.push_back({std::vector<Ring>(5'000, Ring{{0, 0}, {65'536, 0}, {65'536, 65'536}})});
    return regions;
  }();
  return all;
}

// --- Functions. They return, and throw nothing: what may throw is told in the documents.

const std::vector<PreserveRelation>& Hostile<PreserveRelation>::values(Scene&) {
  static const std::vector<PreserveRelation> all{
      {},
      [](Block, Block) { return true; },
      [](Block a, Block b) { return (a ^ b) % 2 != 0; },
      [](Block, Block) {
        static std::uint32_t state = 1;
        state = state * 1'664'525u + 1'013'904'223u;
        return (state >> 16 & 1u) != 0;
      },
  };
  return all;
}

const std::vector<StayingBlocks>& Hostile<StayingBlocks>::values(Scene&) {
  static const std::vector<StayingBlocks> all{
      {},
      [](Block) { return true; },
      [](Block block) { return block % 2 != 0; },
      [](Block) {
        static std::uint32_t calls = 0;
        return ++calls % 3 == 0;
      },
  };
  return all;
}

const std::vector<Executor>& Hostile<Executor>::values(Scene&) {
  using Job = std::function<void(std::size_t)>;
  static const std::vector<Executor> all{
      [](std::size_t count, const Job& job) {
        for (std::size_t k = 0; k < count; ++k) job(k);
      },
      {},
      [](std::size_t, const Job&) {},
      [](std::size_t count, const Job& job) {
        for (std::size_t k = 2 * count + 3; k-- > 0;) job(k / 2);
      },
      [](std::size_t, const Job& job) {
        for (const std::size_t k : {SIZE_MAX, SIZE_MAX - 1, std::size_t{0x8000'0000}}) job(k);
      },
  };
  return all;
}

const std::vector<ByteSink>& Hostile<ByteSink>::values(Scene& scene) {
  static const World* world = nullptr;
  world = &scene.world;
  static const std::vector<ByteSink> all{
      [](std::span<const std::byte>) {},
      {},
      [](std::span<const std::byte>) { static_cast<void>(world->stats()); },  // it may read
  };
  return all;
}

const std::vector<World::PolygonVisitor>& Hostile<World::PolygonVisitor>::values(Scene& scene) {
  static const World* world = nullptr;
  world = &scene.world;
  static const std::vector<World::PolygonVisitor> all{
      [](Cell, const PlacedPolygon&) {},
      {},
      [](Cell cell, const PlacedPolygon& p) {
        static_cast<void>(world->polygons(cell));
        static_cast<void>(world->polygon(p.handle));
      },
  };
  return all;
}

// --- In words

std::string Hostile<Points>::told(const Points& v) { return counted(v, "points"); }
std::string Hostile<Reals<float>>::told(const Reals<float>& v) { return counted(v, "points"); }
std::string Hostile<Reals<double>>::told(const Reals<double>& v) { return counted(v, "points"); }
std::string Hostile<std::vector<Points>>::told(const std::vector<Points>& v) { return counted(v, "polygons"); }
std::string Hostile<std::vector<Reals<double>>>::told(const std::vector<Reals<double>>& v) {
  return counted(v, "rings");
}
std::string Hostile<std::vector<Point>>::told(const std::vector<Point>& v) { return counted(v, "points"); }
std::string Hostile<std::vector<PolygonHandle>>::told(const std::vector<PolygonHandle>& v) {
  return counted(v, "handles");
}
std::string Hostile<std::vector<SegmentId>>::told(const std::vector<SegmentId>& v) { return counted(v, "ids"); }
std::string Hostile<std::vector<Placement>>::told(const std::vector<Placement>& v) {
  return counted(v, "placements") + (v.empty() ? "" : ", the last in " + Hostile<Cell>::told(v.back().cell));
}
std::string Hostile<std::vector<DirectedEdge>>::told(const std::vector<DirectedEdge>& v) { return counted(v, "edges"); }
std::string Hostile<std::vector<EdgeLinks>>::told(const std::vector<EdgeLinks>& v) { return counted(v, "links"); }
std::string Hostile<std::vector<std::byte>>::told(const std::vector<std::byte>& v) { return counted(v, "bytes"); }
std::string Hostile<Region>::told(const Region& v) {
  return counted(v.rings, "rings") + ", " + Hostile<FillRule>::told(v.rule);
}
std::string Hostile<PreserveRelation>::told(const PreserveRelation& v) { return v ? "a relation" : "no relation"; }
std::string Hostile<StayingBlocks>::told(const StayingBlocks& v) { return v ? "some stay" : "none stay"; }
std::string Hostile<Executor>::told(const Executor& v) { return v ? "an executor" : "no executor"; }
std::string Hostile<ByteSink>::told(const ByteSink& v) { return v ? "a sink" : "no sink"; }
std::string Hostile<World::PolygonVisitor>::told(const World::PolygonVisitor& v) {
  return v ? "a visitor" : "no visitor";
}

}  // namespace lgs::test
