// What in a map looks like collision, for a map from which nothing came out.
#pragma once

#include "layers.h"
#include "properties.h"

namespace lgs::tiled {

class Suggestions {
 public:
  /// Notes the properties of a tile that is used and has no shapes. `tile` is its index in Report::tiles.
  void see(std::uint32_t tile, const Properties& properties);

  /// What could be taken, the likeliest first.
  std::vector<Suggestion> make(const std::vector<Layer>& layers, const Report& report) const;

 private:
  std::map<std::string, std::vector<std::uint32_t>> tiles_;  // by property
};

}  // namespace lgs::tiled
