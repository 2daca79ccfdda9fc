// Snapshots: a world as bytes, and a world from bytes. See World::save() and World::load().
// docs/internals/snapshot.md has the format, byte by byte.
#pragma once

#include <lgs/lattice.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <type_traits>

namespace lgs {

/// Takes the bytes of a snapshot in order, in pieces of at most 4,096. It must not change the world. An empty
/// one is not called.
using ByteSink = std::function<void(std::span<const std::byte>)>;

/// Takes the bytes of one chunk of 32×32 cells, all at once. `corner` is its lower-left cell. It must not change the
/// world.
using ChunkSink = std::function<void(Cell corner, std::span<const std::byte>)>;

/// Why a snapshot is refused, and where.
struct SnapshotError {
  /// What is wrong with it.
  enum class What : std::uint64_t {
    notASnapshot,    ///< it does not begin as one
    unknownVersion,  ///< it has a version of the format that this library does not know
    cut,             ///< it ends too early
    damaged,         ///< its checksum does not fit
    tooLong,         ///< bytes follow its end
    relation,        ///< it was saved with another preserve relation, as far as its cells show
    badNumber,       ///< a number is out of its range
    badPolygon,      ///< a polygon is none, or two of one cell overlap
    badSegments,     ///< the ids of the segments are not those of this world's segments, or one occurs twice
    capacity,        ///< more than the engine can hold
    loaded,          ///< of World::reload(): the chunk is not unloaded
    otherBytes,      ///< of World::reload(): not the bytes with which the chunk was unloaded last
  };
  What what{};                ///< the reason
  std::uint64_t offset = 0;   ///< the byte at which it was noticed
  std::uint32_t version = 0;  ///< of the format, if it is unknown
  std::uint32_t newest = 0;   ///< then: the newest version that is read; the oldest is 1
  friend constexpr bool operator==(const SnapshotError&, const SnapshotError&) = default;
};
static_assert(std::has_unique_object_representations_v<SnapshotError>);  // no padding: error.h says why

/// A whole sentence.
std::string message(const SnapshotError& error);

}  // namespace lgs
