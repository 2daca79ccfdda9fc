// Arbitrary polygons, most of them bad. What the slow validator (oracle/check/validity.h) says is held against every way
// into the engine: add() by lattice points and by doubles, shape(), fill(). A refusal is total: the world reads as before,
// to the last segment and handle. Two worlds are kept: one edited cell by cell, one with rectangles filled at once.
#include "fuzz/target.h"
#include "oracle/check/model.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/mirror.h"

#include <fmt/format.h>
#include <lgs/world.h>
#include <algorithm>
#include <array>
#include <unordered_map>

namespace lgs::fuzz {
namespace {

using oracle::Edit;
using oracle::LocalPolygon;
using oracle::Mismatch;
using oracle::Model;

constexpr std::array kActions{Action::spoilt,   Action::spoilt, Action::spoilt, Action::free,  Action::free,
                              Action::vertices, Action::raw,    Action::hull,   Action::place, Action::remove};

PreserveRelation relationOf(const oracle::PreservePairs& pairs) {
  if (pairs.empty()) return {};
  return [pairs](Block a, Block b) { return pairs(a, b); };
}

bool tooMany(const ErrorCode code) { return code == ErrorCode::capacity; }

class Run {
 public:
  Run(const oracle::Trace& trace, oracle::CheckStats& stats)
      : trace_(trace), stats_(stats), world_(relationOf(trace.preserve)), bulk_(relationOf(trace.preserve)) {}

  std::optional<Finding> run() {
    for (edit_ = 0; edit_ < trace_.edits.size() && text_.empty() && !full_; ++edit_) {
      const Edit& edit = trace_.edits[edit_];
      if (edit.kind == Edit::Kind::add) {
        add(edit);
      } else if (edit.kind == Edit::Kind::remove) {
        remove(edit);
      } else {
        commit();
      }
    }
    if (text_.empty() && !full_) commit();
    if (text_.empty()) return std::nullopt;
    return Finding{text_, mismatch()};
  }

 private:
  struct Placed {
    PolygonHandle handle;
    PolygonHandle inBulk;
  };

  // What a refusal must leave as it is.
  struct Reading {
    oracle::Outline outline;
    std::vector<PolygonHandle> handles;
    Stats stats;
    bool operator==(const Reading& other) const {
      return outline == other.outline && handles == other.handles && stats.polygons == other.stats.polygons &&
             stats.cells == other.stats.cells && stats.segments == other.stats.segments;
    }
  };
  static Reading readingOf(const World& world, Cell cell) {
    Reading reading{oracle::outlineOf(world), {}, world.stats()};
    for (const PlacedPolygon& p : world.polygons(cell)) reading.handles.push_back(p.handle);
    return reading;
  }

  void add(const Edit& edit) {
    ++stats_.edits;
    const auto& [cell, block, vertices] = edit.polygon;
    if (model_.isAlive(edit.name)) return;
    const Model::Verdict verdict = model_.judge(edit);
    judgeShape(vertices);
    const Reading before = verdict.accepted ? Reading() : readingOf(world_, cell);
    const auto done = addInTurn(cell, vertices, block);
    if (done ? !judge(edit, verdict, std::nullopt) : !judge(edit, verdict, done.error())) return;
    if (!done) {
      ++stats_.refused;
      if (readingOf(world_, cell) != before) fail(fmt::format("the refusal of '{}' changed the world", edit.name));
      return fillAround(edit);
    }
    const auto filled = bulk_.fill({cell, cell}, *bulk_.shape(std::span<const LocalPoint>(vertices)), block);
    if (!filled) return fail("fill() refuses what add() accepts: " + message(filled.error()));
    placed_[edit.name] = {*done, newestIn(bulk_, cell)};
    model_.apply(edit);
  }

  // By lattice points or by doubles, which are exact here: it must make no difference.
  Expected<PolygonHandle> addInTurn(Cell cell, const LocalPolygon& vertices, Block block) {
    if (edit_ % 2 == 0) return world_.add(cell, std::span<const LocalPoint>(vertices), block);
    std::vector<DoublePoint> points;
    for (const LocalPoint& p : vertices) points.push_back({p.x / double{kUnitsPerCell}, p.y / double{kUnitsPerCell}});
    return world_.add(cell, std::span<const DoublePoint>(points), block);
  }

  bool judge(const Edit& edit, const Model::Verdict& verdict, const std::optional<Error>& error) {
    if (error && tooMany(error->code)) {
      full_ = true;
    } else if (error && (message(*error).empty() || (error->hasCell() && error->cell != edit.polygon.cell))) {
      fail(fmt::format("refused in another cell than it was meant for: '{}': {}", edit.name, message(*error)));
    } else if (verdict.accepted == error.has_value() || (error && error->code != verdict.code)) {
      fail(fmt::format("'{}' {}, but must be {}", edit.name, error ? "is refused: " + message(*error) : "is accepted",
                       verdict.accepted ? "accepted" : fmt::format("refused as {}", name(*verdict.code))));
    } else if (error && error->code == ErrorCode::overlap) {
      judgeOther(edit, *error);
    }
    return text_.empty() && !full_;
  }

