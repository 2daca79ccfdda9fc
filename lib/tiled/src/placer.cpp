#include "placer.h"

#include "subtract.h"

#include <lgs/world.h>

#include <algorithm>
#include <utility>

namespace lgs::tiled {
namespace {

constexpr std::string_view kTrimmed = "lies on what is there already: the common part was taken away";
constexpr std::string_view kLost = "overlaps what is there already in so intricate a way that a part was given up";
constexpr std::string_view kTooMany = "the cell holds as many polygons or vertices as it can";

std::uint32_t asId(std::size_t size) { return static_cast<std::uint32_t>(size); }

}  // namespace

Placer::Placer() : contents_(1), contentIds_{{{}, 0}} {}

std::size_t Placer::CellHash::operator()(Cell c) const {
  const std::uint64_t both =
      static_cast<std::uint64_t>(static_cast<std::uint32_t>(c.i)) << 32 | static_cast<std::uint32_t>(c.j);
  const std::uint64_t mixed = both * 0x9E37'79B9'7F4A'7C15;
  return static_cast<std::size_t>(mixed ^ mixed >> 32);
}

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

void Placer::place(Cell cell, EntryId entry) {
  ContentId& at = cells_[cell];
  const Step taken = step(at, entry);
  at = taken.to;
  if (taken.trimmed) count(entry, cell, NoteKind::trimmed, kTrimmed);
  if (taken.lost) count(entry, cell, NoteKind::leftOut, kLost);
  if (taken.tooMany) count(entry, cell, NoteKind::leftOut, kTooMany);
}

Placer::Step Placer::step(ContentId from, EntryId entry) {
  const std::uint64_t key = std::uint64_t{from} << 32 | entry;
  const auto known = steps_.find(key);
  if (known != steps_.end()) return known->second;
  const Step made = work(contents_[from], entry);
  steps_.emplace(key, made);
  return made;
}

/// Works out what a content becomes. Each part of the entry's polygon loses what one polygon of the cell covers, then
/// what the next one covers, until it is apart from all. A cut is rounded, which can make the part overlap a polygon
/// that it was apart from. So a part is compared with all of them again, and the number of cuts is limited.
Placer::Step Placer::work(const Content& content, EntryId entry) {
  Step result;
  Content grown = content;
  std::vector<Polygon> parts{shapes_[entries_[entry].shape]};
  std::size_t cutsLeft = 64 + 4 * content.size();
  while (!parts.empty()) {
    const Polygon part = std::move(parts.back());
    parts.pop_back();
    const auto overlapped = std::find_if(grown.begin(), grown.end(), [&](EntryId other) {
      return relation(part, shapes_[entries_[other].shape]) != Relation::apart;
    });
    if (overlapped == grown.end()) {
      if (!fits(grown, part)) {
        result.tooMany = true;
        continue;
      }
      Entry added = entries_[entry];
      added.shape = shape(part);
      grown.push_back(this->entry(added));
    } else if (cutsLeft-- == 0) {
      result.lost = true;
      break;
    } else {
      result.trimmed = true;
      std::vector<Polygon> obstacles = parts;
      for (const EntryId other : grown) obstacles.push_back(shapes_[entries_[other].shape]);
      Difference difference = subtract(part, shapes_[entries_[*overlapped].shape], obstacles);
      result.lost |= difference.lost;
      for (Polygon& p : difference.parts) parts.push_back(std::move(p));
    }
  }
  result.to = this->content(std::move(grown));
  return result;
}

bool Placer::fits(const Content& content, const Polygon& ring) const {
  std::size_t vertices = ring.size();
  for (const EntryId other : content) vertices += shapes_[entries_[other].shape].size();
  return content.size() < kMaxPolygonsPerCell && vertices <= kMaxVerticesPerCell;
}

void Placer::count(EntryId entry, Cell cell, NoteKind kind, std::string_view text) {
  const Entry& of = entries_[entry];
  Note& note = notes_[{of.tile, of.tile == kNoTile ? of.layer : 0, of.object, text}];
  if (note.places == 0) note = {kind, of.object, 0, 0, cell, std::string(text)};
  ++note.places;
}

void Placer::finish(ImportedMap& map) {
  Report& report = map.report;
  std::vector<std::pair<Cell, ContentId>> order;
  for (const auto& [cell, content] : cells_) {
    if (content != 0) order.push_back({cell, content});
  }
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first.j, a.first.i) < std::pair(b.first.j, b.first.i);
  });
  constexpr std::uint32_t kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> number(shapes_.size(), kUnused);
  for (const auto& [cell, content] : order) {
    for (const EntryId id : contents_[content]) {
      const Entry& e = entries_[id];
      if (number[e.shape] == kUnused) {
        number[e.shape] = asId(map.shapes.size());
        auto& local = map.shapes.emplace_back();
        for (Point p : shapes_[e.shape]) {
          local.push_back({static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)});
        }
      }
      map.placements.push_back({cell, e.block, number[e.shape], e.tile, e.object, e.layer});
    }
  }
  for (auto& [key, note] : notes_) {
    const auto [tile, layer, object, text] = key;
    (tile == kNoTile ? report.layers[layer].notes : report.tiles[tile].notes).push_back(std::move(note));
  }
  report.cells = order.size();
  report.polygons = map.placements.size();
  report.shapes = map.shapes.size();
}

}  // namespace lgs::tiled
