// The cells as they fill up. The content of a cell is interned, and so is each step from one content to the next. So
// polygons are compared once for each combination that occurs, however large the map is.
#pragma once

#include "budget.h"
#include "cell_numbers.h"
#include "loops.h"

#include <lgs/tiled/import.h>
#include <lgs/world.h>

#include <map>
#include <string_view>
#include <tuple>
#include <unordered_map>

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

  /// What it does is taken from the budget. When that is spent it places nothing any more.
  explicit Placer(Budget& budget);

  /// The number of a ring, whichever vertex it begins with. It is simple, counter-clockwise and inside the cell.
  std::uint32_t shape(const Polygon& ring);

  /// The number of an entry. Equal entries have the same number.
  EntryId entry(const Entry& entry);

  /// Adds to the cell what no polygon there covers yet. A note says what was taken away or given up.
  void place(Cell cell, EntryId entry);

  /// Moves everything into the map: the shapes, the placements, and the counts and notes of the report.
  void finish(ImportedMap& map);

 private:
  using ContentId = std::uint32_t;
  using Content = std::vector<EntryId>;

  struct Step {
    ContentId to = 0;
    bool trimmed = false;
    bool tangled = false;  ///< it was given up
    bool tooMany = false;  ///< World holds no more in one cell
  };

  Step step(ContentId from, EntryId entry);
  Step work(const Content& content, EntryId entry);
  Step paint(const Content& content, EntryId entry);
  ContentId content(Content content);
  bool hasWorkFor(const Content& content, const Polygon& ring);
  bool fits(const Content& content, const Polygon& ring) const;
  void count(EntryId entry, Cell cell, NoteKind kind, std::string_view text);

  Budget& budget_;
  std::vector<Polygon> shapes_;
  std::map<Polygon, std::uint32_t> shapeIds_;
  std::vector<Entry> entries_;
  std::map<Entry, EntryId> entryIds_;
  std::vector<Content> contents_;
  std::map<Content, ContentId> contentIds_;
  std::unordered_map<std::uint64_t, Step> steps_;
  CellNumbers cells_;  // the content of each
  World cell_;         // in which paint() works; a new one for each time would take as long as the brush
  std::size_t painted_ = 0;
  using NoteKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::string_view>;
  std::map<NoteKey, Note> notes_;  // by tile, layer, object, text
};

}  // namespace lgs::tiled
