// Law 14, unloaded is not gone: a world whose chunks leave memory beside one that stays whole.
#include "fuzz/beside.h"
#include "fuzz/questions.h"
#include "fuzz/same.h"
#include "fuzz/strokes.h"
#include "fuzz/units.h"
#include "oracle/check/questions.h"
#include "oracle/reference/outline.h"
#include "oracle/trace/dump.h"

#include <algorithm>
#include <array>

namespace lgs::fuzz {
namespace {

using oracle::Random;
using Chunk = std::vector<std::byte>;

/// Some chunks about the polygons of a world.
CellRect someChunks(const World& world, Random& random) {
  const CellRect all = world.bounds().value_or(CellRect{});
  const Cell at = random.chance(50) ? all.min : all.max;
  const auto inside = [](std::int32_t k) { return std::clamp(k, -kMaxCell, kMaxCell); };
  const std::int32_t i = kChunkSide * random.below(2), j = kChunkSide * random.below(2);
  return {{inside((at.i & -kChunkSide) - i), inside((at.j & -kChunkSide) - j)},
          {inside((at.i | (kChunkSide - 1)) + i), inside((at.j | (kChunkSide - 1)) + j)}};
}

/// A world of which a part is unloaded, and one with all of it.
class Beside {
 public:
  Beside(const World& world, Random& random) : part_(world), whole_(world), random_(random) {
    part_.commit();
    whole_.commit();
  }

  std::string run() {
    cells_ = someChunks(whole_, random_);
    const World before = part_;
    const Mark mark = part_.mark();
    const auto gone = part_.unload(cells_, [&](Cell corner, auto bytes) {
      corners_.push_back(corner);
      chunks_.emplace_back(bytes.begin(), bytes.end());
    });
    if (!gone || *gone != chunks_.size()) return "unload() does not hand out each chunk once";
    for (int days = random_.below(3); days >= 0; --days) {
      if (std::string wrong = commit(); !wrong.empty()) return wrong;
      if (std::string wrong = tryUnloaded(); !wrong.empty()) return wrong;
      if (std::string wrong = ask(); !wrong.empty()) return wrong;
      if (std::string wrong = editLoaded(); !wrong.empty()) return wrong;
    }
    if (random_.chance(30)) return rollBack(before, mark);
    if (std::string wrong = random_.chance(25) ? comeEmpty() : comeBack(); !wrong.empty()) return wrong;
    return commit();
  }

 private:
  bool isLoaded(Cell cell) const { return !part_.firstUnloaded({cell, cell}); }

  std::string commit() {
    Follower follower(part_);
    if (std::string wrong = follower.follow(part_, part_.commit()); !wrong.empty())
      return "with unloaded chunks " + wrong;
    whole_.commit();
    oracle::Outline here = oracle::outlineOf(part_), there;
    for (const SegmentId id : whole_.segments())
      if (const Segment s = *whole_.segment(id); isLoaded(s.cell)) there.push_back(oracle::outlineSegment(s));
    std::ranges::sort(there);
    return here == there ? "" : "what is loaded shows another outline than in the whole world";
  }

  /// Every edit is refused, and so is a save.
  std::string tryUnloaded() {
    const auto cell = part_.firstUnloaded(cells_);
    if (!cell) return "";
    const auto isRefused = [](const auto& done) { return !done && done.error().code == ErrorCode::unloaded; };
    const auto square = part_.shape(kUnitSquare);
    static_cast<void>(whole_.shape(kUnitSquare));
    const Placement placement{*cell, *square, 1};
    const NewPolygon polygon{kUnitSquare, 1};
    const bool areRefused =
        isRefused(part_.add(*cell, *square, 1)) && isRefused(part_.add(*cell, kUnitSquare, 1)) &&
        isRefused(part_.addMany({&placement, 1})) && isRefused(part_.replace(*cell, *square, 1)) &&
        isRefused(part_.exchange(*cell, {}, {&polygon, 1})) && isRefused(part_.fill({*cell, *cell}, *square, 1)) &&
        isRefused(part_.clear(*cell)) && isRefused(part_.save([](auto) {})) &&
        isRefused(carve(part_, circle(toWorld(*cell, {kUnitsPerCell / 2, kUnitsPerCell / 2}), 999)));
    if (!areRefused || !part_.polygons(*cell).empty()) return "a cell that is unloaded is edited";
    for (const PlacedPolygon& p : whole_.polygons(*cell)) {
      const bool isNone = isRefused(part_.remove(p.handle)) && isRefused(part_.setBlock(p.handle, 2)) &&
                          isRefused(part_.removeMany({&p.handle, 1})) && isRefused(part_.polygon(p.handle)) &&
                          isRefused(part_.cellOf(p.handle));
      if (!isNone) return "a polygon that is unloaded is edited";
    }
    return "";
  }

