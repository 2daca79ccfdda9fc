#include "ground.h"

#include <algorithm>
#include <array>

namespace in_step {
namespace {

using lgs::Cell;
using lgs::LocalPoint;

Polygon valueOf(const lgs::PlacedPolygon& polygon) {
  Polygon value{{polygon.vertices.begin(), polygon.vertices.end()}, polygon.block};
  std::rotate(value.vertices.begin(), std::ranges::min_element(value.vertices), value.vertices.end());
  return value;
}

void putContent(Bytes& out, const Content& content) {
  put(out, content.size());
  for (const Polygon& polygon : content) {
    put(out, polygon.block);
    put(out, polygon.vertices.size());
    LocalPoint last;
    for (const LocalPoint v : polygon.vertices) {
      putSigned(out, v.x - last.x);
      putSigned(out, v.y - last.y);
      last = v;
    }
  }
}

Content readContent(Reader& in) {
  Content content;
  for (std::uint64_t polygons = in.number(lgs::kMaxPolygonsPerCell); polygons > 0 && in.isGood(); --polygons) {
    Polygon& polygon = content.emplace_back();
    polygon.block = static_cast<lgs::Block>(in.number(UINT32_MAX));
    LocalPoint v;
    std::uint64_t vertices = in.number(lgs::kMaxVerticesPerCell);
    if (vertices < 3) in.fail();
    for (; vertices > 0 && in.isGood(); --vertices) {
      v.x += in.signedNumber(2 * lgs::kUnitsPerCell);
      v.y += in.signedNumber(2 * lgs::kUnitsPerCell);
      if (std::min(v.x, v.y) < 0 || std::max(v.x, v.y) > lgs::kUnitsPerCell) in.fail();
      polygon.vertices.push_back(v);
    }
  }
  return content;
}

/// Cells from `first` on, to the right, that hold the same.
struct Run {
  Cell first;
  std::uint32_t cells = 0;
  std::size_t content = 0;  ///< its number among the distinct ones
};

/// Says in its lowest bits what else stands in the head of a run: a run in the row of the last one, right beside it,
/// has nothing more.
constexpr std::uint64_t kHasGap = 1, kIsInNewRow = 2;

bool setCell(lgs::World& world, Cell cell, const Content& wanted) {
  std::vector<lgs::PolygonHandle> removed;
  Content there;
  for (const lgs::PlacedPolygon& placed : world.polygons(cell)) {
    Polygon polygon = valueOf(placed);
    if (std::ranges::binary_search(wanted, polygon))
      there.push_back(std::move(polygon));
    else
      removed.push_back(placed.handle);
  }
  std::ranges::sort(there);
  std::vector<lgs::NewPolygon> added;
  for (const Polygon& polygon : wanted)
    if (!std::ranges::binary_search(there, polygon)) added.push_back({polygon.vertices, polygon.block});
  return (removed.empty() && added.empty()) || world.exchange(cell, removed, added).has_value();
}

}  // namespace

Content contentOf(const std::vector<lgs::PlacedPolygon>& polygons) {
  Content content;
  for (const lgs::PlacedPolygon& polygon : polygons) content.push_back(valueOf(polygon));
  std::ranges::sort(content);
  return content;
}

Ground groundIn(const lgs::World& world, const lgs::CellRect& cells) {
  Ground ground;
  world.forEachPolygon(cells,
                       [&](Cell cell, const lgs::PlacedPolygon& polygon) { ground[cell].push_back(valueOf(polygon)); });
  for (auto& [cell, content] : ground) std::ranges::sort(content);
  return ground;
}

void put(Bytes& out, const Ground& ground) {
  std::map<Content, std::size_t> numbers;
  std::vector<const Content*> contents;
  std::vector<std::pair<Cell, std::size_t>> cells;
  for (const auto& [cell, content] : ground) {
    const auto [place, isNew] = numbers.try_emplace(content, contents.size());
    if (isNew) contents.push_back(&place->first);
    cells.emplace_back(cell, place->second);
  }
  std::ranges::sort(cells, {}, [](const auto& c) { return std::pair(c.first.j, c.first.i); });
  std::vector<Run> runs;
  for (const auto& [cell, content] : cells) {
    if (!runs.empty()) {
      Run& last = runs.back();
      if (last.content == content && last.first.j == cell.j && last.first.i + std::int64_t{last.cells} == cell.i) {
        ++last.cells;
        continue;
      }
    }
    runs.push_back({cell, 1, content});
  }
  put(out, contents.size());
  for (const Content* content : contents) putContent(out, *content);
  put(out, runs.size());
  Cell next;  // behind the last run
  for (const Run& run : runs) {
    const bool isInNewRow = run.first.j != next.j, hasGap = run.first.i != next.i;
    put(out, (run.cells - 1ULL) << 2 | (isInNewRow ? kIsInNewRow : 0) | (hasGap ? kHasGap : 0));
    if (isInNewRow) putSigned(out, std::int64_t{run.first.j} - next.j);
    if (hasGap) putSigned(out, std::int64_t{run.first.i} - next.i);
    put(out, run.content);
    next = {static_cast<std::int32_t>(run.first.i + std::int64_t{run.cells}), run.first.j};
  }
}

Ground readGround(Reader& in) {
  Ground ground;
  std::vector<Content> contents;
  for (std::uint64_t count = in.number(in.left()); count > 0 && in.isGood(); --count) {
    contents.push_back(readContent(in));
    std::ranges::sort(contents.back());
  }
  std::int64_t i = 0, j = 0;
  std::size_t vertices = 0, read = 0;  // cells may come twice
  for (std::uint64_t runs = in.number(in.left()); runs > 0 && in.isGood(); --runs) {
    const std::uint64_t head = in.number(4 * kMaxCells);
    if (head & kIsInNewRow) j += in.signedNumber(INT32_MAX);
    if (head & kHasGap) i += in.signedNumber(INT32_MAX);
    const std::uint64_t content = in.number();
    const auto cells = static_cast<std::int64_t>((head >> 2) + 1);
    read += static_cast<std::size_t>(cells);
    if (content >= contents.size() || std::max(-j, j) > lgs::kMaxCell || i < -lgs::kMaxCell ||
        i + cells - 1 > lgs::kMaxCell || read > kMaxCells)
      in.fail();
    for (std::int64_t k = 0; k < cells && in.isGood(); ++k, ++i) {
      for (const Polygon& polygon : contents[content]) vertices += polygon.vertices.size();
      if (vertices > kMaxVertices) in.fail();
      ground[{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)}] = contents[content];
    }
  }
  return ground;
}

bool setGround(lgs::World& world, const Ground& ground, const lgs::CellRect& cells) {
  lgs::Transaction edits = world.edit();
  for (const auto& [cell, content] : ground)
    if (!setCell(world, cell, content)) return false;
  std::vector<Cell> emptied;
  world.forEachPolygon(cells, [&](Cell cell, const lgs::PlacedPolygon&) {
    if (!ground.contains(cell) && (emptied.empty() || emptied.back() != cell)) emptied.push_back(cell);
  });
  for (const Cell cell : emptied)
    if (!world.clear(cell)) return false;
  edits.keep();
  return true;
}

}  // namespace in_step
