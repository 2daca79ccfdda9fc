#include "block_numbers.h"

#include <utility>

namespace lgs::tiled {

void BlockNumbers::report(ImportedMap& map) const {
  map.blocks = numbers_;
  const auto listed = [](std::string& names, const std::string& name) {
    names += (names.empty() ? "" : ", ") + (name.empty() ? "(no class)" : name);
  };
  if (std::string names; !asTheyCame_.empty()) {
    for (const std::string& name : asTheyCame_) listed(names, name);
    map.report.notes.push_back("blocks are numbered in the order of their first use: " + names +
                               ". An edit of the map may change the numbers. Choose them, or look them up by name");
  }
  std::map<Block, std::uint64_t> polygons;
  for (const MapPolygon& placement : map.placements) ++polygons[placement.block];
  std::map<Block, std::string> names;
  for (const auto& [name, number] : numbers_) listed(names[number], name);
  for (const auto& [block, count] : polygons) map.report.blocks.push_back({names[block], block, count});
}

}  // namespace lgs::tiled
