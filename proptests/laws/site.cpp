#include "site.h"

#include "oracle/reference/naive.h"
#include "oracle/trace/dump.h"
#include "proptests/support/law.h"
#include "proptests/support/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>

namespace lgs::test {
namespace {

using oracle::Edit;
using Shape = std::vector<LocalPolygon>;
namespace gen = rc::gen;

constexpr Cell kFarCorner{7, 5};  // of the site

rc::Gen<Cell> anyCell() {
  const auto cell = gen::pair(gen::inRange(0, kFarCorner.i + 1), gen::inRange(0, kFarCorner.j + 1));
  return gen::resize(rc::kNominalSize, gen::map(cell, [](std::pair<int, int> c) { return Cell{c.first, c.second}; }));
}

rc::Gen<CellRect> anyRect() {
  return gen::map(gen::pair(anyCell(), anyCell()), [](const std::pair<Cell, Cell>& corners) {
    const auto& [a, b] = corners;
    return CellRect{{std::min(a.i, b.i), std::min(a.j, b.j)}, {std::max(a.i, b.i), std::max(a.j, b.j)}};
  });
}

rc::Gen<Block> anyBlock() { return gen::resize(rc::kNominalSize, gen::inRange<Block>(0, 4)); }

std::string inWords(Cell c) { return fmt::format("({}, {})", c.i, c.j); }

/// The polygon that is overlapped stands in the cell, with that block. The one that overlaps it is one of the shape's.
bool namesAnOverlap(const Site& site, const Error& error, const Shape& shape) {
  const auto other = site.stage.world.polygon(error.other);
  if (!other || site.stage.world.cellOf(error.other) != error.cell || other->block != error.otherBlock) return false;
  if (error.polygon < 0 || static_cast<std::size_t>(error.polygon) >= shape.size()) return false;
  const LocalPolygon there(other->vertices.begin(), other->vertices.end());
  return oracle::overlap(shape[static_cast<std::size_t>(error.polygon)], there);
}

template <class T>
void expectVerdict(const Site& site, const Expected<T>& result, std::optional<ErrorCode> refusal, Cell cell,
                   const Shape& shape) {
  if (refusal) {
    failUnless(!result, "accepted, but must be refused");
    failUnless(result.error().code == *refusal && result.error().cell == site.at(cell), "refused for another reason");
    if (*refusal == ErrorCode::overlap)
      failUnless(namesAnOverlap(site, result.error(), shape), "the refusal names what does not overlap");
  } else if (!result) {
    failIf("refused, but is good: " + message(result.error()));
  }
}

PolygonHandle handleOf(const Site& site, Cell cell, const LocalPolygon& polygon) {
  for (const PolygonFields& p : polygonsIn(site.stage.world, site.at(cell)))
    if (p.vertices == polygon) return p.handle;
  failIf("a polygon that was added is not there");
  return {};
}

/// What the world says of its cells is what the model says.
void expectPolygons(const Site& site, const SiteModel& model) {
  for (const Cell cell : cellsOf({{}, kFarCorner})) {
    const std::vector<PolygonFields> there = polygonsIn(site.stage.world, site.at(cell));
    const auto& expected = model.standing.in(cell);
    failUnless(there.size() == expected.size(), "another number of polygons stands in a cell");
    for (const oracle::Model::Placed& e : expected) {
      const auto isThat = [&](const PolygonFields& p) { return p.vertices == e.vertices && p.block == e.block; };
      failUnless(std::ranges::any_of(there, isThat), "other polygons stand in a cell");
    }
  }
}

oracle::Scene sceneOf(const Site& site, const SiteModel& model) {
  oracle::Scene scene{{}, site.setting.preserve};
  for (const auto& [cell, placed] : model.standing.cells())
    for (const oracle::Model::Placed& p : placed) scene.polygons.push_back({site.at(cell), p.block, p.vertices});
  return scene;
}

// --- Edits -----------------------------------------------------------------------------------------------------------

enum class Door { vertices, floats, doubles, shape };

struct Add : SiteEdit {
  Cell cell = *anyCell();
  Block block = *anyBlock();
  Door door = *gen::element(Door::vertices, Door::shape, Door::shape, Door::floats, Door::doubles);
  AnyShape shape = *gen::arbitrary<AnyShape>();

