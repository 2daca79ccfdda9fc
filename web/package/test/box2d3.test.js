// The terrain for box2d3-wasm: it follows every edit, wakes bodies, and knows what was hit.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { Box2dTerrain } from 'localgridseg/box2d3'
import { circle, createWorld, unitSquare } from 'localgridseg'
import { b2, floorOf, makeBody, makePhysics, ride, vec } from './box2d3.js'

/** The edge of each segment in metres, ghost1, start, end, ghost2; and its friction. */
function edgesOf(terrain, world) {
  const edges = new Map()
  for (const id of [...world.segments().id]) {
    const shape = terrain.shape(id)
    if (shape === null) continue
    assert.equal(terrain.segment(shape), id)
    const { ghost1, segment, ghost2 } = b2.b2Shape_GetChainSegment(shape)
    const { x, y } = b2.b2Body_GetPosition(b2.b2Shape_GetBody(shape))
    const points = [ghost1, segment.point1, segment.point2, ghost2].flatMap((p) => [p.x + x, p.y + y])
    edges.set(id, [...points, b2.b2Shape_GetFriction(shape)])
  }
  return edges
}

function assertShows(terrain, world, options) {
  const physics = makePhysics()
  const edges = edgesOf(terrain, world)
  assert.deepEqual(edges, edgesOf(new Box2dTerrain(b2, physics, world, options), world))
  b2.b2DestroyWorld(physics)
  return edges
}

const material = (block) => ({ friction: block / 4 })

test('it follows commits and roll-backs: edges and ghosts are those of the world', () => {
  const world = floorOf(20), physics = makePhysics(), options = { chunkCells: 4, material }
  const terrain = new Box2dTerrain(b2, physics, world, options)
  let random = 1
  const next = (n) => (random = (random * 48271) % 2147483647) % n
  const marks = []
  for (let k = 0; k < 60; ++k) {
    if (k % 10 === 0) marks.push(world.mark())
    const region = circle(next(20) + next(16) / 16, next(8) / 8, 0.3 + next(10) / 10)
    if (next(2) === 0) world.carve(region)
    else world.paint(region, 1 + next(3), 'replace')
    terrain.sync(world.commit())
    const edges = assertShows(terrain, world, options)
    const { id, geometry: g, block } = world.segments()
    id.forEach((segment, at) => {
      const edge = edges.get(segment)
      if (edge === undefined) return
      assert.equal(edge[8], block[at] / 4)
      const [x0, y0, x1, y1, gx1, gy1, gx2, gy2] = g.subarray(8 * at)
      // Where a ghost is too near, another one takes its place.
      const expected = [gx1, gy1, x0, y0, x1, y1, gx2, gy2]
      if (Math.hypot(gx1 - x0, gy1 - y0) < 0.0055) expected.splice(0, 2, edge[0], edge[1])
      if (Math.hypot(gx2 - x1, gy2 - y1) < 0.0055) expected.splice(6, 2, edge[6], edge[7])
      expected.forEach((value, n) => assert.ok(Math.abs(edge[n] - value) < 1e-5))
    })
  }
  while (marks.length > 0) {
    terrain.sync(world.rollBack(marks.pop()))
    assertShows(terrain, world, options)
  }
  b2.b2DestroyWorld(physics)
  world.free()
})

test('segments shorter than the slop are left out, and ghosts are beyond them', () => {
  const world = createWorld(), physics = makePhysics()
  const tiny = 0.003
  world.addPolygon(0, 0, [0, 0, 1, 0, 1, 1 - tiny, 1 - tiny, 1, 0, 1], 1)
  world.commit()
  const terrain = new Box2dTerrain(b2, physics, world)
  const edges = assertShows(terrain, world)
  assert.equal(edges.size, 4)
  const top = [...edges.values()].find(([, , , , x, y]) => x === 0 && y === 1)
  assert.deepEqual(top.slice(0, 2), [1, 0], 'the ghost of the top is the lower end of the right side')
  // A change beyond the gap reaches the edge before it.
  const square = world.shape(unitSquare)
  for (const [i, j] of [[1, -1], [1, 0], [0, 1], [-1, 0], [0, -1]]) {
    const polygon = world.add(i, j, square, 1)
    terrain.sync(world.commit())
    assertShows(terrain, world)
    world.remove(polygon)
    terrain.sync(world.commit())
    assertShows(terrain, world)
  }
  b2.b2DestroyWorld(physics)
  world.free()
})

