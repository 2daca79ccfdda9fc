// Pieces: an edit with its commit and the pieces' update, beside the commit alone and beside the pieces of a chunk of
// 32×32 cells worked out anew; a hole carved, with its commit and update. Each world is as before after each time.
#include "bench/micro/benches.h"

#include <lgs/brush.h>
#include <lgs/pieces.h>

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>
#include <random>
#include <stdexcept>

namespace lgs::bench {
namespace {

constexpr std::int32_t kChunk = 32;  // cells along its side
constexpr std::int64_t kHole = 3;    // cells, the radius

World followedWorldOf(const Tiles& tiles, bool isFollowed) {
  World world;
  if (isFollowed && !world.followCells(true)) throw std::logic_error("a new world can not be followed");
  for (std::size_t k = 0; k < tiles.size(); ++k)
    for (const std::vector<LocalPoint>& polygon : tiles.kind(k).polygons)
      if (!world.add(tiles.cell(k), polygon, tiles.kind(k).block)) throw std::logic_error("a tile is refused");
  world.commit();
  return world;
}

/// Takes the polygons of a cell away and puts them back. Each way is an edit; `commit` is timed.
template <class Commit>
void digAndRefill(World& world, Cell cell, Times& times, Commit&& commit) {
  std::vector<std::pair<std::vector<LocalPoint>, Block>> polygons;
  for (const PlacedPolygon& p : world.polygons(cell))
    polygons.emplace_back(std::vector<LocalPoint>(p.vertices.begin(), p.vertices.end()), p.block);
  times.add(timeOf([&] {
    if (!world.clear(cell)) throw std::logic_error("a cell can not be cleared");
    commit();
  }));
  times.add(timeOf([&] {
    for (const auto& [vertices, block] : polygons)
      if (!world.add(cell, vertices, block)) throw std::logic_error("a polygon does not fit back");
    commit();
  }));
}

void editWithPieces(benchmark::State& state, const Tiles& tiles, std::size_t edits) {
  World plain = followedWorldOf(tiles, false), world = followedWorldOf(tiles, true);
  Pieces pieces(world);
  World chunk;
  world.forEachPolygon({{0, 0}, {kChunk - 1, kChunk - 1}}, [&](Cell cell, const PlacedPolygon& p) {
    if (!chunk.add(cell, p.vertices, p.block)) throw std::logic_error("a polygon is refused");
  });
  chunk.commit();
  Times alone, with, anew;
  while (state.KeepRunning()) {
    std::mt19937_64 random(1);
    for (std::size_t k = 0; k < edits; ++k) {
      const Cell cell = tiles.cell(random() % tiles.size());
      digAndRefill(plain, cell, alone, [&] { plain.commit(); });
      digAndRefill(world, cell, with, [&] { benchmark::DoNotOptimize(pieces.update(world, world.commit())); });
      if (k % 20 == 0) anew.add(timeOf([&] { benchmark::DoNotOptimize(Pieces(chunk).stats().cells); }));
    }
  }
  putTimes(state, with);
  putTimes(state, alone, "commit_alone_");
  putTimes(state, anew, "chunk_anew_");
}

void carveWithPieces(benchmark::State& state, const Tiles& tiles, std::size_t edits) {
  World world = followedWorldOf(tiles, true);
  Pieces pieces(world);
  Times carved, updated;
  std::mt19937_64 random(1);
  const auto coordinate = [&](std::int32_t cells) {
    const auto room = static_cast<std::uint64_t>(std::max<std::int64_t>(cells - 2 * kHole, 1) * kUnitsPerCell);
    return kHole * kUnitsPerCell + static_cast<std::int64_t>(random() % room);
  };
  while (state.KeepRunning()) {
    for (std::size_t k = 0; k < edits; ++k) {
      const std::int64_t x = coordinate(tiles.width);
      const Region hole = circle({x, coordinate(tiles.height)}, kHole * kUnitsPerCell, 32);
      const Mark mark = world.mark();
      const Changes* changes = nullptr;
      carved.add(timeOf([&] {
        if (!carve(world, hole)) throw std::logic_error("a hole is refused");
        changes = &world.commit();
      }));
      updated.add(timeOf([&] { benchmark::DoNotOptimize(pieces.update(world, *changes)); }));
      if (!world.rollBack(mark) || !world.forget(mark) || !pieces.update(world, world.changesOfRollBack()))
        throw std::logic_error("there is no way back");
    }
  }
  putTimes(state, updated);
  putTimes(state, carved, "carve_and_commit_");
}

}  // namespace

void registerPieces(const Scale& scale) {
  const Size size = sizeOf(std::clamp<std::int64_t>(scale.maxCells, 100, 10'000));
  const auto edits = static_cast<std::size_t>(std::clamp<std::int64_t>(scale.edits / 10, 1, 2'000));
  for (const std::string world : kWorlds) {
    benchmark::RegisterBenchmark(fmt::format("pieces/edit/{}", world).c_str(), [=](benchmark::State& state) {
      editWithPieces(state, makeTiles(world, size), edits);
    })->Iterations(1);
  }
  for (const std::string world : {"full", "mix"}) {
    benchmark::RegisterBenchmark(fmt::format("pieces/carve/{}", world).c_str(), [=](benchmark::State& state) {
      carveWithPieces(state, makeTiles(world, size), std::max<std::size_t>(edits / 5, 1));
    })->Iterations(1);
  }
}

}  // namespace lgs::bench
