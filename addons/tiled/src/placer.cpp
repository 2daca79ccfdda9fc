#include "placer.h"

#include <lgs/brush.h>
#include <lgs/world.h>

#include <algorithm>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::string_view kTrimmed = "lies on what is there already: the common part was taken away";
constexpr std::string_view kTangled = "crosses what is there already more than 1024 times";
constexpr std::string_view kTooMany = "the cell holds as many polygons or vertices as it can";

/// Twice an area. What is left of a polygon and is smaller is dropped: across a cell it would be 4 lattice units wide.
constexpr std::int64_t kSliver = 8 * std::int64_t{kUnitsPerCell};

}  // namespace

std::uint32_t Placer::shape(const Polygon& ring) {
  Polygon canonical = ring;
  std::rotate(canonical.begin(), std::min_element(canonical.begin(), canonical.end()), canonical.end());
  return shapes_.of(std::move(canonical));
}

Placer::Step Placer::step(ContentId from, EntryId entry) {
  const std::uint64_t key = std::uint64_t{from} << 32 | entry;
  const auto known = steps_.find(key);
  if (known != steps_.end()) return known->second;
  const Step made = work(contents_[from], entry);
  steps_.emplace(key, made);
  return made;
}

/// Works out what a content becomes. What it costs to compare a ring with all that is in a cell, and to keep what comes
/// of it, is taken first.
Placer::Step Placer::work(const Content& content, EntryId entry) {
  const Polygon& ring = ringOf(entry);
  std::size_t vertices = ring.size(), crossed = 0;
  std::uint64_t steps = 1'000;
  for (const EntryId other : content) {
    const std::uint64_t both = ring.size() + ringOf(other).size();
    steps += 100 + both * both;
    vertices += ringOf(other).size();
  }
  const auto stays = [&](std::string_view note) { return Step{contents_.of(content), note}; };
  if (!budget_.work(steps)) return stays({});
  bool isApart = true;
  for (const EntryId other : content) {
    const Relation now = relation(ring, ringOf(other));
    if (now == Relation::inside) return stays(kTrimmed);  // as under solid ground: nothing is left
    if (now == Relation::apart) continue;
    isApart = false;
    crossed += crossings(ring, ringOf(other), kMaxCrossings);
  }
  if (crossed > kMaxCrossings) return stays(kTangled);  // a brush could take minutes
  if (!isApart) return budget_.strokeInCell(vertices) ? paint(content, entry) : stays({});
  if (content.size() == kMaxPolygonsPerCell || vertices > kMaxVerticesPerCell) return stays(kTooMany);
  Content grown = content;
  grown.push_back(entry);
  return {contents_.of(std::move(grown))};
}

/// The same where the entry's polygon lies on others: a brush fills what they leave free. Where outlines cross they get
/// a common vertex, so the others can bend, by less than a lattice unit.
Placer::Step Placer::paint(const Content& content, EntryId entry) {
  constexpr Cell kHere{};
  if (painted_++ % 1'024 == 0) cell_ = World();  // it keeps all that it has seen
  static_cast<void>(cell_.clear(kHere));
  for (std::size_t k = 0; k < content.size(); ++k)
    static_cast<void>(cell_.add(kHere, localRing(ringOf(content[k])), static_cast<Block>(k)));
  const auto last = static_cast<Block>(content.size());
  const auto painted = lgs::paint(cell_, {{ringOf(entry)}}, last, PaintMode::fill);
  Step result{contents_.of(content), painted ? kTrimmed : kTooMany};
  if (!painted) return result;
  Content grown;
  bool isNew = false;
  for (Block block = 0; block <= last; ++block) {
    for (const PlacedPolygon& polygon : cell_.polygons(kHere)) {
      if (polygon.block != block || (block == last && detail::doubleArea(polygon.vertices) <= kSliver)) continue;
      Entry part = entries_[block == last ? entry : content[block]];
      part.shape = shape(tiled::ringOf(polygon.vertices));
      grown.push_back(this->entry(part));
      isNew |= block == last;
    }
  }
  if (isNew) result.to = contents_.of(std::move(grown));
  return result;
}

void Placer::count(EntryId entry, Cell cell, std::string_view text) {
  const Entry& of = entries_[entry];
  const NoteKind kind = text == kTrimmed ? NoteKind::trimmed : NoteKind::leftOut;
  Note& note = notes_[{of.tile, of.layer, of.object, text}];
  if (note.places == 0) note = {kind, of.object, 0, 0, cell, std::string(text), of.layer};
  ++note.places;
}

void Placer::finish(ImportedMap& map) {
  Report& report = map.report;
  std::unordered_map<std::uint32_t, std::uint32_t> numbers;  // of shapes in the map
  std::stable_sort(placed_.begin(), placed_.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first.j, a.first.i) < std::tie(b.first.j, b.first.i);
  });
  for (auto at = placed_.begin(); at != placed_.end() && !budget_.isOutOfWork();) {
    const Cell cell = at->first;
    ContentId content = 0;
    for (; at != placed_.end() && at->first == cell; ++at) {
      const Step taken = step(content, at->second);
      content = taken.to;
      if (!taken.note.empty()) count(at->second, cell, taken.note);
    }
    report.cells += content != 0;
    for (const EntryId id : contents_[content]) {
      MapPolygon& polygon = map.placements.emplace_back(entries_[id]);
      const auto [number, isNew] = numbers.try_emplace(polygon.shape, static_cast<std::uint32_t>(map.shapes.size()));
      if (isNew) map.shapes.push_back(localRing(shapes_[polygon.shape]));
      polygon.cell = cell;
      polygon.shape = number->second;
    }
  }
  for (auto& [key, note] : notes_) {
    const auto [tile, layer, object, text] = key;
    (tile == kNoTile ? report.layers[layer].notes : report.tiles[tile].notes).push_back(std::move(note));
  }
  report.polygons = map.placements.size();
  report.shapes = map.shapes.size();
}

}  // namespace lgs::tiled
