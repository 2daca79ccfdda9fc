// The ground from bytes, none of which is believed. docs/internals/snapshot.md has the format; save.cpp writes it.
#include "geometry/sort.h"
#include "ground/snapshot.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <tuple>
#include <utility>
#include <vector>

namespace lgs::detail {
namespace {

using What = SnapshotError::What;

class Load {
 public:
  Load(Ground& ground, SnapshotReader& in) : ground_(ground), in_(in) {}

  void world(bool hasFreeNumbers) {
    relation();
    polygons();
    // save() writes each polygon once, so each is new here, and gets the next number.
    for (std::size_t k = 0; k < polygons_.size(); ++k)
      if (polygons_[k] != k + 1) return in_.fail(What::badPolygon);
    contents();
    shapes();
    if (hasFreeNumbers) freeNumbers();
    chunks();
  }

  Cell chunk(std::uint32_t checksum) {
    relation();
    const auto [ci, cj] = place({}, {});
    if (in_.failed()) return {};
    const std::uint32_t number = ground_.grid.numberAt(ci, cj);
    const Border* border = ground_.grid.border(number);
    if (border ? border->checksum != checksum : number != Grid::kNone)
      in_.fail(border ? What::otherBytes : What::loaded);
    if (number == Grid::kNone && ground_.grid.isFull()) in_.fail(What::capacity);
    polygons();
    contents();
    const Cell corner{ci * kChunkSize, cj * kChunkSize};
    cells(corner);
    if (in_.left() != 0) in_.fail(What::tooLong);
    if (in_.failed()) return {};
    if (!border) {
      fill(*ground_.obtain(corner).chunk);
      return corner;
    }
    CellMask known;
    Chunk& chunk = ground_.load(number, known);
    for (const Filled& f : filled_)
      if (!contains(known, f.local)) ground_.bringBack({&chunk, f.local}, f.content, f.lastSerial, placed(f));
    return corner;
  }

 private:
  /// A content by its number in the bytes. There the slots are in the order of the polygons' numbers.
  struct Known {
    ContentId content = kEmptyContent;
    std::vector<Slot> slots;  ///< here, by those in the bytes
  };
  /// What a cell gets.
  struct Filled {
    std::uint32_t local = 0;
    ContentId content = kEmptyContent;
    std::uint32_t lastSerial = 0;
    std::uint32_t first = 0, count = 0;  ///< of placed_
  };

  void relation() {
    if ((in_.byte() != 0) != static_cast<bool>(ground_.preserve)) in_.fail(What::relation);
  }

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
      if (!id) return in_.fail(What::badPolygon);
      polygons_.push_back(*id);
    }
  }

  /// Numbers of polygons, as one cell may hold them; ids_ are their names here.
  const std::vector<PolygonId>& list() {
    list_.resize(in_.count(kMaxPolygonsPerCell));
    for (PolygonId& number : list_) number = static_cast<PolygonId>(in_.number(polygons_.size()));
    ids_.clear();
    for (const PolygonId number : list_) {
      if (number >= polygons_.size()) in_.fail(What::badNumber);
      ids_.push_back(in_.failed() ? 0 : polygons_[number]);
    }
    return list_;
  }

