// The terrain for planck: bodies ride without kicks, and it follows every edit.
import assert from 'node:assert/strict'
import { readFile } from 'node:fs/promises'
import { before, test } from 'node:test'
import { Box, Circle, World as Physics } from 'planck'
import { circle, createWorld, init, rectangle, unitSquare } from 'localgridseg'
import { PlanckTerrain } from 'localgridseg/planck'
import { parseTrace, TracePlayer } from 'localgridseg/trace'
import { ride, Surface } from './ride.js'

before(() => init())

const gravity = { x: 0, y: -10 }

function floor(length) {
  const world = createWorld()
  world.fill({ i0: 0, j0: 0, i1: length - 1, j1: 0 }, world.shape(unitSquare), 1)
  world.commit()
  return world
}

async function track() {
  const trace = parseTrace(await readFile(new URL('../../../docs/ride.trace', import.meta.url), 'utf8'))
  const world = createWorld()
  const player = new TracePlayer(world)
  for (const edit of trace.edits) player.apply(edit)
  world.commit()
  return world
}

function rideOver(world, shape, { x, y, speed, steps, upright = false, friction = 0, drive = 0, terrain = {} }) {
  const physics = new Physics({ gravity })
  new PlanckTerrain(physics, world, terrain)
  const body = physics.createBody({
    type: 'dynamic',
    position: { x, y },
    linearVelocity: { x: speed, y: 0 },
    fixedRotation: upright,
    allowSleep: false,
  })
  body.createFixture(shape, { density: 1, friction })
  return ride(physics, new Surface(world), body, { steps, drive })
}

const withAndWithout = [{ ghosts: true }, { ghosts: false }]

test('a ball on a floor of 200 cells: no kick with ghosts, many without', () => {
  const world = floor(200)
  const [smooth, rough] = withAndWithout.map((terrain) =>
    rideOver(world, new Circle(0.4), { x: 2, y: 1.4, speed: 3, steps: 3900, terrain }),
  )
  assert.equal(smooth.kicks, 0)
  assert.ok(
    smooth.path.every(([, , vx, vy]) => Math.abs(vx - 3) < 1e-6 && Math.abs(vy) < 0.2),
    'it goes on as it began',
  )
  assert.ok(smooth.path.at(-1)[0] > 195)
  assert.ok(rough.kicks >= 20, `${rough.kicks} kicks`)
  world.free()
})

// In planck boxes do not feel the seams even without ghosts: for them there is no control.
test('the ride of docs/ride.trace: balls of two sizes, and an upright box', async () => {
  const world = await track()
  for (const [shape, options] of [
    [new Circle(0.3), { x: 1, y: 5.31, speed: 2, steps: 600 }],
    [new Circle(0.35), { x: 1, y: 5.36, speed: 4, steps: 600 }],
    [new Box(0.35, 0.35), { x: 1, y: 5.37, speed: 4, steps: 600, upright: true }],
  ]) {
    const [smooth, rough] = withAndWithout.map((terrain) => rideOver(world, shape, { ...options, terrain }))
    assert.equal(smooth.kicks, 0)
    assert.ok(rough.kicks > 5 || shape.getType() !== 'circle', `${rough.kicks} kicks`)
  }
  world.free()
})

test('borders of chunks make no difference, nor does the origin', () => {
  const world = floor(60)
  const options = { x: 2, y: 1.4, speed: 3, steps: 1000 }
  const paths = [1, 5, 16, 64].map(
    (chunkCells) => rideOver(world, new Circle(0.4), { ...options, terrain: { chunkCells } }).path,
  )
  for (const path of paths)
    path.forEach((sample, k) => sample.forEach((value, n) => assert.ok(Math.abs(value - paths[0][k][n]) < 1e-9)))
  world.free()
})

