// Two readings of one map, side by side.
#pragma once

#include <lgs/tiled/import.h>

#include <string>

namespace lgs::cli {

/// An SVG of both, each as a whole. Polygons that only one of them has are coloured.
std::string drawReadings(const std::string& title, const tiled::ImportedMap& taken, const tiled::ImportedMap& other,
                         const std::string& otherName);

}  // namespace lgs::cli
