// A world as bytes. docs/snapshot.md has the format; load.cpp reads it.
#include "geometry/sort.h"
#include "refusal.h"
#include "snapshot_bytes.h"
#include "world_impl.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace lgs {
namespace {

using detail::CellAt;
using detail::Chunk;
using detail::ContentId;
using detail::InternedContent;
using detail::PolygonId;
using detail::Slot;
using detail::SnapshotWriter;

/// Numbers the contents of cells by their first use, and polygons by their vertices. So worlds that look alike give the
/// same bytes, whatever their history.
class Numbers {
 public:
  explicit Numbers(const World::Impl& world) : world_(world) {
    ofContent_.assign(world.catalogue.contentLimit(), kNone);
    ofPolygon_.assign(world.catalogue.polygonLimit(), kNone);
    for (const auto& chunk : world.grid.chunks())
      for (std::uint32_t local = 0; local < detail::kChunkCells; ++local) use(world.grid.content({chunk.get(), local}));
    for (std::uint32_t k = 1; const detail::InternedShape* shape = world.catalogue.shape(ShapeId{k}); ++k)
      for (const PolygonId polygon : shape->polygons) ofPolygon_[polygon] = 0;
    for (PolygonId id = 0; id < ofPolygon_.size(); ++id)
      if (ofPolygon_[id] != kNone) polygons_.push_back(id);
    detail::sort(polygons_, [&](PolygonId a, PolygonId b) {
      return std::ranges::lexicographical_compare(world.catalogue.vertices(a), world.catalogue.vertices(b));
    });
    for (std::uint32_t number = 0; number < polygons_.size(); ++number) ofPolygon_[polygons_[number]] = number;
  }

  /// The slots of a content by the numbers of their polygons: the slots that the content will have in a loaded world.
  std::vector<Slot> slots(const InternedContent& content) const {
    std::vector<Slot> slots(content.polygons.size());
    std::iota(slots.begin(), slots.end(), Slot{0});
    detail::sort(slots, [&](Slot a, Slot b) { return of(content.polygons[a]) < of(content.polygons[b]); });
    return slots;
  }

  const std::vector<PolygonId>& polygons() const { return polygons_; }
  const std::vector<ContentId>& contents() const { return contents_; }
  std::uint32_t of(PolygonId polygon) const { return ofPolygon_[polygon]; }
  /// From 1; the empty content is 0.
  std::uint32_t ofContent(ContentId content) const {
    return content == detail::kEmptyContent ? 0 : ofContent_[content];
  }

 private:
  static constexpr std::uint32_t kNone = 0xffff'ffff;

  void use(ContentId content) {
    if (content == detail::kEmptyContent || ofContent_[content] != kNone) return;
    contents_.push_back(content);
    ofContent_[content] = static_cast<std::uint32_t>(contents_.size());
    for (const PolygonId polygon : world_.catalogue.content(content).polygons) ofPolygon_[polygon] = 0;
  }

  const World::Impl& world_;
  std::vector<std::uint32_t> ofContent_, ofPolygon_;
  std::vector<ContentId> contents_;
  std::vector<PolygonId> polygons_;
};

class Save {
 public:
  Save(const World::Impl& world, const ByteSink& sink) : world_(world), numbers_(world), out_(sink) {}

  void run() {
    for (const std::uint8_t letter : detail::kSnapshotMagic) out_.byte(letter);
    out_.byte(detail::kSnapshotVersion);
    out_.byte(world_.preserve ? 1 : 0);
    polygons();
    contents();
    shapes();
    chunks();
    ids(world_.segments.free(), [](std::uint32_t id) { return id; });
    ids(world_.changes.removed, [](SegmentId id) { return id.value; });
    for (const auto& chunk : world_.grid.chunks()) segments(*chunk);
    out_.end();
  }

 private:
  void polygons() {
    out_.number(numbers_.polygons().size());
    for (const PolygonId id : numbers_.polygons()) {
      const detail::PolygonView vertices = world_.catalogue.vertices(id);
      out_.number(vertices.size());
      for (const LocalPoint v : vertices) {
        out_.number(static_cast<std::uint64_t>(v.x));
        out_.number(static_cast<std::uint64_t>(v.y));
      }
    }
  }

