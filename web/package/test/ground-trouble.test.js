// A Ground in trouble: functions of the game that throw or that change the ground while it changes,
// and bytes that are damaged. A call does all or nothing, and the next one works.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import fc from 'fast-check'
import { Circle, World as Physics } from 'planck'
import { Ground, init, LgsError, unitSquare } from 'localgridseg/islands'
import { Ground as PlanckGround } from 'localgridseg/planck'
import { allOf, anchors, bedrock, land, matterOf, pillar, refuses, square, steps, withPlanck } from './ground.js'

before(() => init())

const scale = Math.max(1, Number(process.env.LGS_TEST_SCALE ?? 0))

const cells = (i0, j0, i1 = i0, j1 = j0) => ({ i0, j0, i1, j1 })

// --- Functions that throw, or that change the ground while it changes

class Mine extends Error {}

/** What a game hands in. One of it throws, when it is asked the so and so manyth time, or tries each change of the ground. */
class Trouble {
  kind = null
  which = ''
  left = 0
  fired = null
  ground = null
  begin(kind, which = '', left = 0) { Object.assign(this, { kind, which, left, fired: null }) }
  in(name, f) {
    return (...told) => {
      if (this.kind !== null && this.which === name && this.left-- === 0) {
        this.fired = name
        if (this.kind === 'throw') throw new Mine(name)
        this.reenter()
      }
      return f(...told)
    }
  }
  reenter() {
    const { ground } = this
    for (const call of [() => ground.dig(0, 0, 1), () => ground.undo(), () => ground.redo(), () => ground.step(1), () => ground.window(cells(900, 0)), () => ground.save(),
      () => ground.load(new Uint8Array(9)), () => ground.forgetUndo(), () => ground.settle(ground.rocks()[0]?.body), () => ground.forget(ground.rocks()[0]?.body), () => ground.free()])
      refuses('busy', call)
  }
}

/** Hills that go on for ever, of few cells. */
const thin = (world, { i0, j0, i1, j1 }) => {
  const shape = world.shape(unitSquare)
  for (let i = i0; i <= i1; ++i)
    for (let j = Math.max(j0, -2); j <= Math.min(j1, 2 + Math.floor(3 * Math.sin(i / 5))); ++j) world.add(i, j, shape, j === -2 ? bedrock : 1)
}

/** A ground whose functions can make trouble, and how it is set up. */
function troubled({ withPlanck, withLand }) {
  const trouble = new Trouble(), shelf = new Map(), cancelled = new Set(), asked = trouble.in('preserve', (a, b) => a === 1 && b === 2)
  trouble.preserve = (a, b) => {
    if (cancelled.has(`${a} ${b}`)) return false
    try {
      return asked(a, b)
    } catch (error) {
      cancelled.add(`${a} ${b}`)
      throw error
    }
  }
  const options = {
    anchors,
    ...(withLand && { land: trouble.in('land', thin) }),
    preserve: trouble.preserve,
    follow: trouble.in('follow', () => {}),
    shelf: { put: trouble.in('put', (i, j, bytes) => void shelf.set(`${i} ${j}`, bytes)), get: trouble.in('get', (i, j) => shelf.get(`${i} ${j}`)) },
  }
  if (withPlanck) {
    const physics = new Physics({ gravity: { x: 0, y: -10 } })
    trouble.ground = new PlanckGround(physics, options, { material: trouble.in('material', () => ({})) }, { density: trouble.in('density', () => 1), material: trouble.in('shape', () => ({})) })
    for (const name of listeners)
      physics.on(name, trouble.in(name, () => {}))
  } else trouble.ground = new Ground(options)
  if (withLand) trouble.ground.window(cells(-32, -32, 31, 31))
  else pillar(trouble.ground)
  return trouble
}

const place = fc.record({ x: fc.double({ min: -3, max: 12, noNaN: true }), y: fc.double({ min: -0.5, max: 7, noNaN: true }), radius: fc.double({ min: 0.2, max: 1.6, noNaN: true }) })
const listeners = ['begin-contact', 'end-contact', 'pre-solve', 'post-solve', 'add-body', 'remove-body', 'add-fixture', 'remove-fixture']
const named = ({ withPlanck, withLand }) => ['follow', 'preserve', 'put', 'get', ...(withLand ? ['land', 'land'] : []), ...(withPlanck ? ['material', 'density', 'shape', ...listeners] : [])]

