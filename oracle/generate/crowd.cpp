#include "oracle/calls/random.h"
#include "oracle/generate/forms.h"
#include "oracle/generate/generator.h"
#include "oracle/reference/validity.h"

#include <fmt/format.h>
#include <lgs/world.h>
#include <algorithm>
#include <numeric>

namespace lgs::oracle {
namespace {

constexpr std::int32_t kRows = 16;  // and columns: 256 places, a few more than a cell may hold polygons

struct Box {
  std::int32_t left, floor, right, top;
};

Box placeOf(std::int32_t place) {
  constexpr std::int32_t kSide = kUnitsPerCell / kRows;
  const std::int32_t x = place % kRows * kSide, y = place / kRows * kSide;
  return {x, y, x + kSide, y + kSide};
}

// A rectangle; half of one, if it has three vertices. If there are more than four, the others lie on its floor.
LocalPolygon polygonIn(const Box& box, std::size_t vertices) {
  LocalPolygon polygon;
  const auto pieces = static_cast<std::int32_t>(std::max<std::size_t>(vertices, 4)) - 3;
  for (std::int32_t k = 0; k <= pieces; ++k) {
    const std::int64_t along = std::int64_t{box.right - box.left} * k / pieces;
    polygon.push_back({box.left + static_cast<std::int32_t>(along), box.floor});
  }
  polygon.push_back({box.right, box.top});
  if (vertices > 3) polygon.push_back({box.left, box.top});
  return polygon;
}

class Crowder {
 public:
  Crowder(std::size_t edits, std::uint64_t seed) : left_(edits), random_(seed) {
    if (random_.chance(50)) cell_ = {31, -1};  // in the corner of its chunk
  }

  Trace run(Crowd of) {
    of == Crowd::vertices ? fillWithVertices() : fillWithPolygons();
    edits_.push_back(Call::commit());
    Trace trace;
    Model model;
    makeInForms(edits_, model, random_, [&](Call call) { trace.calls.push_back(std::move(call)); });
    for (int k = 0; k < 4 && of == Crowd::strokes; ++k) trace.calls.push_back(cut());
    if (of == Crowd::strokes) {
      cell_.i -= 1;  // with hardly anything in it
      const Call speck = Call::add("speck", {cell_, 1, {{0, 0}, {300, 0}, {0, 300}}});
      trace.calls.insert(trace.calls.end(), {speck, comb(), lattice()});
    }
    trace.mayRefuse = true;
    return trace;
  }

 private:
  // Most of them have one block, so that few calls add them. The others come one by one, until there is no room.
  void fillWithPolygons() {
    std::vector<std::int32_t> places(std::size_t{kRows} * kRows);
    std::iota(places.begin(), places.end(), 0);
    if (random_.chance(50)) random_.shuffle(places);
    const std::size_t vertices = random_.chance(50) ? 3 : 4;
    const std::size_t atOnce = kMaxPolygonsPerCell - 1 - random_.below(std::size_t{5});
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (k == atOnce) edits_.push_back(Call::commit());
      add(polygonIn(placeOf(places[k]), vertices), k < atOnce ? 1 : 2);
      if (k >= atOnce && random_.chance(50)) change();
    }
    for (int k = 0; k < 4; ++k) change();
  }

  // Polygons of many vertices fill all rows of places but one. A polygon there just fits, or just does not.
  void fillWithVertices() {
    constexpr std::int32_t kColumns = 4;
    constexpr std::size_t kEach = 68;
    const auto boxAt = [](std::int32_t k) {
      const Box first = placeOf(k / kColumns * kRows), last = placeOf((k / kColumns + 1) * kRows - 1);
      return Box{kUnitsPerCell / kColumns * (k % kColumns), first.floor, kUnitsPerCell / kColumns * (k % kColumns + 1),
                 last.top};
    };
    std::int32_t at = 0;
    for (; at < kColumns * (kRows - 1); ++at) add(polygonIn(boxAt(at), kEach), 1);
    const std::size_t room = kMaxVerticesPerCell - static_cast<std::size_t>(at) * kEach;
    edits_.push_back(Call::commit());
    add(polygonIn(boxAt(at), room + 1), 2);
    add(polygonIn(boxAt(at), room - (random_.chance(50) ? 3 : 0)), 2);
    add(polygonIn(boxAt(at + 1), 3), 3);
    change();
    add(polygonIn(boxAt(at + 2), 3), 1);
    add(polygonIn(boxAt(at + 3), kMaxVerticesPerCell + 1), 1);
  }

  // A narrow stroke through all of the cell: it cuts some polygons in two.
  Call cut() {
    const auto at = [&](std::int32_t x) { return toWorld(cell_, {x, random_.below(kUnitsPerCell)}); };
    const Point left = at(0), right = at(kUnitsPerCell);
    return Call::byBrush({.deed = random_.chance(50) ? BrushEdit::Deed::carve : BrushEdit::Deed::replace,
                          .block = 1,
                          .rings = {{left, right, {right.x, right.y + 100}, {left.x, left.y + 100}}}});
  }

  // Strokes that must be refused for themselves. The first has one edge more than a region may have in a cell.
  Call comb() {
    BrushEdit brush{.rings = {{}}};
    for (std::int32_t k = 0; k <= static_cast<std::int32_t>(kMaxRegionEdgesPerCell); ++k)
      brush.rings[0].push_back(toWorld(cell_, {1'000 + 12 * (k / 2) + k % 2 * 6, k % 2 == 0 ? 1'000 : 60'000}));
    return Call::byBrush(std::move(brush));
  }

  // Edges of the second cross more often than they may there: 200 that lie almost flat, and 200 that stand.
  Call lattice() {
    BrushEdit brush;
    for (std::int32_t k = 1; k <= 100; ++k) {
      const std::int32_t at = 600 * k;
      brush.rings.push_back(
          {toWorld(cell_, {500, at}), toWorld(cell_, {65'000, at + 3}), toWorld(cell_, {65'000, at + 100})});
      brush.rings.push_back(
          {toWorld(cell_, {at, 500}), toWorld(cell_, {at + 100, 65'000}), toWorld(cell_, {at + 3, 65'000})});
    }
    return Call::byBrush(std::move(brush));
  }

  // Commits, removes a polygon, or adds one where there is one already.
  void change() {
    switch (random_.below(4)) {
      case 0:
        return edits_.push_back(Call::commit());
      case 1:
        return add(polygonIn(placeOf(random_.below(kRows * kRows)), 3), 1);
      default:
        if (left_ == 0 || names_.empty()) return;
        --left_;
        edits_.push_back(Call::remove(names_.back()));
        names_.pop_back();
    }
  }

  void add(LocalPolygon vertices, Block block) {
    if (left_ == 0) return;
    --left_;
    names_.push_back(fmt::format("p{}", ++count_));
    edits_.push_back(Call::add(names_.back(), {cell_, block, std::move(vertices)}));
  }

  std::vector<Call> edits_;
  Cell cell_;
  std::vector<std::string> names_;
  std::size_t left_;
  std::size_t count_ = 0;  // of names
  Random random_;
};

}  // namespace

Trace crowdedCase(Crowd of, std::size_t edits, std::uint64_t seed) { return Crowder(edits, seed).run(of); }

}  // namespace lgs::oracle