  void contents() {
    out_.number(numbers_.contents().size());
    for (const ContentId id : numbers_.contents()) {
      const InternedContent& content = world_.catalogue.content(id);
      const std::vector<Slot> slots = numbers_.slots(content);
      std::vector<Slot> after(slots.size());  // the new slot of an old one
      out_.number(slots.size());
      for (std::size_t k = 0; k < slots.size(); ++k) {
        after[slots[k]] = static_cast<Slot>(k);
        out_.number(numbers_.of(content.polygons[slots[k]]));
      }
      std::vector<std::pair<Slot, Slot>> preserved;
      for (const auto& [a, b] : content.preserved) preserved.push_back(std::minmax(after[a], after[b]));
      detail::sort(preserved);
      out_.number(preserved.size());
      for (const auto& [a, b] : preserved) {
        out_.number(a);
        out_.number(b);
      }
    }
  }

  void shapes() {
    out_.number(world_.catalogue.shapeCount());
    for (std::uint32_t k = 1; k <= world_.catalogue.shapeCount(); ++k) {
      const std::vector<PolygonId>& polygons = world_.catalogue.shape(ShapeId{k})->polygons;
      out_.number(polygons.size());
      for (const PolygonId id : polygons) out_.number(numbers_.of(id));
    }
  }

  void chunks() {
    out_.number(world_.grid.chunks().size());
    std::int32_t ci = 0, cj = 0;
    for (const auto& chunk : world_.grid.chunks()) {
      out_.number(detail::folded(std::int64_t{chunk->ci} - ci));
      out_.number(detail::folded(std::int64_t{chunk->cj} - cj));
      ci = chunk->ci;
      cj = chunk->cj;
      cells(*chunk);
    }
  }

  /// Visits the cells of a chunk by rows.
  template <class Visit>
  static void forEachCell(const Chunk& chunk, Visit&& visit) {
    for (std::uint32_t local = 0; local < detail::kChunkCells; ++local) visit(CellAt{chunk.around[4], local});
  }

  void cells(const Chunk& chunk) {
    const detail::Grid& grid = world_.grid;
    std::vector<std::uint64_t> contents, serials, blocks;
    forEachCell(chunk, [&](CellAt at) {
      const ContentId content = grid.content(at);
      contents.push_back(std::uint64_t{numbers_.ofContent(content)} << 1 | (grid.listsPolygons(at) ? 1u : 0u));
      if (grid.listsPolygons(at)) return;
      serials.push_back(grid.lastSerial(at));
      if (content != detail::kEmptyContent) blocks.push_back(grid.placed(at)[0].block);
    });
    out_.runs(contents);
    out_.runs(serials);
    out_.runs(blocks);
    forEachCell(chunk, [&](CellAt at) {
      if (!grid.listsPolygons(at)) return;
      out_.number(grid.lastSerial(at));
      for (const Slot slot : numbers_.slots(world_.contentOf(at))) {
        const detail::Placed placed = grid.placed(at)[slot];
        out_.number(placed.serial);
        out_.number(placed.block);
      }
    });
  }

  /// The ids of a chunk's segments; all else about them follows from the polygons.
  void segments(const Chunk& chunk) {
    forEachCell(chunk, [&](CellAt at) {
      for (const std::uint32_t id : world_.grid.segments(at)) writeId(id);
    });
  }

  template <class Ids, class Value>
  void ids(const Ids& ids, Value&& value) {
    out_.number(ids.size());
    for (const auto id : ids) writeId(value(id));
  }

  /// Writes an id as its distance from the previous id + 1. That is mostly one byte, and never less. So a short file
  /// cannot ask for many segments.
  void writeId(std::uint32_t id) {
    out_.number(detail::folded(std::int64_t{id} - lastId_ - 1));
    lastId_ = id;
  }

  const World::Impl& world_;
  Numbers numbers_;
  SnapshotWriter out_;
  std::int64_t lastId_ = 0;
};

}  // namespace

Expected<void> World::save(const ByteSink& sink) const {
  if (!impl_->dirtyChunks.empty()) return detail::refuse({.code = ErrorCode::uncommitted});
  Save(*impl_, sink).run();
  return {};
}

}  // namespace lgs
