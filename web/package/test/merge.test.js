// Edges that merge: a body that rolls over a flat floor has one contact, and hit() still names the tile.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import fc from 'fast-check'
import { Circle, World as Physics } from 'planck'
import { circle, createWorld, init, unitSquare } from 'localgridseg'
import { Box2dTerrain } from 'localgridseg/box2d3'
import { PlanckTerrain } from 'localgridseg/planck'
import { b2, makePhysics } from './box2d3.js'

before(() => init())

/** `blocks` gives each of 40 columns its block. */
function floor(blocks = () => 1) {
  const world = createWorld()
  for (let i = 0; i < 40; ++i) world.add(i, 0, world.shape(unitSquare), blocks(i))
  world.commit()
  return world
}

/** A circle over 30 seams: how often a contact with the floor begins, and which cells are hit then, at its middle. */
function roll(world, options) {
  const physics = new Physics({ gravity: { x: 0, y: -10 } }), terrain = new PlanckTerrain(physics, world, options)
  const ball = physics.createBody({ type: 'dynamic', position: { x: 2.5, y: 1.3 }, linearVelocity: { x: 6, y: 0 } })
  ball.createFixture(new Circle(0.3), { density: 1, friction: 0 })
  let begins = 0, ends = 0
  physics.on('begin-contact', (contact) => {
    ++begins
    const { x } = ball.getPosition(), hit = terrain.hit(contact)
    assert.ok(Math.abs(hit.i + 0.5 - x) < 0.6, `cell ${hit.i} at ${x}`)
  })
  physics.on('end-contact', () => ++ends)
  let seams = 0
  while (ball.getPosition().x < 33) {
    const was = Math.floor(ball.getPosition().x)
    terrain.beforeStep()
    physics.step(1 / 60)
    terrain.afterStep()
    seams += Math.floor(ball.getPosition().x) - was
    assert.ok(Math.abs(ball.getLinearVelocity().y) < 1e-9, 'no kick')
    for (let contact = ball.getContactList(); contact; contact = contact.next) {
      if (!contact.contact.isTouching()) continue
      const { x } = ball.getPosition(), hit = terrain.hit(contact.contact)
      assert.ok(x > hit.i - 0.35 && x < hit.i + 1.35, `cell ${hit.i} at ${x}`)
    }
  }
  const counts = { begins, ends, seams }
  terrain.destroy()
  return counts
}

test('a circle over 30 seams of a flat floor has one contact', () => {
  const world = floor()
  assert.deepEqual(roll(world, { merge: true, chunkCells: 64 }), { begins: 1, ends: 0, seams: 31 })
  const { begins, ends } = roll(world, { merge: true })  // an edge ends with its chunk of 16 cells
  assert.ok(begins <= 3 && ends <= 2, `${begins}, ${ends}`)
  assert.ok(roll(world, {}).begins >= 30, 'without, each cell is one')
  world.free()
})

test('only equal materials merge', () => {
  const world = floor((i) => (i < 20 ? 1 : i < 30 ? 2 : 3)), physics = new Physics()
  const count = (material) => {
    const terrain = new PlanckTerrain(physics, world, { merge: true, chunkCells: 64, material })
    const fixtures = new Set(Array.from(world.segments().id, (id) => terrain.fixture(id)))
    terrain.destroy()
    return fixtures.size
  }
  assert.equal(count(undefined), 4)
  assert.equal(count((block) => ({ friction: block < 3 ? 0.5 : 0.1 })), 6)
  assert.equal(count((block) => ({ friction: block === 2 ? 0.5 : 0.1, restitution: 0 })), 8)
  assert.equal(count((block) => (block === 1 ? { friction: 0.1, restitution: 0 } : { restitution: 0, friction: 0.1 })), 4, 'whatever their order')
  assert.throws(() => count(() => 3), /material\(\)/)
  assert.throws(() => new PlanckTerrain(physics, world, { merge: 1 }), /merge must be true or false/)
  world.free()
})

test('a fixture and a point name the tile, a fixture alone the first of them', () => {
  const world = floor((i) => 1 + (i % 3)), physics = new Physics()
  const terrain = new PlanckTerrain(physics, world, { merge: true, chunkCells: 64, cellSize: 0.5 })
  const top = terrain.fixture(world.nearest(7.5, 1, 0.1).segment)
  for (const i of [0, 7, 21, 39]) assert.deepEqual([terrain.hit(top, { x: (i + 0.5) / 2, y: 0.5 }).i, terrain.hit(top, { x: (i + 0.5) / 2, y: 0.5 }).block], [i, 1 + (i % 3)])
  assert.equal(terrain.hit(top).i, 39, 'the solid is on the left')
  world.free()
})

test('edits, roll-backs and another world: the edges are those that a new terrain has', () => {
  const edit = fc.record({ x: fc.double({ min: 0, max: 40, noNaN: true }), y: fc.double({ min: 0, max: 2, noNaN: true }), radius: fc.double({ min: 0.1, max: 3, noNaN: true }), block: fc.integer({ min: 0, max: 3 }) })
  const shown = (terrain, world) => new Set(Array.from(world.segments().id, (id) => {
    const { m_vertex1: a, m_vertex2: b, m_vertex0: before, m_vertex3: after } = terrain.fixture(id).getShape(), { x, y } = terrain.fixture(id).getBody().getPosition()
    return [a, b, before, after].flatMap((v) => [v.x + x, v.y + y]).join()
  }))
  fc.assert(fc.property(fc.array(edit, { minLength: 1, maxLength: 8 }), (edits) => {
    const world = floor(), physics = new Physics(), options = { merge: true, material: (block) => ({ friction: block === 2 ? 0.1 : 0.5 }) }
    const terrain = new PlanckTerrain(physics, world, options), mark = world.mark()
    const isRight = () => {
      const anew = new PlanckTerrain(new Physics(), world, options)
      assert.deepEqual(shown(terrain, world), shown(anew, world))
      anew.destroy()
    }
    for (const { x, y, radius, block } of edits) {
      if (block === 0) world.carve(circle(x, y, radius))
      else world.paint(circle(x, y, radius), block, 'replace')
      terrain.commit()
      isRight()
    }
    terrain.sync(world.rollBack(mark))
    isRight()
    const other = floor((i) => i % 5)
    terrain.resync(other)
    world.free()
    assert.ok(terrain.hit(terrain.fixture(1)) !== null)
    other.clear(5, 0)
    terrain.commit()
    other.free()
  }), { numRuns: 60 })
})

test('box2d3-wasm: the same, and its shapes', () => {
  const world = floor(), physics = makePhysics()
  const terrain = new Box2dTerrain(b2, physics, world, { merge: true, chunkCells: 64 })
  const shapes = new Set(Array.from(world.segments().id, (id) => terrain.shape(id).index1))
  assert.equal(shapes.size, 4)
  const top = terrain.shape(world.nearest(7.5, 1, 0.1).segment)
  assert.equal(terrain.hit(top, { x: 21.5, y: 1 }).i, 21)
  world.clear(20, 0)
  terrain.commit()
  assert.equal(terrain.hit(terrain.shape(world.nearest(7.5, 1, 0.1).segment), { x: 7.5, y: 1 }).i, 7)
  terrain.destroy()
  world.free()
})
