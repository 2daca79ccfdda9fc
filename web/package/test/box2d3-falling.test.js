// Ground that falls, in box2d3-wasm: where it was, at rest, without kicks, and back in the ground, where it can be dug.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { Box2dTerrain, FallingGround } from '../dist/box2d3.js'
import { circle, createWorld, init, Islands, unitSquare } from '../dist/islands.js'

await init()  // before box2d3.js starts the engine without islands
const { b2, makePhysics, vec } = await import('./box2d3.js')

const iron = 7, bedrock = 9
const density = (block) => (block === iron ? 8 : 2)
const near = (a, b, within = 1e-5) => assert.ok(Math.abs(a - b) <= within * Math.max(1, Math.abs(b)), `${a} and not ${b}`)
const read = (handle, f) => { const value = f(handle); handle.delete(); return value }
const positionOf = (body) => read(b2.b2Body_GetPosition(body), ({ x, y }) => ({ x, y }))
const velocityOf = (body) => read(b2.b2Body_GetLinearVelocity(body), ({ x, y }) => ({ x, y }))
const bodyCount = (physics) => read(b2.b2World_GetCounters(physics), (counters) => counters.bodyCount)
const shapesOf = (body) => b2.b2Body_GetShapes(body, b2.b2Body_GetShapeCount(body))
const moveTo = (body, x, y, angle = 0) => b2.b2Body_SetTransform(body, vec(x, y), b2.b2MakeRot(angle))

/** A pillar with an arm, of which the end is iron, with half a cell on it. The arm is cut off. */
function cutArm({ cellSize = 1, origin = { i: 0, j: 0 } } = {}) {
  const world = createWorld(), square = world.shape(unitSquare)
  world.fill({ i0: -10, j0: -1, i1: 20, j1: -1 }, square, bedrock)
  world.fill({ i0: 0, j0: 0, i1: 0, j1: 3 }, square, 1)
  world.fill({ i0: 1, j0: 3, i1: 3, j1: 3 }, square, 1)
  world.add(4, 3, square, iron)
  world.addPolygon(2, 4, [0, 0, 1, 0, 1, 1], 1)
  world.commit()
  const physics = makePhysics(), terrain = new Box2dTerrain(b2, physics, world, { cellSize, origin })
  const islands = new Islands(world, { blocks: [bedrock] })
  const material = (block) => ({ friction: block === iron ? 0.25 : 0.5, categoryBits: 4 })
  const falling = new FallingGround(b2, physics, terrain, islands, { density, material })
  const commit = () => islands.update(terrain.commit())
  world.clear(1, 3)
  commit()
  for (const id of islands.loose()) falling.takeAsBody(id)
  assert.deepEqual(falling.bodies, [], 'it is nowhere until the ground is gone')
  commit()
  const made = falling.afterSync()
  assert.equal(made.length, 1)
  const step = () => { b2.b2World_Step(physics, 1 / 60, 4); return terrain.afterStep() }
  const end = () => { terrain.destroy(); b2.b2DestroyWorld(physics); islands.free(); world.free() }
  return { world, physics, terrain, islands, falling, commit, step, end, body: made[0].body, ground: made[0].ground }
}

test('a body is where its ground was, at rest, and its first step is free fall', () => {
  const { falling, islands, step, end, body } = cutArm()
  assert.deepEqual(positionOf(body), { x: 2, y: 3 })
  assert.deepEqual(velocityOf(body), { x: 0, y: 0 })
  assert.equal(islands.all().length, 1, 'the arm is no ground any more')
  for (const shape of shapesOf(body)) read(b2.b2Shape_GetFilter(shape), (filter) => assert.equal(Number(filter.categoryBits), 4))
  assert.deepEqual(new Set(shapesOf(body).map((shape) => b2.b2Shape_GetFriction(shape))), new Set([0.25, 0.5]))
  step()
  assert.equal(velocityOf(body).x, 0, 'it touched what it was part of')
  near(velocityOf(body).y, -10 / 60)
  assert.equal(b2.b2Body_GetAngularVelocity(body), 0)
  assert.deepEqual(falling.afterSync(), [], 'each is made once')
  end()
})

for (const cellSize of [1, 0.5])
  test(`mass is that of its blocks, with cells of ${cellSize} m`, () => {
    const { end, body } = cutArm({ cellSize, origin: { i: -3, j: 1 } })
    // Two squares and a half of weight 2, one square of weight 8; counted from (2, 3).
    const mass = 2 * 2.5 + 8, x = (2 * (0.5 + 1.5 + (0.5 * 2) / 3) + 8 * 2.5) / mass, y = (2 * (0.5 + 0.5 + (0.5 * 4) / 3) + 8 * 0.5) / mass
    const square = (weight, cx) => weight / 6 + weight * ((cx - x) ** 2 + (0.5 - y) ** 2)
    const ramp = 2 * (0.5 / 9 + 0.5 * ((2 / 3 - x) ** 2 + (4 / 3 - y) ** 2))
    const inertia = square(2, 0.5) + square(2, 1.5) + square(8, 2.5) + ramp, area = cellSize ** 2
    near(b2.b2Body_GetMass(body), mass * area)
    const center = read(b2.b2Body_GetLocalCenterOfMass(body), (c) => ({ x: c.x, y: c.y }))
    near(center.x, x * cellSize)
    near(center.y, y * cellSize)
    near(b2.b2Body_GetRotationalInertia(body), inertia * area * area)
    assert.deepEqual(positionOf(body), { x: 5 * cellSize, y: 2 * cellSize })
    end()
  })

