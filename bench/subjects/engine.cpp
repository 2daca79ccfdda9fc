#include "bench/subjects/engine.h"

#include <algorithm>

namespace lgs::bench {

void Engine::prepare(const Tiles& tiles) {
  tiles_ = &tiles;
  handles_.resize(tiles.size());
  hasSingles_ = by_ != By::fill && std::all_of(tiles.kinds.begin(), tiles.kinds.end(),
                                               [](const Kind& kind) { return kind.polygons.size() <= 1; });
  if (by_ == By::polygons) {
    for (std::size_t k = 0; k < tiles.size(); ++k) {
      for (const auto& polygon : tiles.kind(k).polygons) {
        polygons_.push_back({tiles.cell(k), tiles.kind(k).block, polygon});
        cellOf_.push_back(static_cast<std::uint32_t>(k));
      }
    }
    return;
  }
  for (const Kind& kind : tiles.kinds) {
    shapes_.push_back(kind.polygons.empty() ? ShapeId{} : world_.shape(kind.polygons).value());
  }
  if (by_ != By::bulk) return;
  for (std::size_t k = 0; k < tiles.size(); ++k) {
    if (!tiles.isEmpty(k)) placements_.push_back({tiles.cell(k), shapes_[tiles.at[k]], tiles.kind(k).block});
  }
}

bool Engine::build() {
  if (by_ == By::polygons) {
    for (std::size_t k = 0; k < polygons_.size(); ++k) {
      const oracle::ScenePolygon& p = polygons_[k];
      handles_[cellOf_[k]] = world_.add(p.cell, std::span<const LocalPoint>(p.vertices), p.block).value();
    }
  } else if (by_ == By::shapes) {
    std::size_t k = 0;
    for (std::int32_t j = 0; j < tiles_->height; ++j) {
      for (std::int32_t i = 0; i < tiles_->width; ++i, ++k) addAt(k, {i, j}, tiles_->at[k]);
    }
  } else if (by_ == By::bulk) {
    if (placements_.size() != handles_.size()) return false;  // the handles are found by cell
    if (!world_.addMany(placements_, handles_)) return false;
  } else {
    for (const std::uint16_t kind : tiles_->at) {
      if (kind != tiles_->at[0]) return false;
    }
    const CellRect all{{0, 0}, {tiles_->width - 1, tiles_->height - 1}};
    if (!world_.fill(all, shapes_[tiles_->at[0]], tiles_->kind(0).block)) return false;
  }
  commit();
  return true;
}

Edges Engine::edges() const {
  Edges edges;
  for (const SegmentId id : world_.segments()) {
    const Segment s = *world_.segment(id);
    edges.push_back({s.start, s.end});
  }
  return edges;
}

void Engine::find(std::size_t cell) { found_ = handles_[cell]; }

void Engine::remove(std::size_t cell) {
  removeOnly(cell);
  commit();
}

void Engine::add(std::size_t cell, std::size_t kind) {
  addOnly(cell, kind);
  commit();
}

void Engine::removeOnly(std::size_t cell) {
  if (hasSingles_) {
    (void)world_.remove(found_);
  } else {
    (void)world_.clear({tiles_->cell(cell), tiles_->cell(cell)});
  }
}

void Engine::addOnly(std::size_t cell, std::size_t kind) { addAt(cell, tiles_->cell(cell), kind); }

void Engine::addAt(std::size_t at, Cell cell, std::size_t kind) {
  const Kind& content = tiles_->kinds[kind];
  if (by_ == By::polygons) {
    for (const auto& polygon : content.polygons) {
      handles_[at] = world_.add(cell, std::span<const LocalPoint>(polygon), content.block).value();
    }
  } else if (shapes_[kind]) {
    handles_[at] = world_.add(cell, shapes_[kind], content.block).value();
  }
}

}  // namespace lgs::bench
