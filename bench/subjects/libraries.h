// The subjects other than the engine. CMakeLists.txt leaves out those whose library is missing.
#pragma once

#include "bench/subjects/subject.h"

namespace lgs::bench {

using Made = tl::expected<std::unique_ptr<Subject>, std::string>;

Made makePublishedPort();
Made makePublishedPortWithNewSets();
Made makePublishedArrays();
Made makeCgal();
Made makeClipper();
Made makeGeosUnaryUnion();
Made makeGeosCoverageUnion();
Made makeBoost();
Made makePolygonClipping();

}  // namespace lgs::bench
