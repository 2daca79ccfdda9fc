// What ground that falls does with any physics engine: it is where it was, at rest, without kicks, and back in the
// ground, where it can be dug.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { circle, createWorld, Islands, unitSquare } from 'localgridseg/islands'

export const iron = 7
const bedrock = 9
const density = (block) => (block === iron ? 8 : 2)

/** The area of the polygons of a block. */
const areaOf = (world, block) => world.polygons().filter((p) => p.block === block).reduce((sum, { vertices: v }) => {
  for (let k = 0; k < v.length; k += 2) sum += (v[k] * v[(k + 3) % v.length] - v[k + 1] * v[(k + 2) % v.length]) / 2
  return sum
}, 0)

/** A terrain and its islands in a world of physics. */
function grounded(engine, world, frame = {}) {
  const physics = engine.makePhysics(), terrain = engine.makeTerrain(physics, world, frame)
  const islands = new Islands(world, { blocks: [bedrock] })
  const falling = engine.makeFalling(physics, terrain, islands, { density, material: engine.material })
  const commit = () => islands.update(terrain.commit())
  const takeLoose = () => {
    for (const id of islands.loose()) falling.takeAsBody(id)
    assert.deepEqual(falling.bodies, [], 'it is nowhere until the ground is gone')
    commit()
    return falling.afterSync()
  }
  const step = () => { engine.step(physics); return terrain.afterStep() }
  const end = () => { terrain.destroy(); engine.destroy(physics); islands.free(); world.free() }
  return { world, physics, terrain, islands, falling, commit, takeLoose, step, end }
}

/** A pillar with an arm, of which the end is iron, with half a cell on it. The arm is cut off. */
export function cutArm(engine, { cellSize = 1, origin = { i: 0, j: 0 } } = {}) {
  const world = createWorld(), square = world.shape(unitSquare)
  world.fill({ i0: -10, j0: -1, i1: 20, j1: -1 }, square, bedrock)
  world.fill({ i0: 0, j0: 0, i1: 0, j1: 3 }, square, 1)
  world.fill({ i0: 1, j0: 3, i1: 3, j1: 3 }, square, 1)
  world.add(4, 3, square, iron)
  world.addPolygon(2, 4, [0, 0, 1, 0, 1, 1], 1)
  world.commit()
  const arm = grounded(engine, world, { cellSize, origin })
  world.clear(1, 3)
  arm.commit()
  const made = arm.takeLoose()
  assert.equal(made.length, 1)
  return { ...arm, body: made[0].body, ground: made[0].ground }
}

