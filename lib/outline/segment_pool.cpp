#include "outline/segment_pool.h"

#include <cstdlib>

namespace lgs::detail {

void SegmentPool::addPage() {
  if (top_ / kPage < pages_.size()) return;  // it is still there, after putBack()
  if (top_ > kMaxSegment) std::abort();      // with 56 GiB of segments, as if memory had run out
  pages_.add();
}

}  // namespace lgs::detail
