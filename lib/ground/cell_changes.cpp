#include "ground/cell_changes.h"

#include "geometry/sort.h"
#include "storage/vectors.h"

#include <algorithm>

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

// --- Chunks that leave and come back

void CellChanges::leaves(const Ground& ground, Journal::Moment commit, std::uint32_t chunk) {
  if (!wasLoaded_.emplace(chunk, true).second) return;
  std::unordered_map<std::uint32_t, const Note*> pending;  // edits, which may be undone until it is told
  for (const Note& note : ground.journal.since(commit))
    if (note.thing == Thing::cell && note.key / kChunkCells == chunk && note.before < commit)
      pending.emplace(note.key, &note);
  std::vector<PlacedPolygon> polygons;
  for (CellAt at{&ground.grid.chunk(chunk), 0}; at.local < kChunkCells; ++at.local) {
    polygons.clear();
    const auto edited = pending.find(at.ref());
    ground.read(at.ref(), edited == pending.end() ? ground.held(at) : ground.held(*edited->second), polygons);
    for (const PlacedPolygon& p : polygons)
      left_.push_back({p.handle, p.block, {p.vertices.begin(), p.vertices.end()}});
  }
}

/// What a cell held that left, from one of its polygons on. Returns where those of the next cell begin.
std::size_t CellChanges::readLeft(std::size_t first, std::vector<PlacedPolygon>& out) const {
  std::size_t k = first;
  for (; k < left_.size() && left_[k].ref() == left_[first].ref(); ++k)
    out.push_back({left_[k].handle, left_[k].block, left_[k].vertices});
  return k;
}

void CellChanges::forgetStreamed() {
  wasLoaded_.clear();
  left_.clear();
}

bool CellChanges::wasLoaded(const Ground& ground, std::uint32_t chunk) const {
  const auto known = wasLoaded_.find(chunk);
  return known != wasLoaded_.end() ? known->second : !ground.grid.border(chunk);
}

/// Cells of which there is no note since the commit: they are the same, and maybe loaded no more, or again; or they were
/// given up since.
void CellChanges::readStreamed(const Ground& ground, Journal::Moment commit) {
  std::vector<PlacedPolygon> polygons;
  const auto isNoted = [&](std::uint32_t ref) { return ground.journal.isNotedSince(commit, Thing::cell, ref); };
  for (std::size_t k = 0; k < left_.size();) {
    const std::uint32_t ref = left_[k].ref();
    polygons.clear();
    k = readLeft(k, polygons);
    const bool isLoaded = ground.grid.stateOf(ref / kChunkCells) == ChunkState::loaded;
    if (isNoted(ref) || (isLoaded && ground.held(ground.grid.find(ref)).size() != 0)) continue;
    add(ground.grid.cellOfAny(ref), polygons, {});
  }
  std::vector<std::uint32_t> streamed;
  for (const auto& [chunk, was] : wasLoaded_)
    if (was != (ground.grid.stateOf(chunk) == ChunkState::loaded)) streamed.push_back(chunk);
  detail::sort(streamed);
  for (const std::uint32_t chunk : streamed) {
    if (ground.grid.stateOf(chunk) != ChunkState::loaded) continue;
    for (CellAt at{&ground.grid.chunk(chunk), 0}; at.local < kChunkCells; ++at.local) {
      polygons.clear();
      ground.read(at.ref(), ground.held(at), polygons);
      if (!polygons.empty() && !isNoted(at.ref())) add(at.cell(), {}, polygons);
    }
  }
  nameEach(ground, streamed);
}

/// A chunk that was streamed and of which nothing is told is named by a cell that is empty before and now: so followers know
/// which chunks are in memory.
void CellChanges::nameEach(const Ground& ground, std::span<const std::uint32_t> streamed) {
  if (streamed.empty()) return;
  const auto cornerOf = [](Cell cell) { return Cell{cell.i & -kChunkSize, cell.j & -kChunkSize}; };
  std::vector<Cell> named;
  for (const CellChange& change : changes_) named.push_back(cornerOf(change.cell));
  detail::sort(named);
  for (const std::uint32_t chunk : streamed) {
    if (ground.grid.stateOf(chunk) == ChunkState::none) continue;
    const Cell corner = cornerOf(ground.grid.cellOfAny(chunk * kChunkCells));
    if (!std::ranges::binary_search(named, corner)) add(corner, {}, {});
  }
}

// --- What is told

void CellChanges::read(Ground& ground, Journal::Moment commit, Way way) {
  std::vector<PlacedPolygon> then, now;
  clear();
  detail::sort(left_, [](const LeftPolygon& a, const LeftPolygon& b) { return a.handle < b.handle; });
  for (const Note& note : ground.journal.since(commit)) {
    if (note.thing != Thing::cell || note.before >= commit) continue;
    const std::uint32_t chunk = note.key / kChunkCells;
    const bool was = wasLoaded(ground, chunk), is = !ground.grid.border(chunk);
    if (!was && !is) continue;
    const auto left = std::ranges::lower_bound(left_, note.key, {}, &LeftPolygon::ref);
    const bool hasLeft = left != left_.end() && left->ref() == note.key;
    then.clear();
    now.clear();
    ground.read(note.key, ground.held(note), then);
    const bool isGivenUp = hasLeft && then.empty();
    if (way == Way::stay && was == is && !isGivenUp) continue;
    if (way == Way::stay)
      now = then;
    else if (way == Way::back ? was : is)
      ground.read(note.key, ground.heldNow(note.key), now);
    if (way == Way::back) std::swap(then, now);
    if (hasLeft) {
      then.clear();
      readLeft(static_cast<std::size_t>(left - left_.begin()), then);
    }
    if (!was) then.clear();
    if (!is) now.clear();
    add(ground.grid.cellOfAny(note.key), then, now);
  }
  readStreamed(ground, commit);
  own();
  forgetStreamed();
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

std::uint64_t CellChanges::bytes() const {
  std::uint64_t sum = heldBytes(changes_, polygons_, vertices_, left_);
  for (const LeftPolygon& polygon : left_) sum += heldBytes(polygon.vertices);
  return sum;
}

}  // namespace lgs::detail
