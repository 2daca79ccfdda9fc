// A world from bytes, none of which is believed. docs/snapshot.md has the format; save.cpp writes it.
//
// What follows from the polygons is worked out anew: the ends, owners and links of the segments. The file gives their
// ids, which depend on history.
#include "geometry/sort.h"
#include "linking.h"
#include "look.h"
#include "snapshot_bytes.h"
#include "world_impl.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace lgs {
namespace {

using detail::CellAt;
using detail::Chunk;
using detail::ContentId;
using detail::PolygonId;
using detail::RunReader;
using detail::SnapshotReader;
using What = SnapshotError::What;

constexpr std::size_t kHead = detail::kSnapshotMagic.size() + 1;  // letters, version
constexpr std::size_t kTail = 4;                                  // checksum

class Load {
 public:
  Load(World::Impl& world, std::span<const std::byte> bytes) : world_(world), in_(bytes) {}

  std::optional<SnapshotError> run() {
    if ((in_.byte() != 0) != static_cast<bool>(world_.preserve)) in_.fail(What::relation);
    polygons();
    contents();
    shapes();
    chunks();
    segments();
    if (in_.left() != 0) in_.fail(What::tooLong);
    if (in_.failed()) return in_.error();
    link();
    return std::nullopt;
  }

 private:
  void polygons() {
    const std::size_t count = in_.count(~std::uint64_t{0});
    std::vector<LocalPoint> vertices;
    for (std::size_t k = 0; k < count && !in_.failed(); ++k) {
      vertices.resize(in_.count(kMaxVerticesPerCell));
      for (LocalPoint& v : vertices) {
        v.x = static_cast<std::int32_t>(in_.number(kUnitsPerCell));
        v.y = static_cast<std::int32_t>(in_.number(kUnitsPerCell));
      }
      if (in_.failed()) return;
      const auto id = world_.catalogue.internPolygon(vertices);
      // save() writes each polygon once, so each is new here, and gets the next number.
      if (!id || *id != polygons_.size()) return in_.fail(What::badPolygon);
      polygons_.push_back(*id);
    }
  }

  /// Polygons by number, as one cell may hold them.
  const std::vector<PolygonId>& list() {
    list_.resize(in_.count(kMaxPolygonsPerCell));
    for (PolygonId& id : list_) id = static_cast<PolygonId>(in_.number(polygons_.size()));
    for (const PolygonId id : list_)
      if (id >= polygons_.size()) in_.fail(What::badNumber);
    return list_;
  }

  void contents() {
    contents_.push_back(detail::kEmptyContent);
    const std::size_t count = in_.count(detail::kMaxContent);
    std::vector<std::pair<detail::Slot, detail::Slot>> preserved;
    for (std::size_t k = 0; k < count && !in_.failed(); ++k) {
      const std::vector<PolygonId>& polygons = list();
      preserved.resize(in_.count(kMaxPolygonsPerCell * kMaxPolygonsPerCell));
      for (auto& [a, b] : preserved) {
        a = static_cast<detail::Slot>(in_.number(kMaxPolygonsPerCell));
        b = static_cast<detail::Slot>(in_.number(kMaxPolygonsPerCell));
      }
      if (in_.failed()) return;
      if (polygons.empty() || !isIncreasing(polygons) || !isIncreasing(preserved)) return in_.fail(What::badNumber);
      const auto content = world_.catalogue.internContent(polygons, {}, preserved);
      if (!content) return in_.fail(content.error().code == ErrorCode::capacity ? What::capacity : What::badPolygon);
      // Only an overlap that is there can be preserved, and only by a relation.
      const auto& contacts = world_.catalogue.content(*content).contacts;
      if (!std::ranges::includes(contacts, preserved) || (!preserved.empty() && !world_.preserve))
        return in_.fail(What::badNumber);
      contents_.push_back(*content);
    }
  }

  void shapes() {
    const std::size_t count = in_.count(~std::uint64_t{0});
    for (std::size_t k = 0; k < count && !in_.failed(); ++k) {
      const std::vector<PolygonId>& polygons = list();
      if (in_.failed()) return;
      const auto shape = world_.catalogue.internShape(polygons);
      if (!shape || shape->value != k + 1) return in_.fail(What::badPolygon);
    }
  }

  template <class Values>
  static bool isIncreasing(const Values& values) {
    return std::adjacent_find(values.begin(), values.end(), [](const auto& a, const auto& b) { return a >= b; }) ==
           values.end();
  }

  void chunks() {
    constexpr std::int64_t kFarthest = kMaxCell / detail::kChunkSize;
    const std::size_t count = in_.count(kMaxChunks);
    std::int64_t ci = 0, cj = 0;
    for (std::size_t k = 0; k < count && !in_.failed(); ++k) {
      ci += detail::unfolded(in_.number(8 * kFarthest));
      cj += detail::unfolded(in_.number(8 * kFarthest));
      if (std::max(std::abs(ci), std::abs(cj)) > kFarthest) in_.fail(What::badNumber);
      if (in_.failed()) return;
      const CellAt at = world_.grid.obtain(
          {static_cast<std::int32_t>(ci * detail::kChunkSize), static_cast<std::int32_t>(cj * detail::kChunkSize)});
      if (!at || at.chunk->index != k + 1) return in_.fail(What::badNumber);  // it is there already
      cells(*at.chunk);
    }
  }

