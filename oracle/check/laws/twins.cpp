// Laws 4 and 5 on whole worlds: the same ground elsewhere, with other blocks, turned or mirrored, shows the same segments
// there; and a part of it with the cells around shows what the whole world shows of that part. A twin is a world that
// gets what stands in the edited cells, after each commit.
#include "oracle/check/laws/list.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace lgs::oracle {
namespace {

constexpr std::int32_t kUnit = kUnitsPerCell;
constexpr Cell kMove{13, 21};                       // so that the borders of chunks are elsewhere
constexpr Block kFactor = 0x9e37'79b1, kPlus = 77;  // odd: no two blocks become one

/// Where things are in a twin.
struct Way {
  const char* name;
  Cell (*cell)(Cell);
  LocalPoint (*vertex)(LocalPoint);
  Point (*point)(Point);
  bool isMirrored = false;  ///< what ran counter-clockwise runs clockwise
  bool isRenamed = false;   ///< blocks have other numbers, and polygons begin with another vertex
  bool isCut = false;       ///< only some columns are there
};

Cell sameCell(Cell c) { return c; }
LocalPoint sameVertex(LocalPoint v) { return v; }
Point samePoint(Point p) { return p; }

constexpr std::array kWays{
    Way{"moved, and with other blocks",
        [](Cell c) {
          return Cell{c.i + kMove.i, c.j + kMove.j};
        },
        sameVertex,
        [](Point p) {
          return Point{p.x + kMove.i * std::int64_t{kUnit}, p.y + kMove.j * std::int64_t{kUnit}};
        },
        false, true},
    Way{"turned by a quarter",
        [](Cell c) {
          return Cell{-c.j - 1, c.i};
        },
        [](LocalPoint v) {
          return LocalPoint{kUnit - v.y, v.x};
        },
        [](Point p) {
          return Point{-p.y, p.x};
        }},
    Way{"mirrored",
        [](Cell c) {
          return Cell{-c.i - 1, c.j};
        },
        [](LocalPoint v) {
          return LocalPoint{kUnit - v.x, v.y};
        },
        [](Point p) {
          return Point{-p.x, p.y};
        },
        true},
    Way{"without the columns east of some", sameCell, sameVertex, samePoint, false, false, true}};

Block renamed(Block block) { return block * kFactor + kPlus; }

PreservePairs pairsOf(const Way& way, const PreservePairs& pairs) {
  if (!way.isRenamed) return pairs;
  PreservePairs out;
  for (const auto& [a, b] : pairs.pairs()) out.add(renamed(a), renamed(b));
  return out;
}

class Twin {
 public:
  Twin(const Way& way, const PreservePairs& preserve)
      : way_(way), preserve_(pairsOf(way, preserve)), world_(oracle::relationOf(preserve_)) {}

  // What is not in memory stays as it was.
  void follow(const Seen& seen) {
    const Model& model = seen.model();
    CellSet cells = seen.edited;
    if (seen.isAnywhere) {
      for (const auto& entry : model.standing().cells()) cells.insert(entry.first);
      for (const auto& entry : known_) cells.insert(entry.first);
    }
    for (const Cell cell : cells)
      if (isThere(cell) && model.isLoaded(cell)) follow(cell, model.standing().in(cell));
    world_.commit();
  }

  Found compare(Seen& seen) const {
    if (isOver_ || !seen.model().isWhole()) return std::nullopt;
    Outline expected = seen.shown(), actual = outlineOf(world_);
    for (Outline* outline : {&expected, &actual})
      if (way_.isCut) std::erase_if(*outline, [&](const OutlineSegment& s) { return cellOf(s).i > *last_; });
    for (OutlineSegment& s : expected) s = mapped(s);
    std::ranges::sort(expected);
    if (expected == actual) return std::nullopt;
    auto found = seen.differing(Mismatch::Kind::history, sceneOf(), expected, actual);
    if (found) found->text = fmt::format("{}, the same ground has another outline:\n{}", way_.name, found->text);
    return found;
  }

