// The rules of terrains for physics engines, which know no physics engine: which edges there are (EdgeSet), and law 13,
// nobody is buried (NewGround, WayOut). JavaScript does what they say to bodies and edges.
#include "bridge.h"
#include "find_hit.h"
#include "way_out.h"

#include <lgs/box2d/edges.h>

#include <algorithm>
#include <unordered_map>

namespace lgs::web {

/// Whether the form with this index, in the input of the call, is held by a block.
__attribute__((import_module("lgs"), import_name("holds"))) std::int32_t holdsInJavaScript(std::uint32_t form,
                                                                                           Block block);

/// A terrain over a world, for one physics world.
struct Terrain {
  Bridge* bridge;
  std::unordered_map<Block, std::uint32_t> materials;  ///< blocks with the same number may share an edge
  box2d::EdgeSet edges;
  std::optional<box2d::NewGround> ground = {};  ///< what the change did that is being shown
  std::optional<box2d::Box> around = {};        ///< where that concerns bodies
  box2d::Whose whose = box2d::Whose::free;      ///< which of them
  Block64 block = {};

  const World& world() const { return bridge->world; }
};

void DropTerrain::operator()(Terrain* terrain) const { delete terrain; }

namespace {

/// The head of a block with edges. web/package/src/terrain.ts reads it.
struct EdgeHead {
  double version;
  std::uint32_t removed, added, relinked, words;
};
static_assert(sizeof(EdgeHead) == 24);

DoublePoint unitsOf(double x, double y) { return {x * kUnitsPerCell, y * kUnitsPerCell}; }

/// Forms in the input: how many corners, the radius, the middle, and the corners; in cells. `from` is moved behind
/// them.
std::vector<box2d::Form> inputForms(std::size_t count, std::span<const double>& from) {
  std::vector<box2d::Form> forms(count);
  for (std::size_t k = 0; k < count; ++k) {
    box2d::Form& form = forms[k];
    const auto corners = static_cast<std::size_t>(from[0]);
    form.radius = from[1] * kUnitsPerCell;
    form.middle = unitsOf(from[2], from[3]);
    form.holds = [k](Block block) { return holdsInJavaScript(static_cast<std::uint32_t>(k), block) != 0; };
    for (std::size_t c = 0; c < corners; ++c) form.hull.push_back(unitsOf(from[4 + 2 * c], from[5 + 2 * c]));
    from = from.subspan(4 + 2 * corners);
  }
  return forms;
}

/// Forms that are all that the input has.
std::vector<box2d::Form> inputForms(std::size_t count, std::size_t numbers) {
  auto from = input<double>(numbers);
  return inputForms(count, from);
}

/// A length in lattice units as a length in cells.
double cells(double units) { return units / kUnitsPerCell; }

double* putPoint(double* to, const std::optional<Point>& p, Point corner) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  *to++ = p ? cellsOf(p->x - corner.x) : kNone;
  *to++ = p ? cellsOf(p->y - corner.y) : kNone;
  return to;
}

/// In this order, for edges that were added and relinked: geometry, from the corner of the chunk; chunks, blocks, first
/// segments; and before these last ones the ids, with those that were removed first.
const std::uint64_t* put(Terrain& terrain, const box2d::EdgeChanges& changes) {
  const box2d::EdgeSet& edges = terrain.edges;
  const std::size_t count = changes.added.size() + changes.relinked.size(), ids = count + changes.removed.size();
  const std::size_t bytes =
      sizeof(EdgeHead) + count * (8 * sizeof(double) + 3 * sizeof(std::uint32_t)) + ids * sizeof(std::uint32_t);
  Block64& block = terrain.block;
  block.open(bytes);
  *block.array<EdgeHead>(1) = {static_cast<double>(edges.version()), static_cast<std::uint32_t>(changes.removed.size()),
                               static_cast<std::uint32_t>(changes.added.size()),
                               static_cast<std::uint32_t>(changes.relinked.size()),
                               static_cast<std::uint32_t>((bytes + 7) / 8)};
  auto* geometry = block.array<double>(8 * count);
  auto* id = block.array<std::uint32_t>(ids);
  auto* chunk = block.array<std::uint32_t>(count);
  auto* material = block.array<Block>(count);
  auto* segment = block.array<std::uint32_t>(count);
  for (const box2d::EdgeId removed : changes.removed) *id++ = removed.value;
  const box2d::Frame frame{1, {}, edges.options().chunkCells};
  for (const auto* list : {&changes.added, &changes.relinked}) {
    for (const box2d::EdgeId live : *list) {
      const box2d::Edge& edge = edges.edge(live);
      const Point corner = frame.cornerOf(edges.chunk(edge.chunk));
      *id++ = live.value;
      *chunk++ = edge.chunk;
      *material++ = edge.block;
      *segment++ = edge.first.value;
      for (const std::optional<Point>& p :
           {std::optional(edge.start), std::optional(edge.end), edge.ghost1, edge.ghost2})
        geometry = putPoint(geometry, p, corner);
    }
  }
  return block.data();
}

}  // namespace

