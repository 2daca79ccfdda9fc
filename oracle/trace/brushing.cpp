#include "oracle/trace/brushing.h"

#include "oracle/trace/player.h"

#include <fmt/format.h>
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

}  // namespace

Region regionOf(const BrushEdit& brush) {
  return {brush.rings, brush.isEvenOdd ? FillRule::evenOdd : FillRule::nonZero};
}

Expected<BrushResult> stroke(World& world, const BrushEdit& brush) {
  StayingBlocks staying;
  if (!brush.staying.empty())
    staying = [&brush](Block block) { return std::ranges::find(brush.staying, block) != brush.staying.end(); };
  if (brush.deed == BrushEdit::Deed::carve) return carve(world, regionOf(brush), staying);
  const PaintMode mode = brush.deed == BrushEdit::Deed::fill ? PaintMode::fill : PaintMode::replace;
  return paint(world, regionOf(brush), brush.block, mode, staying);
}

CellRect cellsUnder(const BrushEdit& brush) {
  const auto [min, max] = boxOf(brush);
  if (min.x > max.x) return {{0, 0}, {-1, -1}};
  return {cellAt(min), cellAt(max)};
}

bool isOutOfReach(const BrushEdit& brush) {
  constexpr std::int64_t kMost = kMaxRegionCells * kUnitsPerCell;
  constexpr std::int64_t kLeast = -std::int64_t{kMaxCell} * kUnitsPerCell;  // where the first cell begins
  const auto [min, max] = boxOf(brush);
  if (min.x > max.x) return false;
  return std::min(min.x, min.y) < kLeast || !inRange(min) || !inRange(max) || max.x - min.x > kMost ||
         max.y - min.y > kMost;
}

Player::Done Player::brush(const Edit& edit) {
  const auto done = stroke(world(), edit.brush);
  if (done) return readBack(edit, *done);
  const Error& error = done.error();
  auto refusal = refused(error);
  if (error.code == ErrorCode::outOfReach && error.polygon >= 0)
    refusal.value().text = fmt::format("ring {}, vertex {}: {}", error.polygon, error.vertex, refusal.value().text);
  return refusal;
}

// A polygon that has kept its handle, its block and its vertices has kept its name. What else there is gets a new one:
// no trace can name it, since # begins a comment. The result must tell of just these.
Player::Done Player::readBack(const Edit& edit, const BrushResult& result) {
  std::set<PolygonHandle> old(result.went.begin(), result.went.end()), made(result.came.begin(), result.came.end());
  for (const BrushChange& change : result.changed) {
    old.insert(change.old);
    made.insert(change.now.begin(), change.now.end());
  }
  const CellRect cells = cellsUnder(edit.brush);
  std::map<PolygonHandle, ScenePolygon> there;
  world().forEachPolygon(cells, [&](Cell cell, const PlacedPolygon& p) {
    there[p.handle] = {cell, p.block, {p.vertices.begin(), p.vertices.end()}};
  });
  for (const auto& [cell, placed] : standing().cells()) {
    if (!contains(cells, cell)) continue;
    for (const auto& [name, block, vertices, handle] : placed) {
      const auto now = there.find(handle);
      const bool isKept = now != there.end() && now->second == ScenePolygon{cell, block, vertices};
      if (isKept == old.contains(handle))
        return wrong(fmt::format("the brush does not tell what it did to '{}'", name));
      if (std::ranges::find(result.bent, handle) != result.bent.end()) brushed_.bent.push_back(name);
      if (isKept) {
        there.erase(now);
      } else {
        brushed_.went[name] = {cell, block, vertices};
      }
    }
  }
  for (const auto& entry : brushed_.went) {
    lost_[entry.first] = edit.line;
    brushed_.edits.push_back(Edit::remove(entry.first));
    calls_.apply(brushed_.edits.back());
  }
  for (auto& [handle, polygon] : there) {
    if (made.erase(handle) == 0) return wrong("the brush does not tell of a polygon that it made");
    const Edit& part = brushed_.edits.emplace_back(Edit::add(fmt::format("#{}", ++brushNames_), std::move(polygon)));
    if (!standing().judge(part).accepted) return wrong("a brush makes what must be refused: " + printEdit(part));
    calls_.apply(part, handle);
  }
  return made.empty() ? Done() : wrong("the brush tells of a polygon that it did not make");
}

std::vector<std::vector<Edit>> brushedBy(const Trace& trace) {
  Player player(trace.preserve, Loads::never);
  std::vector<std::vector<Edit>> all(trace.edits.size());
  if (!hasBrushes(trace)) return all;
  for (std::size_t k = 0; k < trace.edits.size(); ++k) {
    const Edit& edit = trace.edits[k];
    if (edit.kind == Edit::Kind::commit || !player.apply(edit)) continue;
    if (edit.kind == Edit::Kind::brush) all[k] = player.brushed().edits;
  }
  return all;
}

Trace withoutBrushes(const Trace& trace) {
  if (!hasBrushes(trace)) return trace;
  std::string prefix = "brush";
  const auto isTaken = [&](const Edit& edit) { return edit.name.starts_with(prefix); };
  while (std::ranges::any_of(trace.edits, isTaken)) prefix += '-';
  const auto all = brushedBy(trace);
  Trace plain{trace.preserve, {}};
  for (std::size_t k = 0; k < trace.edits.size(); ++k) {
    const Edit& edit = trace.edits[k];
    if (edit.kind != Edit::Kind::brush) plain.edits.push_back(edit);
    for (Edit part : all[k]) {
      if (part.name.starts_with('#')) part.name.replace(0, 1, prefix);
      part.line = edit.line;
      plain.edits.push_back(std::move(part));
    }
  }
  return plain;
}

}  // namespace lgs::oracle
