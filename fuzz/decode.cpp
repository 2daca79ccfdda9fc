#include "fuzz/format.h"
#include "oracle/calls/shapes.h"
#include "oracle/trace/step.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <map>

namespace lgs::fuzz {
namespace {

using oracle::Edit;
using oracle::LocalPolygon;
using oracle::ScenePolygon;
using oracle::Trace;

constexpr std::int32_t U = kUnitsPerCell;
constexpr std::size_t kFirstVertex = 4;
constexpr std::size_t kShortVertices = 6;  // of a record
constexpr int kMaxFill = 20;               // cells of one record: enough for a crowded row

struct Window {
  std::int32_t width, height;
};
// Small, so that neighbours meet; and rows long enough to be crowded, across the chunks of 32 columns.
constexpr std::array<Window, 8> kWindows{{{4, 4}, {3, 3}, {2, 2}, {2, 1}, {5, 5}, {16, 1}, {40, 2}, {3, 40}}};
// The origin; across and beside the chunks' corners; the world's ends.
constexpr std::array<Cell, 8> kOrigins{{{0, 0},
                                        {-2, -2},
                                        {30, 30},
                                        {-33, 31},
                                        {-kMaxCell, -kMaxCell},
                                        {kMaxCell - 2, kMaxCell - 2},
                                        {kMaxCell - 1, -5},
                                        {1'000'000, -kMaxCell - 1}}};

template <class T>
T little(const std::uint8_t* bytes) {
  T value = 0;
  for (std::size_t k = 0; k < sizeof(T); ++k) value |= static_cast<T>(T{bytes[k]} << (8 * k));
  return value;
}

std::int32_t inner(std::uint8_t byte, int grid) {
  switch (grid) {
    case 0:
      return byte % 9 * (U / 8);
    case 1:
      return byte % 5 * (U / 4);
    case 2:  // on and beside the lines of a grid of sixteenths
      return std::clamp(byte % 17 * (U / 16) + byte / 17 % 3 - 1, 0, U);
    default:
      return byte == 0xff ? U : byte * 257;
  }
}

// Most bytes give a coordinate inside the cell. The last six give one outside it. Some of these are so large that
// arithmetic may overflow.
std::int32_t anywhere(std::uint8_t byte, int grid) {
  constexpr std::array<std::int32_t, 6> kOutside{-1, U + 1, 2 * U, -U, 32'767 * U, -32'767 * U};
  return byte >= 250 && grid >= 2 ? kOutside[byte - 250U] : inner(byte, grid);
}

// Andrew's monotone chain; counter-clockwise, without collinear vertices. Fewer than three points if they are
// collinear.
LocalPolygon hullOf(LocalPolygon points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto turnsLeft = [](LocalPoint a, LocalPoint b, LocalPoint c) {
    return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x) > 0;
  };
  LocalPolygon hull;
  const auto chain = [&](auto first, auto last) {
    const std::size_t base = hull.size();
    for (; first != last; ++first) {
      while (hull.size() >= base + 2 && !turnsLeft(hull[hull.size() - 2], hull.back(), *first)) hull.pop_back();
      hull.push_back(*first);
    }
    hull.pop_back();  // begins the other chain
  };
  if (points.size() < 3) return points;
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

LocalPolygon spoil(LocalPolygon polygon, Bytes record) {
  const std::size_t n = polygon.size();
  const std::size_t k = record[5] % n;
  const std::size_t m = record[6] % n;
  switch (record[4] % 10) {
    case 0:
      std::reverse(polygon.begin(), polygon.end());
      break;
    case 1:
      polygon.resize(record[5] % 3);
      break;
    case 2:
      polygon[k].x = anywhere(static_cast<std::uint8_t>(250 + record[6] % 6), 3);
      break;
    case 3:
      polygon.push_back(polygon[k]);
      break;
    case 4:
      std::swap(polygon[k], polygon[m]);
      break;
    case 5:
      polygon[k] = {inner(record[6], record[8] % 4), inner(record[7], record[8] % 4)};
      break;
    case 6: {  // a new corner in the middle of another edge
      const LocalPoint a = polygon[m], b = polygon[(m + 1) % n];
      polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(k), {(a.x + b.x) / 2, (a.y + b.y) / 2});
      break;
    }
    case 7:  // off a line by one
      polygon[k].y += record[6] % 2 == 0 ? 1 : -1;
      break;
    case 8:
      for (LocalPoint& p : polygon) p.y = p.x;
      break;
    default:  // there and back again
      for (std::size_t left = n; left-- > 0;) polygon.push_back(polygon[left]);
      break;
  }
  return polygon;
}

class Decoder {
 public:
  Trace run(Bytes bytes) {
    header(next(bytes));
    for (record_ = 1; !bytes.empty() && edits_ < kMaxEdits; ++record_) record(next(bytes));
    return std::move(trace_);
  }

