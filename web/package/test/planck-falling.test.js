// Ground that falls, in planck: where it was, at rest, without kicks, and back in the ground, where it can be dug.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import { World as Physics } from 'planck'
import { circle, createWorld, init, Islands, unitSquare } from '../dist/islands.js'
import { FallingGround, PlanckTerrain } from '../dist/planck.js'

before(() => init())

const iron = 7, bedrock = 9
const density = (block) => (block === iron ? 8 : 2)

/** A pillar with an arm, of which the end is iron, with half a cell on it. The arm is cut off. */
function cutArm({ cellSize = 1, origin = { i: 0, j: 0 } } = {}) {
  const world = createWorld(), square = world.shape(unitSquare)
  world.fill({ i0: -10, j0: -1, i1: 20, j1: -1 }, square, bedrock)
  world.fill({ i0: 0, j0: 0, i1: 0, j1: 3 }, square, 1)
  world.fill({ i0: 1, j0: 3, i1: 3, j1: 3 }, square, 1)
  world.add(4, 3, square, iron)
  world.addPolygon(2, 4, [0, 0, 1, 0, 1, 1], 1)
  world.commit()
  const physics = new Physics({ gravity: { x: 0, y: -10 } })
  const terrain = new PlanckTerrain(physics, world, { cellSize, origin })
  const islands = new Islands(world, { blocks: [bedrock] })
  const falling = new FallingGround(physics, terrain, islands, { density, material: () => ({ friction: 0.6 }) })
  const commit = () => islands.update(terrain.commit())
  world.clear(1, 3)
  commit()
  for (const id of islands.loose()) falling.takeAsBody(id)
  assert.deepEqual(falling.bodies, [], 'it is nowhere until the ground is gone')
  commit()
  const made = falling.afterSync()
  assert.equal(made.length, 1)
  const step = () => { physics.step(1 / 60); return terrain.afterStep() }
  return { world, physics, terrain, islands, falling, commit, step, body: made[0].body, ground: made[0].ground }
}

test('a body is where its ground was, at rest, and its first step is free fall', () => {
  const { world, physics, falling, islands, step, body } = cutArm()
  assert.deepEqual({ ...body.getPosition() }, { x: 2, y: 3 })
  assert.equal(body.getLinearVelocity().length(), 0)
  assert.equal(falling.bodies.length, 1)
  assert.equal(islands.all().length, 1, 'the arm is no ground any more')
  step()
  assert.equal(body.getLinearVelocity().x, 0, 'it touched what it was part of')
  assert.ok(Math.abs(body.getLinearVelocity().y + 10 / 60) < 1e-12)
  assert.equal(body.getAngularVelocity(), 0)
  assert.deepEqual(falling.afterSync(), [], 'each is made once')
  assert.ok(physics.getBodyCount() > 1)
  world.free()
})

for (const cellSize of [1, 0.5])
  test(`mass is that of its blocks, with cells of ${cellSize} m`, () => {
    const { world, body } = cutArm({ cellSize, origin: { i: -3, j: 1 } })
    // Two squares and a half of weight 2, one square of weight 8; counted from (2, 3).
    const mass = 2 * 2.5 + 8, x = (2 * (0.5 + 1.5 + (0.5 * 2) / 3) + 8 * 2.5) / mass, y = (2 * (0.5 + 0.5 + (0.5 * 4) / 3) + 8 * 0.5) / mass
    const square = (weight, cx) => weight / 6 + weight * ((cx - x) ** 2 + (0.5 - y) ** 2)
    const ramp = 2 * (0.5 / 9 + 0.5 * ((2 / 3 - x) ** 2 + (4 / 3 - y) ** 2))
    const inertia = square(2, 0.5) + square(2, 1.5) + square(8, 2.5) + ramp, area = cellSize ** 2
    const center = body.getLocalCenter()
    assert.ok(Math.abs(body.getMass() - mass * area) < 1e-12)
    assert.ok(Math.abs(center.x - x * cellSize) < 1e-12 && Math.abs(center.y - y * cellSize) < 1e-12)
    assert.ok(Math.abs(body.getInertia() - area * (mass * area * (center.x ** 2 + center.y ** 2) / area + inertia * area)) < 1e-9)
    assert.deepEqual({ ...body.getPosition() }, { x: 5 * cellSize, y: 2 * cellSize })
    world.free()
  })

for (const cellSize of [1, 0.25])
  test(`what came to rest is ground again, and can be dug, with cells of ${cellSize} m`, () => {
    const { world, physics, terrain, islands, falling, commit, step, body } = cutArm({ cellSize })
    let steps = 0
    for (; steps < 1200 && body.isAwake(); ++steps) assert.deepEqual(step(), [])
    assert.ok(steps < 1200, 'it comes to rest')
    const { x, y } = terrain.point(body.getWorldCenter()), bodies = physics.getBodyCount()
    assert.ok(y > 0 && y < 2)
    assert.equal(world.at(x, y).where, 'outside')
    assert.ok(falling.settle(body))
    assert.deepEqual(falling.bodies, [])
    assert.equal(physics.getBodyCount(), bodies - 1)
    commit()
    assert.equal(islands.all().length, 1, 'it hangs together with what it rests on')
    assert.deepEqual(islands.loose(), [])
    assert.equal(world.at(x, y).where, 'inside')
    assert.throws(() => falling.settle(body), (error) => error.code === 'bad-argument')
    const area = islands.island(islands.all()[0]).area
    world.carve(circle(x, y, 0.3))
    commit()
    assert.equal(world.at(x, y).where, 'outside')
    assert.ok(islands.all().every((id) => islands.island(id).anchors > 0) && islands.all().length === 1)
    assert.ok(islands.island(islands.all()[0]).area <= area)
    world.free()
  })

