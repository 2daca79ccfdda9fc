// What is asked for less often, in one place: as it is not small, it should not be inlined wherever it is called.
#include "parts.h"

namespace lgs::detail {

Parts partsOf(const PartEnds& ends, unsigned touching, CornerEnds inside) {
  return {ends, cornerEnds(ends, touching, inside)};
}

Parts partsOfManyInside(unsigned sides, unsigned inside) { return workOutPartsOfSides(sides, inside); }

}  // namespace lgs::detail
