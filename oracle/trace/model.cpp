#include "oracle/trace/model.h"

#include "oracle/trace/brushing.h"

#include <lgs/world.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

Cell chunkOf(Cell cell) { return {cell.i >> 5, cell.j >> 5}; }

bool areTooMany(std::size_t polygons, std::size_t vertices) {
  return polygons > kMaxPolygonsPerCell || vertices > kMaxVerticesPerCell;
}

std::size_t verticesOf(std::span<const LocalPolygon> shape) {
  std::size_t sum = 0;
  for (const LocalPolygon& polygon : shape) sum += polygon.size();
  return sum;
}

}  // namespace

const std::vector<Model::Placed>& Model::in(Cell cell) const {
  static const std::vector<Placed> kNone;
  const auto found = cells_.find(cell);
  return found == cells_.end() ? kNone : found->second;
}

std::size_t Model::polygonsIn(const CellRect& cells) const {
  std::size_t count = 0;
  for (auto at = cells_.lower_bound({cells.min.i, cells.min.j}); at != cells_.end() && at->first.i <= cells.max.i; ++at)
    if (contains(cells, at->first)) count += at->second.size();
  return count;
}

Scene Model::scene(PreservePairs preserve) const {
  Scene scene{{}, std::move(preserve)};
  scene.polygons.reserve(polygons());
  for (const auto& [cell, there] : cells_)
    for (const Placed& placed : there) scene.polygons.push_back({cell, placed.block, placed.vertices});
  return scene;
}

const Model::Placed& Model::placed(const std::string& name) const {
  return *std::ranges::find(in(cellOf(name)), name, &Placed::name);
}

ScenePolygon Model::operator[](const std::string& name) const {
  const Placed& found = placed(name);
  return {cellOf(name), found.block, found.vertices};
}

const std::string* Model::nameOf(PolygonHandle handle) const {
  const auto found = names_.find(handle);
  return found == names_.end() ? nullptr : &found->second;
}

Model Model::part(const std::set<Cell>& cells) const {
  Model part;
  for (const Cell cell : cells)
    for (const Placed& p : in(cell)) part.apply(Edit::add(p.name, {cell, p.block, p.vertices}), p.handle);
  return part;
}

Verdict Model::judge(const Edit& edit) const {
  if (edit.kind == Edit::Kind::commit) return {};
  if (edit.kind == Edit::Kind::remove) return {isAlive(edit.name)};
  if (edit.kind == Edit::Kind::brush)
    return isOutOfReach(edit.brush) ? Verdict{false, ErrorCode::outOfReach} : Verdict{};
  if (isAlive(edit.name)) return {false};
  const auto& [cell, block, vertices] = edit.polygon;
  if (!inRange(cell)) return {false, ErrorCode::cellOutOfRange, cell};
  if (const auto fault = faultOf(vertices)) return {false, fault, cell};
  if (const auto refusal = refusalIn(cell, {&vertices, 1})) return {false, refusal, cell};
  return {};
}

std::optional<ErrorCode> Model::refusalIn(Cell cell, std::span<const LocalPolygon> shape) const {
  if (!inRange(cell)) return ErrorCode::cellOutOfRange;
  if (chunks_.size() >= kMaxChunks && !chunks_.contains(chunkOf(cell))) return ErrorCode::capacity;
  const std::vector<Placed>& there = in(cell);
  std::size_t vertices = verticesOf(shape);
  for (const Placed& placed : there) vertices += placed.vertices.size();
  if (areTooMany(there.size() + shape.size(), vertices)) return ErrorCode::capacity;
  for (const LocalPolygon& polygon : shape)
    for (const Placed& placed : there)
      if (overlap(polygon, placed.vertices)) return ErrorCode::overlap;
  return std::nullopt;
}

void Model::apply(const Edit& edit, PolygonHandle handle) {
  if (edit.kind == Edit::Kind::add) {
    cells_[edit.polygon.cell].push_back({edit.name, edit.polygon.block, edit.polygon.vertices, handle});
    if (handle) names_.emplace(handle, edit.name);
    cellOf_.emplace(edit.name, edit.polygon.cell);
    chunks_.insert(chunkOf(edit.polygon.cell));
  } else if (edit.kind == Edit::Kind::remove) {
    const auto found = cells_.find(cellOf_.at(edit.name));
    names_.erase(handleOf(edit.name));
    std::erase_if(found->second, [&](const Placed& placed) { return placed.name == edit.name; });
    if (found->second.empty()) cells_.erase(found);
    cellOf_.erase(edit.name);
  }
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

Trace withoutRefused(const Trace& trace) {
  Model model;
  Trace accepted{trace.preserve, {}};
  for (const Edit& edit : trace.edits) {
    if (!model.judge(edit).accepted) continue;
    model.apply(edit);
    accepted.edits.push_back(edit);
  }
  return accepted;
}

}  // namespace lgs::oracle