  void contents() {
    contents_.emplace_back();
    const std::size_t count = in_.count(kMaxContent);
    std::vector<std::pair<Slot, Slot>> preserved;
    for (std::size_t k = 0; k < count && !in_.failed(); ++k) {
      const std::vector<PolygonId>& numbers = list();
      preserved.resize(in_.count(kMaxPolygonsPerCell * kMaxPolygonsPerCell));
      for (auto& [a, b] : preserved) {
        a = static_cast<Slot>(in_.number(kMaxPolygonsPerCell));
        b = static_cast<Slot>(in_.number(kMaxPolygonsPerCell));
        if (a >= numbers.size() || b >= numbers.size()) in_.fail(What::badNumber);
      }
      if (in_.failed()) return;
      if (numbers.empty() || !isIncreasing(numbers) || !isIncreasing(preserved)) return in_.fail(What::badNumber);
      const std::vector<Slot> slots = sorted(ids_);
      if (!isIncreasing(ids_)) return in_.fail(What::badPolygon);  // the same one twice
      for (auto& [a, b] : preserved) std::tie(a, b) = std::pair(std::minmax(slots[a], slots[b]));
      detail::sort(preserved);
      const auto content = ground_.catalogue.internContent(ids_, {}, preserved);
      if (!content) return in_.fail(content.error().code == ErrorCode::capacity ? What::capacity : What::badPolygon);
      // Only an overlap that is there can be preserved, and only by a relation.
      const auto& contacts = ground_.catalogue.content(*content).contacts;
      if (!std::ranges::includes(contacts, preserved) || (!preserved.empty() && !ground_.preserve))
        return in_.fail(What::badNumber);
      contents_.push_back({*content, slots});
    }
  }

  /// Sorts. Returns where each of them went.
  static std::vector<Slot> sorted(std::vector<PolygonId>& ids) {
    std::vector<std::pair<PolygonId, Slot>> order;
    for (std::size_t k = 0; k < ids.size(); ++k) order.emplace_back(ids[k], static_cast<Slot>(k));
    detail::sort(order);
    std::vector<Slot> slots(ids.size());
    for (std::size_t k = 0; k < ids.size(); ++k) {
      ids[k] = order[k].first;
      slots[order[k].second] = static_cast<Slot>(k);
    }
    return slots;
  }