  /// Only a shape can be of several polygons.
  Shape polygons() const { return door == Door::shape ? shape.polygons : Shape{shape.polygons[0]}; }

  void apply(SiteModel& model) const override {
    if (!model.refusal(cell, polygons())) model.add(cell, polygons(), block);
  }
  void run(const SiteModel& model, Site& site) const override {
    const auto refusal = model.refusal(cell, polygons());
    const ShapeId id = door == Door::shape ? shapeOf(site.stage.world, shape.polygons) : ShapeId{};
    if (refusal && site.manner == Manner::withoutRefused) return;
    std::vector<PolygonHandle> handles(polygons().size());
    const auto added = addTo(site, id, handles);
    expectVerdict(site, added, refusal, cell, polygons());
    if (!added) return;
    handles[0] = *added;
    site.story.handles.insert(site.story.handles.end(), handles.begin(), handles.end());
  }
  Expected<PolygonHandle> addTo(Site& site, ShapeId id, std::span<PolygonHandle> handles) const {
    World& world = site.stage.world;
    const LocalPolygon& polygon = shape.polygons[0];
    if (door == Door::shape) return world.add(site.at(cell), id, block, handles);
    if (door == Door::floats)
      return world.add(site.at(cell), std::span<const FloatPoint>(reals<float>(polygon)), block);
    if (door == Door::doubles)
      return world.add(site.at(cell), std::span<const DoublePoint>(reals<double>(polygon)), block);
    return world.add(site.at(cell), std::span<const LocalPoint>(polygon), block);
  }
  template <class Real>
  static std::vector<RealPoint<Real>> reals(const LocalPolygon& polygon) {
    std::vector<RealPoint<Real>> points;
    for (const LocalPoint& v : polygon) points.push_back({static_cast<Real>(v.x) / U, static_cast<Real>(v.y) / U});
    return points;
  }
  void show(std::ostream& out) const override {
    constexpr const char* kDoors[] = {"vertices", "floats", "doubles", "shape"};
    out << fmt::format("add by {} in {}, block {}: {}", kDoors[static_cast<int>(door)], inWords(cell), block,
                       rc::toString(AnyShape{polygons()}));
  }
};

struct Fill : SiteEdit {
  CellRect rect = *anyRect();
  Block block = *anyBlock();
  AnyShape shape = *gen::arbitrary<AnyShape>();

  std::optional<Cell> firstRefused(const SiteModel& model) const {
    for (const Cell cell : cellsOf(rect))
      if (model.refusal(cell, shape.polygons)) return cell;
    return std::nullopt;
  }
  void apply(SiteModel& model) const override {
    if (firstRefused(model)) return;
    for (const Cell cell : cellsOf(rect)) model.add(cell, shape.polygons, block);
  }
  void run(const SiteModel& model, Site& site) const override {
    World& world = site.stage.world;
    const ShapeId id = shapeOf(world, shape.polygons);
    const auto refused = firstRefused(model);
    if (refused && site.manner == Manner::withoutRefused) return;
    const auto refusal = refused ? model.refusal(*refused, shape.polygons) : std::nullopt;
    if (site.manner != Manner::cellByCell) {
      const auto filled = world.fill({site.at(rect.min), site.at(rect.max)}, id, block);
      expectVerdict(site, filled, refusal, refused.value_or(Cell{}), shape.polygons);
      failUnless(!filled || *filled == cellsOf(rect).size(), "another number of cells is filled");
    } else if (refused) {
      expectVerdict(site, world.add(site.at(*refused), id, block), refusal, *refused, shape.polygons);
    } else {
      for (const Cell cell : cellsOf(rect))
        expectVerdict(site, world.add(site.at(cell), id, block), std::nullopt, cell, shape.polygons);
    }
    if (refused) return;
    for (const Cell cell : cellsOf(rect))
      for (const LocalPolygon& p : shape.polygons) site.story.handles.push_back(handleOf(site, cell, p));
  }
  void show(std::ostream& out) const override {
    out << fmt::format("fill {} to {}, block {}: {}", inWords(rect.min), inWords(rect.max), block, rc::toString(shape));
  }
};

struct Clear : SiteEdit {
  CellRect rect = *anyRect();

