// Islands: which there are, which were cut off, and how they leave the ground and come back. And bodies: their convex
// parts, and what they weigh. A body is a list of numbers in JavaScript; here it is nothing that stays.
#include "bodies.h"

#include <lgs/islands.h>

#include <algorithm>
#include <cmath>

namespace lgs::web {

/// The islands of a world. JavaScript says which world it is, in each call: it knows whether that still lives.
struct Followed : Follower {
  Islands islands;
};

namespace {

/// Blocks and rectangles of cells that hold. In the input: how many blocks, these, and four numbers a rectangle.
IsAnchor inputAnchors(std::size_t count) {
  const auto in = input<double>(count);
  const auto blockCount = static_cast<std::size_t>(in[0]);
  std::vector<Block> blocks;
  for (const double block : in.subspan(1, blockCount)) blocks.push_back(static_cast<Block>(block));
  std::vector<CellRect> rects;
  const auto whole = [&](std::size_t k) { return static_cast<std::int32_t>(in[k]); };
  for (std::size_t k = 1 + blockCount; k < count; k += 4)
    rects.push_back({{whole(k), whole(k + 1)}, {whole(k + 2), whole(k + 3)}});
  return [blocks, rects](Block block, Cell cell) {
    return std::ranges::find(blocks, block) != blocks.end() ||
           std::ranges::any_of(rects, [cell](const CellRect& rect) { return contains(rect, cell); });
  };
}

std::size_t answered(const std::vector<IslandId>& ids) {
  answer().clear();
  for (const IslandId id : ids) answer().push_back(id.value);
  return answer().size();
}

std::size_t answered(const std::vector<IslandPair>& pairs) {
  answer().clear();
  for (const IslandPair& pair : pairs)
    answer().insert(answer().end(), {static_cast<double>(pair.from.value), static_cast<double>(pair.into.value)});
  return answer().size();
}

void putMass(const MassOfPolygons& mass) {
  answer().insert(answer().end(), {mass.area, mass.centroid.x, mass.centroid.y, mass.secondMoment});
}

/// The polygons of a body.
Body inputBody(std::size_t count) { return bodyOf(input<double>(count)); }

template <class Result>
std::int32_t putDone(Bridge& bridge, const Expected<Result>& done) {
  if (!done) return refused(done.error(), 0);
  bridge.isEdited = true;
  return 1;
}

}  // namespace

void putBody(const Body& body) {
  auto& out = answer();
  const std::size_t head = out.size();
  out.insert(out.end(), {0, static_cast<double>(body.origin.i), static_cast<double>(body.origin.j)});
  putMass(body.mass);
  for (const BodyPolygon& p : body.polygons) {
    out.insert(out.end(), {static_cast<double>(p.cell.i), static_cast<double>(p.cell.j), static_cast<double>(p.block),
                           static_cast<double>(p.vertices.size())});
    for (const LocalPoint v : p.vertices) out.insert(out.end(), {cellsOf(v.x), cellsOf(v.y)});
  }
  out[head] = static_cast<double>(out.size() - head - 1);
}

Body bodyOf(std::span<const double> in) {
  Body body;
  for (std::size_t k = 0; k < in.size();) {
    BodyPolygon polygon{.cell = {static_cast<std::int32_t>(in[k]), static_cast<std::int32_t>(in[k + 1])},
                        .block = static_cast<Block>(in[k + 2]),
                        .vertices = {}};
    const auto vertices = static_cast<std::size_t>(in[k + 3]);
    k += 4;
    for (std::size_t v = 0; v < vertices; ++v, k += 2) {
      const Point p = latticePoint({in[k], in[k + 1]});  // JavaScript has checked that it is in the cell
      polygon.vertices.push_back({static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)});
    }
    body.polygons.push_back(std::move(polygon));
  }
  return body;
}

/// The anchors are in the input; with none of them nothing is an anchor.
LGS_EXPORT("islands") Followed* islands(Bridge* bridge, std::size_t numbers, std::int32_t isOpen) {
  IsAnchor isAnchor = numbers > 1 ? inputAnchors(numbers) : IsAnchor{};
  if (const auto done = bridge->world.followCells(true); !done)
    return refused(done.error(), static_cast<Followed*>(nullptr));
  return new Followed{{.moment = bridge->moment},
                      Islands(bridge->world, std::move(isAnchor), isOpen != 0 ? AtEdge::open : AtEdge::holds)};
}
LGS_EXPORT("freeIslands") void freeIslands(Followed* followed) { delete followed; }

LGS_EXPORT("updateIslands") std::int32_t updateIslands(Followed* followed, const Bridge* bridge) {
  return followed->follow(*bridge, [&] { return followed->islands.update(bridge->world, *bridge->last); });
}
LGS_EXPORT("areIslandsOfNow") std::int32_t areIslandsOfNow(const Followed* followed, const Bridge* bridge) {
  return followed->isOfNow(*bridge);
}

