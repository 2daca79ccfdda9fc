// Law 5 across worlds: who has the polygons of a rectangle and of the cells that touch it has all that the whole world
// says of the rectangle. So a world can be cut among processes (docs/guide.md, "Large worlds").
#include "oracle/trace/model.h"
#include "proptests/support/law.h"
#include "proptests/support/traces.h"
#include "proptests/support/worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace lgs::test {
namespace {

using oracle::Call;
using SegmentEnds =
    std::pair<Point, Point>;  // no two segments of a world have the same: what is solid on the left is one

/// What is known of a segment without ids. Links are named by the ends of the segments that they lead to.
struct RegionRow {
  Block block = 0;
  std::vector<LocalPoint> polygon;
  std::optional<SegmentEnds> predecessor, successor;
  friend bool operator==(const RegionRow&, const RegionRow&) = default;
};

/// The segments of a world that belong to cells of a rectangle, and what its commits tell of them.
class RegionView {
 public:
  RegionView(const PreserveRelation& preserve, const CellRect& rect) : world_(preserve), rect_(rect) {}

  void play(const Call& edit) {
    if (edit.kind == Call::Kind::add) {
      const auto& [cell, block, vertices] = edit.polygon();
      const auto handle = world_.add(cell, vertices, block);
      failUnless(handle.has_value(), "a good edit is refused");
      handles_[edit.name()] = *handle;
    } else if (const auto found = handles_.find(edit.name()); found != handles_.end()) {
      failUnless(world_.remove(found->second).has_value(), "a good edit is refused");
      handles_.erase(found);
    }
  }

  void commit() {
    const Changes& changes = world_.commit();
    listed_.clear();
    const auto list = [&](int what, std::span<const SegmentId> ids) {
      for (const SegmentId id : ids)
        if (const auto found = ends_.find(id); found != ends_.end()) listed_.emplace_back(what, found->second);
    };
    list(0, changes.removed);
    ends_.clear();
    rows_.clear();
    for (const SegmentId id : world_.segments()) {
      const Segment s = *world_.segment(id);
      if (!contains(rect_, s.cell)) continue;
      const auto vertices = world_.polygon(s.polygon).value().vertices;
      ends_[id] = {s.start, s.end};
      rows_[ends_[id]] = {s.block, {vertices.begin(), vertices.end()}, endsOf(s.predecessor), endsOf(s.successor)};
    }
    list(1, changes.added);
    list(2, changes.relinked);
    std::ranges::sort(listed_);
  }

  bool operator==(const RegionView& other) const { return rows_ == other.rows_ && listed_ == other.listed_; }

 private:
  std::optional<SegmentEnds> endsOf(SegmentId id) const {
    if (!id) return {};
    const Segment s = *world_.segment(id);
    return SegmentEnds{s.start, s.end};
  }

  World world_;
  CellRect rect_;
  std::map<std::string, PolygonHandle> handles_;
  std::map<SegmentId, SegmentEnds> ends_;
  std::map<SegmentEnds, RegionRow> rows_;
  std::vector<std::tuple<int, SegmentEnds>> listed_;
};

CellRect regionWithin(const CellRect& all, Chance& chance) {
  const auto within = [&](std::int32_t first, std::int32_t last) {
    return static_cast<std::int32_t>(first + chance.below(std::int64_t{last} - first + 1));
  };
  const Cell a{within(all.min.i, all.max.i), within(all.min.j, all.max.j)};
  const Cell b{within(a.i, all.max.i), within(a.j, all.max.j)};
  return {a, b};
}

LGS_LAW(Regions, HaveTheSegmentsOfTheWholeWorld, 1'000, (const GoodTrace& trace, Chance chance)) {
  if (isEmpty(boundsOf(trace))) return;
  const CellRect rect = regionWithin(boundsOf(trace), chance);
  const CellRect halo{{rect.min.i - 1, rect.min.j - 1}, {rect.max.i + 1, rect.max.j + 1}};
  RegionView whole(oracle::relationOf(trace.preserve), rect), region(oracle::relationOf(trace.preserve), rect);
  const auto meet = [&] {
    whole.commit();
    region.commit();
    failUnless(whole == region, "a region with its halo shows something else than the whole world");
  };
  for (const Call& edit : trace.calls) {
    if (edit.kind == Call::Kind::commit) {
      meet();
      continue;
    }
    whole.play(edit);
    if (edit.kind == Call::Kind::remove || contains(halo, edit.polygon().cell)) region.play(edit);
  }
  meet();
}

}  // namespace
}  // namespace lgs::test