  /// The same, or that it is not known.
  std::string ask() {
    for (int k = 0; k < 4; ++k) {
      const Point p = oracle::somePoint(whole_, random_), q = oracle::somePoint(whole_, random_);
      const Spot here = part_.at(p), there = whole_.at(p);
      const bool isSpot = here.where == Spot::Where::unloaded
                              ? !isLoaded(here.cell)
                              : here.where == there.where && here.polygon == there.polygon && here.cell == there.cell;
      if (!isSpot) return "at() is another one than in the whole world";
      if (!isSame(part_.nearest(p, 3), whole_.nearest(p, 3))) return "nearest() is another one than in the whole world";
      if (!isSame(part_.rayCast(p, q), whole_.rayCast(p, q))) return "rayCast() is another one than in the whole world";
    }
    return "";
  }
  template <class Answer>
  bool isSame(const Expected<Answer>& here, const Expected<Answer>& there) const {
    if (!here) return here.error().code == (there ? ErrorCode::unloaded : there.error().code);
    if (!there || !here->segment || !there->segment) return there && here->segment == there->segment;
    return oracle::outlineSegment(*part_.segment(here->segment)) ==
           oracle::outlineSegment(*whole_.segment(there->segment));
  }

  /// The same edits beside what is unloaded.
  std::string editLoaded() {
    constexpr std::array<LocalPoint, 3> kRamp{{{0, 0}, {kUnitsPerCell, 0}, {kUnitsPerCell, kUnitsPerCell}}};
    const CellRect r = cells_;
    for (int k = random_.below(4); k > 0; --k) {
      const std::int32_t i = random_.between(-1, 1), j = random_.between(-1, 1);
      const Cell cell{(random_.chance(50) ? r.min.i : r.max.i) + i, (random_.chance(50) ? r.min.j : r.max.j) + j};
      if (!isLoaded(cell) || !inRange(cell)) continue;
      const Block block = random_.below(3U);
      bool areAlike = false;
      if (random_.chance(30)) {
        areAlike = part_.clear(cell).value_or(99) == whole_.clear(cell).value_or(999);
      } else {
        const auto here = random_.chance(50) ? part_.add(cell, kRamp, block) : part_.add(cell, kUnitSquare, block);
        const bool isRamp = here && part_.polygon(*here)->vertices.size() == 3;
        if (!here) continue;
        const auto there = isRamp ? whole_.add(cell, kRamp, block) : whole_.add(cell, kUnitSquare, block);
        areAlike = there && *here == *there;
      }
      if (!areAlike) return "an edit beside what is unloaded comes to something else";
    }
    return "";
  }

  std::string comeBack() {
    random_.shuffle(chunks_);
    for (const Chunk& chunk : chunks_) {
      Chunk damaged = chunk;
      damaged[random_.below(damaged.size())] ^= std::byte{1};
      if (part_.reload(damaged) || part_.reload(std::span(chunk).first(chunk.size() - 1)))
        return "bytes that are damaged come back";
      const auto back = part_.reload(chunk);
      if (!back) return "a chunk does not come back: " + message(back.error());
      if (part_.reload(chunk)) return "a chunk comes back twice";
    }
    if (std::string wrong = commit(); !wrong.empty()) return wrong;
    return samePolygons(part_, whole_) ? "" : "the chunks that came back hold other polygons";
  }

  /// Across a mark of before; and forth again.
  std::string rollBack(const World& before, Mark mark) {
    part_.commit();
    const World after = part_;
    const Mark end = part_.mark();
    Follower follower(part_);
    if (!part_.rollBack(mark, Undone::keep)) return "a mark of before the unloading is lost";
    if (std::string wrong = follower.follow(part_, part_.changesOfRollBack()); !wrong.empty()) return wrong;
    if (part_.firstUnloaded(cells_) != after.firstUnloaded(cells_)) return "to roll back loads a chunk";
    const bool areLoaded = random_.chance(50);
    for (const Chunk& chunk : areLoaded ? chunks_ : std::vector<Chunk>())
      if (!part_.reload(chunk)) return "after a roll-back the newest bytes are refused";
    if (std::string wrong = follower.follow(part_, part_.commit()); !wrong.empty()) return wrong;
    if (areLoaded && !samePolygons(before, part_)) return "back before the edits there are other polygons";
    if (!part_.redo(end)) return "chunks that come and go end the redo";
    if (std::string wrong = follower.follow(part_, part_.changesOfRollBack()); !wrong.empty()) return wrong;
    if (areLoaded) return samePolygons(whole_, part_) ? "" : "forward again there are other polygons";
    const std::string wrong = differenceOf(after, part_);
    return wrong.empty() ? wrong : "forward to where chunks are unloaded: " + wrong;
  }

  std::string comeEmpty() {
    const auto count = part_.reloadEmpty(cells_);
    if (!count || *count != chunks_.size()) return "reloadEmpty() counts other chunks";
    for (const auto [i, j] : corners_)
      if (!whole_.clear(
              CellRect{{i, j}, {std::min(i + kChunkSide - 1, kMaxCell), std::min(j + kChunkSide - 1, kMaxCell)}}))
        return "a chunk can not be cleared";
    return samePolygons(part_, whole_) ? "" : "chunks that came back empty are not empty";
  }

  World part_, whole_;
  Random& random_;
  CellRect cells_;
  std::vector<Cell> corners_;  // of the chunks that went
  std::vector<Chunk> chunks_;
};

}  // namespace

std::string unloadSome(const World& world, Random& random) { return Beside(world, random).run(); }

}  // namespace lgs::fuzz