 private:
  struct Stands {
    Block block = 0;
    LocalPolygon vertices;
    PolygonHandle handle{};
    bool operator==(const Stands& other) const { return block == other.block && vertices == other.vertices; }
  };

  bool isThere(Cell cell) {
    if (!last_) last_ = cell.i;
    return !way_.isCut || cell.i <= std::int64_t{*last_} + 1;
  }

  Stands mapped(const Standing::Placed& placed) const {
    Stands out{placed.block, placed.vertices};
    for (LocalPoint& v : out.vertices) v = way_.vertex(v);
    if (way_.isMirrored) std::ranges::reverse(out.vertices);
    if (way_.isRenamed) std::rotate(out.vertices.begin(), out.vertices.begin() + 1, out.vertices.end());
    if (way_.isRenamed) out.block = renamed(out.block);
    return out;
  }

  OutlineSegment mapped(OutlineSegment s) const {
    for (Point* p : {&s.start, &s.end}) *p = way_.point(*p);
    for (auto* ghost : {&s.ghost1, &s.ghost2})
      if (*ghost) *ghost = way_.point(**ghost);
    if (way_.isRenamed) s.block = renamed(s.block);
    if (!way_.isMirrored) return s;
    std::swap(s.start, s.end);
    std::swap(s.ghost1, s.ghost2);
    return s;
  }

  void follow(Cell cell, const std::vector<Standing::Placed>& placed) {
    std::vector<Stands>& known = known_[cell];
    std::vector<Stands> now;
    for (const Standing::Placed& p : placed) now.push_back(mapped(p));
    std::vector<PolygonHandle> gone;
    std::erase_if(known, [&](const Stands& was) {
      const bool isGone = std::ranges::find(now, was) == now.end();
      if (isGone) gone.push_back(was.handle);
      return isGone;
    });
    std::erase_if(now, [&](const Stands& is) { return std::ranges::find(known, is) != known.end(); });
    std::vector<NewPolygon> comes;
    for (const Stands& is : now) comes.push_back({is.vertices, is.block});
    std::vector<PolygonHandle> handles(comes.size());
    isOver_ = isOver_ || !inRange(way_.cell(cell)) || !world_.exchange(way_.cell(cell), gone, comes, handles);
    for (std::size_t k = 0; k < now.size(); ++k) now[k].handle = handles[k];
    known.insert(known.end(), now.begin(), now.end());
    if (known.empty()) known_.erase(cell);
  }

  Scene sceneOf() const {
    Scene scene{{}, preserve_};
    for (const auto& [cell, stands] : known_)
      for (const Stands& is : stands) scene.polygons.push_back({way_.cell(cell), is.block, is.vertices});
    return scene;
  }

  const Way& way_;
  PreservePairs preserve_;
  World world_;
  std::map<Cell, std::vector<Stands>> known_;  // by the cells of the world that it follows
  std::optional<std::int32_t> last_;           // column that is compared, if it is cut
  bool isOver_ = false;                        // it has come to the end of the world
};

class TwinsLaw : public Law {
 public:
  void begin(Seen& seen) override {
    for (const Way& way : kWays) twins_.emplace_back(way, seen.trace.preserve);
  }

  Found afterCommit(Seen& seen) override {
    for (Twin& twin : twins_) twin.follow(seen);
    return std::nullopt;
  }

  Found nowAndThen(Seen& seen) override {
    for (Twin& twin : twins_) {
      if (seen.isAnywhere) twin.follow(seen);  // it has rolled back since the last commit
      if (auto found = twin.compare(seen)) return found;
    }
    return std::nullopt;
  }

 private:
  std::vector<Twin> twins_;
};

}  // namespace

std::unique_ptr<Law> laws::twins() { return std::make_unique<TwinsLaw>(); }

}  // namespace lgs::oracle