 private:
  using Record = std::array<std::uint8_t, kRecord>;

  static Record next(Bytes& bytes) {
    Record record{};
    const std::size_t n = std::min(bytes.size(), kRecord);
    std::copy_n(bytes.begin(), n, record.begin());
    bytes = bytes.subspan(n);
    return record;
  }

  void header(const Record& h) {
    window_ = kWindows[h[3] % kWindows.size()];
    origin_ = kOrigins[h[4] % kOrigins.size()];
    if (h[2] % 4 != 3) return;
    unsigned bits = little<std::uint16_t>(h.data());
    for (Block a = 1; a <= 4; ++a) {
      for (Block b = a; b <= 4; ++b, bits >>= 1) {
        if (bits & 1U) trace_.preserve.add(a, b);
      }
    }
  }

  void record(const Record& r) {
    const auto action = static_cast<Action>(r[0] % 16);
    const Cell cell = cellAt(r[1]);
    switch (action) {
      case Action::replace:
      case Action::replaceB:
      case Action::replaceC:
        clear(cell);
        place(cell, r, 0);
        break;
      case Action::place:
        place(cell, r, r[4]);
        break;
      case Action::fill:
        fill(r);
        break;
      case Action::spoilt: {
        const auto& polygons = shape(r).polygons;
        add(cell, block(r, 0), spoil(oracle::turned(polygons[r[9] % polygons.size()], r[3] % 8), r));
        break;
      }
      case Action::hull:
      case Action::hullB:
        add(cell, block(r, 0), hullOf(withVertices(r, 3 + r[2] % 4, inner)));
        break;
      case Action::free:
        add(cell, block(r, 0), withVertices(r, r[2] % (kShortVertices + 1), anywhere));
        break;
      case Action::remove:
        remove(cell, r[2]);
        break;
      case Action::removeRecord:
        removeRecord(little<std::uint32_t>(&r[4]));
        break;
      case Action::clear:
        clear(cell);
        break;
      case Action::commit:
        trace_.edits.push_back(Edit::commit());
        return;
      case Action::vertices:
        keepVertices(r);
        return;
      case Action::raw:
        add({little<std::int32_t>(&r[4]), little<std::int32_t>(&r[8])}, little<std::uint32_t>(&r[12]),
            std::exchange(kept_, {}));
        break;
      case Action::preserve:
        trace_.preserve.add(little<std::uint32_t>(&r[4]), little<std::uint32_t>(&r[8]));
        return;
    }
    if (r[0] & 0x30) trace_.edits.push_back(Edit::commit());
  }

  Cell cellAt(std::uint8_t byte) const {
    const std::int32_t at = byte % (window_.width * window_.height);
    return {origin_.i + at % window_.width, origin_.j + at / window_.width};
  }

  static const oracle::NamedShape& shape(const Record& r) {
    return oracle::degenerateShapes()[r[2] % oracle::degenerateShapes().size()];
  }

  // One block for all of a shape's polygons, or one after the other.
  static Block block(const Record& r, std::size_t polygon) {
    const std::size_t step = r[3] & 0x80 ? polygon : 0;
    return static_cast<Block>(1 + (r[0] / 64 + step) % 4);
  }