test('nobody settles in the ground, and nothing has changed', () => {
  const { world, falling, islands, commit, body } = cutArm()
  const { version } = world
  for (const height of [-0.5, -0.05]) {
    body.setTransform({ x: 4, y: height }, 0)
    assert.equal(falling.settle(body), false)
  }
  assert.equal(falling.bodies.length, 1)
  commit()
  assert.equal(world.version, version)
  body.setTransform({ x: 4, y: 0.001 }, 0)
  assert.ok(falling.settle(body))
  commit()
  assert.equal(islands.all().length, 1)
  world.free()
})

test('dust has no body; ground that left in another way has one, at any place', () => {
  const { world, physics, falling, islands, commit, ground, body } = cutArm()
  world.addPolygon(10, 5, [0, 0.002, 0.003, 0.002, 0.002, 0.005], 1)
  world.addPolygon(12, 5, [0, 0.002, 1, 0.002, 1, 0.005], 1)
  commit()
  for (const id of islands.loose()) falling.takeAsBody(id)
  commit()
  assert.deepEqual(falling.afterSync(), [])
  const twin = falling.make(ground, { x: 7, y: 2, angle: 1 })
  assert.deepEqual(falling.placeOf(twin.body), { x: 7, y: 2, angle: 1 })
  assert.equal(twin.body.getMass(), body.getMass())
  falling.forget(twin.body)
  assert.equal(falling.bodies.length, 1)
  for (const place of [null, {}, { x: NaN, y: 0, angle: 0 }]) assert.throws(() => falling.make(ground, place), (error) => error.code === 'bad-argument')
  assert.throws(() => falling.make(null), (error) => error.code === 'bad-argument')
  assert.equal(falling.make({ i: 0, j: 0, polygons: [] }), null)
  const count = physics.getBodyCount()
  const bad = new FallingGround(physics, new PlanckTerrain(new Physics(), world), islands, { density: () => -1 })
  assert.throws(() => bad.make(ground), (error) => error.code === 'bad-argument')
  assert.equal(physics.getBodyCount(), count, 'nothing is left of it')
  world.free()
})

test('in a step nothing is made or settled', () => {
  const { world, physics, falling, step, body, ground } = cutArm()
  const told = []
  physics.on('begin-contact', () => {
    for (const f of [() => falling.settle(body), () => falling.make(ground)])
      try { f() } catch (error) { told.push(error.code) }
  })
  for (let k = 0; k < 120; ++k) step()
  assert.ok(told.length >= 2 && told.every((code) => code === 'busy'), told.join())
  assert.equal(falling.bodies.length, 1)
  world.free()
})

test('a rock dug free rolls down a slope without going through it, and its blocks stay what they are', () => {
  const world = createWorld()
  world.paint({ rings: [[0, -2, 40, -2, 40, 0, 30, 0, 10, 10, 0, 10]] }, bedrock)
  world.paint(circle(9, 16, 1.5, 24), 1)
  world.paint(circle(9, 16, 0.5, 16), iron, 'replace')
  world.paint({ rings: [[8.8, 17, 9.2, 17, 9.2, 20, 8.8, 20]] }, 1)
  world.paint({ rings: [[0, 20, 10, 20, 10, 21, 0, 21]] }, bedrock)
  world.commit()
  const physics = new Physics({ gravity: { x: 0, y: -10 } })
  const terrain = new PlanckTerrain(physics, world), islands = new Islands(world, { blocks: [bedrock] })
  const falling = new FallingGround(physics, terrain, islands, { density, material: () => ({ friction: 0.6 }) })
  const areaOf = (block) => massOfBlock(world, block)
  const before = [areaOf(1), areaOf(iron)]
  world.carve({ rings: [[8, 18, 10, 18, 10, 20, 8, 20]] })
  islands.update(terrain.commit())
  before[0] = areaOf(1)
  for (const id of islands.loose()) falling.takeAsBody(id)
  islands.update(terrain.commit())
  const [{ body }] = falling.afterSync()
  body.setAngularDamping(0.3)
  let k = 0
  for (; k < 3000 && body.isAwake(); ++k) {
    physics.step(1 / 60)
    assert.deepEqual(terrain.afterStep(), [])
  }
  assert.ok(k < 3000)
  assert.ok(falling.settle(body))
  islands.update(terrain.commit())
  assert.ok(islands.all().every((id) => islands.island(id).anchors > 0), 'it is held again')
  for (const [n, block] of [1, iron].entries()) assert.ok(Math.abs(areaOf(block) - before[n]) < 0.02, `${areaOf(block)} of ${before[n]}`)
  world.free()
})

function massOfBlock(world, block) {
  let area = 0
  for (const { block: b, vertices: v } of world.polygons())
    if (b === block) for (let k = 0; k < v.length; k += 2) area += (v[k] * v[(k + 3) % v.length] - v[k + 1] * v[(k + 2) % v.length]) / 2
  return area
}