  void apply(SiteModel& model) const override {
    for (const Cell cell : cellsOf(rect)) model.clear(cell);
  }
  void run(const SiteModel& model, Site& site) const override {
    std::size_t count = 0;
    for (const Cell cell : cellsOf(rect)) {
      for (const oracle::Model::Placed& p : model.standing.in(cell)) {
        site.removed.push_back(handleOf(site, cell, p.vertices));
        ++count;
      }
      if (site.manner == Manner::cellByCell) removeAll(site.stage.world, site.at(cell));
    }
    if (site.manner == Manner::cellByCell) return;
    const auto cleared = site.stage.world.clear({site.at(rect.min), site.at(rect.max)});
    failUnless(cleared.has_value() && *cleared == count, "another number of polygons is cleared away");
  }
  void show(std::ostream& out) const override {
    out << fmt::format("clear {} to {}", inWords(rect.min), inWords(rect.max));
  }
};

struct Remove : SiteEdit {
  std::size_t which = *gen::resize(rc::kNominalSize, gen::inRange<std::size_t>(0, 100));

  /// The cell, and the polygon there.
  std::pair<Cell, oracle::Model::Placed> gone(const SiteModel& model) const {
    std::size_t left = which % model.standing.polygons();
    for (const auto& [cell, placed] : model.standing.cells()) {
      if (left < placed.size()) return {cell, placed[left]};
      left -= placed.size();
    }
    return {};
  }
  void checkPreconditions(const SiteModel& model) const override { RC_PRE(model.standing.polygons() != 0); }
  void apply(SiteModel& model) const override {
    model.standing.apply(Edit::remove(gone(model).second.name));
    ++model.removed;
  }
  void run(const SiteModel& model, Site& site) const override {
    const auto [cell, placed] = gone(model);
    site.removed.push_back(handleOf(site, cell, placed.vertices));
    failUnless(site.stage.world.remove(site.removed.back()).has_value(), "a polygon can not be removed");
  }
  void show(std::ostream& out) const override { out << fmt::format("remove polygon {} of those there", which); }
};

struct RemoveAgain : SiteEdit {
  std::size_t which = *gen::resize(rc::kNominalSize, gen::inRange<std::size_t>(0, 100));

  void checkPreconditions(const SiteModel& model) const override { RC_PRE(model.removed != 0); }
  void run(const SiteModel&, Site& site) const override {
    if (site.manner == Manner::withoutRefused) return;
    const PolygonHandle handle = site.removed[which % site.removed.size()];
    const auto again = site.stage.world.remove(handle);
    const Error expected{.code = ErrorCode::staleHandle, .other = handle};
    failUnless(!again && areAlike(again.error(), expected), "a handle of a removed polygon is not stale");
  }
  void show(std::ostream& out) const override { out << fmt::format("remove polygon {} of those removed", which); }
};

struct Refused : SiteEdit {
  BadEdit bad = *gen::resize(rc::kNominalSize, gen::elementOf(badAnywhere()));

