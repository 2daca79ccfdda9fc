// What the tests of the terrain for box2d3-wasm have in common: a world of Box2D, bodies, and rides.
import Box2DFactory from 'box2d3-wasm'
import { createWorld, init, unitSquare } from 'localgridseg'

await init()
export const b2 = await Box2DFactory()

export const vec = (x, y) => new b2.b2Vec2(x, y)

export function makePhysics() {
  const def = b2.b2DefaultWorldDef()
  def.gravity = vec(0, -10)
  return b2.b2CreateWorld(def)
}

export function makeBody(physics, { x, y, speed = 0, sleeps = false, box = 0, ball = 0, friction = 0 }) {
  const def = b2.b2DefaultBodyDef()
  def.type = b2.b2BodyType.b2_dynamicBody
  def.position = vec(x, y)
  def.linearVelocity = vec(speed, 0)
  def.enableSleep = sleeps
  const body = b2.b2CreateBody(physics, def)
  const shape = b2.b2DefaultShapeDef()
  shape.material.friction = friction
  if (box > 0) {
    b2.b2CreatePolygonShape(body, shape, b2.b2MakeBox(box, box))
  } else {
    const round = new b2.b2Circle()
    round.center = vec(0, 0)
    round.radius = ball
    b2.b2CreateCircleShape(body, shape, round)
  }
  return body
}

/** Each step's x, y, vx, vy. */
export function ride(physics, body, steps, eachStep = () => {}) {
  return Array.from({ length: steps }, (_, step) => {
    eachStep(step)
    b2.b2World_Step(physics, 1 / 60, 4)
    const position = b2.b2Body_GetPosition(body), velocity = b2.b2Body_GetLinearVelocity(body)
    return [position.x, position.y, velocity.x, velocity.y]
  })
}

/** Steps in which the velocity changes by at least 0.01 m/s; on a frictionless floor nothing should change it. */
export const kicks = (path) =>
  path.filter(([, , vx, vy], k) => k > 0 && Math.hypot(vx - path[k - 1][2], vy - path[k - 1][3]) >= 0.01).length

export function floorOf(length, height = 1) {
  const world = createWorld()
  world.fill({ i0: 0, j0: 0, i1: length - 1, j1: height - 1 }, world.shape(unitSquare), 1)
  world.commit()
  return world
}
