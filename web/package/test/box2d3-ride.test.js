// The terrain for box2d3-wasm: bodies ride without kicks, also while it is edited.
import assert from 'node:assert/strict'
import { readFile } from 'node:fs/promises'
import { test } from 'node:test'
import { Box2dTerrain } from 'localgridseg/box2d3'
import { createWorld, unitSquare } from 'localgridseg'
import { parseTrace, TracePlayer } from 'localgridseg/trace'
import { b2, floorOf, kicks, makeBody, makePhysics, ride, vec } from './box2d3.js'

const riders = [
  ['ball', { ball: 0.4, x: 2, y: 1.4, speed: 3 }],
  ['box', { box: 0.4, x: 2, y: 1.4, speed: 3 }],
]

/** Each segment by itself: the control. */
function withoutGhosts(physics, world) {
  const ground = b2.b2CreateBody(physics, b2.b2DefaultBodyDef())
  const { id, geometry: g } = world.segments()
  id.forEach((_, k) => {
    const segment = new b2.b2Segment()
    segment.point1 = vec(g[8 * k], g[8 * k + 1])
    segment.point2 = vec(g[8 * k + 2], g[8 * k + 3])
    b2.b2CreateSegmentShape(ground, b2.b2DefaultShapeDef(), segment)
  })
}

for (const [name, rider] of riders) {
  test(`a frictionless ${name} on a floor of 200 cells: no kick with ghosts; without it is kicked or stuck`, () => {
    const world = floorOf(200)
    const [smooth, rough] = [(p) => new Box2dTerrain(b2, p, world), (p) => withoutGhosts(p, world)].map((lay) => {
      const physics = makePhysics()
      lay(physics)
      const path = ride(physics, makeBody(physics, rider), 3900)
      b2.b2DestroyWorld(physics)
      return path
    })
    assert.equal(kicks(smooth.slice(60)), 0)
    assert.ok(smooth.slice(60).every(([, , vx, vy]) => Math.abs(vx - 3) < 1e-3 && Math.abs(vy) < 1e-3), 'it goes on as it began')
    assert.ok(smooth.at(-1)[0] > 195)
    assert.ok(kicks(rough.slice(60)) >= 5, `${kicks(rough)} kicks`)
    assert.ok(rough.at(-1)[0] < 100, `without ghosts it comes to x = ${rough.at(-1)[0]}`)
    world.free()
  })
}

test('the ride goes on as before while the floor is dug and refilled before and behind', () => {
  const paths = [false, true].map((digs) => {
    const world = floorOf(100, 2), physics = makePhysics()
    const terrain = new Box2dTerrain(b2, physics, world)
    const square = world.shape(unitSquare)
    const ball = makeBody(physics, { ball: 0.4, x: 2, y: 2.4, speed: 3 })
    const path = ride(physics, ball, 1800, (step) => {
      if (!digs || step % 5 !== 0) return
      const i = Math.floor(b2.b2Body_GetPosition(ball).x)
      for (const [column, row] of [[i + 2, 1], [i - 2, 1], [i + 2, 0], [i, 0]]) {
        if (world.clear(column, row) === 0) world.fill({ i0: column, j0: row, i1: column, j1: row }, square, step % 3)
      }
      // Where the ball will be, there is floor.
      if (world.polygonsAt(i + 1, 1).length === 0) world.add(i + 1, 1, square, 1)
      terrain.sync(world.commit())
    })
    b2.b2DestroyWorld(physics)
    world.free()
    return path
  })
  assert.equal(kicks(paths[1].slice(60)), 0)
  assert.ok(paths[1].at(-1)[0] > 90)
  paths[1].forEach((sample, k) => sample.forEach((value, n) => assert.ok(Math.abs(value - paths[0][k][n]) < 1e-2, `step ${k}`)))
})

test('on docs/ride.trace a ball has the path that it has on one closed chain', async () => {
  const trace = parseTrace(await readFile(new URL('../../../docs/ride.trace', import.meta.url), 'utf8'))
  const world = createWorld()
  const player = new TracePlayer(world)
  for (const edit of trace.edits) player.apply(edit)
  world.commit()
  const closedChains = (physics) => {
    const ground = b2.b2CreateBody(physics, b2.b2DefaultBodyDef())
    for (const { vertices } of world.loops()) {
      const def = b2.b2DefaultChainDef()
      def.isLoop = true
      def.SetPoints(Array.from({ length: vertices.length / 2 }, (_, k) => vec(vertices[2 * k], vertices[2 * k + 1])))
      b2.b2CreateChain(ground, def)
    }
  }
  const [terrain, chains] = [(p) => new Box2dTerrain(b2, p, world, { material: () => ({ friction: 0 }) }), closedChains].map((lay) => {
    const physics = makePhysics()
    lay(physics)
    const path = ride(physics, makeBody(physics, { ball: 0.3, x: 1, y: 5.31, speed: 2 }), 600)
    b2.b2DestroyWorld(physics)
    return path
  })
  const apart = Math.max(...terrain.map(([x, y], k) => Math.hypot(x - chains[k][0], y - chains[k][1])))
  assert.ok(apart < 1e-3, `${apart} m apart`)
  assert.ok(terrain.at(-1)[0] > 12)
  world.free()
})

test('cells of half a metre, far from the origin of the world', () => {
  const far = 2 ** 29
  const world = createWorld()
  world.fill({ i0: far, j0: far, i1: far + 199, j1: far }, world.shape(unitSquare), 1)
  world.commit()
  const physics = makePhysics()
  const terrain = new Box2dTerrain(b2, physics, world, { cellSize: 0.5, origin: { i: far, j: far } })
  const path = ride(physics, makeBody(physics, { ball: 0.4, x: 1, y: 0.9, speed: 3 }), 1800)
  assert.equal(kicks(path.slice(60)), 0)
  assert.ok(Math.abs(path.at(-1)[0] - 91) < 0.01)
  assert.deepEqual(terrain.point(terrain.position(far + 3, far + 4)), { x: far + 3, y: far + 4 })
  b2.b2DestroyWorld(physics)
  world.free()
})