/// `shortest` is in lattice units. With `merge` edges are merged that go straight on, by materialIs().
LGS_EXPORT("terrain")
Terrain* makeTerrain(Bridge* bridge, std::int32_t chunkCells, double shortest, std::int32_t merge) {
  auto terrain = std::unique_ptr<Terrain, DropTerrain>(new Terrain{bridge, {}, box2d::EdgeSet({})});
  box2d::EdgeOptions options{
      .chunkCells = chunkCells, .shortest = static_cast<std::int64_t>(shortest), .merge = merge != 0};
  if (options.merge)  // the terrain stays where it is
    options.material = [own = terrain.get()](Block block) { return own->materials.at(block); };
  terrain->edges = box2d::EdgeSet(std::move(options));
  return bridge->terrains.emplace_back(std::move(terrain)).get();
}
/// Before a sync with this block: the number of its material.
LGS_EXPORT("materialIs") void materialIs(Terrain* terrain, Block block, std::uint32_t number) {
  terrain->materials[block] = number;
}
LGS_EXPORT("dropTerrain") void dropTerrain(Terrain* terrain) {
  std::erase_if(terrain->bridge->terrains, [terrain](const auto& other) { return other.get() == terrain; });
}
/// From now on it is the terrain of another world. Then beginSync(2) and endSync(1).
LGS_EXPORT("moveTerrain") void moveTerrain(Terrain* terrain, Bridge* to) {
  auto& from = terrain->bridge->terrains;
  const auto own = std::ranges::find(from, terrain, [](const auto& other) { return other.get(); });
  to->terrains.push_back(std::move(*own));
  from.erase(own);
  terrain->ground.reset();
  terrain->around.reset();
  terrain->bridge = to;
}

/// The first half of a sync: what is different from the edges. 0: nothing that matters; 1: what the last commit or
/// roll-back did; 2: whatever was done, to bodies too. Returns 1 if bodies must be looked at, and around them a box:
/// x0, y0, x1, y1 in cells.
LGS_EXPORT("beginSync") std::int32_t beginSync(Terrain* terrain, std::int32_t what) {
  auto& ground = terrain->ground;
  if (what == 1)
    ground.emplace(terrain->world(), terrain->edges, *terrain->bridge->last);
  else if (what == 2)
    ground.emplace(terrain->world(), terrain->edges);
  else
    ground.emplace(terrain->world());
  const auto& box = terrain->around = what == 2 ? box2d::kEverywhere : ground->box();
  terrain->whose = what == 2 ? box2d::Whose::all : box2d::Whose::free;
  if (!box) return 0;
  answer() = {cells(box->min.x), cells(box->min.y), cells(box->max.x), cells(box->max.y)};
  return 1;
}

/// The second half: edges that went, came, or got other ghosts. With `all` whatever was done to the world.
LGS_EXPORT("endSync") const std::uint64_t* endSync(Terrain* terrain, std::int32_t all) {
  return put(*terrain, all != 0 ? terrain->edges.load(terrain->world())
                                : terrain->edges.update(terrain->world(), *terrain->bridge->last));
}

