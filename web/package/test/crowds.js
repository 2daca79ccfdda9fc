// Bodies of all forms in a physics world, for planck and for box2d3-wasm alike.
import { Circle, Polygon, World as Planck } from 'planck'
import { Box2dTerrain } from 'localgridseg/box2d3'
import { PlanckTerrain } from 'localgridseg/planck'

/** The shapes of a figure that is `size` metres long: circles { x, y, radius } and convex polygons. */
function shapesOf(figure, size) {
  const h = size / 2, box = (w, t) => [[-w, -t], [w, -t], [w, t], [-w, t]]
  switch (figure) {
    case 'circle': return [{ x: 0, y: 0, radius: h }]
    case 'capsule': return [{ x: -h / 2, y: 0, radius: h / 2 }, { x: h / 2, y: 0, radius: h / 2 }, box(h / 2, h / 2)]
    case 'triangle': return [[[-h, -h], [h, -h], [-0.3 * h, h]]]
    case 'octagon': return [Array.from({ length: 8 }, (_, k) => [h * Math.cos(k * Math.PI / 4), h * Math.sin(k * Math.PI / 4)])]
    case 'stick': return [box(h, 0.1 * h)]
    case 'cross': return [box(h, 0.3 * h), box(0.3 * h, h)]
    case 'flag': return [box(h / 2, h / 2).map(([x, y]) => [x + h, y])] // beside the origin of its body
    default: return [box(h, h)]
  }
}

export const planckCrowd = () => {
  const physics = new Planck({ x: 0, y: -10 }), bodies = []
  return {
    bodies, physics,
    makeTerrain: (world, options) => new PlanckTerrain(physics, world, options),
    add(figure, size, position) {
      const body = physics.createBody({ type: 'dynamic', position })
      for (const shape of shapesOf(figure, size)) {
        const made = Array.isArray(shape) ? new Polygon(shape.map(([x, y]) => ({ x, y }))) : new Circle(shape, shape.radius)
        body.createFixture(made, { density: 1 })
      }
      bodies.push(body)
      return body
    },
    middlesOf(body) {
      const middles = []
      for (let f = body.getFixtureList(); f; f = f.getNext()) {
        const shape = f.getShape()
        middles.push(body.getWorldPoint(shape.getType() === 'circle' ? shape.m_p : shape.m_centroid))
      }
      return middles
    },
    remove: (k) => physics.destroyBody(bodies.splice(k, 1)[0]),
    positionOf: (body) => ({ ...body.getPosition() }),
    namesOf: (some) => some.map((body) => bodies.indexOf(body)), // a failed comparison of bodies themselves takes minutes
    velocityOf: (body) => ({ ...body.getLinearVelocity() }),
    put: (body, position) => body.setTransform(position, body.getAngle()),
    turn: (body) => body.setTransform(body.getPosition(), body.getAngle() + Math.PI / 2),
    isEnabled: (body) => body.isActive(),
    kick(body, x, y) {
      body.setLinearVelocity({ x, y })
      body.setAwake(true)
    },
    step: () => physics.step(1 / 60, 8, 3),
    moveOrigin(terrain, cell) {
      physics.shiftOrigin(terrain.position(cell.i, cell.j))
      terrain.moveOrigin(cell)
    },
  }
}

export const box2dCrowd = (b2) => () => {
  const vec = (x, y) => new b2.b2Vec2(x, y)
  const worldDef = b2.b2DefaultWorldDef()
  worldDef.gravity = vec(0, -10)
  const physics = b2.b2CreateWorld(worldDef), bodies = []
  const own = (handle) => { // what it holds; it is deleted
    const { x, y } = handle
    handle.delete()
    return { x, y }
  }
  const shapes = (body) => b2.b2Body_GetShapes(body, b2.b2Body_GetShapeCount(body))
  const turned = new b2.b2Rot()
  const put = (body, { x, y }) => {
    const at = vec(x, y), transform = b2.b2Body_GetTransform(body)
    Object.assign(turned, { c: transform.q.c, s: transform.q.s })
    transform.delete()
    b2.b2Body_SetTransform(body, at, turned)
    at.delete()
  }
  return {
    bodies, physics,
    makeTerrain: (world, options) => new Box2dTerrain(b2, physics, world, options),
    add(figure, size, { x, y }) {
      const def = b2.b2DefaultBodyDef(), shapeDef = b2.b2DefaultShapeDef()
      def.type = b2.b2BodyType.b2_dynamicBody
      def.position = vec(x, y)
      const body = b2.b2CreateBody(physics, def)
      if (figure === 'capsule') {
        const capsule = new b2.b2Capsule()
        capsule.center1 = vec(-size / 4, 0)
        capsule.center2 = vec(size / 4, 0)
        capsule.radius = size / 4
        b2.b2CreateCapsuleShape(body, shapeDef, capsule)
      } else for (const shape of shapesOf(figure, size)) {
        if (Array.isArray(shape)) {
          const hull = b2.b2ComputeHull(shape.map(([px, py]) => vec(px, py)))
          b2.b2CreatePolygonShape(body, shapeDef, b2.b2MakePolygon(hull, 0))
        } else {
          const round = new b2.b2Circle()
          round.center = vec(shape.x, shape.y)
          round.radius = shape.radius
          b2.b2CreateCircleShape(body, shapeDef, round)
        }
      }
      bodies.push(body)
      return body
    },
    middlesOf(body) {
      return shapes(body).map((shape) => {
        const type = b2.b2Shape_GetType(shape).value
        const outline = type === 0 ? b2.b2Shape_GetCircle(shape) : type === 1 ? b2.b2Shape_GetCapsule(shape) : b2.b2Shape_GetPolygon(shape)
        const middle = type === 0 ? outline.center : type === 3 ? outline.centroid : null // parts, which are not deleted
        const [a, b] = middle ? [middle, middle] : [outline.center1, outline.center2]
        const local = vec((a.x + b.x) / 2, (a.y + b.y) / 2)
        outline.delete()
        const there = own(b2.b2Body_GetWorldPoint(body, local))
        local.delete()
        return there
      })
    },
    remove: (k) => b2.b2DestroyBody(bodies.splice(k, 1)[0]),
    positionOf: (body) => own(b2.b2Body_GetPosition(body)),
    namesOf: (some) => some.map(({ index1 }) => index1),
    velocityOf: (body) => own(b2.b2Body_GetLinearVelocity(body)),
    put,
    turn(body) {
      const { x, y } = own(b2.b2Body_GetPosition(body)), at = vec(x, y)
      b2.b2Body_SetTransform(body, at, Object.assign(turned, { c: 0, s: 1 }))
      at.delete()
    },
    isEnabled: (body) => b2.b2Body_IsEnabled(body),
    kick(body, x, y) {
      const velocity = vec(x, y)
      b2.b2Body_SetLinearVelocity(body, velocity)
      velocity.delete()
      b2.b2Body_SetAwake(body, true)
    },
    step: () => b2.b2World_Step(physics, 1 / 60, 4),
    moveOrigin(terrain, cell) {
      const by = terrain.position(cell.i, cell.j)
      for (const body of bodies) {
        const { x, y } = own(b2.b2Body_GetPosition(body))
        put(body, { x: x - by.x, y: y - by.y })
      }
      terrain.moveOrigin(cell)
    },
    destroy: () => b2.b2DestroyWorld(physics),
  }
}
