// Hashes of the ground: whether two worlds hold the same, and where they differ.
#include "bridge.h"

#include <lgs/hashes.h>

namespace lgs::web {

/// The hashes of a world. JavaScript says which world it is, in each call.
struct Hashed : Follower {
  GroundHashes hashes;
};

namespace {

void putRect(const CellRect& r) {
  for (const std::int32_t index : {r.min.i, r.min.j, r.max.i, r.max.j}) answer().push_back(index);
}
/// level, i0, j0, i1, j1, and the hash in two halves.
void putSquare(const HashedSquare& square) {
  answer().push_back(square.level);
  putRect(square.cells);
  for (const std::uint64_t half : {square.hash >> 32, square.hash & 0xffff'ffff})
    answer().push_back(static_cast<double>(half));
}

}  // namespace

LGS_EXPORT("hashes") Hashed* hashes(Bridge* bridge) {
  if (const auto done = bridge->world.followCells(true); !done)
    return refused(done.error(), static_cast<Hashed*>(nullptr));
  return new Hashed{{.moment = bridge->moment}, GroundHashes(bridge->world)};
}
LGS_EXPORT("freeHashes") void freeHashes(Hashed* hashed) { delete hashed; }

LGS_EXPORT("updateHashes") std::int32_t updateHashes(Hashed* hashed, const Bridge* bridge) {
  return hashed->follow(*bridge, [&] { return hashed->hashes.update(bridge->world, *bridge->last); });
}

LGS_EXPORT("wholeHash") void wholeHash(const Hashed* hashed) {
  answer().clear();
  putSquare(hashed->hashes.whole());
}

LGS_EXPORT("hashesIn")
std::size_t hashesIn(const Hashed* hashed, std::int32_t i0, std::int32_t j0, std::int32_t i1, std::int32_t j1,
                     std::int32_t level) {
  answer().clear();
  for (const HashedSquare& square : hashed->hashes.hashes({{i0, j0}, {i1, j1}}, level)) putSquare(square);
  return answer().size();
}

LGS_EXPORT("hashDifferences") std::size_t hashDifferences(const Hashed* a, const Hashed* b) {
  answer().clear();
  for (const CellRect& cells : differences(a->hashes, b->hashes)) putRect(cells);
  return answer().size();
}

}  // namespace lgs::web
