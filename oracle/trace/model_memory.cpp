// Chunks that leave memory, come back, and are forgotten.
#include "oracle/trace/model.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace lgs::oracle {

namespace {

// By rows.
bool comesBefore(Cell a, Cell b) { return std::pair(a.j, a.i) < std::pair(b.j, b.i); }

// Whether a chunk lies in a rectangle as a whole. Cells that there are not need not.
bool isWithin(const CellRect& cells, Cell chunk) {
  const auto fits = [](std::int64_t k, std::int32_t min, std::int32_t max) {
    return min <= std::max<std::int64_t>(32 * k, -kMaxCell) && std::min<std::int64_t>(32 * k + 31, kMaxCell) <= max;
  };
  return fits(chunk.i, cells.min.i, cells.max.i) && fits(chunk.j, cells.min.j, cells.max.j);
}

// But for names, which may have been given again.
bool isSame(const Model::Content& a, const Model::Content& b) {
  const auto areAlike = [](const Standing::Placed& p, const Standing::Placed& q) {
    return std::tie(p.handle, p.block, p.vertices) == std::tie(q.handle, q.block, q.vertices);
  };
  return std::ranges::equal(a, b, [&](const auto& one, const auto& other) {
    return one.first == other.first && std::ranges::equal(one.second, other.second, areAlike);
  });
}

}  // namespace

std::optional<Cell> Model::firstAway(const CellRect& cells) const {
  std::optional<Cell> first;
  for (const auto& entry : now_.away) {
    const CellRect all = cellsOfChunk(entry.first);
    const CellRect here{{std::max(all.min.i, cells.min.i), std::max(all.min.j, cells.min.j)},
                        {std::min(all.max.i, cells.max.i), std::min(all.max.j, cells.max.j)}};
    if (!isEmpty(here) && (!first || comesBefore(here.min, *first))) first = here.min;
  }
  return first;
}

// By rows.
std::vector<Cell> Model::chunksWithin(const CellRect& cells, bool areLoaded) const {
  std::vector<Cell> within;
  for (const Cell chunk : now_.chunks)
    if (isWithin(cells, chunk) && now_.away.contains(chunk) != areLoaded) within.push_back(chunk);
  std::ranges::sort(within, comesBefore);
  return within;
}

void Model::takeAway(Cell chunk) {
  Content& content = now_.away[chunk];
  std::vector<Cell> filled;
  for (const auto& entry : now_.standing.cells())
    if (chunkOf(entry.first) == chunk) filled.push_back(entry.first);
  for (const Cell cell : filled) content[cell] = now_.standing.take(cell);
}

void Model::bringBack(const Content& content) {
  for (const auto& [cell, there] : content)
    for (const auto& [name, block, vertices, handle] : there)  // a name may be that of what is there since
      now_.standing.add(isAlive(name) ? freshName() : name, {cell, block, vertices}, handle);
}

void Model::unload(const CellRect& cells) {
  for (const Cell chunk : chunksWithin(cells, true)) {
    takeAway(chunk);
    shelf_[chunk].push_back(now_.away.at(chunk));
    owed_.erase(chunk);
  }
}

// Being in memory is no edit: what there is becomes what there was, and what is away stays away. A chunk that is away,
// and was not there yet, was there at all times, and held nothing.
void Model::goTo(State state) {
  const std::map<Cell, Content> away = now_.away;
  const bool wasPending = now_.pending != Pending::no;  // chunks may have come or gone
  now_ = std::move(state);
  if (wasPending) isPending(Pending::maybe);
  for (const auto& entry : std::exchange(now_.away, {})) bringBack(entry.second);
  for (const auto& [chunk, before] : away) {
    takeAway(chunk);
    owed_[chunk] = std::max(owed(chunk), isSame(now_.away.at(chunk), before) ? Owed::maybe : Owed::sure);
    if (!now_.chunks.insert(chunk).second) continue;
    timeline_.forEach([&, &cell = chunk](State& other) { other.chunks.insert(cell); });
  }
  now_.alone.clear();
  for (const auto& entry : away)
    if (!isBesideLoaded(entry.first)) now_.alone.insert(entry.first);
}

