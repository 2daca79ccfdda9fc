// Block numbers for the names of classes and layers.
#pragma once

#include <lgs/tiled/import.h>

#include <set>

namespace lgs::tiled {

/// Those that Options::blocks has keep their numbers. Other names get the least unused numbers from 1 up, as they come.
class BlockNumbers {
 public:
  explicit BlockNumbers(const Options& options) {
    if (options.blockFrom != BlockFrom::one) numbers_ = options.blocks;
    for (const auto& [name, block] : numbers_) taken_.insert(block);
  }

  Block of(const std::string& name) {
    const auto known = numbers_.find(name);
    if (known != numbers_.end()) return known->second;
    while (taken_.contains(next_)) ++next_;
    taken_.insert(next_);
    asTheyCame_.push_back(name);
    return numbers_[name] = next_;
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