/// 0: came, 1: went, 2: changed, 3: cut off, 4: joined. Of the last two a pair each.
LGS_EXPORT("islandChanges") std::size_t islandChanges(const Followed* followed, std::int32_t list) {
  static const IslandChanges kNone;
  const IslandChanges& told = followed->hasNews ? followed->islands.changes() : kNone;
  switch (list) {
    case 0:
      return answered(told.added);
    case 1:
      return answered(told.removed);
    case 2:
      return answered(told.changed);
    case 3:
      return answered(told.cutOff);
    default:
      return answered(told.joined);
  }
}

LGS_EXPORT("looseIslands") std::size_t looseIslands(const Followed* followed) {
  return answered(followed->hasNews ? followed->islands.loose() : std::vector<IslandId>{});
}
LGS_EXPORT("allIslands") std::size_t allIslands(const Followed* followed) { return answered(followed->islands.all()); }

/// area, x0, y0, x1, y1, segments, anchors. Returns 0 if there is no such island.
LGS_EXPORT("island") std::int32_t island(const Followed* followed, std::uint32_t id) {
  const auto facts = followed->islands.island({id});
  if (!facts) return 0;
  const LoopFacts& outer = facts->outer;
  answer() = {outer.area(),
              cellsOf(outer.min.x),
              cellsOf(outer.min.y),
              cellsOf(outer.max.x),
              cellsOf(outer.max.y),
              static_cast<double>(outer.segments),
              static_cast<double>(facts->anchors)};
  return 1;
}

/// The island of a polygon; 0 if there is no such polygon.
LGS_EXPORT("islandOf") std::uint32_t islandOf(const Followed* followed, const Bridge* bridge, double polygon) {
  return followed->islands.of(bridge->world, toHandle(polygon)).value;
}

/// A body, or its parts: the number of its numbers, i, j of the origin, area, centroid, second moment, and the
/// polygons, as bodyOf() reads them.
LGS_EXPORT("takeIsland")
std::size_t takeIsland(const Followed* followed, Bridge* bridge, std::uint32_t id, std::int32_t isApart) {
  std::vector<Body> bodies;
  if (isApart != 0) {
    auto parts = takeApart(bridge->world, followed->islands, {id});
    if (!parts) return refused(parts.error(), std::size_t{0});
    bodies = std::move(*parts);
  } else {
    auto body = take(bridge->world, followed->islands, {id});
    if (!body) return refused(body.error(), std::size_t{0});
    bodies.push_back(std::move(*body));
  }
  bridge->isEdited = true;
  answer().clear();
  for (const Body& body : bodies) putBody(body);
  return answer().size();
}

/// What the edits that wait would do: commits them beside the bridge, so that nobody else hears of it. Returns 0 if
/// there was a commit before.
LGS_EXPORT("tryEdits") std::int32_t tryEdits(Followed* followed, Bridge* bridge) {
  if (followed->moment != bridge->moment) return 0;
  followed->hasNews = followed->islands.update(bridge->world, bridge->world.commit());
  return 1;
}

/// Rolls back to before them. Returns 0 if the edits were not edits alone: then all followers must begin anew.
LGS_EXPORT("untryEdits") std::int32_t untryEdits(Followed* followed, Bridge* bridge, double mark) {
  World& world = bridge->world;
  const bool isBack = world.rollBack(markOf(mark)).has_value();
  const bool wereEdits =
      isBack && followed->moment == bridge->moment && followed->islands.update(world, world.changesOfRollBack());
  if (isBack) {
    bridge->isEdited = false;
    static_cast<void>(world.forget(markOf(mark)));
  }
  bridge->isLastNews = false;
  followed->hasNews = false;
  if (!wereEdits) ++bridge->moment;
  return wereEdits ? 1 : 0;
}

// --- Bodies

LGS_EXPORT("putBody") std::int32_t putBody(Bridge* bridge, std::size_t numbers, std::int32_t i, std::int32_t j) {
  return putDone(*bridge, put(bridge->world, inputBody(numbers), {i, j}));
}

LGS_EXPORT("putAsItLies")
std::int32_t putBodyAsItLies(Bridge* bridge, std::size_t numbers, double x, double y, double cosine, double sine) {
  const Placing placing{.origin = {x, y}, .cosine = cosine, .sine = sine};
  return putDone(*bridge, putAsItLies(bridge->world, inputBody(numbers), placing));
}

/// For each part its block, the number of its vertices, and these in cells.
LGS_EXPORT("convexParts") std::int32_t convexPartsOf(std::size_t numbers, std::size_t maxVertices) {
  const auto parts = convexParts(inputBody(numbers), maxVertices);
  if (!parts) return refused(parts.error(), -1);
  auto& out = answer();
  out.clear();
  for (const ConvexPart& part : *parts) {
    out.insert(out.end(), {static_cast<double>(part.block), static_cast<double>(part.vertices.size())});
    for (const Point v : part.vertices) out.insert(out.end(), {cellsOf(v.x), cellsOf(v.y)});
  }
  return static_cast<std::int32_t>(out.size());
}

/// area, centroid, second moment. Refused where a world would not take the polygons.
LGS_EXPORT("massOf") std::int32_t massOfBody(std::size_t numbers) {
  const Body body = inputBody(numbers);
  World scratch;
  if (const auto done = put(scratch, body, {}); !done) return refused(done.error(), 0);
  answer().clear();
  putMass(massOf(body.polygons));
  return 1;
}

}  // namespace lgs::web