/// The corner of a chunk, in cells.
LGS_EXPORT("chunkOf") void chunkOf(const Terrain* terrain, std::uint32_t number) {
  const box2d::Chunk chunk = terrain->edges.chunk(number);
  const double side = terrain->edges.options().chunkCells;
  answer() = {chunk.x * side, chunk.y * side};
}

/// The edge of a segment; 0 if it is left out.
LGS_EXPORT("edgeOf") std::uint32_t edgeOf(const Terrain* terrain, std::uint32_t segment) {
  return terrain->edges.edgeOf(SegmentId{segment}).value;
}

/// Of the segments of an edge the one that is nearest to a point in cells; 0 if they have changed since.
LGS_EXPORT("segmentAt") std::uint32_t segmentAt(const Terrain* terrain, std::uint32_t edge, double x, double y) {
  const auto hit = box2d::nearestHit(terrain->world(), terrain->edges, {edge}, {}, {x, y});
  return hit ? hit->segment.value : 0;
}

/// Between beginSync() and endSync(): 1 if new ground catches the forms of a body. Then the depth, whether there is a
/// way out, and it.
LGS_EXPORT("overlap")
std::int32_t overlap(const Terrain* terrain, std::size_t forms, std::size_t numbers, double tolerance) {
  const auto found =
      box2d::catchOf(*terrain->ground, inputForms(forms, numbers), terrain->whose, tolerance * kUnitsPerCell);
  if (!found) return 0;
  const DoublePoint way = found->way.value_or(DoublePoint{});
  answer() = {cells(found->depth), found->way ? 1.0 : 0.0, cells(way.x), cells(way.y)};
  return 1;
}

/// After beginSync(): 1 if who was disabled comes free, and the way.
LGS_EXPORT("released")
std::int32_t released(const Terrain* terrain, std::size_t forms, std::size_t numbers, double tolerance) {
  const auto& around = terrain->around;
  if (!around) return 0;
  const auto way = box2d::releaseOf(terrain->world(), inputForms(forms, numbers), *around, tolerance * kUnitsPerCell);
  if (!way) return 0;
  answer() = {cells(way->x), cells(way->y)};
  return 1;
}

/// Whether the ground leaves the forms of a body room.
LGS_EXPORT("fits")
std::int32_t fits(const Terrain* terrain, std::size_t forms, std::size_t numbers, double tolerance) {
  const auto all = inputForms(forms, numbers);
  const box2d::NewGround ground(terrain->world());
  return box2d::WayOut(ground, all, tolerance * kUnitsPerCell).isFree() ? 1 : 0;
}

/// Forms before a step, and as many after it: whether a middle came through ground.
LGS_EXPORT("crossed") std::int32_t crossed(const Terrain* terrain, std::size_t forms, std::size_t numbers) {
  auto from = input<double>(numbers);
  const auto before = inputForms(forms, from), now = inputForms(forms, from);
  return box2d::hasCrossed(terrain->world(), before, now) ? 1 : 0;
}

/// Points in the input, x, y in cells. The answer has for each the block of the solid there; -1 for none.
LGS_EXPORT("solids") void solids(const Terrain* terrain, std::size_t points) {
  answer().clear();
  for (const DoublePoint p : inputPoints(points)) {
    const Spot spot = terrain->world().at(latticePoint(p));
    answer().push_back(spot.where == Spot::Where::outside ? -1.0 : static_cast<double>(spot.block));
  }
}

/// Polygons around forms, as numbers of regions: for each the number of its vertices and these in cells.
LGS_EXPORT("outlines") std::size_t outlines(std::size_t forms, std::size_t numbers) {
  auto& out = answer();
  out.clear();
  for (const box2d::Form& form : inputForms(forms, numbers)) {
    const auto outline = box2d::outlineOf(form);
    out.push_back(static_cast<double>(outline.size()));
    for (const Point v : outline) out.insert(out.end(), {cellsOf(v.x), cellsOf(v.y)});
  }
  return out.size();
}

}  // namespace lgs::web
