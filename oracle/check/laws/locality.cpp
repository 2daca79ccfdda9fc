// Law 5: a commit changes only segments that lie in, or end on the rim of, an edited cell, and links at that rim's
// vertices.
#include "oracle/check/laws/list.h"
#include "oracle/reference/vector.h"

#include <algorithm>
#include <utility>
#include <vector>

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
    std::vector<Segment> now;  // by id, in which order the world lists them (law 6)
    const World& world = seen.world();
    for (const SegmentId id : world.segments()) now.push_back(*world.segment(id));
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
    const auto lies = [](const auto& is, const std::vector<Segment>& in) {
      return [&is, &in](SegmentId id) {
        const Segment* const s = find(in, id);
        return s != nullptr && is(*s);
      };
    };
    const char* what = nullptr;
    if (!std::ranges::all_of(changes.removed, lies(isAt, before))) what = "removed";
    if (!std::ranges::all_of(changes.added, lies(isAt, now))) what = "added";
    if (!std::ranges::all_of(changes.relinked, lies(isNear, now))) what = "relinked";
    // A link can change where the ghost does not, which no list says.
    for (const Segment& old : before) {
      const Segment* const s = find(now, old.id);
      const bool isSame = s != nullptr && s->predecessor == old.predecessor && s->successor == old.successor;
      if (!isSame && !isNear(old)) what = "another one";
    }
    if (what == nullptr) return std::nullopt;
    return seen.mismatch(Mismatch::Kind::changes, std::string("a segment far from the edits is ") + what);
  }

 private:
  static const Segment* find(const std::vector<Segment>& in, SegmentId id) {
    const auto at = std::ranges::lower_bound(in, id, {}, &Segment::id);
    return at != in.end() && at->id == id ? &*at : nullptr;
  }

  std::vector<Segment> before_;
};

}  // namespace

std::unique_ptr<Law> laws::locality() { return std::make_unique<LocalityLaw>(); }

}  // namespace lgs::oracle
