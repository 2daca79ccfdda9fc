// The engine as a subject.
#pragma once

#include "bench/subjects/subject.h"

#include <lgs/world.h>

#include <span>

namespace lgs::bench {

class Engine final : public Incremental {
 public:
  enum class By {
    polygons,  ///< each polygon by its vertices, to be validated and interned
    shapes,    ///< each cell by the id of a shape that was interned before
    fill,      ///< one rectangle at once: for worlds of one kind only, others are refused
  };
  explicit Engine(By by, Executor executor = {}) : by_(by), executor_(std::move(executor)) {}

  void prepare(const Tiles& tiles) override;
  bool build() override;
  Edges edges() const override;

  void find(std::size_t cell) override;
  void remove(std::size_t cell) override;
  void add(std::size_t cell, std::size_t kind) override;
  void replace(std::size_t cell, std::size_t kind) override;

  // The parts of an edit, for what is not one edit and one commit.
  void removeOnly(std::size_t cell);
  void addOnly(std::size_t cell, std::size_t kind);
  void commit() { changes_ = executor_ ? &world_.commit(executor_) : &world_.commit(); }

  const Changes& changes() const { return *changes_; }  ///< of the last commit
  const World& world() const { return world_; }

 private:
  void addAt(std::size_t at, Cell cell, std::size_t kind);

  By by_;
  Executor executor_;
  const Tiles* tiles_ = nullptr;
  World world_;
  std::vector<ShapeId> shapes_;                 // by kind; null for nothing
  std::vector<PolygonHandle> handles_;          // by cell: its first polygon
  std::vector<oracle::ScenePolygon> polygons_;  // by polygons: all of the world, as the caller holds them
  std::vector<std::uint32_t> cellOf_;           // of polygons_
  PolygonHandle found_;
  bool hasSingles_ = false;  // one polygon in a cell at most: it is removed by its handle, else the cell is cleared
  const Changes* changes_ = nullptr;
};

}  // namespace lgs::bench
