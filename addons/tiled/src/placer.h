// What is placed, cell by cell. The content of a cell is interned, and so is each step from one content to the next. So
// polygons are compared once for each combination that occurs, however large the map is.
#pragma once

#include "budget.h"
#include "pixel_grid.h"

#include <lgs/tiled/import.h>
#include <lgs/world.h>

#include <map>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lgs::tiled {

class Placer {
 public:
  using Entry = MapPolygon;  ///< whose cell does not count, and whose shape has a number here
  using EntryId = std::uint32_t;

  /// What it does is taken from the budget. When that is spent it does nothing any more.
  explicit Placer(Budget& budget) : budget_(budget) { contents_.of({}); }

  /// The number of a ring, whichever vertex it begins with. It is simple, counter-clockwise and inside the cell.
  std::uint32_t shape(const Polygon& ring);

  /// The number of an entry. Equal entries have the same number.
  EntryId entry(const Entry& entry) { return entries_.of(entry); }

  /// Adds to the cell what no polygon covers there that was placed before. Cost: 12 bytes.
  void place(Cell cell, EntryId entry) { placed_.push_back({cell, entry}); }

  /// Moves everything into the map: the shapes, the placements, and the counts and notes of the report, which say what
  /// was taken away or given up. Cost: that of sorting by cell, and a brush for each combination of what overlaps.
  void finish(ImportedMap& map);

 private:
  /// Equal values have one number.
  template <class T>
  class Numbered {
   public:
    std::uint32_t of(T value) {
      const auto [at, isNew] = numbers_.emplace(std::move(value), static_cast<std::uint32_t>(values_.size()));
      if (isNew) values_.push_back(&at->first);
      return at->second;
    }
    const T& operator[](std::uint32_t number) const { return *values_[number]; }

   private:
    std::map<T, std::uint32_t> numbers_;
    std::vector<const T*> values_;
  };
  using Content = std::vector<EntryId>;
  using ContentId = std::uint32_t;

  struct Step {
    ContentId to = 0;
    std::string_view note = {};  ///< what is to be said of it; "" if it was placed as it is
  };

  Step step(ContentId from, EntryId entry);
  Step work(const Content& content, EntryId entry);
  Step paint(const Content& content, EntryId entry);
  const Polygon& ringOf(EntryId entry) const { return shapes_[entries_[entry].shape]; }
  void count(EntryId entry, Cell cell, std::string_view text);

  Budget& budget_;
  Numbered<Polygon> shapes_;
  Numbered<Entry> entries_;
  Numbered<Content> contents_;
  std::unordered_map<std::uint64_t, Step> steps_;
  std::vector<std::pair<Cell, EntryId>> placed_;
  World cell_;  // in which paint() works; a new one for each time would take as long as the brush
  std::size_t painted_ = 0;
  using NoteKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::string_view>;
  std::map<NoteKey, Note> notes_;  // by tile, layer, object, text
};

}  // namespace lgs::tiled
