// The windows of a Ground: what streams in and out, by example and in any order.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import fc from 'fast-check'
import { Circle } from 'planck'
import { Ground, init, LgsError, unitSquare } from 'localgridseg/islands'
import { allOf, anchors, bedrock, land, matterOf, pillar, refuses, solidOf, square, steps, withPlanck } from './ground.js'

before(() => init())

const scale = Math.max(1, Number(process.env.LGS_TEST_SCALE ?? 0))
const cells = (i0, j0, i1 = i0, j1 = j0) => ({ i0, j0, i1, j1 })

const columns = [-40, -20, 1, 1, 2, 10, 10, 31, 32, 50]
const strokes = {
  cut: (world, i) => -world.clear(cells(i, 4)),
  mend: (world, i) => world.fill(cells(i, 4), world.shape(unitSquare), 2),
  prop: (world, i) => world.fill(cells(i, 0, i, 3), world.shape(unitSquare), bedrock),
  topple: (world) => -world.clear(cells(0, 0, 0, 3)),
}
const moves = fc.array(fc.oneof(
  { weight: 4, arbitrary: fc.constantFrom(...columns).map((i) => ['cut', i]) },
  { weight: 2, arbitrary: fc.constantFrom(...columns).map((i) => ['mend', i]) },
  { weight: 2, arbitrary: fc.constantFrom(...columns).map((i) => ['prop', i]) },
  { weight: 1, arbitrary: fc.constant(['topple', 0]) },
  { weight: 5, arbitrary: fc.constant(['undo']) },
  { weight: 4, arbitrary: fc.constant(['redo']) },
  { weight: 7, arbitrary: fc.constantFrom([0, 31], [0, 31], [-64, 95], [-64, 95], [0, 63], [300, 301]).map(([i0, i1]) => ['window', cells(i0, -1, i1, 10)]) },
), { minLength: 6, maxLength: 20, size: 'max' })

/** A beam on a pillar, over several chunks, of which now these and now those are in memory. */
function stream(game, make) {
  const ground = make()
  ground.edit((world) => {
    world.fill(cells(-50, -1, 80, -1), world.shape(unitSquare), bedrock)
    world.fill(cells(0, 0, 0, 3), world.shape(unitSquare), 1)
    world.fill(cells(-40, 4, 70, 4), world.shape(unitSquare), 2)
  })
  ground.forgetUndo()
  let now = allOf(ground), moments = [now], at = 0 // the ground right after each stroke
  for (const [what, how] of game) {
    let more = 0, went = false
    try {
      if (strokes[what]) more = ground.edit((world) => strokes[what](world, how))
      else if (what === 'window') for (let k = 0; !ground.window(how); ++k) assert.ok(k < 100, 'it never comes in')
      else went = ground[what]()
    } catch (error) {
      if (!(error instanceof LgsError)) throw error
      assert.ok(['overlap', 'unloaded'].includes(error.code), error.message)
      assert.deepEqual(allOf(ground), now, 'what is refused changes nothing')
      continue
    }
    const { matter } = now
    now = allOf(ground)
    if (strokes[what]) moments = [...moments.slice(0, ++at), now]
    if (went) at += what === 'undo' ? -1 : 1
    assert.equal(now.matter, went ? moments[at].matter : matter + more)
    if (went && !ground.terrain) assert.deepEqual(now.cells, moments[at].cells) // law 13 moves bodies
    if (what === 'window') assert.equal(ground.world.firstUnloaded(how), null)
    assert.deepEqual([ground.canUndo, ground.canRedo], [at > 0, at + 1 < moments.length])
    const { islands } = ground
    if (!ground.canRedo) assert.ok(islands.all().every((id) => islands.island(id).anchors > 0), 'nothing hangs in the air')
  }
  ground.free()
}

for (const [name, make] of [['without physics', () => new Ground({ anchors })], ['with planck', () => withPlanck().ground],
  ['chunk by chunk', () => new Ground({ anchors, chunksAtOnce: 1 })]])
  test(`strokes, undo and redo under windows that move, ${name}: all matter is there, and what is loose falls`, () => {
    fc.assert(fc.property(moves, (game) => stream(game, make)), { numRuns: 15 * scale })
  })

test('what an edge of memory held falls when all is in memory, after an undo and a redo too', () => {
  const some = ['window', cells(0, -1, 31, 10)], all = ['window', cells(-64, -1, 95, 10)]
  for (const game of [[some, ['cut', 1], all, ['undo'], ['redo']], [some, ['cut', 1], ['prop', 10], all, ['undo'], ['cut', 20]], [some, ['cut', 1], ['undo'], all, ['redo']]])
    stream(game, () => new Ground({ anchors }))
})

