// Random edits of one world by every call that edits, good and bad ones, and all that they give out.
#pragma once

#include "hash.h"
#include "random.h"

#include <lgs/world.h>

#include <vector>

namespace platform {

class Editor {
 public:
  /// The editor keeps both references.
  Editor(lgs::World& world, Hash& hash, std::uint64_t seed, lgs::Cell origin = {-4, -4})
      : world_(world), hash_(hash), random_(seed), origin_(origin) {}

  /// One edit, or one call of several.
  void edit();
  void edits(int count) {
    for (int k = 0; k < count; ++k) edit();
  }
  /// The three lists, and what is new in full.
  void commit();
  /// Everything that can be read, as of the last commit.
  void readAll();

 private:
  static constexpr std::int32_t kSide = 10;  ///< cells, across the corners of chunks
  static constexpr std::size_t kKept = 512;  ///< handles: old ones are overwritten

  lgs::Cell cell();
  lgs::CellRect cells(std::int32_t most);
  lgs::Block block() { return random_.below(6); }
  lgs::ShapeId shape();
  lgs::PolygonHandle handle();
  void keep(const lgs::Expected<lgs::PolygonHandle>& added);

  void makeShape();
  void addPoints();
  void addReals();
  void addShape();
  void addMany();
  void replace();
  void remove();
  void removeMany();
  void group();

  lgs::World& world_;
  Hash& hash_;
  Random random_;
  lgs::Cell origin_;
  std::vector<lgs::ShapeId> shapes_;
  std::vector<lgs::PolygonHandle> handles_;
};

}  // namespace platform