for (const cellSize of [1, 0.25])
  test(`what came to rest is ground again, and can be dug, with cells of ${cellSize} m`, () => {
    const { world, physics, terrain, islands, falling, commit, step, end, body } = cutArm({ cellSize })
    let steps = 0
    for (; steps < 1200 && b2.b2Body_IsAwake(body); ++steps) assert.deepEqual(step(), [])
    assert.ok(steps < 1200, 'it comes to rest')
    const center = read(b2.b2Body_GetWorldCenterOfMass(body), (c) => ({ x: c.x, y: c.y }))
    const { x, y } = terrain.point(center), bodies = bodyCount(physics)
    assert.ok(y > 0 && y < 2)
    assert.equal(world.at(x, y).where, 'outside')
    assert.ok(falling.settle(body))
    assert.deepEqual(falling.bodies, [])
    assert.equal(bodyCount(physics), bodies - 1)
    commit()
    assert.equal(islands.all().length, 1, 'it hangs together with what it rests on')
    assert.deepEqual(islands.loose(), [])
    assert.equal(world.at(x, y).where, 'inside')
    assert.throws(() => falling.settle(body), (error) => error.code === 'bad-argument')
    world.carve(circle(x, y, 0.3))
    commit()
    assert.equal(world.at(x, y).where, 'outside')
    assert.ok(islands.all().length === 1 && islands.island(islands.all()[0]).anchors > 0)
    end()
  })

test('nobody settles in the ground, and nothing has changed', () => {
  const { world, falling, islands, commit, end, body } = cutArm()
  const { version } = world
  for (const height of [-0.5, -0.05]) {
    moveTo(body, 4, height)
    assert.equal(falling.settle(body), false)
  }
  assert.equal(falling.bodies.length, 1)
  commit()
  assert.equal(world.version, version)
  moveTo(body, 4, 0.001)
  assert.ok(falling.settle(body))
  commit()
  assert.equal(islands.all().length, 1)
  end()
})

test('dust has no body; ground that left in another way has one, at any place', () => {
  const { world, physics, terrain, falling, islands, commit, end, ground, body } = cutArm()
  world.addPolygon(10, 5, [0, 0.002, 0.003, 0.002, 0.002, 0.005], 1)
  world.addPolygon(12, 5, [0, 0.002, 1, 0.002, 1, 0.005], 1)
  commit()
  for (const id of islands.loose()) falling.takeAsBody(id)
  commit()
  const count = bodyCount(physics)
  assert.deepEqual(falling.afterSync(), [])
  assert.equal(bodyCount(physics), count)
  const twin = falling.make(ground, { x: 7, y: 2, angle: 1 })
  const place = falling.placeOf(twin.body)
  near(place.x, 7), near(place.y, 2), near(place.angle, 1, 1e-3)
  assert.equal(b2.b2Body_GetMass(twin.body), b2.b2Body_GetMass(body))
  falling.forget(twin.body)
  assert.equal(falling.bodies.length, 1)
  for (const wrong of [null, {}, { x: NaN, y: 0, angle: 0 }]) assert.throws(() => falling.make(ground, wrong), (error) => error.code === 'bad-argument')
  assert.throws(() => falling.make(null), (error) => error.code === 'bad-argument')
  assert.equal(falling.make({ i: 0, j: 0, polygons: [] }), null)
  const bad = new FallingGround(b2, physics, terrain, islands, { density: () => -1 })
  assert.throws(() => bad.make(ground), (error) => error.code === 'bad-argument')
  assert.equal(bodyCount(physics), count + 1, 'nothing is left of it')
  terrain.destroy()
  assert.throws(() => falling.make(ground), (error) => error.code === 'freed')
  end()
})

test('a rock dug free rolls down a slope without going through it, and its blocks stay what they are', () => {
  const world = createWorld()
  world.paint({ rings: [[0, -2, 40, -2, 40, 0, 30, 0, 10, 10, 0, 10]] }, bedrock)
  world.paint(circle(9, 16, 1.5, 24), 1)
  world.paint(circle(9, 16, 0.5, 16), iron, 'replace')
  world.paint({ rings: [[8.8, 17, 9.2, 17, 9.2, 20, 8.8, 20]] }, 1)
  world.paint({ rings: [[0, 20, 10, 20, 10, 21, 0, 21]] }, bedrock)
  world.commit()
  const physics = makePhysics(), terrain = new Box2dTerrain(b2, physics, world), islands = new Islands(world, { blocks: [bedrock] })
  const falling = new FallingGround(b2, physics, terrain, islands, { density, material: () => ({ friction: 0.6 }) })
  const areaOf = (block) => world.polygons().filter((p) => p.block === block).reduce((sum, { vertices: v }) => {
    for (let k = 0; k < v.length; k += 2) sum += (v[k] * v[(k + 3) % v.length] - v[k + 1] * v[(k + 2) % v.length]) / 2
    return sum
  }, 0)
  world.carve({ rings: [[8, 18, 10, 18, 10, 20, 8, 20]] })
  islands.update(terrain.commit())
  const was = [areaOf(1), areaOf(iron)]
  for (const id of islands.loose()) falling.takeAsBody(id)
  islands.update(terrain.commit())
  const [{ body }] = falling.afterSync()
  b2.b2Body_SetAngularDamping(body, 0.3)
  let k = 0
  for (; k < 3000 && b2.b2Body_IsAwake(body); ++k) {
    b2.b2World_Step(physics, 1 / 60, 4)
    assert.deepEqual(terrain.afterStep(), [])
  }
  assert.ok(k < 3000)
  assert.ok(falling.settle(body))
  islands.update(terrain.commit())
  assert.ok(islands.all().every((id) => islands.island(id).anchors > 0), 'it is held again')
  for (const [n, block] of [1, iron].entries()) assert.ok(Math.abs(areaOf(block) - was[n]) < 0.02, `${areaOf(block)} of ${was[n]}`)
  world.free()
})