std::set<Cell> Model::chunksAway() const {
  std::set<Cell> chunks;
  for (const auto& entry : now_.away) chunks.insert(entry.first);
  return chunks;
}

// What a chunk held is given up, at all times.
void Model::empty(Cell chunk) {
  now_.away.erase(chunk);
  timeline_.forEach([&](State& state) {
    std::vector<Cell> filled;
    for (const auto& entry : state.standing.cells())
      if (chunkOf(entry.first) == chunk) filled.push_back(entry.first);
    for (const Cell cell : filled) state.standing.take(cell);
    if (const auto away = state.away.find(chunk); away != state.away.end()) away->second.clear();
  });
}

std::vector<Cell> Model::comingBack(const CellRect& cells) const {
  std::vector<Cell> back;
  for (const auto& entry : shelf_) {
    const bool isGone = !now_.chunks.contains(entry.first);
    if (contains(cells, cellsOfChunk(entry.first).min) && (isGone || now_.away.contains(entry.first)))
      back.push_back(entry.first);
  }
  return back;
}

// A chunk that was forgotten comes back with new handles.
void Model::reload(Cell chunk, const World* world) {
  const bool isNew = now_.chunks.insert(chunk).second;
  Content content = isNew ? shelf_.at(chunk).back() : now_.away.at(chunk);
  now_.away.erase(chunk);
  if (isNew) timeline_.happened(Redo::no);
  for (auto& [cell, there] : content) {
    const auto now = world != nullptr && isNew ? world->polygons(cell) : std::vector<PlacedPolygon>();
    for (std::size_t k = 0; k < there.size() && isNew; ++k)
      there[k].handle = k < now.size() ? now[k].handle : PolygonHandle{};
  }
  bringBack(content);
}

// A loaded one has a chunk of its own, however empty that is.
bool Model::isBesideLoaded(Cell chunk, const std::set<Cell>& gone) const {
  return std::ranges::any_of(cellsOf({{chunk.i - 1, chunk.j - 1}, {chunk.i + 1, chunk.j + 1}}), [&](Cell beside) {
    return now_.chunks.contains(beside) && !now_.away.contains(beside) && !gone.contains(beside);
  });
}

// The chunks that forget() takes: those loaded that hold nothing; then those not in memory that no loaded one is beside,
// nor was at the last commit.
std::vector<Cell> Model::leaving(const CellRect& cells) const {
  if (isEmpty(cells)) return {};
  std::set<Cell> filled;
  for (const auto& entry : now_.standing.cells()) filled.insert(chunkOf(entry.first));
  std::vector<Cell> gone = chunksWithin(cells, true);
  std::erase_if(gone, [&](Cell chunk) { return filled.contains(chunk); });
  const std::set<Cell> loaded(gone.begin(), gone.end());
  for (const Cell chunk : chunksWithin(cells, false))
    if (!isBesideLoaded(chunk, loaded) && now_.alone.contains(chunk)) gone.push_back(chunk);
  return gone;
}

Model::Owed Model::owed(Cell chunk) const {
  const auto found = owed_.find(chunk);
  return found == owed_.end() ? Owed::no : found->second;
}

std::size_t Model::owing(const CellRect& cells, Owed least) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      leaving(cells), [&](Cell chunk) { return now_.away.contains(chunk) && owed(chunk) >= least; }));
}

// An undo may have changed nothing: the engine knows.
bool Model::stays(Cell chunk, const World* world) const {
  if (!now_.away.contains(chunk) || owed(chunk) == Owed::no) return false;
  const Cell corner = cellsOfChunk(chunk).min;
  return owed(chunk) == Owed::sure || world == nullptr || world->firstUnloaded({corner, corner});
}

}  // namespace lgs::oracle