const call = fc.oneof(
  { weight: 6, arbitrary: place.map(({ x, y, radius }) => ['dig', x, y, radius]) },
  { weight: 3, arbitrary: place.map(({ x, y, radius }) => ['paint', x, y, radius, 1 + Math.floor(4 * radius)]) },
  { weight: 2, arbitrary: place.map(({ x, y }) => ['place', Math.floor(x), Math.floor(y), square, 2]) },
  { weight: 5, arbitrary: fc.constant(['undo']) },
  { weight: 4, arbitrary: fc.constant(['redo']) },
  { weight: 6, arbitrary: fc.constant(['step', 1 / 60]) },
  { weight: 1, arbitrary: fc.constant(['load']) },
  { weight: 1, arbitrary: fc.constant(['settle']) },
  { weight: 3, arbitrary: fc.constantFrom(-80, 0, 0, 80).map((i) => ['window', cells(i - 10, -2, i + 20, 20)]) })
const troubles = fc.array(fc.record({ call, kind: fc.constantFrom(null, 'throw', 'throw', 'reenter'), which: fc.nat(99), left: fc.constantFrom(0, 0, 1, 4) }), { minLength: 5, maxLength: 25 })

/** Makes a call; what it threw. */
function made({ ground }, [name, ...told]) {
  try {
    if (name === 'load') ground.load(ground.save())
    else if (name === 'settle') ground.rocks()[0]?.body && ground.settle(ground.rocks()[0].body)
    else ground[name](...told)
    return null
  } catch (error) {
    if (!(error instanceof Mine || error instanceof LgsError)) throw error
    return error
  }
}

/** The same game is played without trouble, and the grounds are the same after each call. */
function suffer(game, how, told) {
  const one = troubled(how), other = troubled(how)
  let window = how.withLand ? cells(-32, -32, 31, 31) : null
  const names = named(how)
  for (const { call, kind, which, left } of game) {
    one.begin(kind, names[which % names.length], left)
    let error = made(one, call)
    const thrown = one.fired
    one.begin(null)
    const isMine = error instanceof Mine || error?.cause instanceof Mine
    assert.equal(isMine, thrown !== null && kind === 'throw', error ? error.stack : `${thrown} threw, and nobody was told`)
    if (thrown !== null) told.add(`${kind} ${thrown}`)
    if (isMine && call[0] === 'load') error = made(one, call)  // it may have been the save that threw
    const wanted = made(other, call)
    if (!isMine) assert.equal(error?.code, wanted?.code)
    if (call[0] === 'step') for (let k = 0; k < 20; ++k) for (const each of [one, other]) each.ground.step(1 / 60)
    if (call[0] === 'window') window = call[1]
    if (window !== null) for (const each of [one, other]) each.ground.window(window)
    assert.deepEqual(allOf(one.ground, one), allOf(other.ground, other))
    assert.deepEqual([one.ground.canUndo, one.ground.canRedo], [other.ground.canUndo, other.ground.canRedo])
    const { ground: { world, terrain, islands, canRedo } } = one
    if (terrain) assert.ok(Array.from(world.segments().id).every((id) => terrain.segment(terrain.fixture(id)) === id))
    if (!canRedo) assert.ok(islands.all().every((id) => islands.island(id).anchors > 0), 'nothing hangs in the air')
  }
  for (const each of [one, other]) each.ground.free()
}

for (const [name, how, runs] of [['without physics', {}, 12], ['with planck', { withPlanck: true }, 15],
  ['over land', { withLand: true }, 12], ['over land with planck', { withLand: true, withPlanck: true }, 8]])
  test(`functions that throw or change the ground, ${name}: each call is done or refused, and the next one works`, (t) => {
    const told = new Set()
    // Few games may meet few kinds of trouble by chance; then there are more of them.
    for (let round = 0; round === 0 || (told.size < 4 && round < 20); ++round)
      fc.assert(fc.property(troubles, (game) => suffer(game, how, told)), { numRuns: runs * scale })
    t.diagnostic([...told].sort().join(', '))
    assert.ok(told.size >= 4)
  })

