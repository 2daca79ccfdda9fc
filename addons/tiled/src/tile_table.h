// What tiles are by a table of the user's: it changes tilesets after they are read.
#pragma once

#include "tileset.h"

namespace lgs::tiled {

/// Gives each tile that the table names the shape that the table says, instead of its own ones.
void reshape(Tileset& tileset, const TileTable& table);

}  // namespace lgs::tiled
