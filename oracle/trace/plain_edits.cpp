#include "oracle/trace/plain_edits.h"

#include "oracle/trace/model.h"
#include "oracle/trace/player.h"

#include <lgs/brush.h>
#include <algorithm>

namespace lgs::oracle {
namespace {

struct Box {
  Point min{INT64_MAX, INT64_MAX}, max{INT64_MIN, INT64_MIN};
};

Box boxOf(const BrushEdit& brush) {
  Box box;
  for (const auto& ring : brush.rings) {
    for (const Point p : ring) {
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
  }
  return box;
}

// All there is, by name.
std::map<std::string, ScenePolygon> polygonsOf(const Model& model) {
  std::map<std::string, ScenePolygon> all;
  const auto take = [&](Cell cell, const std::vector<Standing::Placed>& there) {
    for (const Standing::Placed& p : there) all[p.name] = {cell, p.block, p.vertices};
  };
  for (const auto& [cell, there] : model.standing().cells()) take(cell, there);
  for (const auto& [chunk, content] : model.state().away)
    for (const auto& [cell, there] : content) take(cell, there);
  return all;
}

std::vector<Call> difference(const std::map<std::string, ScenePolygon>& before,
                             const std::map<std::string, ScenePolygon>& after) {
  std::vector<Call> edits;
  const auto isIn = [](const auto& all, const auto& entry) {
    const auto found = all.find(entry.first);
    return found != all.end() && found->second == entry.second;
  };
  for (const auto& entry : before)
    if (!isIn(after, entry)) edits.push_back(Call::remove(entry.first));
  for (const auto& entry : after)
    if (!isIn(before, entry)) edits.push_back(Call::add(entry.first, entry.second));
  return edits;
}

}  // namespace

CellRect cellsUnder(const BrushEdit& brush) {
  const auto [min, max] = boxOf(brush);
  if (min.x > max.x) return {{0, 0}, {-1, -1}};
  return {cellAt(min), cellAt(max)};
}

std::pair<int, int> vertexInNoCell(const BrushEdit& brush) {
  constexpr std::int64_t kLeast = -std::int64_t{kMaxCell} * kUnitsPerCell;  // where the first cell begins
  for (std::size_t r = 0; r < brush.rings.size(); ++r)
    for (std::size_t v = 0; v < brush.rings[r].size(); ++v)
      if (const Point p = brush.rings[r][v]; std::min(p.x, p.y) < kLeast || !inRange(p))
        return {static_cast<int>(r), static_cast<int>(v)};
  return {-1, -1};
}

bool isOutOfReach(const BrushEdit& brush) {
  constexpr std::int64_t kMost = kMaxRegionCells * kUnitsPerCell;
  if (vertexInNoCell(brush).first >= 0) return true;
  const auto [min, max] = boxOf(brush);
  return min.x <= max.x && (max.x - min.x > kMost || max.y - min.y > kMost);
}

std::vector<std::vector<Call>> editsBy(const Trace& trace) {
  std::vector<std::vector<Call>> all(trace.calls.size());
  if (isPlain(trace)) {
    Model model;
    for (std::size_t k = 0; k < trace.calls.size(); ++k)
      if (model.play(trace.calls[k]) && trace.calls[k].kind != Call::Kind::commit) all[k] = {trace.calls[k]};
    return all;
  }
  Player player(trace.preserve);
  for (std::size_t k = 0; k < trace.calls.size(); ++k) {
    const Call& call = trace.calls[k];
    if (call.kind == Call::Kind::commit) {
      static_cast<void>(player.apply(call));
      continue;
    }
    const bool isSimple = isPlain(call) || call.kind == Call::Kind::brush;
    const auto before = isSimple ? std::map<std::string, ScenePolygon>() : polygonsOf(player.model());
    if (!player.apply(call)) continue;
    if (call.kind == Call::Kind::brush)
      all[k] = player.brushed().edits;
    else
      all[k] = isSimple ? std::vector{call} : difference(before, polygonsOf(player.model()));
  }
  return all;
}

Trace inPlainEdits(const Trace& trace) {
  if (isPlain(trace)) return trace;
  std::string prefix = "new";
  const auto isTaken = [&](const Call& call) {
    return std::ranges::any_of(call.comes, [&](const Coming& coming) {
      return std::ranges::any_of(coming.names, [&](const std::string& name) { return name.starts_with(prefix); });
    });
  };
  while (std::ranges::any_of(trace.calls, isTaken)) prefix += '-';
  const auto all = editsBy(trace);
  Trace plain{trace.preserve, {}};
  const auto rename = [&](std::string& name) {
    if (name.starts_with('#')) name.replace(0, 1, prefix);
  };
  for (std::size_t k = 0; k < trace.calls.size(); ++k) {
    const Call& call = trace.calls[k];
    for (Call part : all[k]) {
      for (Named& named : part.goes) rename(named.name);
      for (Coming& coming : part.comes) std::ranges::for_each(coming.names, rename);
      part.line = call.line;
      plain.calls.push_back(std::move(part));
    }
    if (call.kind == Call::Kind::commit || commitsFirst(call.kind)) plain.calls.push_back(Call::commit());
  }
  return plain;
}

Scene sceneOf(const Trace& trace) {
  Model model;
  for (const Call& call : inPlainEdits(trace).calls) model.play(call);
  return model.scene(trace.preserve);
}

}  // namespace lgs::oracle
