// Arbitrary polygons, most of them bad. What the slow validator (oracle/reference/validity.h) says is held against every
// way into the engine: add() by lattice points and by doubles, shape(), fill(). A refusal is total: the world reads
// as before, to the last segment and handle; what an error names is to blame. Two worlds are kept: one edited cell by
// cell, one with rectangles filled at once.
#include "fuzz/target.h"
#include "oracle/reference/blame.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/dump.h"
#include "oracle/trace/mirror.h"
#include "oracle/trace/model.h"

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
using Kind = oracle::Mismatch::Kind;

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
    for (edit_ = 0; edit_ < trace_.edits.size() && !found_ && !full_; ++edit_) {
      const Edit& edit = trace_.edits[edit_];
      if (edit.kind == Edit::Kind::add) {
        add(edit);
      } else if (edit.kind == Edit::Kind::remove) {
        remove(edit);
      } else {
        commit();
      }
    }
    if (!found_ && !full_) commit();
    if (!found_) return std::nullopt;
    found_->edits = edit_;  // the last of them included
    return Finding{describe(found_->kind) + ":\n" + found_->text, std::move(found_)};
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
    if (done) {
      if (!verdict.accepted)
        return fail(Kind::verdict,
                    fmt::format("'{}' is accepted, but must be refused as {}", edit.name, name(*verdict.code)));
    } else {
      judge(fmt::format("'{}'", edit.name), done.error(), verdict.code, world_, cell, vertices);
      if (found_ || full_) return;
    }
    if (!done) {
      ++stats_.refused;
      if (readingOf(world_, cell) != before) {
        fail(Kind::refusal, fmt::format("the refusal of '{}' changed the world", edit.name));
      }
      return fillAround(edit);
    }
    const auto filled = bulk_.fill({cell, cell}, *bulk_.shape(std::span<const LocalPoint>(vertices)), block);
    if (!filled) return fail(Kind::verdict, "fill() refuses what add() accepts: " + message(filled.error()));
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

  // A refusal, against the reason there is, if any; `cell` is the one it must name.
  void judge(const std::string& who, const Error& error, std::optional<ErrorCode> reason, const World& world, Cell cell,
             const LocalPolygon& vertices) {
    if (tooMany(error.code)) {
      full_ = true;
    } else if (error.code != reason) {
      fail(Kind::verdict,
           fmt::format("{} is refused, but must be {}: {}", who,
                       reason ? fmt::format("refused as {}", name(*reason)) : "accepted", message(error)));
    } else if (error.cell != cell || message(error).empty()) {
      fail(Kind::verdict,
           fmt::format("the refusal of {} names another cell, or says nothing: {}", who, message(error)));
    } else if (const std::string wrong = oracle::wrongBlame(error, vertices); !wrong.empty()) {
      fail(Kind::verdict, fmt::format("the refusal of {} {}: {}", who, wrong, message(error)));
    } else if (error.code == ErrorCode::overlap) {
      judgeOther(who, error, world, cell, vertices);
    }
  }

  // The polygon that is named as overlapped must be.
  void judgeOther(const std::string& who, const Error& error, const World& world, Cell cell,
                  const LocalPolygon& vertices) {
    const auto other = world.polygon(error.other);
    if (!other || world.cellOf(error.other) != cell) {
      fail(Kind::verdict, fmt::format("{} is said to overlap a polygon that is not in its cell", who));
    } else if (!oracle::overlap({other->vertices.begin(), other->vertices.end()}, vertices)) {
      fail(Kind::verdict, fmt::format("{} is said to overlap a polygon that it does not overlap", who));
    }
  }

  // shape() knows nothing of the cell, and judges the rest the same way.
  void judgeShape(const LocalPolygon& vertices) {
    const auto fault = oracle::faultOf(vertices);
    const auto shape = bulk_.shape(std::span<const LocalPoint>(vertices));
    if (!shape) {
      judge("shape()", shape.error(), fault, bulk_, Error::kNoCell, vertices);
    } else if (fault) {
      fail(Kind::verdict, fmt::format("shape() accepts what must be refused as {}", name(*fault)));
    }
  }

  // A rectangle with one cell that refuses: all or nothing, and the first cell that refuses is named.
  void fillAround(const Edit& edit) {
    const Cell cell = edit.polygon.cell;
    const LocalPolygon& vertices = edit.polygon.vertices;
    const auto shape = bulk_.shape(std::span<const LocalPoint>(vertices));
    if (!shape || !inRange(cell)) return;
    const CellRect rect{{cell.i - 1, cell.j}, {cell.i + 1, cell.j}};
    const std::uint64_t polygons = bulk_.stats().polygons;
    const auto filled = bulk_.fill(rect, *shape, edit.polygon.block);
    if (filled) return fail(Kind::verdict, "fill() accepts a rectangle with a cell that refuses");
    if (bulk_.stats().polygons != polygons) return fail(Kind::refusal, "a refused fill() changed the world");
    if (!inRange(rect.min) || !inRange(rect.max)) {
      const Cell corner = inRange(rect.min) ? rect.max : rect.min;
      return judge("fill()", filled.error(), ErrorCode::cellOutOfRange, bulk_, corner, vertices);
    }
    Cell first = rect.min;
    while (first != cell && !refuses(first, vertices)) ++first.i;
    judge("fill()", filled.error(), ErrorCode::overlap, bulk_, first, vertices);
  }

  bool refuses(Cell cell, const LocalPolygon& vertices) const {
    const auto& placed = model_.in(cell);
    return std::any_of(placed.begin(), placed.end(),
                       [&](const Model::Placed& p) { return oracle::overlap(vertices, p.vertices); });
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
    if (!done) return fail(Kind::verdict, "a polygon that is there can not be removed: " + message(done.error()));
    const auto again = world_.remove(found->second.handle);
    if (again || again.error().code != ErrorCode::staleHandle)
      return fail(Kind::verdict, "the handle of a removed polygon is not stale");
    model_.apply(edit);
    const bool last = model_.in(cell).empty();
    if (last && edit_ % 2 == 0) {
      const auto cleared = bulk_.clear({cell, cell});
      if (!cleared || *cleared != 1) return fail(Kind::verdict, "clear() does not remove the one polygon of a cell");
    } else if (const auto removed = bulk_.remove(found->second.inBulk); !removed) {
      return fail(Kind::verdict, "a polygon that was filled can not be removed: " + message(removed.error()));
    }
    placed_.erase(found);
  }

  void commit() {
    ++stats_.commits;
    ++commits_;
    const Changes& changes = world_.commit();
    if (auto problem = mirror_.update(world_, changes)) return fail(Kind::changes, std::move(*problem));
    bulk_.commit();
    const oracle::Outline actual = oracle::outlineOf(world_);
    compareOutlines(Kind::naive, naive_(sceneOfModel()).outline, actual);
    compareOutlines(Kind::history, oracle::outlineOf(bulk_), actual);  // as rectangles, filled at once
  }

  void compareOutlines(Kind kind, const oracle::Outline& expected, const oracle::Outline& actual) {
    if (found_ || expected == actual) return;
    fail(kind, oracle::describe(oracle::compare(expected, actual)));
    found_->expected = expected;
  }

  oracle::Scene sceneOfModel() const {
    oracle::Scene scene;
    scene.preserve = trace_.preserve;
    for (const auto& [cell, polygons] : model_.cells()) {
      for (const Model::Placed& p : polygons) scene.polygons.push_back({cell, p.block, p.vertices});
    }
    return scene;
  }

  // The first failure is the one that counts.
  void fail(Kind kind, std::string text) {
    if (found_) return;
    if (!text.ends_with('\n')) text += '\n';
    const oracle::Outline outline = oracle::outlineOf(world_);
    found_ = Mismatch{kind, std::move(text), edit_, commits_, sceneOfModel(), outline, outline, {}};
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
  std::size_t commits_ = 0;
  std::optional<Mismatch> found_;
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
