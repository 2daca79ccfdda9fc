// Ground that falls, in planck; what it does with any engine is in falling.js.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { Polygon, World as Physics } from 'planck'
import { createWorld, init, Islands } from 'localgridseg/islands'
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

test('what stands on a tip falls over, and what stands on its side rests at once', () => {
  for (const [corners, isTip] of [[[0.5, 0, 1, 1, 0, 1], true], [[0, 0, 1, 0, 0.5, 1], false]]) {
    const world = createWorld()
    world.fill({ i0: -4, j0: -1, i1: 4, j1: -1 }, world.shape([0, 0, 1, 0, 1, 1, 0, 1]), 9)
    world.addPolygon(0, 0, corners, 1)
    world.commit()
    const physics = engine.makePhysics(), terrain = new PlanckTerrain(physics, world), islands = new Islands(world, { blocks: [9] })
    const falling = new FallingGround(physics, terrain, islands)
    const [{ i, j, vertices }] = world.polygons().filter(({ block }) => block === 1)
    const body = physics.createBody({ type: 'dynamic', position: { x: i, y: j + 0.015 } })
    body.createFixture(new Polygon(Array.from({ length: 3 }, (_, k) => ({ x: vertices[2 * k], y: vertices[2 * k + 1] }))), { density: 1, friction: 0.6 })
    world.clear(0, 0)
    terrain.commit()
    for (let k = 0; k < 900 && !falling.rests(body); ++k) physics.step(1 / 60)
    assert.ok(falling.rests(body))
    assert.equal(Math.abs(body.getAngle()) > 0.5, isTip, `${body.getAngle()}`)
    islands.free()
    world.free()
  }
})
