// Small maps of Tiled's whose tiles, objects, numbers and options are drawn at random, and some of them hostile.
#pragma once

#include "oracle/calls/random.h"

#include <lgs/tiled/import.h>

#include <string>

namespace lgs::tiled {

struct HostileMap {
  std::string text;
  Options options;

  static HostileMap draw(oracle::Random& choices);
  std::string inWords() const;  ///< its text, and what its options are
  tl::expected<ImportedMap, ImportError> import() const;
};

}  // namespace lgs::tiled