  // The polygon that is named as overlapped must be.
  void judgeOther(const Edit& edit, const Error& error) {
    const auto other = world_.polygon(error.other);
    if (!other) return fail(fmt::format("'{}' overlaps a polygon that is not there", edit.name));
    if (!oracle::overlap({other->vertices.begin(), other->vertices.end()}, edit.polygon.vertices)) {
      fail(fmt::format("'{}' is said to overlap a polygon that it does not overlap", edit.name));
    }
  }

  // shape() knows nothing of the cell, and judges the rest the same way.
  void judgeShape(const LocalPolygon& vertices) {
    const auto fault = oracle::faultOf(vertices);
    const auto shape = bulk_.shape(std::span<const LocalPoint>(vertices));
    if (!shape && tooMany(shape.error().code)) {
      full_ = true;
    } else if (shape.has_value() == fault.has_value() || (!shape && shape.error().code != *fault)) {
      fail(fmt::format("shape(): {}, but must be {}", shape ? "accepted" : message(shape.error()),
                       fault ? name(*fault) : "accepted"));
    }
  }

  // A rectangle with one cell that refuses: all or nothing.
  void fillAround(const Edit& edit) {
    const Cell cell = edit.polygon.cell;
    const auto shape = bulk_.shape(std::span<const LocalPoint>(edit.polygon.vertices));
    if (!shape || !inRange(cell)) return;
    const CellRect rect{{cell.i - 1, cell.j}, {cell.i + 1, cell.j + 1}};
    const std::uint64_t polygons = bulk_.stats().polygons;
    const auto filled = bulk_.fill(rect, *shape, edit.polygon.block);
    if (filled) return fail("fill() accepts a rectangle with a cell that refuses");
    if (bulk_.stats().polygons != polygons) return fail("a refused fill() changed the world");
    const bool reachesOut = !inRange(rect.min) || !inRange(rect.max);
    if (reachesOut ? filled.error().code != ErrorCode::cellOutOfRange : filled.error().code != ErrorCode::overlap) {
      fail("fill() is refused for another reason than add(): " + message(filled.error()));
    }
  }

  static PolygonHandle newestIn(const World& world, Cell cell) {
    PolygonHandle newest;
    for (const PlacedPolygon& p : world.polygons(cell)) newest = std::max(newest, p.handle);
    return newest;
  }

  void remove(const Edit& edit) {
    ++stats_.edits;
    const auto found = placed_.find(edit.name);
    if (found == placed_.end()) return;
    const Cell cell = model_.cellOf(edit.name);
    const auto done = world_.remove(found->second.handle);
    if (!done) return fail("a polygon that is there can not be removed: " + message(done.error()));
    const auto again = world_.remove(found->second.handle);
    if (again || again.error().code != ErrorCode::staleHandle)
      return fail("the handle of a removed polygon is not stale");
    model_.apply(edit);
    const bool last = model_.in(cell).empty();
    if (last && edit_ % 2 == 0) {
      const auto cleared = bulk_.clear({cell, cell});
      if (!cleared || *cleared != 1) return fail("clear() does not remove the one polygon of a cell");
    } else if (const auto removed = bulk_.remove(found->second.inBulk); !removed) {
      return fail("a polygon that was filled can not be removed: " + message(removed.error()));
    }
    placed_.erase(found);
  }

  void commit() {
    ++stats_.commits;
    const Changes& changes = world_.commit();
    if (auto problem = mirror_.update(world_, changes)) return fail(std::move(*problem));
    bulk_.commit();
    if (oracle::outlineOf(bulk_) != oracle::outlineOf(world_))
      fail("filled cells have another outline than single polygons");
    oracle::Scene scene = sceneOfModel();
    if (naive_(scene).outline != oracle::outlineOf(world_)) fail("the outline differs from the naive reference's");
  }

  oracle::Scene sceneOfModel() const {
    oracle::Scene scene;
    scene.preserve = trace_.preserve;
    for (const auto& [cell, polygons] : model_.cells()) {
      for (const Model::Placed& p : polygons) scene.polygons.push_back({cell, p.block, p.vertices});
    }
    return scene;
  }

  void fail(std::string text) {
    if (text_.empty()) text_ = std::move(text) + "\n";
  }

  Mismatch mismatch() const {
    Mismatch result;
    result.kind = Mismatch::Kind::refusal;
    result.text = text_;
    result.edits = edit_;
    result.scene = sceneOfModel();
    result.actual = oracle::outlineOf(world_);
    result.expected = result.actual;
    return result;
  }

  const oracle::Trace& trace_;
  oracle::CheckStats& stats_;
  World world_;
  World bulk_;
  Model model_;
  oracle::Mirror mirror_;
  oracle::NaiveReference naive_;
  std::unordered_map<std::string, Placed> placed_;
  std::size_t edit_ = 0;
  std::string text_;
  bool full_ = false;
};

std::optional<Finding> checkTrace(const oracle::Trace& trace, oracle::CheckStats& stats) {
  return Run(trace, stats).run();
}

std::optional<Finding> check(Bytes input, oracle::CheckStats& stats) { return checkTrace(decode(input), stats); }

}  // namespace

const Target kPolygons{"polygons", "bad polygons: refusals are right and total", check, decode, checkTrace, kActions,
                       {}};

}  // namespace lgs::fuzz