test('under a preserve relation edges end where no other goes on: their ghosts are straight ahead', () => {
  const world = createWorld({ preserve: () => true }), physics = makePhysics()
  const square = world.shape(unitSquare)
  world.add(0, 0, square, 1)
  world.add(1, 0, square, 2)
  world.commit()
  const edges = assertShows(new Box2dTerrain(b2, physics, world), world)
  assert.equal(edges.size, world.stats().segments)
  for (const edge of edges.values()) assert.ok(edge.every(Number.isFinite))
  b2.b2DestroyWorld(physics)
  world.free()
})

test('a body that sleeps wakes up when the ground below it goes, or appears at it', () => {
  const world = floorOf(4), physics = makePhysics()
  const terrain = new Box2dTerrain(b2, physics, world)
  const ball = makeBody(physics, { ball: 0.6, x: 1.5, y: 1.6, friction: 0.5, sleeps: true })
  const fallsAsleep = () => {
    ride(physics, ball, 240)
    assert.equal(b2.b2Body_IsAwake(ball), false)
  }
  fallsAsleep()
  const above = world.add(1, 2, world.shape(unitSquare), 1) // no edge that the ball touched changes
  terrain.sync(world.commit())
  assert.equal(b2.b2Body_IsAwake(ball), true)
  world.remove(above)
  terrain.sync(world.commit())
  fallsAsleep()
  world.clear({ i0: 0, j0: 0, i1: 2, j1: 0 })
  terrain.sync(world.commit())
  assert.equal(b2.b2Body_IsAwake(ball), true)
  assert.ok(ride(physics, ball, 60).at(-1)[1] < 0)
  b2.b2DestroyWorld(physics)
  world.free()
})

test('which tile was hit where short segments are welded: the one at the point', () => {
  const cellSize = 0.004, world = floorOf(6), physics = makePhysics()
  world.add(2, 1, world.shape(unitSquare), 1)
  world.commit()
  const terrain = new Box2dTerrain(b2, physics, world, { cellSize, origin: { i: -3, j: 5 } })
  const segments = [...world.segments()], middle = ({ start, end }) => terrain.position((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
  const shapes = segments.map(({ id }) => terrain.shape(id))
  assert.ok(new Set(shapes.map((shape) => terrain.segment(shape))).size < segments.length, 'some are welded')
  segments.forEach((segment, k) => {
    assert.equal(terrain.segment(shapes[k], middle(segment)), segment.id)
    const { i, j } = terrain.hit(shapes[k], middle(segment))
    assert.deepEqual([i, j], [segment.i, segment.j])
  })
  // Between a commit and its sync shapes may be of segments that are no more.
  world.clear({ i0: 0, j0: 0, i1: 5, j1: 1 })
  const changes = world.commit()
  segments.forEach((segment, k) => {
    assert.equal(terrain.segment(shapes[k], middle(segment)), 0)
    assert.equal(terrain.hit(shapes[k], middle(segment)), null)
  })
  terrain.sync(changes)
  b2.b2DestroyWorld(physics)
  world.free()
})

test('a body that is new is noted when a chunk of the terrain goes at the same time', () => {
  const world = createWorld(), physics = makePhysics()
  world.fill({ i0: 0, j0: 0, i1: 3, j1: 0 }, world.shape(unitSquare), 1)
  world.add(40, 0, world.shape(unitSquare), 1)
  world.commit()
  const terrain = new Box2dTerrain(b2, physics, world)
  terrain.beforeStep()
  b2.b2World_Step(physics, 1 / 60, 4)
  terrain.afterStep()
  const ball = makeBody(physics, { x: 1.5, y: 1.4, ball: 0.4 })
  world.clear(40, 0)
  terrain.commit()
  terrain.beforeStep()
  b2.b2Body_SetTransform(ball, vec(1.5, 0.5), b2.b2MakeRot(0))
  b2.b2World_Step(physics, 1 / 60, 4)
  assert.equal(terrain.afterStep().length, 1)
  terrain.destroy()
  b2.b2DestroyWorld(physics)
  world.free()
})
