#include "oracle/trace/model.h"

#include <algorithm>

namespace lgs::oracle {

const std::vector<Model::Placed>& Model::in(Cell cell) const {
  static const std::vector<Placed> kNone;
  const auto found = cells_.find(cell);
  return found == cells_.end() ? kNone : found->second;
}

Model::Verdict Model::judge(const Edit& edit) const {
  if (edit.kind == Edit::Kind::commit) return {};
  if (edit.kind == Edit::Kind::remove) return {isAlive(edit.name)};
  if (isAlive(edit.name)) return {false};
  const ScenePolygon& polygon = edit.polygon;
  if (!inRange(polygon.cell)) return {false, ErrorCode::cellOutOfRange};
  if (const auto fault = faultOf(polygon.vertices)) return {false, fault};
  for (const Placed& other : in(polygon.cell)) {
    if (overlap(polygon.vertices, other.vertices)) return {false, ErrorCode::overlap};
  }
  return {};
}

void Model::apply(const Edit& edit) {
  if (edit.kind == Edit::Kind::add) {
    cells_[edit.polygon.cell].push_back({edit.name, edit.polygon.block, edit.polygon.vertices});
    cellOf_.emplace(edit.name, edit.polygon.cell);
  } else if (edit.kind == Edit::Kind::remove) {
    const auto found = cells_.find(cellOf_.at(edit.name));
    std::erase_if(found->second, [&](const Placed& placed) { return placed.name == edit.name; });
    if (found->second.empty()) cells_.erase(found);
    cellOf_.erase(edit.name);
  }
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
