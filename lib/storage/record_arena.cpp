#include "storage/record_arena.h"

#include <cstdlib>

namespace lgs::detail {

void RecordArena::addPage() {
  if (pages_.size() == kMaxPages) std::abort();  // with 8 GiB of records, as if memory had run out
  pages_.add();
  used_ = pages_.size() == 1 ? 1 : 0;  // reference 0 names no record
}

}  // namespace lgs::detail
