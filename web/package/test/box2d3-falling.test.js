// Ground that falls, in box2d3-wasm; what it does with any engine is in falling.js.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { Box2dTerrain, FallingGround } from 'localgridseg/box2d3'
import { init } from 'localgridseg/islands'
import { cutArm, iron, testFalling } from './falling.js'

await init()  // before box2d3.js starts the engine without islands
const { b2, makePhysics, vec } = await import('./box2d3.js')

const read = (handle, f) => { const value = f(handle); handle.delete(); return value }
const pointOf = (handle) => read(handle, ({ x, y }) => ({ x, y }))

const engine = {
  within: 1e-5,
  withinAngle: 1e-3,
  makePhysics,
  makeTerrain: (physics, world, frame) => new Box2dTerrain(b2, physics, world, frame),
  makeFalling: (...given) => new FallingGround(b2, ...given),
  material: (block) => ({ friction: block === iron ? 0.25 : 0.5, categoryBits: 4 }),
  step: (physics) => b2.b2World_Step(physics, 1 / 60, 4),
  destroy: (physics) => b2.b2DestroyWorld(physics),
  bodyCount: (physics) => read(b2.b2World_GetCounters(physics), (counters) => counters.bodyCount),
  positionOf: (body) => pointOf(b2.b2Body_GetPosition(body)),
  velocityOf: (body) => pointOf(b2.b2Body_GetLinearVelocity(body)),
  spinOf: (body) => b2.b2Body_GetAngularVelocity(body),
  isAwake: (body) => b2.b2Body_IsAwake(body),
  massOf: (body) => b2.b2Body_GetMass(body),
  centerOf: (body) => pointOf(b2.b2Body_GetLocalCenterOfMass(body)),
  worldCenterOf: (body) => pointOf(b2.b2Body_GetWorldCenterOfMass(body)),
  inertiaOf: (body) => b2.b2Body_GetRotationalInertia(body),
  moveTo: (body, x, y) => b2.b2Body_SetTransform(body, vec(x, y), b2.b2MakeRot(0)),
  setAngularDamping: (body, damping) => b2.b2Body_SetAngularDamping(body, damping),
}

testFalling(engine)

test('each block has its own material in a body', () => {
  const { end, body } = cutArm(engine)
  const shapes = b2.b2Body_GetShapes(body, b2.b2Body_GetShapeCount(body))
  for (const shape of shapes) read(b2.b2Shape_GetFilter(shape), (filter) => assert.equal(Number(filter.categoryBits), 4))
  assert.deepEqual(new Set(shapes.map((shape) => b2.b2Shape_GetFriction(shape))), new Set([0.25, 0.5]))
  end()
})