  void run(const SiteModel&, Site& site) const override {
    if (site.manner == Manner::withoutRefused) return;
    failUnless(areAlike(bad.attempt(site.stage), bad.expected), "not refused as it must be");
  }
  void show(std::ostream& out) const override { out << "a bad edit: " << bad.name; }
};

struct Commit : SiteEdit {
  void run(const SiteModel& model, Site& site) const override {
    Site::Story& story = site.story;
    story.changes.push_back(copyOf(site.stage.world.commit()));
    story.outlines.push_back(oracle::outlineOf(site.stage.world));
    std::vector<Cell> cells = cellsOf({site.at({}), site.at(kFarCorner)});
    story.snapshots.push_back(snapshotOf(site.stage.world, cells));
    expectPolygons(site, model);
    failUnless(story.outlines.back() == naiveOutline(sceneOf(site, model)), "the outline is not that of the model");
  }
  void show(std::ostream& out) const override { out << "commit"; }
};

}  // namespace

std::optional<ErrorCode> SiteModel::refusal(Cell cell, const Shape& shape) const {
  for (const LocalPolygon& polygon : shape) {
    const auto verdict = standing.judge(Edit::add("new", {cell, 0, polygon}));
    if (!verdict.accepted) return verdict.code;
  }
  return std::nullopt;
}

void SiteModel::add(Cell cell, const Shape& shape, Block block) {
  for (const LocalPolygon& polygon : shape) standing.apply(Edit::add(std::to_string(++added), {cell, block, polygon}));
}

void SiteModel::clear(Cell cell) {
  while (!standing.in(cell).empty()) {
    standing.apply(Edit::remove(std::string(standing.in(cell).back().name)));
    ++removed;
  }
}

Site::Site(Setting where, Manner how) : setting(std::move(where)), manner(how) {
  if (!setting.preserve.empty())
    stage.world = World([pairs = setting.preserve](Block a, Block b) { return pairs(a, b); });
  stage.square = shapeOf(stage.world, {unitSquare()});
}

Site::Story storyOf(const SiteEdits& edits, const Setting& setting, Manner manner) {
  Site site(setting, manner);
  rc::state::runAll(edits.list, SiteModel(), site);
  return site.story;
}

void showValue(const Setting& setting, std::ostream& out) {
  out << "cells from " << inWords(setting.corner);
  for (const auto& [a, b] : setting.preserve.pairs()) out << fmt::format(", preserve {} {}", a, b);
}

void showValue(const SiteEdits& edits, std::ostream& out) {
  for (const auto& edit : edits.list) {
    edit->show(out);
    out << '\n';
  }
}

}  // namespace lgs::test

namespace rc {

using namespace lgs;
using namespace lgs::test;

Gen<Setting> Arbitrary<Setting>::arbitrary() {
  // About the origin, across borders of chunks, at the ends of the world.
  const auto index = gen::element<std::int32_t>(0, -4, 28, -36, kMaxCell - 9, -kMaxCell);
  using Pair = std::pair<Block, Block>;
  const auto pairs = gen::container<std::vector<Pair>>(gen::pair(anyBlock(), anyBlock()));
  return gen::map(gen::tuple(index, index, gen::oneOf(gen::just(std::vector<Pair>()), gen::scale(0.05, pairs))),
                  [](const std::tuple<std::int32_t, std::int32_t, std::vector<Pair>>& drawn) {
                    const auto& [i, j, preserved] = drawn;
                    Setting setting{{i, j}, {}};
                    for (const auto& [a, b] : preserved) setting.preserve.add(a, b);
                    return setting;
                  });
}

Gen<SiteEdits> Arbitrary<SiteEdits>::arbitrary() {
  const auto one = [](const SiteModel&) {
    return state::gen::execOneOfWithArgs<Add, Add, Fill, Clear, Remove, Remove, RemoveAgain, Refused, Commit,
                                         Commit>()();
  };
  return gen::map(state::gen::commands(SiteModel(), one),
                  [](const state::Commands<SiteEdit>& list) { return SiteEdits{list}; });
}

}  // namespace rc
