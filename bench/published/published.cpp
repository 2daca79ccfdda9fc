#include "bench/published/published.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace lgs::bench {
namespace {

// Section 5.2: "only for equality comparisons".
constexpr float kEpsilon = 1e-3f;

bool vec2Equals(Vec2 a, Vec2 b) { return std::abs(a.x - b.x) < kEpsilon && std::abs(a.y - b.y) < kEpsilon; }

Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }

bool isInteger(float v) { return v == std::floor(v); }

/// The angle from one direction to the other, normalised to [0, 2π).
double directionalAngle(Vec2 from, Vec2 to, bool clockwise) {
  const double a = std::atan2(from.y, from.x), b = std::atan2(to.y, to.x);
  const double angle = clockwise ? a - b : b - a;
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// Section 3.2. Silent: how near to 0 is "≈ 0". Here it is the one ε that the article names.
PublishedSegment* findBestMatch(Vec2 targetDir, std::span<PublishedSegment* const> candidates, Vec2 vertex,
                                bool clockwise) {
  PublishedSegment* best = nullptr;
  double minAngle = std::numeric_limits<double>::infinity();
  for (PublishedSegment* cand : candidates) {
    const Vec2 candFarPt = vec2Equals(cand->start, vertex) ? cand->end : cand->start;
    const double angle = directionalAngle(targetDir, candFarPt - vertex, clockwise);
    if (angle < double{kEpsilon}) continue;  // skip self-match
    if (angle < minAngle) {
      minAngle = angle;
      best = cand;
    }
  }
  return best;
}

}  // namespace

// Section 5.2: "by reinterpreting their Float32 bit patterns".
Published::Hash Published::hash(Vec2 v) {
  return Hash{std::bit_cast<std::uint32_t>(v.x)} << 32 | std::bit_cast<std::uint32_t>(v.y);
}

Published::Hash Published::hash(Cell cell) {
  return Hash{static_cast<std::uint32_t>(cell.i)} << 32 | static_cast<std::uint32_t>(cell.j);
}

// Section 4.1. "If both endpoints lie on a cell boundary" is true of a ramp's diagonal too, but the diagonal is neither
// horizontal nor vertical. Silent: what it is then. Here it is an interior edge, as the article's RAMP benchmark needs.
Published::Place Published::placeOf(Cell cell, Vec2 start, Vec2 end) {
  if (start.y == end.y && isInteger(start.y)) {
    const Cell boundary{cell.i, static_cast<std::int32_t>(start.y)};
    return {&horizontalBoundarySegs_, &resolvedHorizontal_, &dirtyHorizontal_, hash(boundary)};
  }
  if (start.x == end.x && isInteger(start.x)) {
    const Cell boundary{static_cast<std::int32_t>(start.x), cell.j};
    return {&verticalBoundarySegs_, &resolvedVertical_, &dirtyVertical_, hash(boundary)};
  }
  return {};
}

PublishedSegment* Published::make(const PublishedSegment& segment) {
  if (free_.empty()) return &pool_.emplace_back(segment);
  PublishedSegment* out = free_.back();
  free_.pop_back();
  *out = segment;
  return out;
}

void Published::insertIntoManifold(PublishedSegment* segment) {
  for (const Vec2 vertex : {segment->start, segment->end}) {
    vertexManifold_[hash(vertex)].push_back(segment);
    dirtyVertices_.insert(hash(vertex));
  }
}

void Published::removeFromManifold(PublishedSegment* segment) {
  for (const Vec2 vertex : {segment->start, segment->end}) {
    const auto at = vertexManifold_.find(hash(vertex));
    if (at == vertexManifold_.end()) continue;  // far away floats are coarse, so both ends can be one vertex
    std::erase(at->second, segment);
    if (at->second.empty()) vertexManifold_.erase(at);
    dirtyVertices_.insert(hash(vertex));
  }
  drop(segment);
}

void Published::removeResolved(SegmentMap& resolved, Hash boundaryHash) {
  const auto at = resolved.find(boundaryHash);
  if (at == resolved.end()) return;
  for (PublishedSegment* segment : at->second) removeFromManifold(segment);
  resolved.erase(at);
}

void Published::add(Cell cell, std::span<const Vec2> polygon, Block block) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 start = polygon[i], end = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    PublishedSegment* segment = make({start, end, {}, {}, hash(cell), block});
    const Place place = placeOf(cell, start, end);
    if (place.boundary) {
      (*place.boundary)[place.cell].push_back(segment);
      place.dirty->insert(place.cell);
      removeResolved(*place.resolved, place.cell);
    } else {
      insertIntoManifold(segment);
    }
  }
}

void Published::remove(Cell cell, std::span<const Vec2> polygon, Block block) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 start = polygon[i], end = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const Place place = placeOf(cell, start, end);
    const auto isIt = [&](const PublishedSegment* s) {
      return s->cellHash == hash(cell) && s->ogBlock == block && vec2Equals(s->start, start) && vec2Equals(s->end, end);
    };
    SegmentMap& map = place.boundary ? *place.boundary : vertexManifold_;
    const auto at = map.find(place.boundary ? place.cell : hash(start));
    if (at == map.end()) continue;
    const auto segment = std::find_if(at->second.begin(), at->second.end(), isIt);
    if (segment == at->second.end()) continue;
    if (place.boundary) {
      drop(*segment);
      at->second.erase(segment);
      if (at->second.empty()) map.erase(at);
      place.dirty->insert(place.cell);
      removeResolved(*place.resolved, place.cell);
    } else {
      removeFromManifold(*segment);
    }
  }
}

