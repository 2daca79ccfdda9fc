#include "region.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace regions {

using lgs::Cell;
using lgs::CellRect;
using lgs::SegmentId;

namespace {

bool touch(const CellRect& a, const CellRect& b) {
  return a.min.i <= b.max.i + kHalo && b.min.i <= a.max.i + kHalo && a.min.j <= b.max.j + kHalo &&
         b.min.j <= a.max.j + kHalo;
}

}  // namespace

std::size_t Region::HashOfEnds::operator()(const Ends& ends) const {
  std::uint64_t hash = 0;
  for (const std::int64_t word : {ends.start.x, ends.start.y, ends.end.x, ends.end.y}) {
    hash = (hash ^ static_cast<std::uint64_t>(word)) * 0x9e37'79b9'7f4a'7c15U;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

Region::Region(Cutting cutting, int rank, lgs::PreserveRelation preserve)
    : cutting_(std::move(cutting)), rank_(rank), world_(std::move(preserve)) {
  const auto self = static_cast<std::size_t>(rank);
  const CellRect& region = cutting_[self];
  inner_ = {{region.min.i + kHalo, region.min.j + kHalo}, {region.max.i - kHalo, region.max.j - kHalo}};
  for (std::size_t other = 0; other < cutting_.size(); ++other)
    if (other != self && touch(region, cutting_[other])) neighbours_.push_back(other);
}

template <class Item>
void Region::tell(Cell cell, const Item& item, Outbox& out) const {
  for (const std::size_t other : neighbours_)
    if (needs(cutting_[other], cell)) append(out[other], item);
}

lgs::Expected<void> Region::play(const Edit& edit) {
  if (edit.kind == Edit::Kind::add) {
    const auto added = world_.add(edit.cell, edit.polygon, edit.block);
    return added ? lgs::Expected<void>() : tl::unexpected(added.error());
  }
  if (edit.kind == Edit::Kind::clear) {
    const auto cleared = world_.clear(edit.cell);
    return cleared ? lgs::Expected<void>() : tl::unexpected(cleared.error());
  }
  lgs::PolygonHandle handle;  // stays null, and is refused as a stale one, if there is no such polygon
  for (const lgs::PlacedPolygon& polygon : world_.polygons(edit.cell))
    if (std::ranges::equal(polygon.vertices, edit.polygon)) handle = polygon.handle;
  return world_.remove(handle);
}

lgs::Expected<void> Region::decide(const Edit& edit, Outbox& edits) {
  auto done = play(edit);
  if (done && !lgs::contains(inner_, edit.cell)) tell(edit.cell, edit, edits);
  return done;
}

void Region::follow(const Edit& edit) {
  [[maybe_unused]] const auto done = play(edit);
  assert(done);  // the owner made the same edit in the same cell
}

const OwnChanges& Region::commit(Outbox& names) {
  const lgs::Changes& all = world_.commit();
  changes_.removed.clear();
  changes_.added.clear();
  changes_.relinked.clear();
  for (const SegmentId id : all.removed) {
    if (!isOwn(id)) continue;
    own_[id.value] = false;
    changes_.removed.push_back(id);
    if (const auto gone = border_.find(id.value); gone != border_.end()) {
      tell(gone->second.cell, Naming{gone->second.ends, {}}, names);
      border_.erase(gone);
    }
  }
  // Names that are taken back come first: where a polygon took the place of an equal one, ends have got another id.
  own_.resize(world_.maxSegmentId() + std::size_t{1});
  for (const SegmentId id : all.added) {
    const lgs::Segment segment = *world_.segment(id);
    if (!lgs::contains(cutting_[static_cast<std::size_t>(rank_)], segment.cell)) continue;
    own_[id.value] = true;
    changes_.added.push_back(id);
    if (neighbours_.empty() || lgs::contains(inner_, segment.cell)) continue;
    const Ends ends{segment.start, segment.end};
    tell(segment.cell, Naming{ends, id}, names);
    border_.emplace(id.value, OnBorder{ends, segment.cell});
  }
  for (const SegmentId id : all.relinked)
    if (isOwn(id)) changes_.relinked.push_back(id);
  return changes_;
}

void Region::learn(int from, const Message& names) {
  for (const Naming& naming : readNamings(names)) {
    if (naming.id)
      neighbour_.insert_or_assign(naming.ends, Name{from, naming.id});
    else
      neighbour_.erase(naming.ends);
  }
}

Name Region::nameOf(SegmentId id) const {
  if (!id) return {};
  if (isOwn(id)) return {rank_, id};
  const lgs::Segment segment = *world_.segment(id);
  const auto known = neighbour_.find({segment.start, segment.end});
  return known == neighbour_.end() ? Name{} : known->second;
}

}  // namespace regions
