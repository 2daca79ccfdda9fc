#include "ground/ground.h"

#include "storage/vectors.h"

namespace lgs::detail {

void Ground::endCommit() {
  clearChanges();
  catalogue.collect();
}

void Ground::set(CellAt at, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons) {
  put(at, wordFor(content, lastSerial, polygons), polygons.empty() ? 0 : polygons[0].block, catalogue.facts(content));
}

/// The content is in use once more.
CellWord Ground::wordFor(ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons) {
  catalogue.use(content);
  const bool fits = fitsWord(lastSerial, polygons);
  return fits ? wordOf(content, lastSerial) : makeList(content, lastSerial, polygons);
}

void Ground::beginChunk(const Chunk& chunk) {
  if (journal.isOn()) {
    Note& note = journal.add(Thing::chunk, chunk.index);
    note.value = static_cast<std::uint32_t>(chunk.ci);
    note.block = static_cast<std::uint32_t>(chunk.cj);
  }
  refreshAround(chunk.index);
}

std::uint64_t Ground::bytes() const {
  return Cells::bytes() + journal.bytes() + heldBytes(streamed_, rims_, spare_, sleepy_);
}

}  // namespace lgs::detail
