// Judges what an error names. error.h does not always promise which of several vertices or edges an error names. Then
// any of them is right that is truly to blame, and no other.
#pragma once

#include "oracle/reference/validity.h"

#include <span>
#include <string>

namespace lgs::oracle {

/// Says which fields of an error are wrong; empty if none is. The error's code must be right for these polygons, all that
/// its call counts, at least one. The caller judges the cell, and the polygons of an overlap.
std::string wrongBlame(const Error& error, std::span<const LocalPolygon> polygons);

}  // namespace lgs::oracle
