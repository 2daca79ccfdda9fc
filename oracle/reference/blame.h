// Judges what an error names. error.h does not always promise which of several vertices or edges an error names. Then
// any of them is right that is truly to blame, and no other.
#pragma once

#include "oracle/reference/validity.h"

#include <string>

namespace lgs::oracle {

/// Says which fields of an error are wrong; empty if none is. The error's code must be right for this polygon, and the
/// polygon must be the only one of its call. The caller judges the cell, and the other polygon of an overlap.
std::string wrongBlame(const Error& error, const LocalPolygon& polygon);

}  // namespace lgs::oracle
