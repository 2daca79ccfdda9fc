#include "arrangement.h"

namespace lgs::brush {

List<Segment> groupSegments(const Ground& ground) {
  const List<Side>& sides = ground.sides;
  List<Segment> segments;
  segments.reserve(sides.size());
  for (std::size_t k = 0; k < sides.size();) {
    const Side& first = sides[k];
    Segment segment{first.low, first.high, first.low, first.high, {}, true};
    for (; k < sides.size() && !(first < sides[k]); ++k) {
      const Side& s = sides[k];
      if (ground.groups[s.area] != kNoGroup) {
        const Sum sum{0, static_cast<std::int64_t>(s.area) + 1};
        segment.sum += s.isLeft ? sum : -sum;
      } else {
        segment.bends = false;
      }
    }
    if (segment.sum != Sum{}) segments.push_back(segment);
  }
  return segments;
}

std::optional<Arrangement> arrangementOf(const Ground& ground, PieceSpan region) {
  Arrangement result{groupSegments(ground), ground.known, {}};
  for (std::size_t k = 0; k < ground.polygons.size(); ++k)
    result.staying.push_back(ground.groups[k] == kNoGroup ? &ground.polygons[k].ring : nullptr);
  result.segments.reserve(result.segments.size() + region.size());
  for (const Piece& p : region) result.segments.push_back({p.a, p.b, p.start, p.end, {1, 0}, true});
  if (!addCrossings(result.segments, result.hot)) return std::nullopt;
  normalize(result.hot);
  return result;
}

}  // namespace lgs::brush
