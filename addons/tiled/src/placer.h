// What is placed, cell by cell. The content of a cell is interned, and so is each step from one content to the next. So
// polygons are compared once for each combination that occurs, however large the map is.
#pragma once

#include "budget.h"
#include "loops.h"

#include <lgs/tiled/import.h>
#include <lgs/world.h>

#include <map>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace lgs::tiled {

class Placer {
 public:
  /// A MapPolygon without its cell.
  struct Entry {
    std::uint32_t shape = 0;
    Block block = 1;
    std::uint32_t tile = 0;
    std::uint32_t object = 0;
    std::uint32_t layer = 0;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  using EntryId = std::uint32_t;

  /// What it does is taken from the budget. When that is spent it does nothing any more.
  explicit Placer(Budget& budget);

  /// The number of a ring, whichever vertex it begins with. It is simple, counter-clockwise and inside the cell.
  std::uint32_t shape(const Polygon& ring);

  /// The number of an entry. Equal entries have the same number.
  EntryId entry(const Entry& entry);

  /// Adds to the cell what no polygon covers there that was placed before. Cost: 12 bytes.
  void place(Cell cell, EntryId entry) { placed_.push_back({cell, entry}); }

  /// Moves everything into the map: the shapes, the placements, and the counts and notes of the report, which say what
  /// was taken away or given up. Cost: that of sorting by cell, and a brush for each combination of what overlaps.
  void finish(ImportedMap& map);

 private:
  using ContentId = std::uint32_t;
  using Content = std::vector<EntryId>;

  struct Step {
    ContentId to = 0;
    std::string_view note = {};  ///< what is to be said of it; "" if it was placed as it is
  };

  Step step(ContentId from, EntryId entry);
  Step work(const Content& content, EntryId entry);
  Step paint(const Content& content, EntryId entry);
  ContentId content(Content content);
  bool hasWorkFor(const Content& content, const Polygon& ring);
  bool fits(const Content& content, const Polygon& ring) const;
  void count(EntryId entry, Cell cell, std::string_view text);

  Budget& budget_;
  std::vector<Polygon> shapes_;
  std::map<Polygon, std::uint32_t> shapeIds_;
  std::vector<Entry> entries_;
  std::map<Entry, EntryId> entryIds_;
  std::vector<Content> contents_;
  std::map<Content, ContentId> contentIds_;
  std::unordered_map<std::uint64_t, Step> steps_;
  std::vector<std::pair<Cell, EntryId>> placed_;
  World cell_;  // in which paint() works; a new one for each time would take as long as the brush
  std::size_t painted_ = 0;
  using NoteKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::string_view>;
  std::map<NoteKey, Note> notes_;  // by tile, layer, object, text
};

}  // namespace lgs::tiled
