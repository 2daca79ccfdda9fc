// CGAL, as the oracle uses it: the time includes making CGAL's polygons, and reading segments, links and owners.
#include "bench/subjects/libraries.h"
#include "oracle/cgal/cgal_union.h"

namespace lgs::bench {
namespace {

class Cgal final : public Subject {
 public:
  void prepare(const Tiles& tiles) override { scene_ = tiles.scene(); }
  bool build() override {
    union_ = *oracle::cgalUnion(scene_);
    return true;
  }
  Edges edges() const override {
    Edges edges;
    for (const oracle::OutlineSegment& s : union_.outline) edges.push_back({s.start, s.end});
    return edges;
  }

 private:
  oracle::Scene scene_;
  oracle::CgalUnion union_;
};

}  // namespace

Made makeCgal() { return std::make_unique<Cgal>(); }

}  // namespace lgs::bench
