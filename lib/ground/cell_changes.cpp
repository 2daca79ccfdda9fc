#include "ground/cell_changes.h"

#include "storage/held_bytes.h"

#include <unordered_map>

namespace lgs::detail {

void CellChanges::clear() {
  changes_.clear();
  polygons_.clear();
  vertices_.clear();
}

void CellChanges::add(Cell cell, std::span<const PlacedPolygon> before, std::span<const PlacedPolygon> now) {
  changes_.push_back({cell, before, now});
  for (const auto& polygons : {before, now}) polygons_.insert(polygons_.end(), polygons.begin(), polygons.end());
}

void CellChanges::read(const Ground& ground, Journal::Moment commit, Way way) {
  const Grid& grid = ground.grid;
  const std::span<const Note> notes = ground.journal.since(commit);
  std::unordered_map<std::uint32_t, bool> wasUnloaded;  // chunks of which it was noted
  for (const Note& note : notes)
    if (note.thing == Thing::border && note.before < commit) wasUnloaded[note.key] = note.value != 0;
  std::vector<PlacedPolygon> then, now;
  clear();
  for (const Note& note : notes) {
    if (note.thing != Thing::cell || note.before >= commit) continue;
    const CellAt at = grid.find(note.key);
    const auto known = wasUnloaded.find(at.chunk->index);
    const bool isUnloaded = at.chunk->isUnloaded, was = known == wasUnloaded.end() ? isUnloaded : known->second;
    if (isUnloaded && was) continue;
    then.clear();
    now.clear();
    if (!was) ground.read(ground.held(note), then);
    if (!isUnloaded) ground.read(ground.held(at), now);
    way == Way::back ? add(at.cell(), now, then) : add(at.cell(), then, now);
  }
  own();
}

// What lies one behind the other is found again by its sizes alone, which the spans have, whatever they point to.
void CellChanges::own() {
  std::size_t count = 0;
  for (const PlacedPolygon& p : polygons_) count += p.vertices.size();
  vertices_.clear();
  vertices_.reserve(count);
  for (PlacedPolygon& p : polygons_) {
    const std::size_t first = vertices_.size();
    vertices_.insert(vertices_.end(), p.vertices.begin(), p.vertices.end());
    p.vertices = std::span(vertices_).subspan(first);
  }
  std::span<const PlacedPolygon> rest = polygons_;
  for (CellChange& change : changes_) {
    for (auto* part : {&change.before, &change.now}) {
      *part = rest.first(part->size());
      rest = rest.subspan(part->size());
    }
  }
}

std::uint64_t CellChanges::bytes() const { return heldBytes(changes_, polygons_, vertices_); }

}  // namespace lgs::detail
