// What the terrains for planck and box2d3-wasm have in common: options, and calls at the wrong time. Law 13 has tests of
// its own: buried.test.js.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { Circle, World as Physics } from 'planck'
import { Box2dTerrain } from 'localgridseg/box2d3'
import { LgsError, createWorld, unitSquare } from 'localgridseg'
import { PlanckTerrain } from 'localgridseg/planck'
import { b2, floorOf, makePhysics, vec } from './box2d3.js'

const refuses = (code, f, pattern = /./) =>
  assert.throws(f, (error) => {
    assert.ok(error instanceof LgsError, String(error.stack))
    assert.equal(error.code, code, error.message)
    assert.match(error.message, pattern)
    return true
  })

/** Each engine: how a terrain is made, and a game in which something happens in the middle of a step. */
const engines = [
  {
    name: 'planck',
    make: (world, options) => {
      const physics = new Physics({ x: 0, y: -10 })
      return { physics, terrain: new PlanckTerrain(physics, world, options) }
    },
    inStep({ physics }, act) {
      const ball = physics.createBody({ type: 'dynamic', position: { x: 1.5, y: 1.35 } })
      ball.createFixture(new Circle(0.4), { density: 1 })
      physics.on('begin-contact', act)
      for (let k = 0; k < 30; ++k) physics.step(1 / 60)
      physics.off('begin-contact', act)
    },
    count: ({ physics }, world, terrain) =>
      Array.from(world.segments().id).filter((id) => terrain.fixture(id) !== null).length,
  },
  {
    name: 'box2d3-wasm',
    make: (world, options) => {
      const physics = makePhysics()
      return { physics, terrain: new Box2dTerrain(b2, physics, world, options) }
    },
    inStep({ physics }, act) {
      const def = b2.b2DefaultBodyDef()
      def.type = b2.b2BodyType.b2_dynamicBody
      def.position = vec(1.5, 1.35)
      const shape = b2.b2DefaultShapeDef(), round = new b2.b2Circle()
      shape.enablePreSolveEvents = true
      round.center = vec(0, 0)
      round.radius = 0.4
      b2.b2CreateCircleShape(b2.b2CreateBody(physics, def), shape, round)
      b2.b2World_SetPreSolveCallback(physics, () => (act(), true))
      for (let k = 0; k < 30; ++k) b2.b2World_Step(physics, 1 / 60, 4)
    },
    count: (_, world, terrain) => Array.from(world.segments().id).filter((id) => terrain.shape(id) !== null).length,
  },
]