// --- Bytes

test('bytes that are damaged are refused before anything changes, or are a ground that lives', (t) => {
  const { ground: from } = withPlanck()
  pillar(from)
  from.dig({ rings: [[1, 3, 2, 3, 2, 4, 1, 4]] })
  from.place(9, 5, [0, 0, 1, 0, 0.5, 1], 3)
  steps(from, 5)
  const saved = from.save()
  from.free()
  const { physics, ground } = withPlanck()
  ground.load(saved)
  let [taken, refused] = [0, 0]
  const damage = fc.array(fc.record({ at: fc.nat(), by: fc.oneof(fc.integer({ min: 1, max: 255 }), fc.constantFrom(128, 127, 64, 1)) }), { minLength: 1, maxLength: 3 })
  fc.assert(fc.property(damage, (all) => {
    const bytes = saved.slice(), before = allOf(ground)
    for (const { at, by } of all) bytes[at % Math.min(bytes.length, 700)] ^= by
    try {
      ground.load(bytes)
      ++taken
    } catch (error) {
      assert.equal(error.code, 'not-a-snapshot', error.stack)
      ++refused
      assert.deepEqual(allOf(ground), before)
    }
    steps(ground, 3)
    assert.ok(ground.rocks().every(({ ground: { mass } }) => Number.isFinite(mass.area)))
    assert.ok(!physics.isLocked())
    ground.load(saved)
    assert.equal(ground.rocks().length, 2)
  }), { numRuns: 80 * scale })
  t.diagnostic(`${taken} were taken, ${refused} refused`)
  assert.ok(taken > 5 && refused > 20)
  ground.free()
})

// --- One by one

test('a stroke is no promise, and touches no chunk and no mark', () => {
  const ground = pillar(new Ground({ anchors })), before = allOf(ground), all = cells(-32, -32, 31, 31)
  refuses('bad-argument', () => ground.edit(async (world) => { world.clear(0, 3) }))
  for (const call of [(w) => w.unload(all), (w) => w.reloadEmpty(all), (w) => w.reload(new Uint8Array(9)), (w) => w.mark(), (w) => w.forget(1), () => ground.undo()])
    refuses('busy', () => ground.edit((world) => { world.clear(0, 3); call(world) }))
  refuses('busy', () => ground.islands.foresee(() => ground.free()))
  assert.deepEqual([allOf(ground), ground.canUndo], [before, false])
  ground.free()
})

test('without physics a rock settles where it fits, and nowhere else', () => {
  const ground = pillar(new Ground({ anchors }))
  ground.dig({ rings: [[1, 3, 2, 3, 2, 4, 1, 4]] })
  const [{ body }] = ground.rocks(), matter = matterOf(ground)
  for (const [y, angle] of [[-1, 0], [-0.5, 0], [-0.4, 0.3], [-0.1, 0]]) {
    Object.assign(body, { y, angle })
    assert.equal(ground.settle(body), false, `${y}`)
    assert.deepEqual([matterOf(ground), ground.rocks().length], [matter, 1])
  }
  Object.assign(body, { y: -0.001, angle: 0 })
  assert.ok(ground.settle(body))
  assert.ok(Math.abs(matterOf(ground) - matter) < 0.01)
  ground.free()
})

test('a rock that lies nowhere is not saved; one that is too thin for a body can not settle, and can be forgotten', () => {
  const { ground } = withPlanck({}, { cellSize: 0.5 })
  pillar(ground)
  ground.place(9, 4, [0, 0, 1, 0, 1, 1 / 4096], 1)
  assert.equal(ground.rocks()[0].body, null)
  refuses('bad-argument', () => ground.settle(null))
  ground.forget(null)
  assert.deepEqual(ground.rocks(), [])
  ground.free()
  const values = pillar(new Ground({ anchors }))
  values.dig(0.5, 2.5, 0.6)
  for (const name of ['x', 'angle', 'vx']) {
    const { body } = values.rocks()[0], was = body[name]
    body[name] = NaN
    refuses('bad-argument', () => values.save())
    body[name] = was
  }
  values.save()
  values.free()
})