  void cells(Chunk& chunk) {
    std::array<std::uint64_t, detail::kChunkCells> contents{}, serials{};
    RunReader contentRuns(in_, 2 * contents_.size());
    for (std::uint64_t& content : contents) content = contentRuns.next();
    contentRuns.end();
    const auto isListed = [&](std::uint32_t local) { return (contents[local] & 1u) != 0; };
    const auto contentAt = [&](std::uint32_t local) -> ContentId {
      const auto number = static_cast<std::size_t>(contents[local] >> 1);
      if (number >= contents_.size()) in_.fail(What::badNumber);
      return in_.failed() ? detail::kEmptyContent : contents_[number];
    };
    RunReader serialRuns(in_, detail::Grid::kMaxCompactSerial);
    for (std::uint32_t local = 0; local < detail::kChunkCells; ++local)
      if (!isListed(local)) serials[local] = serialRuns.next();
    serialRuns.end();
    RunReader blockRuns(in_, ~Block{0});
    for (std::uint32_t local = 0; local < detail::kChunkCells && !in_.failed(); ++local)
      if (!isListed(local)) compactCell({&chunk, local}, contentAt(local), serials[local], blockRuns);
    blockRuns.end();
    for (std::uint32_t local = 0; local < detail::kChunkCells && !in_.failed(); ++local)
      if (isListed(local)) listedCell({&chunk, local}, contentAt(local));
  }

  void compactCell(CellAt at, ContentId content, std::uint64_t serial, RunReader& blocks) {
    const bool isEmpty = content == detail::kEmptyContent;
    if (isEmpty && serial == 0) return;
    if (!isEmpty && (serial == 0 || world_.catalogue.content(content).polygons.size() != 1)) in_.fail(What::badNumber);
    const Block block = isEmpty ? 0 : static_cast<Block>(blocks.next());
    if (!in_.failed() && place(at, content))
      setPolygons(at, content, static_cast<std::uint32_t>(serial), isEmpty, block);
  }

  void setPolygons(CellAt at, ContentId content, std::uint32_t serial, bool isEmpty, Block block) {
    const detail::Placed placed{serial, block};
    world_.grid.setPolygons(at, content, serial, {&placed, isEmpty ? 0u : 1u}, false);
  }

  void listedCell(CellAt at, ContentId content) {
    const auto lastSerial = static_cast<std::uint32_t>(in_.number(detail::kMaxSerial));
    placed_.resize(world_.catalogue.content(content).polygons.size());
    serials_.clear();
    for (detail::Placed& placed : placed_) {
      placed.serial = static_cast<std::uint32_t>(in_.number(lastSerial));
      placed.block = static_cast<Block>(in_.number(~Block{0}));
      serials_.push_back(placed.serial);
    }
    detail::sort(serials_);
    if (!isIncreasing(serials_) || (!serials_.empty() && serials_.front() == 0)) in_.fail(What::badNumber);
    if (!in_.failed() && !isPreservedAsHere(world_.catalogue.content(content))) in_.fail(What::relation);
    if (!in_.failed() && place(at, content)) world_.grid.setPolygons(at, content, lastSerial, placed_, true);
  }

  /// Whether the overlaps in a cell with these polygons are preserved as this world's relation wants it.
  bool isPreservedAsHere(const detail::InternedContent& content) const {
    return std::ranges::all_of(content.contacts, [&](const auto& contact) {
      return world_.keeps(placed_[contact.first].block, placed_[contact.second].block) ==
             std::ranges::binary_search(content.preserved, contact);
    });
  }

  /// Notes that a cell will have this content, and makes it dirty, so that link() comes by.
  bool place(CellAt at, ContentId content) {
    const Cell cell = at.chunk->cell(at.local);
    if (!inRange(cell)) in_.fail(What::badNumber);
    if (in_.failed() || content == detail::kEmptyContent) return !in_.failed();
    world_.catalogue.use(content);
    world_.touch(at, content);
    return true;
  }

  /// The segments that the polygons show, with the ids of the file. Each id up to the highest names a segment, or is
  /// free, or was freed by the last commit.
  void segments() {
    std::vector<std::uint32_t> free = idsNotInUse(), removed = idsNotInUse();
    std::uint64_t count = free.size() + removed.size(), shown = 0;
    forEachPlacedCell([&](CellAt at) {
      if (shown <= in_.left()) shown += detail::Look(world_, at).count();
    });
    count += shown;
    if (shown > in_.left()) in_.fail(What::cut);  // an id takes a byte at least
    if (count >= detail::kMaxSegment) in_.fail(What::capacity);
    if (in_.failed()) return;
    world_.segments.reset(static_cast<std::uint32_t>(count), free);
    std::vector<bool> seen(static_cast<std::size_t>(count) + 1);
    for (const auto* ids : {&free, &removed})
      for (const std::uint32_t id : *ids) see(id, seen);
    for (const std::uint32_t id : removed) world_.changes.removed.push_back({id});
    forEachPlacedCell([&](CellAt at) {
      const detail::Look look(world_, at);
      const std::uint32_t here = look.count();
      if (here == 0 || in_.failed()) return;
      look.fill(*world_.grid.spliceSegments(at, 0, 0, here),
                [&](const detail::PackedEnds& ends, detail::Placed placed) {
                  const std::uint32_t id = readId();
                  if (see(id, seen)) world_.segments[id] = newSegment(at.chunk->ref(at.local), ends, placed);
                  return id;
                });
    });
  }

