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

std::uint32_t asId(std::size_t size) { return static_cast<std::uint32_t>(size); }

}  // namespace

Placer::Placer(Budget& budget) : budget_(budget), contents_(1), contentIds_{{{}, 0}} {}

std::uint32_t Placer::shape(const Polygon& ring) {
  Polygon canonical = ring;
  std::rotate(canonical.begin(), std::min_element(canonical.begin(), canonical.end()), canonical.end());
  const auto [at, isNew] = shapeIds_.emplace(std::move(canonical), asId(shapes_.size()));
  if (isNew) shapes_.push_back(at->first);
  return at->second;
}

Placer::EntryId Placer::entry(const Entry& entry) {
  const auto [at, isNew] = entryIds_.emplace(entry, asId(entries_.size()));
  if (isNew) entries_.push_back(entry);
  return at->second;
}

Placer::ContentId Placer::content(Content content) {
  const auto [at, isNew] = contentIds_.emplace(std::move(content), asId(contents_.size()));
  if (isNew) contents_.push_back(at->first);
  return at->second;
}

Placer::Step Placer::step(ContentId from, EntryId entry) {
  const std::uint64_t key = std::uint64_t{from} << 32 | entry;
  const auto known = steps_.find(key);
  if (known != steps_.end()) return known->second;
  const Step made = work(contents_[from], entry);
  steps_.emplace(key, made);
  return made;
}

/// Works out what a content becomes.
Placer::Step Placer::work(const Content& content, EntryId entry) {
  const Polygon ring = shapes_[entries_[entry].shape];
  if (!hasWorkFor(content, ring)) return {this->content(content)};
  bool isApart = true;
  std::size_t crossed = 0;
  for (const EntryId other : content) {
    const Polygon& there = shapes_[entries_[other].shape];
    const Relation now = relation(ring, there);
    if (now == Relation::inside) return {this->content(content), kTrimmed};  // as under solid ground: nothing is left
    if (now == Relation::apart) continue;
    isApart = false;
    crossed += crossings(ring, there, kMaxCrossings);
  }
  if (crossed > kMaxCrossings) return {this->content(content), kTangled};  // a brush could take minutes
  if (!isApart) return paint(content, entry);
  if (!fits(content, ring)) return {this->content(content), kTooMany};
  Content grown = content;
  grown.push_back(entry);
  return {this->content(std::move(grown))};
}

/// Takes what it costs to compare a ring with all that is in a cell, and to keep what comes of it.
bool Placer::hasWorkFor(const Content& content, const Polygon& ring) {
  std::uint64_t steps = 1'000;
  for (const EntryId other : content) {
    const std::uint64_t both = ring.size() + shapes_[entries_[other].shape].size();
    steps += 100 + both * both;
  }
  return budget_.work(steps);
}

/// The same where the entry's polygon lies on others: a brush fills what they leave free. Where outlines cross they get
/// a common vertex, so the others can bend, by less than a lattice unit.
Placer::Step Placer::paint(const Content& content, EntryId entry) {
  constexpr Cell kHere{};
  std::size_t vertices = shapes_[entries_[entry].shape].size();
  for (const EntryId other : content) vertices += shapes_[entries_[other].shape].size();
  if (!budget_.strokeInCell(vertices)) return {this->content(content)};
  if (painted_++ % 1'024 == 0) cell_ = World();  // it keeps all that it has seen
  static_cast<void>(cell_.clear(kHere));
  for (std::size_t k = 0; k < content.size(); ++k) {
    static_cast<void>(cell_.add(kHere, localRing(shapes_[entries_[content[k]].shape]), static_cast<Block>(k)));
  }
  const auto last = static_cast<Block>(content.size());
  const auto painted = lgs::paint(cell_, {{shapes_[entries_[entry].shape]}}, last, PaintMode::fill);
  Step result{this->content(content), painted ? kTrimmed : kTooMany};
  if (!painted) return result;
  Content grown;
  bool isNew = false;
  for (Block block = 0; block <= last; ++block) {
    for (const PlacedPolygon& polygon : cell_.polygons(kHere)) {
      if (polygon.block != block || (block == last && detail::doubleArea(polygon.vertices) <= kSliver)) continue;
      Entry part = entries_[block == last ? entry : content[block]];
      part.shape = shape(ringOf(polygon.vertices));
      grown.push_back(this->entry(part));
      isNew |= block == last;
    }
  }
  if (isNew) result.to = this->content(std::move(grown));
  return result;
}

bool Placer::fits(const Content& content, const Polygon& ring) const {
  std::size_t vertices = ring.size();
  for (const EntryId other : content) vertices += shapes_[entries_[other].shape].size();
  return content.size() < kMaxPolygonsPerCell && vertices <= kMaxVerticesPerCell;
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
  constexpr std::uint32_t kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> number;
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
      const Entry& e = entries_[id];
      number.resize(shapes_.size(), kUnused);
      if (number[e.shape] == kUnused) {
        number[e.shape] = asId(map.shapes.size());
        map.shapes.push_back(localRing(shapes_[e.shape]));
      }
      map.placements.push_back({cell, e.block, number[e.shape], e.tile, e.object, e.layer});
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
