// What the terrain answers: what was hit, what is near, who is there.
#include <lgs/box2d/terrain.h>
#include "find_hit.h"
#include "segment_shape.h"
#include "to_box2d.h"

#include <algorithm>

namespace lgs::box2d {

namespace {

bool collect(b2ShapeId shape, void* shapes) {
  static_cast<std::vector<b2ShapeId>*>(shapes)->push_back(shape);
  return true;
}

}  // namespace

EdgeId Terrain::edgeOf(b2ShapeId shape) const {
  if (!b2Shape_IsValid(shape)) return {};
  const auto id = reinterpret_cast<std::uintptr_t>(b2Shape_GetUserData(shape));
  if (id >= shapes_.size() || !B2_ID_EQUALS(shapes_[id].shape, shape)) return {};
  return EdgeId{static_cast<std::uint32_t>(id)};
}

std::optional<Hit> Terrain::hit(b2ShapeId shape) const {
  const EdgeId id = edgeOf(shape);
  return id ? firstHit(world_, edges_, id) : std::nullopt;
}

std::optional<Hit> Terrain::hit(b2ShapeId shape, Position point) const {
  const EdgeId id = edgeOf(shape);
  return id ? nearestHit(world_, edges_, id, frame_, {point.x, point.y}) : std::nullopt;
}

// In Box2D a chain segment is always shape A: it is after all others in the order of types.
std::optional<Touch> Terrain::hit(const b2ContactData& contact) const {
  const EdgeId id = edgeOf(contact.shapeIdA);
  const b2Manifold& manifold = contact.manifold;
  if (!id || manifold.pointCount == 0) return {};
  const Edge& edge = edges_.edge(id);
  Place middle = frame_.position(frame_.cornerOf(edges_.chunk(edge.chunk)));
  for (int k = 0; k < manifold.pointCount; ++k) {
    const b2Vec2 point = manifold.points[k].anchorA;  // relative to the chunk's body
    middle.x += static_cast<double>(point.x) / manifold.pointCount;
    middle.y += static_cast<double>(point.y) / manifold.pointCount;
  }
  const std::optional<Hit> found = nearestHit(world_, edges_, id, frame_, middle);
  if (!found) return {};
  return Touch{*found, toBox2D(normalOf(edge)), contact.shapeIdB};
}

std::optional<NearestHit> Terrain::nearest(Position point, float radius) const {
  const auto found = nearestTo(world_, frame_, {point.x, point.y}, radius);
  if (!found) return {};
  return NearestHit{found->hit, toBox2D(found->point), toBox2D(found->normal), found->distance};
}

std::optional<GroundRayHit> Terrain::rayCast(Position from, Position to) const {
  const auto ray = box2d::rayCast(world_, frame_, {from.x, from.y}, {to.x, to.y});
  if (!ray) return {};
  return GroundRayHit{ray->hit, toBox2D(ray->point), toBox2D(ray->normal), ray->fraction};
}

std::vector<b2BodyId> Terrain::bodiesInRect(const CellRect& cells) const {
  if (isEmpty(cells)) return {};
  const auto metres = [&](std::int32_t from, std::int32_t to) {
    return static_cast<float>((1.0 + to - from) * frame_.cellSize);
  };
  const float skin = std::min(slop(), metres(0, 0) / 4);
  const float right = metres(cells.min.i, cells.max.i) - skin, top = metres(cells.min.j, cells.max.j) - skin;
  const b2Vec2 corners[] = {{skin, skin}, {right, skin}, {right, top}, {skin, top}};
  b2QueryFilter all = b2DefaultQueryFilter();
  all.categoryBits = UINT64_MAX;
  all.maskBits = UINT64_MAX;
  std::vector<b2ShapeId> shapes;
  forEachShapeOver(physics_, position(toWorld(cells.min, {})), b2MakeProxy(corners, 4, 0), all, collect, &shapes);
  std::vector<b2BodyId> bodies;
  for (const b2ShapeId shape : shapes) {
    if (b2Shape_IsSensor(shape) || edgeOf(shape)) continue;
    const b2BodyId body = b2Shape_GetBody(shape);
    const auto isSame = [&](b2BodyId other) { return B2_ID_EQUALS(body, other); };
    if (std::none_of(bodies.begin(), bodies.end(), isSame)) bodies.push_back(body);
  }
  return bodies;
}

}  // namespace lgs::box2d