  void shapes() {
    const std::size_t count = in_.count(~std::uint64_t{0});
    for (std::size_t k = 0; k < count && !in_.failed(); ++k) {
      list();
      if (in_.failed()) return;
      const auto shape = ground_.catalogue.internShape(ids_);
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
    const std::size_t count = in_.count(kMaxChunks);
    std::pair<std::int32_t, std::int32_t> at;
    std::size_t left = 0;  // free numbers that are passed
    for (std::size_t k = 0; k < count && !in_.failed(); ++k) {
      at = place(at.first, at.second);
      if (in_.failed()) return;
      for (; left < free_.size() && free_[left] == ground_.grid.highest() + 1; ++left) ground_.grid.leaveOut();
      const Cell corner{at.first * kChunkSize, at.second * kChunkSize};
      Chunk& chunk = *ground_.grid.obtain(corner).chunk;
      if (chunk.index != left + k + 1) return in_.fail(What::badNumber);  // it is there already
      cells(corner);
      if (!in_.failed()) fill(chunk);
    }
    if (left != free_.size()) in_.fail(What::badNumber);  // beyond the last chunk none counts as free
    ground_.grid.setFree(std::move(free_));
  }

  /// Of a chunk, in chunks, from the one before.
  std::pair<std::int32_t, std::int32_t> place(std::int64_t ci, std::int64_t cj) {
    constexpr std::int64_t kFarthest = kMaxCell / kChunkSize;
    ci += unfolded(in_.number(8 * kFarthest));
    cj += unfolded(in_.number(8 * kFarthest));
    if (std::max(std::abs(ci), std::abs(cj)) > kFarthest) in_.fail(What::badNumber);
    return {static_cast<std::int32_t>(ci), static_cast<std::int32_t>(cj)};
  }

  /// Reads what the cells of a chunk get. Nothing is changed yet.
  void cells(Cell corner) {
    std::array<std::uint64_t, kChunkCells> contents{}, serials{};
    RunReader contentRuns(in_, 2 * contents_.size());
    for (std::uint64_t& content : contents) content = contentRuns.next();
    contentRuns.end();
    const auto isListed = [&](std::uint32_t local) { return (contents[local] & 1u) != 0; };
    const auto contentAt = [&](std::uint32_t local) -> const Known& {
      const auto number = static_cast<std::size_t>(contents[local] >> 1);
      if (number >= contents_.size()) in_.fail(What::badNumber);
      return contents_[in_.failed() ? 0 : number];
    };
    RunReader serialRuns(in_, kLowMask);
    for (std::uint32_t local = 0; local < kChunkCells; ++local)
      if (!isListed(local)) serials[local] = serialRuns.next();
    serialRuns.end();
    filled_.clear();
    placed_.clear();
    RunReader blockRuns(in_, ~Block{0});
    for (std::uint32_t local = 0; local < kChunkCells && !in_.failed(); ++local)
      if (!isListed(local)) compactCell(local, contentAt(local), serials[local], blockRuns);
    blockRuns.end();
    for (std::uint32_t local = 0; local < kChunkCells && !in_.failed(); ++local)
      if (isListed(local)) listedCell(local, contentAt(local));
    for (const Filled& f : filled_)
      if (!inRange(cellIn(corner.i >> 5, corner.j >> 5, f.local))) in_.fail(What::badNumber);
  }

  void compactCell(std::uint32_t local, const Known& known, std::uint64_t serial, RunReader& blocks) {
    const bool isEmpty = known.content == kEmptyContent;
    if (isEmpty && serial == 0) return;
    if (!isEmpty && (serial == 0 || known.slots.size() != 1)) in_.fail(What::badNumber);
    begin(local, known, static_cast<std::uint32_t>(serial));
    if (!in_.failed() && !isEmpty) placed_.back() = {filled_.back().lastSerial, static_cast<Block>(blocks.next())};
  }

  void listedCell(std::uint32_t local, const Known& known) {
    begin(local, known, static_cast<std::uint32_t>(in_.number(kMaxSerial)));
    const Filled& cell = filled_.back();
    serials_.clear();
    for (const Slot slot : known.slots) {
      Placed& placed = placed_[cell.first + slot];
      placed.serial = static_cast<std::uint32_t>(in_.number(cell.lastSerial));
      placed.block = static_cast<Block>(in_.number(~Block{0}));
      serials_.push_back(placed.serial);
    }
    detail::sort(serials_);
    if (!isIncreasing(serials_) || (!serials_.empty() && serials_.front() == 0)) in_.fail(What::badNumber);
    if (!in_.failed() && !isPreservedAsHere(cell)) in_.fail(What::relation);
  }

  void begin(std::uint32_t local, const Known& known, std::uint32_t lastSerial) {
    filled_.push_back({local, known.content, lastSerial, static_cast<std::uint32_t>(placed_.size()),
                       static_cast<std::uint32_t>(known.slots.size())});
    placed_.resize(placed_.size() + known.slots.size());
  }

  std::span<const Placed> placed(const Filled& cell) const {
    return std::span(placed_).subspan(cell.first, cell.count);
  }

  void fill(Chunk& chunk) {
    for (const Filled& f : filled_) ground_.set({&chunk, f.local}, f.content, f.lastSerial, placed(f));
  }

  /// Whether the overlaps in a cell with these polygons are preserved as this world's relation wants it.
  bool isPreservedAsHere(const Filled& cell) const {
    const Content& content = ground_.catalogue.content(cell.content);
    return std::ranges::all_of(content.contacts, [&](const auto& contact) {
      return ground_.keeps(placed(cell)[contact.first].block, placed(cell)[contact.second].block) ==
             std::ranges::binary_search(content.preserved, contact);
    });
  }

  Ground& ground_;
  SnapshotReader& in_;
  std::vector<std::uint32_t> free_;  ///< numbers of chunks
  std::vector<PolygonId> polygons_, list_, ids_;
  std::vector<Known> contents_;
  std::vector<Filled> filled_;  ///< of one chunk
  std::vector<Placed> placed_;
  std::vector<std::uint32_t> serials_;
};

}  // namespace

void load(Ground& ground, SnapshotReader& in, bool hasFreeNumbers) { Load(ground, in).world(hasFreeNumbers); }

Cell loadChunk(Ground& ground, SnapshotReader& in, std::uint32_t checksum) { return Load(ground, in).chunk(checksum); }

}  // namespace lgs::detail
