// Whether what an error names is to blame. Where error.h does not promise which of several vertices or edges an error
// names, any that are truly to blame are right, and no others.
#pragma once

#include "oracle/reference/validity.h"

#include <string>

namespace lgs::oracle {

/// What is wrong with the fields of an error whose code is right for this polygon, the only one of its call; empty if
/// nothing is. The cell, and the other polygon of an overlap, are the caller's to judge.
std::string wrongBlame(const Error& error, const oracle::LocalPolygon& polygon);

}  // namespace lgs::oracle