test('a window streams over land and shelf; what was dug is there again, and the undo outlives it', () => {
  const shelf = new Map(), told = []
  const { ground } = withPlanck({
    land, follow: (world, changes) => told.push(changes.after),
    shelf: { put: (i, j, bytes) => void shelf.set(`${i},${j}`, bytes), get: (i, j) => shelf.get(`${i},${j}`) },
  })
  const at = (i) => ({ i0: i - 20, j0: -20, i1: i + 20, j1: 20 })
  assert.ok(ground.window(at(0)) && ground.window(at(1)))
  ground.window(at(100))
  ground.window(at(0))  // all that there will be is seen
  const before = solidOf(ground.world)
  ground.dig(0.5, 2.5, 2)
  const after = solidOf(ground.world)
  assert.notDeepEqual(after, before)
  assert.ok(ground.window(at(100)))
  assert.equal(ground.world.at(0.5, 2.5).where, 'unloaded')
  refuses('unloaded', () => ground.dig(0.5, 2.5, 2))
  assert.ok(shelf.size > 0)
  assert.ok(ground.window(at(0)))
  assert.deepEqual(solidOf(ground.world), after)
  ground.window(at(100))
  assert.ok(ground.undo())
  assert.equal(ground.world.at(0.5, 2.5).where, 'unloaded', 'an undo loads nothing')
  ground.window(at(0))
  assert.deepEqual(solidOf(ground.world), before)
  assert.ok(ground.redo())
  assert.deepEqual(solidOf(ground.world), after)
  ground.window(at(300))
  const far = solidOf(ground.world)
  assert.ok(far.length > 1000 && ground.canUndo, 'new land ends no undo')
  assert.ok(ground.undo() && !ground.canRedo, 'but the redo')
  assert.deepEqual(solidOf(ground.world), far, 'nobody has dug there at that time')
  ground.window(at(0))
  assert.deepEqual(solidOf(ground.world), before)
  ground.dig(0.5, 2.5, 2)
  ground.window(at(300))
  assert.deepEqual(solidOf(ground.world), far)
  ground.window(at(0))
  assert.deepEqual(solidOf(ground.world), after)
  const saved = ground.save()
  const twin = withPlanck({ land }).ground
  twin.window(at(100))
  twin.load(saved)
  assert.ok(twin.window(at(0)))
  assert.deepEqual(solidOf(twin.world), after)
  shelf.clear()
  assert.ok(!ground.window(at(100)), 'nothing is where it should be')
  refuses('unloaded', () => ground.save())
  assert.ok(told.length > 5)
  ground.free()
  twin.free()
})

test('what hangs in the air falls when it comes in: after a load, and once there is nothing to redo', () => {
  const loose = new Ground()  // nothing holds, and nothing falls
  loose.place(3, 3, square, 1)
  const ground = new Ground({ anchors })
  ground.load(loose.save())
  assert.equal(ground.rocks().length, 1)
  const column = (k) => ({ i0: 32 * k + 1, j0: 1, i1: 32 * k + 2, j1: 2 })
  const streaming = new Ground({ anchors, land: (world, { i0, j0, i1 }) => {
    if (j0 === 0) world.fill({ i0, j0, i1, j1: j0 }, world.shape(unitSquare), bedrock)
    if (j0 === 0 && i0 === 64) world.addPolygon(70, 5, square, 1)
  } })
  for (const k of [1, 4, 1]) streaming.window(column(k))  // its land is made, and it was never here
  streaming.place(40, 1, square, 1)
  streaming.undo()
  streaming.window(column(2))
  assert.deepEqual([streaming.rocks().length, streaming.canRedo], [0, true])
  assert.ok(streaming.redo())
  streaming.place(66, 1, square, 1)
  assert.equal(streaming.rocks().length, 1)
  for (const each of [loose, ground, streaming]) each.free()
})

