// Clipper 6: all polygons in one sweep.
#include "bench/subjects/libraries.h"

#include <polyclipping/clipper.hpp>

namespace lgs::bench {
namespace {

class Clipper final : public Subject {
 public:
  void prepare(const Tiles& tiles) override {
    for (const oracle::ScenePolygon& p : tiles.scene().polygons) {
      ClipperLib::Path& path = polygons_.emplace_back();
      for (const LocalPoint v : p.vertices) {
        const Point at = toWorld(p.cell, v);
        path.emplace_back(at.x, at.y);
      }
    }
  }

  bool build() override {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(polygons_, ClipperLib::ptSubject, true);
    return clipper.Execute(ClipperLib::ctUnion, united_, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  }

  Edges edges() const override {
    Edges edges;
    for (const ClipperLib::Path& path : united_) {
      Ring ring;
      for (const ClipperLib::IntPoint& p : path) ring.push_back({p.X, p.Y});
      addRing(std::move(ring), Winding::asItIs, edges);  // holes are clockwise already
    }
    return edges;
  }

 private:
  ClipperLib::Paths polygons_;
  ClipperLib::Paths united_;
};

}  // namespace

Made makeClipper() { return std::make_unique<Clipper>(); }

}  // namespace lgs::bench
