// The ground of a game held as one, with planck and without: whatever is done in whatever order, matter is neither doubled
// nor lost, and all that follows the ground is what a look at all of it gives.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { inspect } from 'node:util'
import fc from 'fast-check'
import { Circle, World as Physics } from 'planck'
import { createWorld, Ground, init, Islands, LgsError } from 'localgridseg/islands'
import { linesIn } from 'localgridseg/draw'
import { Ground as PlanckGround } from 'localgridseg/planck'
import { anchors, areaOf, land, matterOf, pillar, refuses, solidOf, square, steps, withPlanck } from './ground.js'

before(() => init())

test('what is cut off falls, becomes ground, and comes back with undo; matter is not doubled', () => {
  const { physics, ground } = withPlanck({}, { cellSize: 0.5 })
  pillar(ground)
  const before = solidOf(ground.world), all = matterOf(ground)
  ground.dig({ rings: [[1, 3, 2, 3, 2, 4, 1, 4]] })
  assert.equal(ground.rocks().length, 1)
  assert.match(inspect(ground), /^Ground \{[^]*rocks: 1,\s*canUndo: true/)
  const [{ x, y, ground: { polygons } }] = ground.rocks()
  assert.deepEqual([x, y, polygons.length], [2, 3, 3])
  assert.equal(matterOf(ground), all - 1)
  steps(ground, 30)
  assert.ok(ground.rocks()[0].y < 3, 'it falls')
  assert.ok(ground.undo(), 'over the take')
  assert.deepEqual([ground.rocks().length, solidOf(ground.world)], [0, before])
  assert.ok(ground.redo())
  assert.deepEqual([ground.rocks()[0].x, ground.rocks()[0].y, matterOf(ground)], [2, 3, all - 1])
  steps(ground, 240)
  assert.equal(ground.rocks().length, 0, 'it is ground again')
  assert.ok(Math.abs(matterOf(ground) - all + 1) < 0.1, `${matterOf(ground)}`)
  ground.place(10, 0, square, 1)  // another stroke
  const built = solidOf(ground.world)
  assert.ok(ground.undo(), 'of that, and of what settled since the one before')
  assert.deepEqual([ground.rocks().length, matterOf(ground)], [1, all - 1])
  assert.ok(ground.rocks()[0].y < 1)
  assert.ok(ground.undo(), 'over the take')
  assert.deepEqual([ground.rocks().length, solidOf(ground.world)], [0, before])
  assert.ok(!ground.undo() && !ground.canUndo)
  assert.ok(ground.redo() && ground.canRedo)
  assert.deepEqual([ground.rocks()[0].y, matterOf(ground)], [3, all - 1])
  assert.ok(ground.redo() && !ground.redo())
  assert.deepEqual([ground.rocks().length, solidOf(ground.world)], [0, built])
  ground.free()
  assert.equal(physics.getBodyCount(), 0)
  assert.match(inspect(ground), /^Ground \{ freed: true \}/)
  refuses('freed', () => ground.dig(0, 0, 1))
  ground.free()
})

test('an undo over a settle alone leaves the rock where it lay, at rest', () => {
  const { ground } = withPlanck()
  pillar(ground)
  const all = matterOf(ground)
  ground.dig({ rings: [[1, 3, 2, 3, 2, 4, 1, 4]] })
  ground.place(15, 0, square, 1)
  steps(ground, 400)
  assert.equal(ground.rocks().length, 0)
  assert.ok(ground.undo(), 'of the stone')
  assert.equal(ground.rocks().length, 1)
  assert.ok(ground.rocks()[0].y < 1 && ground.rocks()[0].vy === 0)
  assert.equal(matterOf(ground), all - 1)
  steps(ground, 200)
  assert.equal(ground.rocks().length, 1, 'while there is something to redo nothing settles')
  assert.ok(ground.redo())
  steps(ground, 200)
  assert.equal(ground.rocks().length, 0, 'now it does')
  ground.free()
})

test('without physics rocks are values, and the game moves them', () => {
  const ground = pillar(new Ground({ anchors })), all = matterOf(ground)
  ground.dig({ rings: [[1, 3, 2, 3, 2, 4, 1, 4]] })
  const [{ body }] = ground.rocks()
  body.y = 0
  ground.step(1)
  assert.equal(ground.rocks()[0].y, 0)
  assert.ok(ground.settle(body))
  assert.deepEqual(ground.rocks(), [])
  assert.equal(matterOf(ground), all - 1)
  assert.ok(ground.world.at(2.5, 0.5).where === 'inside' && ground.world.at(2.5, 3.5).where === 'outside')
  ground.undo()
  assert.equal(matterOf(ground), all)
  ground.redo()
  assert.deepEqual([ground.rocks()[0].y, matterOf(ground)], [0, all - 1], 'to the moment before it was settled')
  ground.settle(ground.rocks()[0].body)
  ground.dig({ rings: [[0, 2, 1, 2, 1, 3, 0, 3]] })
  const rock = ground.rocks()[0]
  Object.assign(rock.body, { x: 7, y: 0 + 1 / 65536, angle: 0.5 })
  assert.ok(ground.settle(rock.body))
  refuses('bad-argument', () => ground.settle(rock.body))
  assert.equal(ground.rocks().length, 1, 'it hangs in the air, and comes loose again')
  ground.forget(ground.rocks()[0].body)
  assert.equal(ground.rocks().length, 0)
  ground.free()
})

test('a stroke that is refused changes nothing, and leaves the redo', () => {
  const { ground } = withPlanck()
  pillar(ground)
  ground.dig(0.5, 3.5, 0.3)
  ground.undo()
  const before = solidOf(ground.world)
  refuses('overlap', () => ground.edit((world) => {
    world.clear(0, 3)
    world.addPolygon(0, 2, square, 1)
  }))
  assert.deepEqual(solidOf(ground.world), before)
  refuses('overlap', () => ground.place(0, 0, square, 1))
  assert.throws(() => ground.edit(() => { throw new Error('own') }), /own/)
  refuses('busy', () => ground.edit(() => ground.dig(0, 0, 1)))
  for (const call of ['commit', 'free']) refuses('busy', () => ground.edit((world) => world[call]()))
  refuses('busy', () => ground.edit((world) => world.rollBack(1)))
  refuses('bad-argument', () => ground.dig(NaN, 0, 1))
  assert.ok(ground.canRedo && ground.redo())
  ground.free()
})

test('words that are misspelt, and what is not of planck, are refused with a sentence', () => {
  const physics = new Physics()
  assert.throws(() => new Ground({ anchor: {} }), /options has no 'anchor', but anchors, atEdge, preserve, land/)
  assert.throws(() => new PlanckGround(physics, {}, { celSize: 3 }), /options has no 'celSize', but cellSize/)
  assert.throws(() => new PlanckGround({}, {}), /physics must be a World of planck/)
  assert.throws(() => new PlanckGround(physics, {}, {}, { densty: 1 }), /options has no 'densty'/)
  refuses('bad-argument', () => new Ground({ shelf: {} }))
  refuses('bad-argument', () => new Ground({ land: 3 }))
  refuses('bad-argument', () => new Ground({ undoSteps: -1 }))
  refuses('bad-argument', () => new Ground({ atEdge: 'shut' }))
  refuses('bad-argument', () => new Ground({ chunksAtOnce: 0 }))
})

test('in a step of the physics nothing changes', () => {
  const { physics, ground } = withPlanck()
  pillar(ground)
  const told = []
  physics.createBody({ type: 'dynamic', position: { x: 8, y: 3 } }).createFixture(new Circle(0.3))
  physics.on('begin-contact', () => {
    for (const call of [() => ground.dig(0, 0, 1), () => ground.undo(), () => ground.window({ i0: 0, j0: 0, i1: 1, j1: 1 }), () => ground.load(new Uint8Array())])
      try { call() } catch (error) { told.push(error.code) }
  })
  steps(ground, 90)
  assert.deepEqual(told.slice(0, 4), ['busy', 'busy', 'busy', 'busy'])
  ground.free()
})

test('saved and loaded with a rock in the air, which goes on as it was', () => {
  const { ground } = withPlanck({}, { cellSize: 0.5 })
  pillar(ground)
  ground.dig({ rings: [[1, 3, 2, 3, 2, 4, 1, 4]] })
  steps(ground, 20)
  const bytes = ground.save(), [was] = ground.rocks(), solid = solidOf(ground.world)
  const twin = withPlanck({}, { cellSize: 0.5 }).ground
  twin.load(bytes)
  const [is] = twin.rocks()
  for (const what of ['x', 'y', 'angle', 'vx', 'vy', 'spin']) assert.ok(Math.abs(is[what] - was[what]) < 1e-12, `${what}: ${is[what]}, ${was[what]}`)
  assert.deepEqual(solidOf(twin.world), solid)
  assert.ok(!twin.canUndo)
  steps(ground, 300)
  steps(twin, 300)
  assert.equal(twin.rocks().length, 0)
  assert.ok(Math.abs(areaOf(twin.world.polygons()) - areaOf(ground.world.polygons())) < 1e-3)
  ground.load(bytes)  // in the middle of another game
  assert.equal(ground.rocks().length, 1)
  const before = solidOf(ground.world)
  for (const bad of [bytes.slice(0, -1), bytes.slice(8), new Uint8Array(), Uint8Array.from([...bytes, 0])]) {
    refuses('not-a-snapshot', () => ground.load(bad))
    assert.deepEqual([solidOf(ground.world), ground.rocks().length], [before, 1])
  }
  refuses('bad-argument', () => ground.load('text'))
  ground.free()
  twin.free()
})

test('only the squares that look different are drawn', () => {
  const ground = pillar(new Ground({ anchors }))
  const picture = new Map(), paint = () => {
    const drawn = ground.draw()
    for (const square of drawn) picture.set(square.key, square)
    return drawn.length
  }
  const isRight = () => {
    for (const { cells, fills, lines } of picture.values()) {
      assert.deepEqual(lines, linesIn(ground.world, cells))
      assert.ok(Math.abs(areaOf(fills) - areaOf(ground.world.polygons(cells))) < 1e-9)
      for (const { vertices } of fills)
        for (let k = 0; k < vertices.length; k += 2) assert.ok(vertices[k] >= cells.i0 && vertices[k] <= cells.i1 + 1 && vertices[k + 1] >= cells.j0 && vertices[k + 1] <= cells.j1 + 1)
    }
    const sum = [...picture.values()].reduce((area, { fills }) => area + areaOf(fills), 0)
    assert.ok(Math.abs(sum - areaOf(ground.world.polygons())) < 1e-9)
  }
  assert.ok(paint() > 3)
  isRight()
  assert.equal(paint(), 0)
  ground.dig(16, -0.5, 0.2)
  assert.ok(paint() <= 4)
  isRight()
  ground.dig({ rings: [[1, 3, 2, 3, 2, 4, 1, 4]] })
  paint()
  isRight()
  ground.undo()
  paint()
  isRight()
  ground.load(ground.save())
  paint()
  isRight()
  ground.free()
})

test('the game of web/examples plays: it streams, rolls back, falls, is saved and loaded, and a second world is told', () => {
  const frames = Number(process.env.LGS_TEST_SCALE ?? 0) >= 1 ? 30_000 : 1_200
  const game = fileURLToPath(new URL('../../examples/game.js', import.meta.url))
  assert.match(execFileSync(process.execPath, [game, `${frames}`], { encoding: 'utf8' }), /both worlds are the same, 0 of 12 balls lost/)
})

// --- Whatever is done

const here = { i0: -32, j0: -32, i1: 31, j1: 31 }, far = 2 ** 30
const place = fc.record({ x: fc.double({ min: -3, max: 12, noNaN: true }), y: fc.double({ min: -0.5, max: 7, noNaN: true }), radius: fc.double({ min: 0.2, max: 1.6, noNaN: true }) })
const calls = fc.array(fc.oneof(
  { weight: 6, arbitrary: place.map(({ x, y, radius }) => ['stroke', (ground) => ground.dig(x, y, radius)]) },
  { weight: 3, arbitrary: place.map(({ x, y, radius }) => ['stroke', (ground) => ground.paint(x, y, radius, 1)]) },
  { weight: 2, arbitrary: place.map(({ x, y }) => ['stroke', (ground) => ground.place(Math.floor(x), Math.floor(y), square, 2)]) },
  { weight: 5, arbitrary: fc.constant(['undo', (ground) => ground.undo()]) },
  { weight: 4, arbitrary: fc.constant(['redo', (ground) => ground.redo()]) },
  { weight: 4, arbitrary: fc.integer({ min: 1, max: 90 }).map((count) => ['steps', (ground) => steps(ground, count)]) },
  { weight: 1, arbitrary: fc.constant(['load', (ground) => ground.load(ground.save())]) },
  { weight: 2, arbitrary: fc.constantFrom(-80, 0, 0, 80).map((i) => ['window', (ground) => ground.window({ i0: i - 10, j0: -2, i1: i + 20, j1: 20 })]) },
), { minLength: 5, maxLength: 25 })

/** The islands and the edges of a ground are those that a look at all of it finds. */
function assertFollows(ground) {
  const { world, islands, terrain } = ground
  if (world.firstUnloaded({ i0: -far, j0: -far, i1: far, j1: far }) === null) {
    const anew = createWorld()
    for (const { i, j, vertices, block } of world.polygons()) anew.addPolygon(i, j, vertices, block)
    anew.commit()
    const look = new Islands(anew, anchors)
    const facts = (all) => all.all().map((id) => JSON.stringify({ ...all.island(id), id: 0 })).sort()
    assert.deepEqual(facts(islands), facts(look))
    look.free()
    anew.free()
  }
  if (!ground.canRedo) assert.ok(islands.all().every((id) => islands.island(id).anchors > 0), 'nothing hangs in the air')
  if (terrain) assert.ok(Array.from(world.segments().id).every((id) => terrain.segment(terrain.fixture(id)) === id))
}

function play(game, make, hasLand) {
  const ground = make()
  if (hasLand) while (!ground.window(here)) continue
  else pillar(ground)
  const matter = () => areaOf(ground.world.polygons(here)) + ground.rocks().reduce((sum, { ground: { mass } }) => sum + mass.area, 0)
  const look = () => (ground.world.firstUnloaded(here) === null ? { solid: solidOf(ground.world, here), matter: matter() } : null)
  let moments = [look()], at = 0 // the ground right after each stroke
  for (const [what, call] of game) {
    const was = look()
    let answer
    try {
      answer = call(ground)
    } catch (error) {
      if (!(error instanceof LgsError)) throw error
      assert.ok(['overlap', 'unloaded', 'capacity'].includes(error.code), error.message)
      assert.deepEqual(look(), was, 'what is refused changes nothing')
      continue
    }
    const is = look()
    if (what === 'stroke') moments = [...moments.slice(0, ++at), is]
    if (what === 'load') [moments, at] = [[is], 0]
    if (answer && (what === 'undo' || what === 'redo')) {
      at += what === 'undo' ? -1 : 1
      if (is && moments[at]) {
        assert.deepEqual(is.solid, moments[at].solid)
        assert.ok(Math.abs(is.matter - moments[at].matter) < 1e-9, `${is.matter} and not ${moments[at].matter}`)
      }
    }
    if (what === 'steps' && was) assert.ok(is.matter < was.matter + 1e-3 && is.matter > was.matter - 0.3, `${was.matter}, ${is.matter}`)
    if (hasLand && !ground.canRedo && (what === 'window' || what === 'undo')) moments.length = at + 1 // new land ends the redo
    assert.equal(ground.canUndo, at > 0)
    assert.equal(ground.canRedo, at + 1 < moments.length)
    assertFollows(ground)
  }
  ground.free()
}

/** Law 13 over land that streams: whose middle was free is free, or is disabled where it was; none moves where no ground is. */
test('any game with planck, with balls over land that streams', () => {
  fc.assert(fc.property(calls, fc.array(fc.tuple(fc.integer({ min: -60, max: 90 }), fc.integer({ min: 9, max: 16 }), fc.boolean()), { minLength: 1, maxLength: 6 }), fc.constantFrom(1, Infinity), (game, places, chunksAtOnce) => {
    const { physics, ground } = withPlanck({ land, chunksAtOnce }), { terrain } = ground
    while (!ground.window(here)) continue
    const balls = places.map(([x, y, isOff]) => {
      const body = physics.createBody({ type: 'dynamic', position: { x: x + 0.5, y: y + 0.5 }, active: !isOff })
      body.createFixture(new Circle(0.3), { density: 1 })
      return { body, isOff, wasFree: true, held: null }
    })
    const look = () => {
      for (const ball of balls) {
        const { x, y } = ball.body.getPosition(), { where } = ground.world.at(x, y), isActive = ball.body.isActive()
        assert.ok(!(ball.isOff && isActive), 'a body that the game keeps switched off is on')
        if (isActive && ball.wasFree) assert.equal(where, 'outside')
        if (!isActive && ball.held) assert.deepEqual({ x, y }, ball.held, 'it moved while it was disabled')
        ball.wasFree = where === 'outside' || (ball.wasFree && !isActive)
        ball.held = isActive ? null : { x, y }
      }
    }
    ground.step(1 / 60)
    for (const [what, call] of game) {
      try {
        if (what === 'steps') for (let k = 0; k < 20; ++k) { ground.step(1 / 60); look() }
        else call(ground)
      } catch (error) {
        if (!(error instanceof LgsError)) throw error
      }
      ground.step(1 / 60)
      look()
      assertFollows(ground)
    }
    assert.ok(terrain.disabled.every((body) => !body.isActive()))
    ground.free()
  }), { numRuns: 40 })
})

for (const [name, make, runs, hasLand] of [['without physics', () => new Ground({ anchors }), 100], ['with planck', () => withPlanck().ground, 80],
  ['over land that streams', () => new Ground({ anchors, land }), 60, true],
  ['over land that comes in one by one', () => new Ground({ anchors, land, chunksAtOnce: 1 }), 40, true],
  ['over land whose edge is open', () => new Ground({ anchors, land, atEdge: 'open' }), 40, true]])
  test(`any game ${name}`, () => { fc.assert(fc.property(calls, (game) => play(game, make, hasLand)), { numRuns: runs }) })
