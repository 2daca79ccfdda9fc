#include "outline/segment_pool.h"

#include <algorithm>
#include <cstdlib>

namespace lgs::detail {

void SegmentPool::addPage() {
  if (top_ / kPage < pages_.size()) {  // it is still there, after setLength()
    bringBack(top_ / kPage);
  } else {
    if (top_ > kMaxSegment) std::abort();  // with 56 GiB of segments, as if memory had run out
    pages_.add();
    if (top_ == kNoSegment)
      pages_[0][kNoSegment] = {};  // so that a dangling link, should there be one, can be followed
  }
  if (top_ == kNoSegment) ++top_;
}

void SegmentPool::bringBack(std::size_t page) {
  if (!pages_.has(page)) pages_.make(page).fill(SegmentRecord{});
}

void SegmentPool::giveBackPages(std::size_t live) {
  const std::size_t there = (pages_.size() - pages_.missing()) * kPage, dead = there - live;
  dead_ = std::min(dead_, dead);
  if (dead < there / 2 || dead - dead_ < there / 8) return;
  dead_ = dead;
  for (std::size_t k = 1; k < maxId() / kPage; ++k) {
    if (!pages_.has(k) || std::ranges::any_of(pages_[k], [](const SegmentRecord& s) { return s.cellRef != 0; }))
      continue;
    pages_.drop(k);
    dead_ -= kPage;
  }
}

}  // namespace lgs::detail