// Section 3.1, resolveHorizontalBoundary(). The article calls the vertical case "identical in concept", so `axis` says
// which of the two it is.
void Published::resolveBoundary(const SegmentMap& boundary, SegmentMap& resolved, Hash boundaryHash,
                                float Vec2::*axis) {
  const auto at = boundary.find(boundaryHash);
  if (at == boundary.end()) return;
  const Segments& segs = at->second;
  const auto isForward = [&](const PublishedSegment* s) { return s->start.*axis < s->end.*axis; };

  // Special cases: nothing to cancel.
  if (segs.size() == 1) {
    PublishedSegment* copy = make(*segs[0]);
    insertIntoManifold(copy);
    resolved[boundaryHash] = {copy};
    return;
  }
  if (segs.size() == 2 && vec2Equals(segs[0]->start, segs[1]->end) && vec2Equals(segs[0]->end, segs[1]->start)) return;

  // Build sweep events.
  candidates_.clear();
  for (const PublishedSegment* segment : segs) {
    const bool forward = isForward(segment);
    candidates_.push_back({segment->start.*axis, forward, forward ? +1 : -1});
    candidates_.push_back({segment->end.*axis, forward, forward ? -1 : +1});
  }
  std::sort(candidates_.begin(), candidates_.end(), [](auto& a, auto& b) { return a.val < b.val; });

  // Silent: about which two blocks shouldPreserve is asked. Here it is the first of each direction.
  const auto up = std::find_if_not(segs.begin(), segs.end(), isForward);
  const auto down = std::find_if(segs.begin(), segs.end(), isForward);
  const bool preserved =
      shouldPreserve_ && up != segs.end() && down != segs.end() && shouldPreserve_((*up)->ogBlock, (*down)->ogBlock);

  // Sweep. Silent: which polygon owns a result. Here it is that of the first segment.
  int activeUp = 0, activeDown = 0;
  Segments results;
  const auto push = [&](float from, float to) {
    PublishedSegment result{segs[0]->start, segs[0]->start, {}, {}, segs[0]->cellHash, segs[0]->ogBlock};
    result.start.*axis = from;
    result.end.*axis = to;
    results.push_back(make(result));
  };
  for (std::size_t i = 0; i + 1 < candidates_.size(); ++i) {
    const Candidate &curr = candidates_[i], &next = candidates_[i + 1];
    (curr.forward ? activeDown : activeUp) += curr.delta;
    if (next.val == curr.val) continue;  // zero-width interval
    const bool overlapping = activeUp > 0 && activeDown > 0 && !preserved;
    if (activeUp > 0 && !overlapping) push(next.val, curr.val);
    if (activeDown > 0 && !overlapping) push(curr.val, next.val);
  }
  for (PublishedSegment* result : results) insertIntoManifold(result);
  if (!results.empty()) resolved[boundaryHash] = std::move(results);
}

// Section 3.2, assignGhostVertices().
void Published::assignGhostVertices(Hash vertexHash) {
  const auto at = vertexManifold_.find(vertexHash);
  if (at == vertexManifold_.end()) return;
  const Vec2 vertex{std::bit_cast<float>(static_cast<std::uint32_t>(vertexHash >> 32)),
                    std::bit_cast<float>(static_cast<std::uint32_t>(vertexHash))};
  outgoing_.clear();
  incoming_.clear();
  for (PublishedSegment* seg : at->second) {
    if (vec2Equals(seg->start, vertex)) outgoing_.push_back(seg);
    if (vec2Equals(seg->end, vertex)) incoming_.push_back(seg);
  }
  for (PublishedSegment* seg : at->second) {
    const bool isOutgoing = vec2Equals(seg->start, vertex);
    const Segments& candidates = isOutgoing ? incoming_ : outgoing_;
    if (candidates.empty()) continue;
    const Vec2 farPt = isOutgoing ? seg->end : seg->start;
    const PublishedSegment* best = findBestMatch(farPt - vertex, candidates, vertex, isOutgoing);
    if (!best) continue;
    (isOutgoing ? seg->ghost1 : seg->ghost2) = isOutgoing ? best->start : best->end;
  }
}

void Published::compute() {
  for (const Hash boundary : dirtyHorizontal_)
    resolveBoundary(horizontalBoundarySegs_, resolvedHorizontal_, boundary, &Vec2::x);
  for (const Hash boundary : dirtyVertical_)
    resolveBoundary(verticalBoundarySegs_, resolvedVertical_, boundary, &Vec2::y);
  for (const Hash vertex : dirtyVertices_) assignGhostVertices(vertex);
  for (HashSet* dirty : {&dirtyHorizontal_, &dirtyVertical_, &dirtyVertices_})
    sets_ == Sets::cleared ? dirty->clear() : HashSet().swap(*dirty);
}

}  // namespace lgs::bench
