// The engine as a subject.
#pragma once

#include "bench/subjects/subject.h"

#include <lgs/world.h>

#include <span>

namespace lgs::bench {

class Engine final : public Incremental {
 public:
  enum class By {
    polygons,  ///< adds each polygon by its vertices, which the engine validates and interns
    shapes,    ///< adds the content of each cell by the id of a shape that was interned before
    bulk,      ///< the same for all cells at once, by addMany()
    fill,      ///< fills one rectangle at once; refuses worlds of more than one kind
  };
  explicit Engine(By by, Executor executor = {}) : by_(by), executor_(std::move(executor)) {}

  void prepare(const Tiles& tiles) override;
  bool build() override;
  Edges edges() const override;

  void find(std::size_t cell) override;
  void remove(std::size_t cell) override;
  void add(std::size_t cell, std::size_t kind) override;

  // The parts of an edit, for batches: many edits with one commit.
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
  std::vector<ShapeId> shapes_;                 // of each kind; null for an empty cell
  std::vector<Placement> placements_;           // By::bulk only: all of the world, as a caller would hold them
  std::vector<PolygonHandle> handles_;          // of the polygon in each cell; of use with hasSingles_ only
  std::vector<oracle::ScenePolygon> polygons_;  // By::polygons only: all of the world, as a caller would hold them
  std::vector<std::uint32_t> cellOf_;           // the cell of each of polygons_
  PolygonHandle found_;
  bool hasSingles_ = false;  // no cell has more than one polygon, so it can be removed by its handle
  const Changes* changes_ = nullptr;
};

}  // namespace lgs::bench
