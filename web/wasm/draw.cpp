// What is drawn: lines along the outline, and which cells look different after a commit.
#include "bridge.h"

namespace lgs::web {
namespace {

constexpr std::uint32_t kNone = 0;

/// Joins segments that follow each other. A vertex where the line goes straight on is left out.
class Lines {
 public:
  Lines(const World& world, const std::vector<SegmentId>& ids) {
    placeOf().resize(std::size_t{world.maxSegmentId()} + 1, kNone);
    segments_.reserve(ids.size());
    for (const SegmentId id : ids) {
      segments_.push_back(*world.segment(id));
      placeOf()[id.value] = static_cast<std::uint32_t>(segments_.size());
    }
    isDone_.resize(ids.size());
  }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;
  ~Lines() {
    for (const Segment& s : segments_) placeOf()[s.id.value] = kNone;
  }

  /// For each line the number of its vertices, and these in cells.
  void put() {
    for (const Segment& s : segments_)
      if (placeOf()[s.predecessor.value] == kNone) putFrom(s.id);
    for (const Segment& s : segments_)
      if (!isDone_[placeOf()[s.id.value] - 1]) putFrom(s.id);  // closed ones, and behind a link that is not mutual
  }

 private:
  /// By the value of its id: the place of a segment among those here, from 1. Between uses all are `kNone`.
  static std::vector<std::uint32_t>& placeOf() {
    static std::vector<std::uint32_t> places(1, kNone);
    return places;
  }

  void putFrom(SegmentId first) {
    line_ = {segments_[placeOf()[first.value] - 1].start};
    for (std::uint32_t at = placeOf()[first.value]; at != kNone && !isDone_[at - 1];) {
      isDone_[at - 1] = true;
      const Segment& s = segments_[at - 1];
      goTo(s.end, {s.end.x - s.start.x, s.end.y - s.start.y});
      at = placeOf()[s.successor.value];
    }
    answer().push_back(static_cast<double>(line_.size()));
    for (const Point p : line_) answer().insert(answer().end(), {cellsOf(p.x), cellsOf(p.y)});
  }

  /// A segment is within a cell, so these are small numbers.
  void goTo(Point end, Point along) {
    const Point u = along_;
    const bool isStraight = u.x * along.y == u.y * along.x && u.x * along.x + u.y * along.y > 0;
    along_ = along;
    if (line_.size() >= 2 && isStraight)
      line_.back() = end;
    else
      line_.push_back(end);
  }

  std::vector<Segment> segments_;
  std::vector<bool> isDone_;
  std::vector<Point> line_;
  Point along_;  // of the last segment
};

}  // namespace

/// The lines along the segments of a rectangle of cells.
LGS_EXPORT("lines")
std::size_t lines(const Bridge* bridge, std::int32_t i0, std::int32_t j0, std::int32_t i1, std::int32_t j1) {
  answer().clear();
  Lines(bridge->world, bridge->world.segments(CellRect{{i0, j0}, {i1, j1}})).put();
  return answer().size();
}

LGS_EXPORT("followCells") std::int32_t followCells(Bridge* bridge) {
  const auto done = bridge->world.followCells(true);
  return done ? 1 : refused(done.error(), 0);
}

/// i, j of each cell that the last commit or roll-back changed.
LGS_EXPORT("changedCells") std::size_t changedCells(const Bridge* bridge) {
  answer().clear();
  for (const CellChange& change : bridge->world.cellChanges())
    answer().insert(answer().end(), {static_cast<double>(change.cell.i), static_cast<double>(change.cell.j)});
  return answer().size();
}

}  // namespace lgs::web