test('bodies that the game destroys are no rocks; those that wait out of the window wait after a load, and not after free()', () => {
  const { physics, ground } = withPlanck()
  pillar(ground)
  ground.dig({ rings: [[1, 3, 2, 3, 2, 4, 1, 4]] })
  const saved = ground.save(), ball = physics.createBody({ type: 'dynamic', position: { x: 100, y: 5 } })
  ball.createFixture(new Circle(0.3))
  physics.destroyBody(ground.rocks()[0].body)
  assert.deepEqual(ground.rocks(), [])
  steps(ground, 2)
  assert.ok(ground.undo() && ground.redo())
  ground.load(saved)
  const [{ body }] = ground.rocks()
  body.setTransform({ x: 80, y: 5 }, 0)
  ground.window(cells(0, 0, 31, 31))
  for (let k = 0; k < 3; ++k) ground.load(ground.save())
  steps(ground, 2)
  assert.deepEqual([ground.rocks()[0].y, ground.rocks()[0].body.isActive(), ball.isActive()], [5, false, false])
  ground.free()
  assert.deepEqual([ball.isActive(), physics.getBodyCount()], [true, 1])
})

test('a load while the window is elsewhere: the land that the save has not is made with the next window()', () => {
  const ground = new Ground({ anchors, land })
  ground.window(cells(0, 0))
  const saved = ground.save()
  ground.window(cells(1000, 0))
  const there = ground.world.polygons().length
  ground.load(saved)
  assert.ok(ground.window(cells(1000, 0)))
  assert.ok(there > 0 && ground.world.polygons().length === there)
  ground.free()
})

test('land is made around what was placed before, in memory or not', () => {
  const full = (world, chunk) => void world.fill(chunk, world.shape(unitSquare), bedrock)
  for (const isAway of [false, true]) {
    const ground = new Ground({ anchors: { blocks: [bedrock, 3] }, land: (world, chunk) => { if (chunk.j0 === 0) full(world, chunk) } })
    ground.place(5, 2, [0, 0, 1, 0, 1, 1], 3)
    ground.forgetUndo()
    if (isAway) ground.window(cells(500, 500))
    assert.ok(ground.window(cells(0, 0)))
    assert.deepEqual(ground.world.polygonsAt(5, 2).map(({ block }) => block), [3])
    assert.equal(ground.world.polygonsAt(6, 2)[0].block, bedrock)
    ground.free()
  }
})

test('who can not be made leaves nothing in the physics world', () => {
  const physics = new Physics(), { _listeners } = physics
  for (const make of [() => new PlanckGround(physics, {}, { cellSize: -1 }), () => new PlanckGround(physics, {}, {}, { density: 7 })]) refuses('bad-argument', make)
  refuses('bad-argument', () => new PlanckGround({}, {}))
  assert.equal(physics.getBodyCount(), 0)
  assert.ok(Object.values(physics._listeners ?? _listeners ?? {}).every((all) => all.length === 0))
})

test('what a shelf does not take is kept until it does', () => {
  const shelf = new Map()
  let isFull = true
  const ground = pillar(new Ground({ anchors, shelf: {
    put: (i, j, bytes) => {
      if (isFull) throw new Mine('full')
      shelf.set(`${i} ${j}`, bytes)
    },
    get: (i, j) => shelf.get(`${i} ${j}`),
  } })), before = allOf(ground)
  for (let k = 0; k < 2; ++k) assert.throws(() => ground.window(cells(500, 0)), Mine)
  assert.deepEqual([allOf(ground), shelf.size], [before, 0])
  isFull = false
  assert.ok(ground.window(cells(500, 0)))
  assert.ok(shelf.size > 0)
  assert.deepEqual(allOf(ground), before)
  ground.free()
})
