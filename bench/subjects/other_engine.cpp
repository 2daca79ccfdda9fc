#include "bench/subjects/other_engine.h"

#include <fmt/format.h>

namespace lgs::bench {
namespace {

std::string nameOf(std::size_t cell, std::size_t nth) { return fmt::format("{}.{}", cell, nth); }

}  // namespace

void OtherEngine::prepare(const Tiles& tiles) {
  tiles_ = &tiles;
  count_.assign(tiles.size(), 0);
  engine_.reset({});
}

bool OtherEngine::build() {
  for (std::size_t cell = 0; cell < tiles_->size(); ++cell) addOnly(cell, tiles_->at[cell]);
  commit();
  return isAlive_;
}

Edges OtherEngine::edges() const {
  Edges edges;
  if (isAlive_)
    for (const oracle::OutlineSegment& s : engine_.outline()) edges.push_back({s.start, s.end});
  return edges;
}

std::optional<Nanoseconds> OtherEngine::ownTime() const {
  const auto time = engine_.time();
  return time ? std::optional<Nanoseconds>(time->count()) : std::nullopt;
}

void OtherEngine::addOnly(std::size_t cell, std::size_t kind) {
  const auto& [polygons, block] = tiles_->kinds[kind];
  for (const auto& polygon : polygons) engine_.add(nameOf(cell, count_[cell]++), {tiles_->cell(cell), block, polygon});
}

void OtherEngine::removeOnly(std::size_t cell) {
  while (count_[cell] > 0) engine_.remove(nameOf(cell, --count_[cell]));
}

void OtherEngine::remove(std::size_t cell) {
  removeOnly(cell);
  commit();
}

void OtherEngine::add(std::size_t cell, std::size_t kind) {
  addOnly(cell, kind);
  commit();
}

}  // namespace lgs::bench