// Each segment is one fixture with the segment's ends and ghosts, and there are no others.
function assertShows(terrain, physics, world) {
  const { id, geometry, block } = world.segments()
  let fixtures = 0
  for (let body = physics.getBodyList(); body; body = body.getNext()) {
    for (let fixture = body.getFixtureList(); fixture; fixture = fixture.getNext())
      if (terrain.segment(fixture) !== 0) ++fixtures
  }
  assert.equal(fixtures, id.length)
  for (let k = 0; k < id.length; ++k) {
    const fixture = terrain.fixture(id[k])
    const edge = fixture.getShape()
    const body = fixture.getBody()
    const places = [edge.m_vertex1, edge.m_vertex2, edge.m_vertex0, edge.m_vertex3].map((v) => body.getWorldPoint(v))
    assert.deepEqual(
      places.flatMap(({ x, y }) => [x, y]),
      [...geometry.subarray(8 * k, 8 * k + 8)],
    )
    assert.ok(edge.m_hasVertex0 && edge.m_hasVertex3)
    assert.equal(fixture.getFriction(), block[k] / 10)
  }
}

test('it follows commits and roll-backs, in place where only a ghost changes', () => {
  const world = floor(20)
  const physics = new Physics({ gravity })
  const terrain = new PlanckTerrain(physics, world, { chunkCells: 4, material: (block) => ({ friction: block / 10 }) })
  assertShows(terrain, physics, world)
  let random = 1
  const next = (n) => (random = (random * 48271) % 2147483647) % n
  const marks = []
  for (let k = 0; k < 60; ++k) {
    if (k % 10 === 0) marks.push(world.mark())
    const region = circle(next(20) + next(16) / 16, next(8) / 8, 0.3 + next(10) / 10)
    if (next(2) === 0) world.carve(region)
    else world.paint(region, 1 + next(3), 'replace')
    const changes = world.commit()
    const [relinked] = changes.relinked.id
    const kept = relinked === undefined ? null : terrain.fixture(relinked)
    terrain.sync(changes)
    if (kept !== null) assert.equal(terrain.fixture(relinked), kept)
    assertShows(terrain, physics, world)
  }
  while (marks.length > 0) {
    terrain.sync(world.rollBack(marks.pop()))
    assertShows(terrain, physics, world)
  }
  assert.equal(physics.getBodyCount(), 5, 'a body for each chunk of ground')
  terrain.destroy()
  assert.equal(physics.getBodyCount(), 0)
  world.free()
})

function sleeper(cells) {
  const world = floor(cells)
  const physics = new Physics({ gravity })
  const terrain = new PlanckTerrain(physics, world)
  const ball = physics.createBody({ type: 'dynamic', position: { x: 1.5, y: 1.3 } })
  ball.createFixture(new Circle(0.3), { density: 1, friction: 0.5 })
  for (let k = 0; k < 120; ++k) physics.step(1 / 60)
  assert.equal(ball.isAwake(), false)
  return { world, physics, terrain, ball }
}

test('a body that sleeps wakes up when the ground below it goes', () => {
  const { world, physics, terrain, ball } = sleeper(4)
  world.clear(1, 0)
  terrain.sync(world.commit())
  assert.equal(ball.isAwake(), true)
  for (let k = 0; k < 60; ++k) physics.step(1 / 60)
  assert.ok(ball.getPosition().y < 0)
  world.free()
})

test('it wakes up when its edge gets another ghost or an edge comes beside it, and sleeps on when ground far away goes', () => {
  const { world, terrain, ball } = sleeper(40)
  world.clear(30, 0)
  terrain.sync(world.commit())
  assert.equal(ball.isAwake(), false)
  world.clear(2, 0)
  const changes = world.commit()
  assert.equal(changes.relinked.length, 4)
  terrain.sync(changes)
  assert.equal(ball.isAwake(), true)
  ball.setAwake(false)
  world.paint(rectangle(1.86, 1.2, 1, 0, 0.04, 0.1), 1)
  terrain.sync(world.commit())
  assert.equal(ball.isAwake(), true)
  world.free()
})

test('edges are one-sided: a body inside the ground falls out of it, and one on a thin roof is carried', () => {
  const world = floor(8)
  world.paint(rectangle(4, 3, 1, 0, 3, 0.005), 1)
  world.commit()
  const physics = new Physics({ gravity })
  new PlanckTerrain(physics, world)
  const bodies = [
    [2, 0.5],
    [6, 3.3],
  ].map(([x, y]) => physics.createBody({ type: 'dynamic', position: { x, y } }))
  for (const body of bodies) body.createFixture(new Circle(0.3), { density: 1 })
  for (let k = 0; k < 120; ++k) physics.step(1 / 60)
  assert.ok(bodies[0].getPosition().y < -1)
  assert.ok(Math.abs(bodies[1].getPosition().y - 3.3) < 0.02)
  world.free()
})

