// The ground as bytes. docs/internals/snapshot.md has the format; load.cpp reads it.
#include "geometry/sort.h"
#include "ground/snapshot.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lgs::detail {
namespace {

/// Numbers the contents of cells by their first use, and polygons by their vertices. So worlds that look alike give the
/// same bytes, whatever their history.
class Numbers {
 public:
  explicit Numbers(const Ground& ground) : ground_(ground) {}

  void use(const Chunk& chunk) {
    for (std::uint32_t local = 0; local < kChunkCells; ++local) use(ground_.contentId({chunk.self(), local}));
  }
  void use(ShapeId shape) {
    for (const PolygonId polygon : ground_.catalogue.shape(shape).polygons) ofPolygon_[polygon] = 0;
  }
  /// After all that is used.
  void end() {
    for (const auto& [id, number] : ofPolygon_) polygons_.push_back(id);
    detail::sort(polygons_, [&](PolygonId a, PolygonId b) {
      return std::ranges::lexicographical_compare(ground_.catalogue.vertices(a), ground_.catalogue.vertices(b));
    });
    for (std::uint32_t number = 0; number < polygons_.size(); ++number) ofPolygon_[polygons_[number]] = number;
  }

  /// The slots of a content by the numbers of their polygons: the slots that the content will have in a loaded world.
  std::vector<Slot> slots(const Content& content) const {
    std::vector<Slot> slots(content.polygons.size());
    std::iota(slots.begin(), slots.end(), Slot{0});
    detail::sort(slots, [&](Slot a, Slot b) { return of(content.polygons[a]) < of(content.polygons[b]); });
    return slots;
  }

  const std::vector<PolygonId>& polygons() const { return polygons_; }
  const std::vector<ContentId>& contents() const { return contents_; }
  std::uint32_t of(PolygonId polygon) const { return ofPolygon_.at(polygon); }
  /// From 1; the empty content is 0.
  std::uint32_t ofContent(ContentId content) const { return content == kEmptyContent ? 0 : ofContent_.at(content); }

 private:
  void use(ContentId content) {
    const auto next = static_cast<std::uint32_t>(contents_.size() + 1);
    if (content == kEmptyContent || !ofContent_.emplace(content, next).second) return;
    contents_.push_back(content);
    for (const PolygonId polygon : ground_.catalogue.content(content).polygons) ofPolygon_[polygon] = 0;
  }

  const Ground& ground_;
  std::unordered_map<std::uint32_t, std::uint32_t> ofContent_, ofPolygon_;
  std::vector<ContentId> contents_;
  std::vector<PolygonId> polygons_;
};

class Save {
 public:
  Save(const Ground& ground, SnapshotWriter& out) : ground_(ground), numbers_(ground), out_(out) {}

  void world() {
    ground_.grid.forEachChunk([this](const Chunk& chunk) { numbers_.use(chunk); });
    for (std::uint32_t k = 1; k <= ground_.catalogue.shapeCount(); ++k) numbers_.use(ShapeId{k});
    numbers_.end();
    out_.byte(ground_.preserve ? 1 : 0);
    polygons();
    contents();
    shapes();
    chunks();
  }

  void chunk(const Chunk& chunk) {
    numbers_.use(chunk);
    numbers_.end();
    out_.byte(ground_.preserve ? 1 : 0);
    out_.number(folded(chunk.ci));
    out_.number(folded(chunk.cj));
    polygons();
    contents();
    cells(chunk);
  }

 private:
  void polygons() {
    out_.number(numbers_.polygons().size());
    for (const PolygonId id : numbers_.polygons()) {
      const PolygonView vertices = ground_.catalogue.vertices(id);
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
      const Content& content = ground_.catalogue.content(id);
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
    out_.number(ground_.catalogue.shapeCount());
    for (std::uint32_t k = 1; k <= ground_.catalogue.shapeCount(); ++k) {
      const std::vector<PolygonId>& polygons = ground_.catalogue.shape(ShapeId{k}).polygons;
      out_.number(polygons.size());
      for (const PolygonId id : polygons) out_.number(numbers_.of(id));
    }
  }

  void chunks() {
    if (hasFreeNumbers(ground_)) freeNumbers();
    out_.number(ground_.grid.count());
    std::int32_t ci = 0, cj = 0;
    ground_.grid.forEachChunk([&](const Chunk& chunk) {
      out_.number(folded(std::int64_t{chunk.ci} - ci));
      out_.number(folded(std::int64_t{chunk.cj} - cj));
      ci = chunk.ci;
      cj = chunk.cj;
      cells(chunk);
    });
  }

  /// Each as its distance from one more than the one before.
  void freeNumbers() {
    out_.number(ground_.grid.highest() - ground_.grid.count());
    std::uint32_t next = 1, afterLastFree = 1;
    ground_.grid.forEachChunk([&](const Chunk& chunk) {
      for (; next < chunk.index; ++next) {
        out_.number(next - afterLastFree);
        afterLastFree = next + 1;
      }
      ++next;
    });
  }

  void cells(const Chunk& chunk) {
    std::vector<std::uint64_t> contents, serials, blocks;
    for (CellAt at{chunk.self(), 0}; at.local < kChunkCells; ++at.local) {
      const Held held = ground_.held(at);
      contents.push_back(std::uint64_t{numbers_.ofContent(held.content())} << 1 | (isListed(at.word()) ? 1u : 0u));
      if (isListed(at.word())) continue;
      serials.push_back(held.lastSerial());
      if (held.size() != 0) blocks.push_back(held[0].block);
    }
    out_.runs(contents);
    out_.runs(serials);
    out_.runs(blocks);
    for (CellAt at{chunk.self(), 0}; at.local < kChunkCells; ++at.local) {
      if (!isListed(at.word())) continue;
      const Held held = ground_.held(at);
      out_.number(held.lastSerial());
      for (const Slot slot : numbers_.slots(ground_.content(at))) {
        out_.number(held[slot].serial);
        out_.number(held[slot].block);
      }
    }
  }

  const Ground& ground_;
  Numbers numbers_;
  SnapshotWriter& out_;
};

}  // namespace

bool hasFreeNumbers(const Ground& ground) { return ground.grid.count() != ground.grid.highest(); }

void save(const Ground& ground, SnapshotWriter& out) { Save(ground, out).world(); }

void save(const Ground& ground, const Chunk& chunk, SnapshotWriter& out) { Save(ground, out).chunk(chunk); }

}  // namespace lgs::detail
