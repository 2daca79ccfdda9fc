// Boost.Geometry, which unites two polygons at a time: first in pairs, then the results in pairs, and so on.
#include "bench/subjects/libraries.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <cmath>
#include <utility>

namespace lgs::bench {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, /*ClockWise=*/false, /*Closed=*/false>;
using BoostPolygons = bg::model::multi_polygon<BoostPolygon>;

class Boost final : public Subject {
 public:
  void prepare(const Tiles& tiles) override {
    for (const oracle::ScenePolygon& p : tiles.scene().polygons) {
      BoostPolygon polygon;
      for (const LocalPoint v : p.vertices) {
        const Point at = toWorld(p.cell, v);
        polygon.outer().emplace_back(static_cast<double>(at.x), static_cast<double>(at.y));
      }
      polygons_.push_back({std::move(polygon)});
    }
  }

  bool build() override {
    std::vector<BoostPolygons> level = polygons_;
    try {
      while (level.size() > 1) {
        std::vector<BoostPolygons> next((level.size() + 1) / 2);
        for (std::size_t k = 0; k + 1 < level.size(); k += 2) bg::union_(level[k], level[k + 1], next[k / 2]);
        if (level.size() % 2 != 0) next.back() = std::move(level.back());
        level = std::move(next);
      }
    } catch (const bg::exception&) {
      return false;
    }
    united_ = level.empty() ? BoostPolygons{} : std::move(level.front());
    return true;
  }

  Edges edges() const override {
    Edges edges;
    for (const BoostPolygon& polygon : united_) {
      addRing(ringOf(polygon.outer()), Winding::counterClockwise, edges);
      for (const auto& hole : polygon.inners()) addRing(ringOf(hole), Winding::clockwise, edges);
    }
    return edges;
  }

 private:
  static Ring ringOf(const BoostPolygon::ring_type& points) {
    Ring ring;
    for (const BoostPoint& p : points) ring.push_back({std::llround(p.x()), std::llround(p.y())});
    return ring;
  }

  std::vector<BoostPolygons> polygons_;
  BoostPolygons united_;
};

}  // namespace

Made makeBoost() { return std::make_unique<Boost>(); }

}  // namespace lgs::bench
