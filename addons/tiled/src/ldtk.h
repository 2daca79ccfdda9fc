// LDtk projects. They become the document that a Tiled map of the same content would be: each level is a group of
// layers with an offset, an IntGrid layer is a tile layer whose tiles are full squares, and the entities of one kind in
// a layer are an object layer.
#pragma once

#include "json.h"

namespace lgs::tiled {

/// The longest side of a cell.
inline constexpr int kMaxCellPixels = 1 << 16;

bool isLdtkProject(const JsonPlace& root);

void readLdtk(const JsonPlace& root, pugi::xml_document& document);

/// Decides what depends on the layers that are wanted: which world stays, whether tiles that are only drawn are read,
/// and how large a cell is. Gives each value of an IntGrid layer its block, unless the options give it another one.
/// What is worth a note goes into `notes`.
void settleLdtk(const XmlFile& file, Options& options, std::vector<std::string>& notes);

}  // namespace lgs::tiled
