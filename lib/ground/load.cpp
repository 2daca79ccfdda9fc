// The ground from bytes, none of which is believed. docs/internals/snapshot.md has the format; save.cpp writes it.
#include "geometry/sort.h"
#include "ground/snapshot.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

namespace lgs::detail {
namespace {

using What = SnapshotError::What;

class Load {
 public:
  Load(Ground& ground, SnapshotReader& in) : ground_(ground), in_(in) {}

  void run(bool hasFreeNumbers) {
    if ((in_.byte() != 0) != static_cast<bool>(ground_.preserve)) in_.fail(What::relation);
    polygons();
    contents();
    shapes();
    if (hasFreeNumbers) freeNumbers();
    chunks();
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
      const auto id = ground_.catalogue.internPolygon(vertices);
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
    contents_.push_back(kEmptyContent);
    const std::size_t count = in_.count(kMaxContent);
    std::vector<std::pair<Slot, Slot>> preserved;
    for (std::size_t k = 0; k < count && !in_.failed(); ++k) {
      const std::vector<PolygonId>& polygons = list();
      preserved.resize(in_.count(kMaxPolygonsPerCell * kMaxPolygonsPerCell));
      for (auto& [a, b] : preserved) {
        a = static_cast<Slot>(in_.number(kMaxPolygonsPerCell));
        b = static_cast<Slot>(in_.number(kMaxPolygonsPerCell));
      }
      if (in_.failed()) return;
      if (polygons.empty() || !isIncreasing(polygons) || !isIncreasing(preserved)) return in_.fail(What::badNumber);
      const auto content = ground_.catalogue.internContent(polygons, {}, preserved);
      if (!content) return in_.fail(content.error().code == ErrorCode::capacity ? What::capacity : What::badPolygon);
      // Only an overlap that is there can be preserved, and only by a relation.
      const auto& contacts = ground_.catalogue.content(*content).contacts;
      if (!std::ranges::includes(contacts, preserved) || (!preserved.empty() && !ground_.preserve))
        return in_.fail(What::badNumber);
      contents_.push_back(*content);
    }
  }

  void shapes() {
    const std::size_t count = in_.count(~std::uint64_t{0});
    for (std::size_t k = 0; k < count && !in_.failed(); ++k) {
      const std::vector<PolygonId>& polygons = list();
      if (in_.failed()) return;
      const auto shape = ground_.catalogue.internShape(polygons);
      if (!shape || shape->value != k + 1) return in_.fail(What::badPolygon);
    }
  }

  template <class Values>
  static bool isIncreasing(const Values& values) {
    return std::adjacent_find(values.begin(), values.end(), [](const auto& a, const auto& b) { return a >= b; }) ==
           values.end();
  }

  void freeNumbers() {
    std::uint64_t next = 1;
    free_.resize(in_.count(kMaxChunks));
    for (std::uint32_t& number : free_) {
      number = static_cast<std::uint32_t>(next + in_.number(kMaxChunks));
      if (number > kMaxChunks) in_.fail(What::badNumber);
      next = std::uint64_t{number} + 1;
    }
    if (free_.empty()) in_.fail(What::badNumber);  // the other version does without this list
  }

  void chunks() {
    constexpr std::int64_t kFarthest = kMaxCell / kChunkSize;
    const std::size_t count = in_.count(kMaxChunks);
    std::int64_t ci = 0, cj = 0;
    std::size_t left = 0;  // free numbers that are passed
    for (std::size_t k = 0; k < count && !in_.failed(); ++k) {
      ci += unfolded(in_.number(8 * kFarthest));
      cj += unfolded(in_.number(8 * kFarthest));
      if (std::max(std::abs(ci), std::abs(cj)) > kFarthest) in_.fail(What::badNumber);
      if (in_.failed()) return;
      for (; left < free_.size() && free_[left] == ground_.grid.highest() + 1; ++left) ground_.grid.leaveOut();
      const CellAt at =
          ground_.grid.obtain({static_cast<std::int32_t>(ci * kChunkSize), static_cast<std::int32_t>(cj * kChunkSize)});
      if (at.chunk->index != left + k + 1) return in_.fail(What::badNumber);  // it is there already
      cells(*at.chunk);
    }
    if (left != free_.size()) in_.fail(What::badNumber);  // beyond the last chunk none counts as free
    ground_.grid.setFree(std::move(free_));
  }

