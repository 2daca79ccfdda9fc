// A picture of pieces and of a way through them, as SVG.
#pragma once

#include "way.h"

#include <lgs/pieces.h>

#include <ostream>

namespace examples {

/// Draws the cells of a rectangle: solid pieces dark, free ones light, the pieces of the way coloured, and the way.
void drawPieces(std::ostream& out, const lgs::Pieces& pieces, const lgs::CellRect& cells, const Way& way);

}  // namespace examples
