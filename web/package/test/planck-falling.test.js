// Ground that falls, in planck; what it does with any engine is in falling.js.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { World as Physics } from 'planck'
import { init } from 'localgridseg/islands'
import { FallingGround, PlanckTerrain } from 'localgridseg/planck'
import { cutArm, testFalling } from './falling.js'

await init()

const engine = {
  within: 1e-13,
  withinAngle: 0,
  makePhysics: () => new Physics({ gravity: { x: 0, y: -10 } }),
  makeTerrain: (physics, world, frame) => new PlanckTerrain(physics, world, frame),
  makeFalling: (...given) => new FallingGround(...given),
  material: () => ({ friction: 0.6 }),
  step: (physics) => physics.step(1 / 60),
  destroy: () => {},
  bodyCount: (physics) => physics.getBodyCount(),
  positionOf: (body) => ({ ...body.getPosition() }),
  velocityOf: (body) => ({ ...body.getLinearVelocity() }),
  spinOf: (body) => body.getAngularVelocity(),
  isAwake: (body) => body.isAwake(),
  massOf: (body) => body.getMass(),
  centerOf: (body) => body.getLocalCenter(),
  worldCenterOf: (body) => body.getWorldCenter(),
  inertiaOf: (body) => body.getInertia() - body.getMass() * body.getLocalCenter().lengthSquared(),
  moveTo: (body, x, y) => body.setTransform({ x, y }, 0),
  setAngularDamping: (body, damping) => body.setAngularDamping(damping),
}

testFalling(engine)

test('in a step nothing is made or settled', () => {
  const { physics, falling, step, end, body, ground } = cutArm(engine)
  const told = []
  physics.on('begin-contact', () => {
    for (const f of [() => falling.settle(body), () => falling.make(ground)])
      try { f() } catch (error) { told.push(error.code) }
  })
  for (let k = 0; k < 120; ++k) step()
  assert.ok(told.length >= 2 && told.every((code) => code === 'busy'), told.join())
  assert.equal(falling.bodies.length, 1)
  end()
})
