// Rounding beside polygons that the region does not reach: they do not bend, and nothing may reach into them.
#pragma once

#include "arrangement.h"
#include "atoms.h"

#include <cstddef>
#include <vector>

namespace lgs::brush {

/// Rounds an arrangement to atoms. Returns the polygons that could not stay, by number: then the atoms are of no use.
/// Where snap rounding would reach into a polygon that must stay, edges of polygons are left straight if nothing
/// crosses them, in case that helps.
std::vector<std::size_t> rounded(Arrangement arrangement, FillRule rule, std::vector<Atom>& atoms);

}  // namespace lgs::brush