test('bodies wait where their ground is not in memory', () => {
  const { physics, ground } = withPlanck({ land })
  const here = { i0: -20, j0: -20, i1: 20, j1: 20 }, there = { i0: 80, j0: -20, i1: 120, j1: 20 }
  ground.window(here)
  const ball = physics.createBody({ type: 'dynamic', position: { x: 0.5, y: 9 } })
  ball.createFixture(new Circle(0.3), { density: 1 })
  steps(ground, 10)
  ground.window(there)
  const { y } = ball.getPosition()
  steps(ground, 60)
  assert.deepEqual([ball.isActive(), ball.getPosition().y], [false, y])
  ground.window(here)
  assert.ok(ball.isActive())
  steps(ground, 200)
  assert.ok(ball.getPosition().y > 3, 'it lies on its ground')
  ball.setTransform({ x: 100, y: 9 }, 0)
  ball.setAwake(true)
  ground.terrain.moved(ball)
  steps(ground, 1)
  assert.ok(!ball.isActive(), 'who leaves the window waits, too')
  physics.destroyBody(ball)
  ground.window(there)
  ground.free()
})

test('who waited is put out of ground that came there meanwhile', () => {
  const { physics, ground } = withPlanck(), rock = { i0: 33, j0: 5, i1: 80, j1: 20 }
  ground.edit((world) => void world.fill(rock, world.shape(unitSquare), bedrock))
  ground.edit((world) => void world.clear(rock))
  const ball = physics.createBody({ type: 'dynamic', position: { x: 40.5, y: 12.5 } })
  ball.createFixture(new Circle(0.3), { density: 1 })
  ground.window({ i0: -64, j0: -32, i1: 31, j1: 31 })
  assert.ok(!ball.isActive() && ground.undo())
  ground.window({ i0: -64, j0: -32, i1: 63, j1: 31 })
  const { x, y } = ball.getPosition()
  assert.ok(!ball.isActive() || ground.world.at(x, y).where === 'outside', `it is in the ground at ${x}, ${y}`)
  physics.destroyBody(ball)
  ground.free()
})

test('one chunk at once: a window comes in over several calls, and bodies wait for it', () => {
  const shelf = new Map(), moved = { in: 0, out: 0 }
  const { physics, ground } = withPlanck({
    land, chunksAtOnce: 1,
    shelf: { put: (i, j, bytes) => { ++moved.out; shelf.set(`${i},${j}`, bytes) }, get: (i, j) => { ++moved.in; return shelf.get(`${i},${j}`) } },
  })
  const at = (i) => ({ i0: i, j0: -30, i1: i + 60, j1: 20 }), bring = (cells) => {
    let calls = 1
    for (Object.assign(moved, { in: 0, out: 0 }); !ground.window(cells); ++calls) {
      assert.ok(moved.in + moved.out <= 2 * calls, `${moved.in} came and ${moved.out} left in ${calls} calls`)
      assert.ok(calls < 200)
    }
    return calls
  }
  assert.ok(bring(at(0)) > 6)
  const ball = physics.createBody({ type: 'dynamic', position: { x: 1.5, y: 9 } })
  ball.createFixture(new Circle(0.3), { density: 1 })
  steps(ground, 200)
  bring(at(200))
  assert.ok(!ball.isActive())
  ground.window(at(0))  // it does not come in at once
  const { y } = ball.getPosition()
  for (let k = 0; k < 60 && ground.world.at(1.5, 0.5).where === 'unloaded'; ++k) {
    steps(ground, 10)
    assert.deepEqual([ball.isActive(), ball.getPosition().y], [false, y])
    ground.window(at(0))
  }
  bring(at(0))
  assert.ok(ball.isActive())
  steps(ground, 60)
  assert.ok(Math.abs(ball.getPosition().y - y) < 0.1, 'it lies where it lay')
  physics.destroyBody(ball)
  ground.free()
})

test('at an edge of memory that is open falls what no anchor in memory holds', () => {
  const column = (i0, i1) => ({ i0, j0: -5, i1, j1: 20 })
  for (const [atEdge, count] of [['holds', 0], ['open', 1]]) {
    const ground = pillar(new Ground({ anchors, atEdge }))
    ground.edit((world) => {
      world.fill({ i0: -60, j0: 10, i1: 40, j1: 10 }, world.shape(unitSquare), 3)
      world.fill({ i0: 40, j0: 0, i1: 40, j1: 9 }, world.shape(unitSquare), bedrock)
    })
    assert.deepEqual(ground.rocks(), [])
    ground.window(column(0, 30))  // what holds it leaves
    assert.equal(ground.rocks().length, count)
    assert.ok(ground.undo())
    assert.deepEqual([ground.rocks().length, ground.world.at(5.5, 10.5).where], [0, 'outside'])
    ground.free()
  }
})