  void cells(Chunk& chunk) {
    std::array<std::uint64_t, kChunkCells> contents{}, serials{};
    RunReader contentRuns(in_, 2 * contents_.size());
    for (std::uint64_t& content : contents) content = contentRuns.next();
    contentRuns.end();
    const auto isListed = [&](std::uint32_t local) { return (contents[local] & 1u) != 0; };
    const auto contentAt = [&](std::uint32_t local) -> ContentId {
      const auto number = static_cast<std::size_t>(contents[local] >> 1);
      if (number >= contents_.size()) in_.fail(What::badNumber);
      return in_.failed() ? kEmptyContent : contents_[number];
    };
    RunReader serialRuns(in_, kLowMask);
    for (std::uint32_t local = 0; local < kChunkCells; ++local)
      if (!isListed(local)) serials[local] = serialRuns.next();
    serialRuns.end();
    RunReader blockRuns(in_, ~Block{0});
    for (std::uint32_t local = 0; local < kChunkCells && !in_.failed(); ++local)
      if (!isListed(local)) compactCell({&chunk, local}, contentAt(local), serials[local], blockRuns);
    blockRuns.end();
    for (std::uint32_t local = 0; local < kChunkCells && !in_.failed(); ++local)
      if (isListed(local)) listedCell({&chunk, local}, contentAt(local));
  }

  void compactCell(CellAt at, ContentId content, std::uint64_t serial, RunReader& blocks) {
    const bool isEmpty = content == kEmptyContent;
    if (isEmpty && serial == 0) return;
    if (!isEmpty && (serial == 0 || ground_.catalogue.content(content).polygons.size() != 1)) in_.fail(What::badNumber);
    const Placed sole{static_cast<std::uint32_t>(serial), isEmpty ? 0 : static_cast<Block>(blocks.next())};
    set(at, content, sole.serial, {&sole, isEmpty ? 0u : 1u});
  }

  void listedCell(CellAt at, ContentId content) {
    const auto lastSerial = static_cast<std::uint32_t>(in_.number(kMaxSerial));
    placed_.resize(ground_.catalogue.content(content).polygons.size());
    serials_.clear();
    for (Placed& placed : placed_) {
      placed.serial = static_cast<std::uint32_t>(in_.number(lastSerial));
      placed.block = static_cast<Block>(in_.number(~Block{0}));
      serials_.push_back(placed.serial);
    }
    detail::sort(serials_);
    if (!isIncreasing(serials_) || (!serials_.empty() && serials_.front() == 0)) in_.fail(What::badNumber);
    if (!in_.failed() && !isPreservedAsHere(ground_.catalogue.content(content))) in_.fail(What::relation);
    set(at, content, lastSerial, placed_);
  }

  /// Whether the overlaps in a cell with these polygons are preserved as this world's relation wants it.
  bool isPreservedAsHere(const Content& content) const {
    return std::ranges::all_of(content.contacts, [&](const auto& contact) {
      return ground_.keeps(placed_[contact.first].block, placed_[contact.second].block) ==
             std::ranges::binary_search(content.preserved, contact);
    });
  }

  void set(CellAt at, ContentId content, std::uint32_t lastSerial, std::span<const Placed> polygons) {
    if (!inRange(at.cell())) in_.fail(What::badNumber);
    if (!in_.failed()) ground_.set(at, content, lastSerial, polygons);
  }

  Ground& ground_;
  SnapshotReader& in_;
  std::vector<std::uint32_t> free_;  ///< numbers of chunks
  std::vector<PolygonId> polygons_, list_;
  std::vector<ContentId> contents_;
  std::vector<Placed> placed_;
  std::vector<std::uint32_t> serials_;
};

}  // namespace

void load(Ground& ground, SnapshotReader& in, bool hasFreeNumbers) { Load(ground, in).run(hasFreeNumbers); }

}  // namespace lgs::detail