/** An engine has functions to make physics and what stands on it, and to ask and move bodies; and how exact it is. */
export function testFalling(engine) {
  const near = (a, b, within = engine.within) => assert.ok(Math.abs(a - b) <= within * Math.max(1, Math.abs(b)), `${a} and not ${b}`)

  test('a body is where its ground was, at rest, and its first step is free fall', () => {
    const { physics, falling, islands, step, end, body } = cutArm(engine)
    assert.deepEqual(engine.positionOf(body), { x: 2, y: 3 })
    assert.deepEqual(engine.velocityOf(body), { x: 0, y: 0 })
    assert.equal(falling.bodies.length, 1)
    assert.equal(islands.all().length, 1, 'the arm is no ground any more')
    step()
    assert.equal(engine.velocityOf(body).x, 0, 'it touched what it was part of')
    near(engine.velocityOf(body).y, -10 / 60)
    assert.equal(engine.spinOf(body), 0)
    assert.deepEqual(falling.afterSync(), [], 'each is made once')
    assert.ok(engine.bodyCount(physics) > 1)
    end()
  })

  for (const cellSize of [1, 0.5])
    test(`mass is that of its blocks, with cells of ${cellSize} m`, () => {
      const { end, body } = cutArm(engine, { cellSize, origin: { i: -3, j: 1 } })
      // Two squares and a half of weight 2, one square of weight 8; counted from (2, 3).
      const mass = 2 * 2.5 + 8, x = (2 * (0.5 + 1.5 + (0.5 * 2) / 3) + 8 * 2.5) / mass, y = (2 * (0.5 + 0.5 + (0.5 * 4) / 3) + 8 * 0.5) / mass
      const square = (weight, cx) => weight / 6 + weight * ((cx - x) ** 2 + (0.5 - y) ** 2)
      const ramp = 2 * (0.5 / 9 + 0.5 * ((2 / 3 - x) ** 2 + (4 / 3 - y) ** 2))
      const inertia = square(2, 0.5) + square(2, 1.5) + square(8, 2.5) + ramp, area = cellSize ** 2
      const center = engine.centerOf(body)
      near(engine.massOf(body), mass * area)
      near(center.x, x * cellSize)
      near(center.y, y * cellSize)
      near(engine.inertiaOf(body), inertia * area * area)
      assert.deepEqual(engine.positionOf(body), { x: 5 * cellSize, y: 2 * cellSize })
      end()
    })

  for (const cellSize of [1, 0.25])
    test(`what came to rest is ground again, and can be dug, with cells of ${cellSize} m`, () => {
      const { world, physics, terrain, islands, falling, commit, step, end, body } = cutArm(engine, { cellSize })
      let steps = 0
      for (; steps < 1200 && engine.isAwake(body); ++steps) assert.deepEqual(step(), [])
      assert.ok(steps < 1200, 'it comes to rest')
      const { x, y } = terrain.point(engine.worldCenterOf(body)), bodies = engine.bodyCount(physics)
      assert.ok(y > 0 && y < 2)
      assert.equal(world.at(x, y).where, 'outside')
      assert.ok(falling.settle(body))
      assert.deepEqual(falling.bodies, [])
      assert.equal(engine.bodyCount(physics), bodies - 1)
      commit()
      assert.equal(islands.all().length, 1, 'it hangs together with what it rests on')
      assert.deepEqual(islands.loose(), [])
      assert.equal(world.at(x, y).where, 'inside')
      assert.throws(() => falling.settle(body), (error) => error.code === 'bad-argument')
      const { area } = islands.island(islands.all()[0])
      world.carve(circle(x, y, 0.3))
      commit()
      assert.equal(world.at(x, y).where, 'outside')
      const [left, ...others] = islands.all().map((id) => islands.island(id))
      assert.deepEqual(others, [])
      assert.ok(left.anchors > 0 && left.area <= area)
      end()
    })

  test('nobody settles in the ground, and nothing has changed', () => {
    const { world, falling, islands, commit, end, body } = cutArm(engine)
    const { version } = world
    for (const height of [-0.5, -0.05]) {
      engine.moveTo(body, 4, height)
      assert.equal(falling.settle(body), false)
    }
    assert.equal(falling.bodies.length, 1)
    commit()
    assert.equal(world.version, version)
    engine.moveTo(body, 4, 0.001)
    assert.ok(falling.settle(body))
    commit()
    assert.equal(islands.all().length, 1)
    end()
  })

  test('dust has no body; ground that left in another way has one, at any place', () => {
    const { world, physics, terrain, falling, islands, commit, end, ground, body } = cutArm(engine)
    world.addPolygon(10, 5, [0, 0.002, 0.003, 0.002, 0.002, 0.005], 1)
    world.addPolygon(12, 5, [0, 0.002, 1, 0.002, 1, 0.005], 1)
    commit()
    for (const id of islands.loose()) falling.takeAsBody(id)
    commit()
    const count = engine.bodyCount(physics)
    assert.deepEqual(falling.afterSync(), [])
    assert.equal(engine.bodyCount(physics), count)
    const twin = falling.make(ground, { x: 7, y: 2, angle: 1 }), place = falling.placeOf(twin.body)
    near(place.x, 7)
    near(place.y, 2)
    near(place.angle, 1, engine.withinAngle)
    assert.equal(engine.massOf(twin.body), engine.massOf(body))
    falling.forget(twin.body)
    assert.equal(falling.bodies.length, 1)
    falling.add(twin.body, ground)
    assert.equal(falling.bodies.length, 2, 'it is given back')
    falling.forget(twin.body)
    for (const wrong of [null, {}, { x: NaN, y: 0, angle: 0 }]) assert.throws(() => falling.make(ground, wrong), (error) => error.code === 'bad-argument')
    assert.throws(() => falling.make(null), (error) => error.code === 'bad-argument')
    assert.equal(falling.make({ i: 0, j: 0, polygons: [] }), null)
    const bad = engine.makeFalling(physics, terrain, islands, { density: () => -1 })
    assert.throws(() => bad.make(ground), (error) => error.code === 'bad-argument')
    assert.equal(engine.bodyCount(physics), count + 1, 'nothing is left of it')
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
    const { islands, falling, commit, takeLoose, step, end } = grounded({ ...engine, material: () => ({ friction: 0.6 }) }, world)
    world.carve({ rings: [[8, 18, 10, 18, 10, 20, 8, 20]] })
    commit()
    const areas = () => [areaOf(world, 1), areaOf(world, iron)], was = areas()
    const [{ body }] = takeLoose()
    engine.setAngularDamping(body, 0.3)
    let k = 0
    for (; k < 3000 && engine.isAwake(body); ++k) assert.deepEqual(step(), [])
    assert.ok(k < 3000)
    assert.ok(falling.settle(body))
    commit()
    assert.ok(islands.all().every((id) => islands.island(id).anchors > 0), 'it is held again')
    areas().forEach((area, n) => assert.ok(Math.abs(area - was[n]) < 0.02, `${area} of ${was[n]}`))
    end()
  })

  test('a density that throws: the other bodies are made, and this one later', () => {
    const world = createWorld()
    for (const [i, block] of [[0, iron], [3, 1], [6, 1]]) world.add(i, 5, world.shape(unitSquare), block)
    world.commit()
    const physics = engine.makePhysics(), terrain = engine.makeTerrain(physics, world, {}), islands = new Islands(world)
    let isIn = true
    const falling = engine.makeFalling(physics, terrain, islands, { density: (block) => { if (isIn && block === iron) throw new Error('no'); return 1 } })
    const all = islands.all()
    for (const id of all) falling.takeAsBody(id)
    assert.throws(() => falling.takeAsBody(all[0]), /names no island that can be taken/)
    islands.update(terrain.commit())
    for (let k = 0; k < 2; ++k) {
      assert.throws(() => falling.afterSync(), { message: 'no' })
      assert.equal(falling.bodies.length, 2)
    }
    isIn = false
    assert.equal(falling.afterSync().length, 3, 'those that were made are told')
    assert.deepEqual(falling.afterSync(), [])
    terrain.destroy()
    engine.destroy(physics)
    islands.free()
    world.free()
  })
}