  std::vector<std::uint32_t> idsNotInUse() {
    std::vector<std::uint32_t> ids(in_.count(detail::kMaxSegment));
    for (std::uint32_t& id : ids) id = readId();
    return ids;
  }

  /// An id; once reading has failed, any number.
  std::uint32_t readId() {
    lastId_ += detail::unfolded(in_.number(4 * std::uint64_t{detail::kMaxSegment})) + 1;
    if (lastId_ < 1 || lastId_ > detail::kMaxSegment) in_.fail(What::badSegments);
    return static_cast<std::uint32_t>(lastId_);
  }

  /// Whether an id may be used, and was not yet.
  bool see(std::uint32_t id, std::vector<bool>& seen) {
    if (id == detail::kNoSegment || id >= seen.size() || seen[id]) in_.fail(What::badSegments);
    if (!in_.failed()) seen[id] = true;
    return !in_.failed();
  }

  template <class Visit>
  void forEachPlacedCell(const Chunk& chunk, Visit&& visit) const {
    for (std::uint32_t local = 0; local < detail::kChunkCells; ++local)
      if (const CellAt at{chunk.around[4], local}; world_.grid.content(at) != detail::kEmptyContent) visit(at);
  }
  template <class Visit>
  void forEachPlacedCell(Visit&& visit) const {
    for (const auto& chunk : world_.grid.chunks()) forEachPlacedCell(*chunk, visit);
  }

  /// All cells with polygons are dirty, so this links all segments; none had links, so none is listed as relinked.
  void link() {
    detail::Linking phase2(world_, world_.fan);
    for (const Chunk* chunk : world_.dirtyChunks) phase2.linkChunk(*chunk);
    world_.forgetDirty();
    world_.version = world_.versions.next();
  }

  World::Impl& world_;
  SnapshotReader in_;
  std::vector<PolygonId> polygons_, list_;
  std::vector<ContentId> contents_;
  std::vector<detail::Placed> placed_;
  std::vector<std::uint32_t> serials_;
  std::int64_t lastId_ = 0;
};

/// What can be told before anything is made of the bytes: whether they are a snapshot, whole and undamaged.
std::optional<SnapshotError> lookAt(std::span<const std::byte> bytes) {
  const auto letters = std::span(detail::kSnapshotMagic);
  const std::size_t compared = std::min(bytes.size(), letters.size());
  for (std::size_t k = 0; k < compared; ++k)
    if (bytes[k] != std::byte{letters[k]}) return SnapshotError{What::notASnapshot, k};
  if (bytes.size() < kHead + kTail) return SnapshotError{What::cut, bytes.size()};
  if (bytes[letters.size()] != std::byte{detail::kSnapshotVersion})
    return SnapshotError{What::unknownVersion, letters.size()};
  detail::Checksum sum;
  for (const std::byte byte : bytes.first(bytes.size() - kTail)) sum.add(byte);
  for (unsigned k = 0; k < kTail; ++k)
    if (bytes[bytes.size() - kTail + k] != static_cast<std::byte>(sum.value() >> 8 * k & 0xffu))
      return SnapshotError{What::damaged, bytes.size() - kTail};
  return std::nullopt;
}

}  // namespace

tl::expected<World, SnapshotError> World::load(std::span<const std::byte> snapshot, PreserveRelation preserve) {
  if (const auto error = lookAt(snapshot)) return tl::unexpected(*error);
  World world(std::move(preserve));
  if (auto error = Load(*world.impl_, snapshot.subspan(kHead, snapshot.size() - kHead - kTail)).run()) {
    error->offset += kHead;
    return tl::unexpected(*error);
  }
  return world;
}

std::string message(const SnapshotError& error) {
  const auto what = [&]() -> std::string {
    switch (error.what) {
      case What::notASnapshot:
        return "this is no snapshot of a world";
      case What::unknownVersion:
        return "a newer version of the library wrote this snapshot";
      case What::cut:
        return "the snapshot ends too early";
      case What::damaged:
        return "the snapshot is damaged, or cut: its checksum does not fit";
      case What::tooLong:
        return "bytes follow the end of the snapshot";
      case What::relation:
        return "the world was saved with another preserve relation than it is loaded with";
      case What::badNumber:
        return "a number is out of its range";
      case What::badPolygon:
        return "a polygon is not valid, or overlaps another one of its cell";
      case What::badSegments:
        return "the ids of the segments do not fit this world";
      case What::capacity:
        return "more than a world can hold";
    }
    return "unknown error";
  };
  return "byte " + std::to_string(error.offset) + ": " + what();
}

}  // namespace lgs
