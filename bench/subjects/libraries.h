// The subjects but the engine. Those whose library is not here are not built (CMakeLists.txt).
#pragma once

#include "bench/subjects/subject.h"

namespace lgs::bench {

using Made = tl::expected<std::unique_ptr<Subject>, std::string>;

Made makePublishedPort();
Made makeCgal();
Made makeClipper();
Made makeGeosUnaryUnion();
Made makeGeosCoverageUnion();
Made makeBoost();
Made makePolygonClipping();

}  // namespace lgs::bench