for (const { name, make, inStep, count } of engines) {
  test(`${name}: in a step nothing is changed, and after it all is as if nothing had been tried`, () => {
    const world = floorOf(4), game = make(world), { terrain } = game
    let tried = 0
    inStep(game, () => {
      if (tried++ > 0) return
      refuses('busy', () => terrain.commit(), /after the step/)
      assert.equal(world.version, world.commit().after)
      world.clear(1, 0)
      const changes = world.commit()
      refuses('busy', () => terrain.sync(changes))
      for (const call of ['resync', 'destroy', 'afterStep']) refuses('busy', () => terrain[call]())
      refuses('busy', () => terrain.moveOrigin({ i: 1, j: 1 }))
    })
    assert.ok(tried > 0, 'something touched')
    // These changes are still the last ones of the world.
    const mark = world.mark()
    terrain.resync()
    assert.equal(count(game, world, terrain), world.stats().segments)
    world.clear(2, 0)
    terrain.sync(world.commit())
    terrain.sync(world.rollBack(mark))
    assert.equal(count(game, world, terrain), world.stats().segments)
    world.free()
  })

  test(`${name}: changes of before a step are synced after it`, () => {
    const world = floorOf(4), game = make(world), { terrain } = game
    let changes = null
    inStep(game, () => {
      if (changes !== null) return
      world.clear(1, 0)
      changes = world.commit()
      refuses('busy', () => terrain.sync(changes))
    })
    terrain.sync(changes)
    assert.equal(count(game, world, terrain), world.stats().segments)
    refuses('shown-already', () => terrain.sync(changes))
    world.free()
  })

  test(`${name}: changes that do not follow what is shown are refused, and say how`, () => {
    const world = floorOf(4), { terrain } = make(world)
    world.clear(1, 0)
    const first = world.commit().copy()
    world.clear(2, 0)
    const second = world.commit()
    refuses('not-the-last', () => terrain.sync(first), /resync/)
    refuses('left-out', () => terrain.sync(second), /resync/)
    refuses('left-out', () => terrain.overlapsWith(second))
    terrain.resync()
    refuses('shown-already', () => terrain.sync(second))
    terrain.destroy()
    for (const call of [() => terrain.sync(second), () => terrain.resync(), () => terrain.afterStep()]) refuses('freed', call)
    world.free()
  })

  test(`${name}: a world that was freed, and one that is none`, () => {
    const world = floorOf(4), { terrain } = make(world)
    world.free()
    refuses('freed', () => terrain.resync())
    terrain.destroy()
    refuses('bad-argument', () => make({ segments() {} }))
    refuses('bad-argument', () => make(null))
    refuses('freed', () => make(world))
  })

  test(`${name}: options are checked`, () => {
    const world = floorOf(4)
    for (const cellSize of [0, -1, '2', NaN, Infinity, 1e-7, null]) refuses('bad-argument', () => make(world, { cellSize }), /cellSize/)
    for (const chunkCells of [0, -1, 2.5, 5000, '16', NaN]) refuses('bad-argument', () => make(world, { chunkCells }), /chunkCells/)
    for (const origin of [7, { i: 0.5, j: 0 }, { i: 0 }, { i: 2 ** 31, j: 0 }]) refuses('bad-argument', () => make(world, { origin }), /origin/)
    refuses('bad-argument', () => make(world, { onOverlap: 'kill' }), /push/)
    refuses('bad-argument', () => make(world, { material: 7 }), /material/)
    refuses('bad-argument', () => make(world, { material: () => 3 }), /material/)
    const { terrain } = make(world, { cellSize: 0.5, chunkCells: 1 })
    assert.equal(terrain.cellSize, 0.5)
    world.clear(1, 0)
    refuses('bad-argument', () => terrain.sync(world.commit(), 'kill'))
    world.free()
  })

  test(`${name}: a sync costs what changed, a resync() all of the world`, () => {
    const world = createWorld(), triangle = world.shape([0.25, 0.25, 0.75, 0.25, 0.5, 0.75])
    world.fill({ i0: 0, j0: 0, i1: 39, j1: 39 }, triangle, 1)
    world.commit()
    const { terrain } = make(world)
    const least = (prepare, act) => {
      const times = Array.from({ length: 20 }, () => {
        const what = prepare(), begin = performance.now()
        act(what)
        return performance.now() - begin
      })
      return Math.min(...times)
    }
    const edit = () => {
      if (world.clear(30, 30) === 0) world.add(30, 30, triangle, 1)
      return world.commit()
    }
    const ofSync = least(edit, (changes) => terrain.sync(changes)), ofAll = least(() => {}, () => terrain.resync())
    assert.ok(ofSync < ofAll / 20, `${ofSync} ms, and ${ofAll} ms`)
    terrain.destroy()
    world.free()
  })

  test(`${name}: a material() that throws has changed nothing`, () => {
    const world = floorOf(4)
    let isWrong = false
    const material = () => {
      if (isWrong) throw new Error('no such block')
      return { friction: 0.5 }
    }
    const game = make(world, { material }), { terrain } = game
    isWrong = true
    world.add(1, 1, world.shape(unitSquare), 9)
    const changes = world.commit()
    assert.throws(() => terrain.sync(changes), /no such block/)
    isWrong = false
    terrain.sync(changes)
    assert.equal(count(game, world, terrain), world.stats().segments)
    world.free()
  })
}

test('planck: a listener that hears of a fixture that goes must not sync', () => {
  const world = floorOf(4), physics = new Physics({ x: 0, y: -10 })
  const terrain = new PlanckTerrain(physics, world)
  const ball = physics.createBody({ type: 'dynamic', position: { x: 1.5, y: 1.39 } })
  ball.createFixture(new Circle(0.4), { density: 1 })
  for (let k = 0; k < 10; ++k) physics.step(1 / 60)
  let heard = 0
  physics.on('end-contact', () => {
    ++heard
    const other = createWorld() // the package may be used
    other.fill({ i0: 0, j0: 0, i1: 199, j1: 199 }, other.shape([0.25, 0.25, 0.75, 0.25, 0.5, 0.75]), 1)
    other.commit()
    refuses('busy', () => terrain.resync(), /listener/)
  })
  world.clear(1, 0)
  terrain.sync(world.commit())
  assert.ok(heard > 0)
  for (const id of world.segments().id) assert.ok(terrain.fixture(id))
  world.free()
})
