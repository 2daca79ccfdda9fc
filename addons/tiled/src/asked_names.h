// The names that the options ask for, of properties and of blocks, and whether a map has them; and the values of
// properties likewise. What is spelt wrong takes nothing, so the report should say it.
#pragma once

#include "layers.h"
#include "tileset.h"

#include <lgs/tiled/import.h>

#include <set>

namespace lgs::tiled {

class AskedNames {
 public:
  explicit AskedNames(const Options& options);

  /// Names that the maps have, be they imported or not.
  void see(const Tileset& tileset);
  void see(const Layer& layer);
  void see(const Called& called);

  /// A note for each name or value that nothing has which was seen. What decides on what is solid makes a part.
  void report(Report& report) const;

 private:
  struct Names {
    std::set<std::string> asked = {}, seen = {};  // nothing is seen if nothing is asked for

    void see(const std::string& name) {
      if (!asked.empty()) seen.insert(name);
    }
  };

  BlockFrom blockFrom_;
  Names properties_, blocks_, leftOut_, tilesets_;
  std::map<std::string, Names> values_;  // of the properties whose value is asked for
};

/// "; there are 'rock', 'ice' and 3 more": those that are similar to the name come first. Nothing if there are none.
std::string thereAre(const std::string& name, const std::set<std::string>& names);

/// Whether two names differ by upper and lower case, or by one edit: a letter more, another, or two swapped.
bool areSimilar(std::string_view a, std::string_view b);

/// Those that Options::blocks has keep their numbers. Other names get the least unused numbers from 1 up, as they come.
class BlockNumbers {
 public:
  explicit BlockNumbers(const Options& options) {
    if (options.blockFrom != BlockFrom::one) numbers_ = options.blocks;
    for (const auto& [name, block] : numbers_) taken_.insert(block);
  }

  Block of(const std::string& name) {
    const auto [known, isNew] = numbers_.try_emplace(name);
    if (!isNew) return known->second;
    while (!taken_.insert(next_).second) ++next_;
    asTheyCame_.push_back(name);
    return known->second = next_;
  }

  /// Tells the map which names there are, and its report which blocks are used.
  void report(ImportedMap& map) const;

 private:
  std::map<std::string, Block> numbers_;
  std::set<Block> taken_;
  std::vector<std::string> asTheyCame_;
  Block next_ = 1;
};

}  // namespace lgs::tiled
