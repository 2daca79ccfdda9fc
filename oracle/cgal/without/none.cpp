// Where CGAL is not linked nobody asks it: CheckOptions::cgal and views are not set. Then these are never called.
#include "oracle/cgal/brushed.h"
#include "oracle/cgal/cgal_union.h"
#include "oracle/cgal/partition.h"

namespace lgs::oracle {

std::optional<CgalUnion> cgalUnion(const Scene&) { __builtin_trap(); }

std::optional<std::string> farFromExact(const Scene&, const BrushEdit&, const Scene&) { __builtin_trap(); }
std::optional<FarOff> farFromExact(const Outline&, std::span<const BrushEdit>, const Outline&, std::int64_t) {
  __builtin_trap();
}
std::optional<std::string> seamIn(const Scene&, const BrushEdit&, const Scene&) { __builtin_trap(); }

std::optional<std::string> notAPartition(const std::vector<LocalPolygon>&, const std::vector<PieceList>&,
                                         const PieceList&) {
  __builtin_trap();
}

}  // namespace lgs::oracle
