#include "ground/ground.h"

#include "storage/held_bytes.h"

namespace lgs::detail {

void Ground::commit() {
  if (notes.areTaken()) [[unlikely]]
    notes.ofCommit();
  settleChanges();
  catalogue.collect();
}

void Ground::beginChunk(const Chunk& chunk) {
  if (notes.areTaken()) notes.ofNewChunk(chunk);
  settleAround(chunk);
}

std::uint64_t Ground::bytes() const { return Cells::bytes() + notes.bytes() + heldBytes(unsettled_, sleepy_); }

}  // namespace lgs::detail