test('ghosts can be switched off and on, for a comparison', () => {
  const world = floor(4)
  const physics = new Physics({ gravity })
  const terrain = new PlanckTerrain(physics, world, { ghosts: false, material: (block) => ({ friction: block / 10 }) })
  for (const id of world.segments().id) assert.ok(!terrain.fixture(id).getShape().m_hasVertex0)
  terrain.ghosts = true
  assertShows(terrain, physics, world)
  world.free()
})

test('material() may use the package, and make its memory grow', () => {
  const world = createWorld()
  const square = world.shape(unitSquare)
  for (let k = 0; k < 8; ++k) world.add(2 * k, 0, square, k)
  world.commit()
  const material = () => {
    const other = createWorld()
    other.fill({ i0: 0, j0: 0, i1: 199, j1: 199 }, other.shape([0.25, 0.25, 0.75, 0.25, 0.5, 0.75]), 1)
    other.commit()
    return {}
  }
  const terrain = new PlanckTerrain(new Physics(gravity), world, { material })
  for (let segment = 1; segment <= world.maxSegmentId; ++segment) assert.ok(terrain.fixture(segment))
})

test('a listener that throws while the terrain changes: all of it changes, and then its error comes', () => {
  const world = floor(12), physics = new Physics({ gravity }), terrain = new PlanckTerrain(physics, world)
  const ball = physics.createBody({ type: 'dynamic', position: { x: 4.5, y: 1.4 } })
  ball.createFixture(new Circle(0.4), { density: 1 })
  for (let k = 0; k < 20; ++k) physics.step(1 / 60)
  for (const name of ['end-contact', 'remove-fixture', 'add-fixture', 'remove-body']) {
    const listener = () => { throw new Error(name) }
    physics.on(name, listener)
    const cells = name === 'remove-body' ? [0, 0, 11, 0] : [4, 0, 4, 0]
    world.clear({ i0: cells[0], j0: 0, i1: cells[2], j1: 0 })
    assert.throws(() => terrain.commit(), { message: name })
    physics.off(name, listener)
    const isThere = () => assert.ok(Array.from(world.segments().id).every((id) => terrain.segment(terrain.fixture(id)) === id))
    isThere()
    world.fill({ i0: cells[0], j0: 0, i1: cells[2], j1: 0 }, world.shape(unitSquare), 1)
    terrain.commit()
    isThere()
    ball.setTransform({ x: 4.5, y: 1.4 }, 0)
    ball.setAwake(true)
    for (let k = 0; k < 20; ++k) physics.step(1 / 60)
  }
  physics.on('end-contact', () => { throw new Error('at the end') })
  assert.throws(() => terrain.destroy(), { message: 'at the end' })
  assert.equal(physics.getBodyCount(), 1)
  assert.throws(() => new PlanckTerrain(physics, world, { material: () => { throw new Error('no material') } }), { message: 'no material' })
  assert.equal(physics.getBodyCount(), 1)
  world.free()
})

test('what a material does while a terrain asks for it: nothing to this terrain, and a world that it frees is freed', () => {
  for (const [act, code] of [['free', 'freed'], ['destroy', 'busy'], ['resync', 'busy']]) {
    const world = floor(4), other = floor(4), physics = new Physics({ gravity })
    let isAsked = false
    const terrain = new PlanckTerrain(physics, world, { material: (block) => {
      if (block !== 7) return {}
      isAsked = true
      act === 'free' ? world.free() : act === 'destroy' ? terrain.destroy() : terrain.resync(other)
      return {}
    } })
    const ball = physics.createBody({ type: 'dynamic', position: { x: 1.5, y: 0.5 } })
    ball.createFixture(new Circle(0.2))
    world.clear(1, 0)
    world.add(1, 0, world.shape(unitSquare), 7)
    const changes = world.commit()
    assert.throws(() => terrain.overlapsWith(changes), (error) => error.code === code)
    assert.ok(isAsked)
    other.free()
    world.free()
  }
})
