#include "oracle/draw/links.h"

#include "oracle/draw/distinct.h"

#include <algorithm>
#include <iterator>

namespace lgs::oracle::drawing {

Links linksOf(const Outline& outline) {
  std::vector<Link> toPredecessor;
  std::vector<Link> toSuccessor;
  for (const OutlineSegment& s : outline) {
    if (s.ghost1) toPredecessor.push_back({*s.ghost1, s.start, s.end});
    if (s.ghost2) toSuccessor.push_back({s.start, s.end, *s.ghost2});
  }
  makeDistinct(toPredecessor);
  makeDistinct(toSuccessor);
  Links links;
  std::set_intersection(toPredecessor.begin(), toPredecessor.end(), toSuccessor.begin(), toSuccessor.end(),
                        std::back_inserter(links.mutual));
  std::set_symmetric_difference(toPredecessor.begin(), toPredecessor.end(), toSuccessor.begin(), toSuccessor.end(),
                                std::back_inserter(links.oneSided));
  return links;
}

}  // namespace lgs::oracle::drawing
