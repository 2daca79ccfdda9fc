// GEOS, by its C interface. UnaryUnion is a cascade of unions. CoverageUnion trusts that polygons share whole edges,
// and refuses a union that it finds not valid.
#include "bench/subjects/libraries.h"

#include <geos_c.h>

#include <cmath>

namespace lgs::bench {
namespace {

class Geos final : public Subject {
 public:
  using Unite = GEOSGeometry* (*)(GEOSContextHandle_t, const GEOSGeometry*);
  explicit Geos(Unite unite) : unite_(unite) {}
  ~Geos() override {
    GEOSGeom_destroy_r(context_, united_);
    GEOSGeom_destroy_r(context_, polygons_);
    GEOS_finish_r(context_);
  }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  void prepare(const Tiles& tiles) override {
    std::vector<GEOSGeometry*> polygons;
    for (const oracle::ScenePolygon& p : tiles.scene().polygons) polygons.push_back(toGeos(p));
    polygons_ = GEOSGeom_createCollection_r(context_, GEOS_MULTIPOLYGON, polygons.data(),
                                            static_cast<unsigned>(polygons.size()));
  }

  bool build() override {
    GEOSGeom_destroy_r(context_, united_);
    united_ = unite_(context_, polygons_);
    return united_ != nullptr;
  }

  Edges edges() const override {
    Edges edges;
    const int parts = GEOSGetNumGeometries_r(context_, united_);
    for (int k = 0; k < parts; ++k) {
      const GEOSGeometry* part = GEOSGetGeometryN_r(context_, united_, k);
      addRing(ringOf(GEOSGetExteriorRing_r(context_, part)), Winding::counterClockwise, edges);
      const int holes = GEOSGetNumInteriorRings_r(context_, part);
      for (int h = 0; h < holes; ++h) {
        addRing(ringOf(GEOSGetInteriorRingN_r(context_, part, h)), Winding::clockwise, edges);
      }
    }
    return edges;
  }

 private:
  GEOSGeometry* toGeos(const oracle::ScenePolygon& p) const {
    const auto n = static_cast<unsigned>(p.vertices.size());
    GEOSCoordSequence* points = GEOSCoordSeq_create_r(context_, n + 1, 2);
    for (unsigned k = 0; k <= n; ++k) {
      const Point at = toWorld(p.cell, p.vertices[k % n]);
      GEOSCoordSeq_setXY_r(context_, points, k, static_cast<double>(at.x), static_cast<double>(at.y));
    }
    return GEOSGeom_createPolygon_r(context_, GEOSGeom_createLinearRing_r(context_, points), nullptr, 0);
  }

  Ring ringOf(const GEOSGeometry* geometry) const {
    const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(context_, geometry);
    unsigned n = 0;
    GEOSCoordSeq_getSize_r(context_, points, &n);
    Ring ring;
    for (unsigned k = 0; k < n; ++k) {
      double x = 0;
      double y = 0;
      GEOSCoordSeq_getXY_r(context_, points, k, &x, &y);
      ring.push_back({std::llround(x), std::llround(y)});
    }
    return ring;
  }

  Unite unite_;
  GEOSContextHandle_t context_ = GEOS_init_r();
  GEOSGeometry* polygons_ = nullptr;
  GEOSGeometry* united_ = nullptr;
};

}  // namespace

Made makeGeosUnaryUnion() { return std::make_unique<Geos>(GEOSUnaryUnion_r); }
Made makeGeosCoverageUnion() { return std::make_unique<Geos>(GEOSCoverageUnion_r); }

}  // namespace lgs::bench
