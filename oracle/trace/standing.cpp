#include "oracle/trace/standing.h"

#include <lgs/world.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

bool areTooMany(std::size_t polygons, std::size_t vertices) {
  return polygons > kMaxPolygonsPerCell || vertices > kMaxVerticesPerCell;
}

std::size_t verticesOf(std::span<const LocalPolygon> shape) {
  std::size_t sum = 0;
  for (const LocalPolygon& polygon : shape) sum += polygon.size();
  return sum;
}

}  // namespace

void Standing::add(const std::string& name, ScenePolygon polygon, PolygonHandle handle) {
  cells_[polygon.cell].push_back({name, polygon.block, std::move(polygon.vertices), handle});
  if (handle) names_.emplace(handle, name);
  cellOf_.emplace(name, polygon.cell);
}

void Standing::remove(const std::string& name) {
  const auto found = cells_.find(cellOf_.at(name));
  names_.erase(handleOf(name));
  std::erase_if(found->second, [&](const Placed& placed) { return placed.name == name; });
  if (found->second.empty()) cells_.erase(found);
  cellOf_.erase(name);
}

void Standing::recolour(const std::string& name, Block block) {
  std::ranges::find(cells_.at(cellOf(name)), name, &Placed::name)->block = block;
}

std::vector<Standing::Placed> Standing::take(Cell cell) {
  std::vector<Placed> all = in(cell);
  for (const Placed& placed : all) {
    names_.erase(placed.handle);
    cellOf_.erase(placed.name);
  }
  cells_.erase(cell);
  return all;
}

const std::vector<Standing::Placed>& Standing::in(Cell cell) const {
  static const std::vector<Placed> kNone;
  const auto found = cells_.find(cell);
  return found == cells_.end() ? kNone : found->second;
}

std::size_t Standing::polygonsIn(const CellRect& cells) const {
  std::size_t count = 0;
  for (auto at = cells_.lower_bound({cells.min.i, cells.min.j}); at != cells_.end() && at->first.i <= cells.max.i; ++at)
    if (contains(cells, at->first)) count += at->second.size();
  return count;
}

std::vector<ScenePolygon> Standing::polygonsOfAll() const {
  std::vector<ScenePolygon> all;
  all.reserve(polygons());
  for (const auto& [cell, there] : cells_)
    for (const Placed& placed : there) all.push_back({cell, placed.block, placed.vertices});
  return all;
}

const Standing::Placed& Standing::placed(const std::string& name) const {
  return *std::ranges::find(in(cellOf(name)), name, &Placed::name);
}

ScenePolygon Standing::operator[](const std::string& name) const {
  const Placed& found = placed(name);
  return {cellOf(name), found.block, found.vertices};
}

const std::string* Standing::nameOf(PolygonHandle handle) const {
  const auto found = names_.find(handle);
  return found == names_.end() ? nullptr : &found->second;
}

Standing Standing::part(const std::set<Cell>& cells) const {
  Standing part;
  for (const Cell cell : cells)
    for (const Placed& p : in(cell)) part.add(p.name, {cell, p.block, p.vertices}, p.handle);
  return part;
}

std::optional<ErrorCode> Standing::refusalIn(Cell cell, std::span<const LocalPolygon> shape) const {
  if (!inRange(cell)) return ErrorCode::cellOutOfRange;
  const std::vector<Placed>& there = in(cell);
  std::size_t vertices = verticesOf(shape);
  for (const Placed& placed : there) vertices += placed.vertices.size();
  if (areTooMany(there.size() + shape.size(), vertices)) return ErrorCode::capacity;
  for (const LocalPolygon& polygon : shape)
    for (const Placed& placed : there)
      if (overlap(polygon, placed.vertices)) return ErrorCode::overlap;
  return std::nullopt;
}

std::optional<ErrorCode> faultOf(std::span<const LocalPolygon> shape) {
  if (shape.empty()) return ErrorCode::emptyShape;
  for (const LocalPolygon& polygon : shape)
    if (const auto fault = faultOf(polygon)) return fault;
  if (areTooMany(shape.size(), verticesOf(shape))) return ErrorCode::capacity;
  for (std::size_t k = 0; k < shape.size(); ++k)
    for (std::size_t l = 0; l < k; ++l)
      if (overlap(shape[k], shape[l])) return ErrorCode::overlap;
  return std::nullopt;
}

}  // namespace lgs::oracle
