// Law 5: a commit changes only segments that lie in, or end on the rim of, an edited cell, and links at that rim's
// vertices.
#include "oracle/check/laws/list.h"
#include "oracle/reference/vector.h"

#include <algorithm>
#include <map>
#include <utility>

namespace lgs::oracle {
namespace {

// The cells that a point is in; those on whose rim it is, too.
CellSet cellsAt(Point p) {
  const auto i = static_cast<std::int32_t>(cellIndex(p.x)), j = static_cast<std::int32_t>(cellIndex(p.y));
  const bool isOnSide = p.x % kUnitsPerCell == 0, isOnFloor = p.y % kUnitsPerCell == 0;
  CellSet cells{{i, j}};
  if (isOnSide) cells.insert({i - 1, j});
  if (isOnFloor) cells.insert({i, j - 1});
  if (isOnSide && isOnFloor) cells.insert({i - 1, j - 1});
  return cells;
}

class LocalityLaw : public Law {
 public:
  Found afterCommit(Seen& seen) override {
    std::map<SegmentId, Segment> now;
    const World& world = seen.world();
    for (const SegmentId id : world.segments()) now.emplace(id, *world.segment(id));
    const auto before = std::exchange(before_, now);
    if (seen.isAnywhere) return std::nullopt;
    const auto isEdited = [&](Cell cell) { return seen.edited.contains(cell); };
    const auto isNear = [&](const Segment& s) {
      return std::ranges::any_of(cellsAt(s.start), isEdited) || std::ranges::any_of(cellsAt(s.end), isEdited);
    };
    const auto isAt = [&](const Segment& s) {
      const CellSet there = cellsAt(s.end);
      return std::ranges::any_of(cellsAt(s.start), [&](Cell cell) { return isEdited(cell) && there.contains(cell); });
    };
    const Changes& changes = seen.library->changes();
    const auto lies = [](const auto& is, const std::map<SegmentId, Segment>& in) {
      return [&is, &in](SegmentId id) { return in.contains(id) && is(in.at(id)); };
    };
    const char* what = nullptr;
    if (!std::ranges::all_of(changes.removed, lies(isAt, before))) what = "removed";
    if (!std::ranges::all_of(changes.added, lies(isAt, now))) what = "added";
    if (!std::ranges::all_of(changes.relinked, lies(isNear, now))) what = "relinked";
    // A link can change where the ghost does not, which no list says.
    for (const auto& [id, old] : before) {
      if (isNear(old)) continue;
      const auto s = now.find(id);
      if (s == now.end() || s->second.predecessor != old.predecessor || s->second.successor != old.successor)
        what = "another one";
    }
    if (what == nullptr) return std::nullopt;
    return seen.mismatch(Mismatch::Kind::changes, std::string("a segment far from the edits is ") + what);
  }

 private:
  std::map<SegmentId, Segment> before_;
};

}  // namespace

std::unique_ptr<Law> laws::locality() { return std::make_unique<LocalityLaw>(); }

}  // namespace lgs::oracle
