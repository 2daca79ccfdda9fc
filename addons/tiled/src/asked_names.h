// The names that the options ask for, of properties and of blocks, and whether a map has them; and the values of
// properties likewise. What is spelt wrong takes nothing, so the report should say it.
#pragma once

#include "layers.h"
#include "tileset.h"

#include <set>

namespace lgs::tiled {

class AskedNames {
 public:
  explicit AskedNames(const Options& options);

  /// Names that the map has, be they imported or not.
  void see(const Tileset& tileset);
  void see(const Layer& layer);
  void see(const CollisionObject& object);

  /// A note for each name or value that nothing has which was seen.
  std::vector<std::string> notes() const;

 private:
  void seeProperties(const Properties& properties);
  void seeClass(const std::string& className);
  void seeObjectName(const std::string& name);
  std::string noProperty(const std::string& rule) const;
  std::string notUsed(const std::string& name) const;

  using Names = std::set<std::string>;

  BlockFrom blockFrom_;
  Names rules_;                          // "NAME" or "NAME=VALUE", as asked
  Names properties_;                     // all that were seen
  std::map<std::string, Names> values_;  // that were seen, of the properties whose value is asked for
  Names askedBlocks_, blocks_;
  Names leftOut_, classes_;  // asked to be left out; all that were seen, if any are
  Names tables_, tilesets_;  // the same of the tilesets that tables of tiles name
};

/// "; there are 'rock', 'ice' and 3 more": the one that is similar to the value comes first. Nothing if there are none.
std::string thereAre(const std::string& value, const std::set<std::string>& values);

/// Whether two names differ by upper and lower case, or by one edit: a letter more, another, or two swapped.
bool areSimilar(std::string_view a, std::string_view b);

}  // namespace lgs::tiled