  void place(Cell cell, const Record& r, unsigned leaveOut) {
    const auto& polygons = shape(r).polygons;
    for (std::size_t k = 0; k < polygons.size(); ++k) {
      if (polygons.size() > 1 && leaveOut >> k & 1U) continue;
      add(cell, block(r, k), oracle::turned(polygons[k], r[3] % 8));
    }
  }

  void fill(const Record& r) {
    const Cell a = cellAt(r[1]);
    const Cell b = cellAt(r[4]);
    int left = kMaxFill;
    for (std::int32_t j = std::min(a.j, b.j); j <= std::max(a.j, b.j); ++j) {
      for (std::int32_t i = std::min(a.i, b.i); i <= std::max(a.i, b.i) && left > 0; ++i, --left) place({i, j}, r, 0);
    }
  }

  template <class Coordinate>
  LocalPolygon withVertices(const Record& r, std::size_t count, Coordinate coordinate) {
    LocalPolygon polygon = std::exchange(kept_, {});
    const int grid = r[3] / 8 % 4;
    for (std::size_t k = kFirstVertex; k < kFirstVertex + 2 * count; k += 2) {
      polygon.push_back({coordinate(r[k], grid), coordinate(r[k + 1], grid)});
    }
    return polygon;
  }

  void keepVertices(const Record& r) {
    const std::size_t count = 3 - r[0] / 64 % 3;
    constexpr std::size_t kFive = 5;
    for (std::size_t k = 0; k < count && kept_.size() < kMaxVertices; ++k) {
      const std::uint8_t* at = &r[1 + k * kFive];
      const std::uint64_t bits = little<std::uint32_t>(at) | std::uint64_t{at[4]} << 32;
      const auto coordinate = [](std::uint64_t twenty) {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(twenty & 0xfffff) << 12) >> 12;
      };
      kept_.push_back({coordinate(bits), coordinate(bits >> 20)});
    }
  }

  void add(Cell cell, Block block, LocalPolygon vertices) {
    ++edits_;
    const std::size_t index = placedBy_ == record_ ? ++placed_ : placed_ = 1;
    placedBy_ = record_;
    std::string name = nameOf(record_, index);
    inCell_[cell].push_back(name);
    trace_.edits.push_back(Edit::add(std::move(name), ScenePolygon{cell, block, std::move(vertices)}));
  }

  // The polygon may be one that is refused when it is added. The bytes alone do not say that.
  void remove(Cell cell, std::size_t which) {
    const auto found = inCell_.find(cell);
    if (found == inCell_.end() || found->second.empty()) return;
    const auto at = found->second.begin() + static_cast<std::ptrdiff_t>(which % found->second.size());
    removeNamed(std::move(*at));
    found->second.erase(at);
  }

  void removeRecord(std::uint32_t index) { removeNamed(index == kNoRecord ? "none" : nameOf(index % record_, 1)); }

  // The letters decide which door the edit takes.
  static std::string nameOf(std::size_t record, std::size_t index) {
    const std::string letters = oracle::randomLetters(record);
    return index == 1 ? fmt::format("p{}{}", record, letters) : fmt::format("p{}.{}{}", record, index, letters);
  }

  void clear(Cell cell) {
    const auto found = inCell_.find(cell);
    if (found == inCell_.end()) return;
    for (std::string& name : found->second) removeNamed(std::move(name));
    found->second.clear();
  }

  void removeNamed(std::string name) {
    ++edits_;
    trace_.edits.push_back(Edit::remove(std::move(name)));
  }

  Trace trace_;
  Window window_{};
  Cell origin_;
  LocalPolygon kept_;
  std::map<Cell, std::vector<std::string>> inCell_;
  std::size_t record_ = 0;  // its number; the header is 0
  std::size_t placedBy_ = 0;
  std::size_t placed_ = 0;
  std::size_t edits_ = 0;
};

}  // namespace

Trace decode(Bytes bytes) { return Decoder().run(bytes); }

}  // namespace lgs::fuzz
