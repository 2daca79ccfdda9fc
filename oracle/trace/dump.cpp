#include "oracle/trace/dump.h"

#include <fmt/format.h>
#include <algorithm>

namespace lgs::oracle {

OutlineSegment outlineSegment(const Segment& segment) {
  OutlineSegment out{segment.start, segment.end, segment.block, {}, {}};
  if (segment.predecessor) out.ghost1 = segment.ghost1;
  if (segment.successor) out.ghost2 = segment.ghost2;
  return out;
}

Outline outlineOf(const World& world) {
  Outline outline;
  for (const SegmentId id : world.segments()) {
    if (const auto segment = world.segment(id)) outline.push_back(outlineSegment(*segment));
  }
  std::sort(outline.begin(), outline.end());
  return outline;
}

std::string dump(const Outline& outline) {
  std::string text;
  const auto point = [&](const Point& p) { text += fmt::format(" {} {}", p.x, p.y); };
  const auto ghost = [&](const std::optional<Point>& p) {
    if (p) {
      point(*p);
    } else {
      text += " - -";
    }
  };
  for (const OutlineSegment& s : outline) {
    text += "segment";
    point(s.start);
    point(s.end);
    ghost(s.ghost1);
    ghost(s.ghost2);
    text += fmt::format(" {}\n", s.block);
  }
  return text;
}

}  // namespace lgs::oracle
