// Islands, against a flood fill.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import fc from 'fast-check'
import { OutlineLines } from 'localgridseg/draw'
import { circle, convexParts, createWorld, init, Islands, loadWorld, massOf, unitSquare } from 'localgridseg/islands'
import { Pieces } from 'localgridseg/pieces'
import { areaOf, assertIsFlood, bedrock, isHeld } from './flood.js'

before(() => init())

const quarter = (vertices) => vertices.map((v) => v / 4)
const shapes = [
  [0, 0, 4, 0, 4, 4, 0, 4], [0, 0, 4, 0, 4, 4], [0, 0, 4, 4, 0, 4], [1, 1, 3, 1, 3, 3, 1, 3], [0, 0, 4, 0, 4, 1, 0, 1],
  [2, 0, 4, 2, 2, 4, 0, 2], [0, 0, 1, 0, 1, 4, 0, 4],
]

const edit = fc.record({ i: fc.nat(5), j: fc.nat(5), shape: fc.nat(shapes.length), block: fc.constantFrom(1, 1, 1, 1, 1, 2, bedrock) })
const commits = fc.array(fc.array(edit, { minLength: 1, maxLength: 12 }), { minLength: 1, maxLength: 12 })

for (const preserve of [undefined, (a, b) => a !== b])
  test(`random worlds${preserve ? ' under a relation' : ''}: islands are those of a flood fill, and what is loose is named`, () => {
    fc.assert(fc.property(commits, fc.nat(), (steps, which) => {
      const world = createWorld({ preserve })
      const ids = shapes.map((shape) => world.shape(quarter(shape)))
      for (let i = 0; i < 6; ++i) for (let j = 0; j < 6; ++j) world.add(i, j, ids[0], j === 0 && i === 2 ? bedrock : 1)
      world.commit()
      const islands = new Islands(world, { blocks: [bedrock] })
      let held = new Set(world.polygons().map(({ id }) => id))
      for (const step of steps) {
        const make = () => {
          for (const { i, j, shape, block } of step) shape === shapes.length ? world.clear(i, j) : world.replace(i, j, ids[shape], block)
        }
        const foreseen = foresee(islands, world, make)
        make()
        islands.update(world.commit())
        assertIsAsForeseen(islands, foreseen)
        const byId = assertIsFlood(islands, world), loose = islands.loose()
        for (const id of loose) assert.ok(!isHeld(byId.get(id)))
        for (const [id, part] of byId)
          if (!isHeld(part) && part.some((polygon) => held.has(polygon.id))) assert.ok(loose.includes(id), `${id} was held, and nobody says that it is loose`)
        const { changed, added, removed, cutOff, joined } = islands.changes
        for (const id of [...added, ...changed, ...cutOff.map(({ into }) => into)]) assert.ok(byId.has(id))
        for (const id of [...removed, ...joined.map(({ from }) => from)]) assert.equal(islands.island(id) !== null, byId.has(id))
        held = new Set([...byId.values()].filter(isHeld).flat().map(({ id }) => id))
      }
      takeAndPut(islands, world, which)
      islands.free()
      world.free()
    }), { numRuns: 60 })
  })

const told = (world) => world.polygons().map(({ i, j, block, vertices }) => [i, j, block, ...vertices].join()).sort()

/** What an edit would do; and the world and its islands are as before. */
function foresee(islands, world, edit) {
  const was = told(world), { version } = world, segments = [...world.segments().id]
  const foreseen = islands.foresee((given) => {
    assert.equal(given, world)
    edit()
  })
  assert.deepEqual(told(world), was)
  assert.equal(world.version, version)
  assert.deepEqual([...world.segments().id], segments)
  assertIsFlood(islands, world)
  assert.deepEqual(islands.loose(), [])
  return foreseen
}

/** Ids may be others, all else is the same. */
function assertIsAsForeseen(islands, { changes, after }) {
  const now = islands.changes
  for (const list of Object.keys(now)) assert.equal(changes[list].length, now[list].length, list)
  const ids = new Set([...now.added, ...now.changed, ...now.cutOff.flatMap(({ from, into }) => [from, into]), ...now.joined.map(({ into }) => into)])
  const facts = (all) => all.map(({ area, x0, y0, x1, y1, segments, anchors }) => [area, x0, y0, x1, y1, segments, anchors].join()).sort()
  assert.deepEqual(facts(after), facts([...ids].map((id) => islands.island(id)).filter(Boolean)))
}

function takeAndPut(islands, world, which) {
  const all = islands.all()
  if (all.length === 0) return
  const id = all[which % all.length], part = world.polygons().filter((polygon) => islands.of(polygon.id) === id)
  const was = told(world), body = islands.take(id)
  assert.equal(body.polygons.length, part.length)
  const { area, x, y } = body.mass
  assert.ok(Math.abs(area - part.reduce((sum, p) => sum + areaOf(p), 0)) < 1e-12)
  assert.deepEqual(massOf(body.polygons), body.mass)
  const parts = convexParts(body)
  assert.ok(Math.abs(parts.reduce((sum, { vertices }) => sum + areaOf({ i: 0, j: 0, vertices }), 0) - area) < 1e-9)
  const sum = [0, 0]
  for (const { vertices: v } of parts)
    for (let k = 2; k < v.length - 2; k += 2) {
      const weight = ((v[k] - v[0]) * (v[k + 3] - v[1]) - (v[k + 1] - v[1]) * (v[k + 2] - v[0])) / 2
      sum[0] += weight * (v[0] + v[k] + v[k + 2]) / 3
      sum[1] += weight * (v[1] + v[k + 1] + v[k + 3]) / 3
    }
  assert.ok(Math.abs(sum[0] / area - x) < 1e-9 && Math.abs(sum[1] / area - y) < 1e-9, 'the centroid')
  islands.update(world.commit())
  assertIsFlood(islands, world)
  assert.equal(islands.island(id), null)
  islands.put(JSON.parse(JSON.stringify(body, (_, v) => (ArrayBuffer.isView(v) ? [...v] : v))))
  islands.update(world.commit())
  assert.deepEqual(told(world), was)
  const bodies = islands.takeApart(islands.of(world.polygons().find((p) => p.i === part[0].i && p.j === part[0].j).id))
  assert.equal(bodies.reduce((sum, { polygons }) => sum + polygons.length, 0), part.length)
  for (const one of bodies) {
    assert.deepEqual(massOf(one.polygons), one.mass)
    islands.put(one)
  }
  islands.update(world.commit())
  assert.deepEqual(told(world), was)
}

/** A floor of bedrock, a pillar and an arm: block 1. */
function arm() {
  const world = createWorld(), square = world.shape(unitSquare)
  world.fill({ i0: -10, j0: -1, i1: 20, j1: -1 }, square, bedrock)
  world.fill({ i0: 0, j0: 0, i1: 0, j1: 3 }, square, 1)
  world.fill({ i0: 1, j0: 3, i1: 4, j1: 3 }, square, 1)
  world.commit()
  return world
}
const code = (wanted) => (error) => error.code === wanted || assert.fail(`${error.code}: ${error.message}`)

test('a bridge is cut: the arm is named, taken, and comes back by undo', () => {
  const world = arm(), islands = new Islands(world, { cells: [{ i0: -100, j0: -1, i1: 100, j1: -1 }] })
  assert.equal(islands.island(islands.all()[0]).anchors, 31)
  assert.deepEqual(islands.loose(), [])
  const mark = world.mark()
  world.clear(1, 3)
  islands.update(world.commit())
  const [cut] = islands.changes.cutOff
  assert.deepEqual(islands.loose(), [cut.into])
  const { area, x0, y0, x1, y1, anchors, segments } = islands.island(cut.into)
  assert.deepEqual({ area, x0, y0, x1, y1, anchors, segments }, { area: 3, x0: 2, y0: 3, x1: 5, y1: 4, anchors: 0, segments: 8 })
  const body = islands.take(cut.into)
  assert.deepEqual({ ...body, polygons: body.polygons.length }, { i: 2, j: 3, polygons: 3, mass: { area: 3, x: 1.5, y: 0.5, secondMoment: 2.5 } })
  islands.update(world.commit())
  assert.equal(islands.all().length, 1)
  islands.putAsItLies(body, { x: 6, y: 0, angle: Math.PI / 2 })
  islands.update(world.commit())
  assert.deepEqual([world.at(5.5, 2.5).where, world.at(6.5, 0.5).where], ['inside', 'outside'])
  assert.equal(islands.all().length, 1, 'it stands on the floor')
  islands.update(world.rollBack(mark))
  assert.equal(islands.island(islands.all()[0]).area, 39)
  islands.free()
  islands.free()
  assert.throws(() => islands.all(), code('freed'))
  world.free()
})

test('what touches with corners only is one island, and two bodies if it is taken apart', () => {
  const world = createWorld(), square = world.shape(unitSquare)
  for (const [i, j] of [[1, 2], [2, 2], [0, 1], [0, 0], [1, 0]]) world.add(i, j, square, 1)
  world.commit()
  const islands = new Islands(world)
  assert.equal(islands.all().length, 1)
  const bodies = islands.takeApart(islands.all()[0])
  assert.deepEqual(bodies.map(({ i, j, polygons, mass }) => [i, j, polygons.length, mass.area]), [[0, 0, 3, 3], [1, 2, 2, 2]])
  islands.update(world.commit())
  assert.deepEqual(islands.all(), [])
  assert.throws(() => islands.takeApart(1), code('stale-handle'))
  islands.free()
  world.free()
})

test('what an edit would cut off is known before it, and nobody else hears of it', () => {
  const world = arm(), islands = new Islands(world, { blocks: [bedrock] }), pieces = new Pieces(world), late = new Islands(world)
  const outline = new OutlineLines(world)
  world.clear(4, 3)
  const changes = world.commit()
  islands.update(changes)
  pieces.update(changes)
  outline.update(changes)
  const { changes: { cutOff, changed }, after } = islands.foresee(() => world.clear(1, 3))
  assert.deepEqual([cutOff.length, changed.length, after.length], [1, 1, 2])
  const [{ area, anchors, x0 }] = after.filter(({ id }) => id === cutOff[0].into)
  assert.deepEqual([area, anchors, x0], [2, 0, 2])
  assert.deepEqual(islands.loose(), [])
  assert.equal(pieces.solidPieces(1, 3).length, 1, 'pieces are still those of now')
  assert.throws(() => late.update(changes), code('left-out'), 'what it missed is gone')
  assert.throws(() => islands.foresee(() => { world.clear(1, 3); world.remove(-1) }), code('stale-handle'))
  assert.deepEqual(islands.foresee(() => {}), { changes: { added: [], removed: [], changed: [], cutOff: [], joined: [] }, after: [] })
  assert.equal(islands.island(islands.all()[0]).area, 31 + 4 + 3)
  world.clear(1, 3)
  assert.throws(() => islands.foresee(() => {}), code('uncommitted'))
  const real = world.commit()
  islands.update(real)
  assert.deepEqual(pieces.update(real), [{ i: 1, j: 3 }])
  assert.equal(outline.update(real).length, 1)
  assert.equal(islands.loose().length, 1)

  for (const foul of [
    () => { world.clear(2, 3); world.commit() },
    () => { world.clear(2, 3); world.commit(); world.clear(3, 3) },
    (mark) => world.rollBack(mark),
  ]) {
    const fresh = new Islands(world), mark = world.mark(), was = told(world)
    assert.throws(() => fresh.foresee(() => foul(mark)), code('left-out'))
    assert.deepEqual(told(world), was)
    assert.throws(() => fresh.take(fresh.all()[0]), code('left-out'))
    assert.throws(() => pieces.solidPieces(0, 0), code('left-out'))
    world.forget(mark)
    fresh.free()
  }
  const other = arm(), gone = new Islands(other)
  assert.throws(() => gone.foresee(() => gone.free()), code('busy'))
  assert.throws(() => gone.foresee(() => gone.foresee(() => other.clear(1, 3))), code('busy'))
  assert.equal(other.polygons().length, 39)
  assert.throws(() => gone.foresee(() => other.free()), code('freed'))
  gone.free()
  for (const each of [islands, pieces, late, world]) each.free()
  assert.throws(() => islands.foresee(() => {}), code('freed'))
})

test('what is refused, and has changed nothing', () => {
  const world = arm()
  world.clear(4, 3)
  assert.throws(() => new Islands(world), code('uncommitted'))
  world.commit()
  const mark = world.mark()
  assert.throws(() => new Islands(world), code('uncommitted'))
  world.forget(mark)
  const islands = new Islands(world, { blocks: [bedrock] })
  world.clear(1, 3)
  const { before, after } = world.commit()
  world.clear(2, 3)
  assert.throws(() => islands.update({ before, after }), code('uncommitted'))
  const last = world.commit()
  assert.throws(() => islands.update({ before, after }), code('not-the-last'))
  assert.throws(() => islands.update(last), code('left-out'))
  assert.throws(() => islands.take(islands.all()[0]), code('left-out'))
  assert.equal(islands.island(islands.all()[0]).area, 31 + 4 + 3, 'as it was')
  islands.free()

  const anew = new Islands(world, { blocks: [bedrock] })
  assert.equal(anew.all().length, 2)
  assert.throws(() => anew.take(7), code('stale-handle'))
  assert.throws(() => world.add(0, -1, world.shape(unitSquare), 1), code('overlap'))
  anew.update(world.commit())
  const polygon = world.add(9, 9, world.shape(unitSquare), 1)
  assert.throws(() => anew.of(polygon), code('uncommitted'))
  const body = anew.take(anew.all()[1])
  assert.throws(() => anew.put(body, 0, 0), code('overlap'))
  anew.put(body)
  const inEdits = world.mark()
  anew.update(world.commit())
  assert.equal(anew.all().length, 3)
  const back = world.rollBack(inEdits)
  assert.throws(() => anew.update(back), code('uncommitted'))
  const told = world.commit()
  assert.throws(() => anew.update(told), code('left-out'))
  anew.free()
  world.free()
  assert.throws(() => new Islands(world), code('freed'))
})

test('after every kind of edit, and until its commit, islands and pieces of now are refused', () => {
  const region = { rings: [[0.5, 2, 3, 2, 3, 3.5, 0.5, 3.5]] }
  const top = (world) => world.polygonsAt(4, 3)[0].id
  const edits = [
    (world) => world.add(9, 9, world.shape(unitSquare), 1),
    (world) => world.addMany(Int32Array.of(9, 9, world.shape(unitSquare), 1)),
    (world) => world.addPolygon(9, 9, unitSquare, 1),
    (world) => world.replace(4, 3, world.shape(unitSquare), 1),
    (world) => world.setBlock(top(world), 2),
    (world) => world.fill({ i0: 9, j0: 9, i1: 10, j1: 9 }, world.shape(unitSquare), 1),
    (world) => world.remove(top(world)),
    (world) => world.removeMany([top(world)]),
    (world) => world.clear(4, 3),
    (world) => world.paint(region, 1),
    (world) => world.carve(region),
    (_, islands, body) => islands.put(body, 9, 9),
    (_, islands, body) => islands.putAsItLies(body, { x: 9, y: 9, angle: 1 }),
    (_, islands) => islands.take(islands.all()[0]),
    (_, islands) => islands.takeApart(islands.all()[0]),
    (world) => world.unload({ i0: 32, j0: 0, i1: 63, j1: 31 }),
  ]
  for (const edit of edits) {
    const world = arm(), far = world.add(40, 3, world.shape(unitSquare), 1), rock = world.polygonsAt(0, -1)[0].id
    world.commit()
    const islands = new Islands(world), pieces = new Pieces(world)
    const commit = () => {
      const changes = world.commit()
      for (const each of [islands, pieces]) each.update(changes)
    }
    const body = islands.take(islands.of(far))
    commit()
    islands.put(body)
    commit()
    assert.equal(islands.of(rock), islands.all()[0])
    assert.equal(pieces.solidPieces(40, 3).length, 1)
    edit(world, islands, body)
    assert.throws(() => islands.of(rock), code('uncommitted'), String(edit))
    assert.throws(() => pieces.solidPieces(0, 0), code('uncommitted'), String(edit))
    for (const each of [islands, pieces, world]) each.free()
  }
})

test('a rectangle of anchors holds what is in it, to its corners, and nothing beside it', () => {
  const world = createWorld(), square = world.shape(unitSquare), rect = { i0: -6, j0: 2, i1: 8, j1: 11 }
  const inside = [[-6, 2], [8, 2], [8, 11], [-6, 11], [1, 5]]
  const outside = [[-7, 5], [9, 5], [1, 1], [1, 12], [-6, -6], [2, -6], [11, 8], [3, 13]]
  for (const [i, j] of [...inside, ...outside]) world.add(i, j, world.shape([0.25, 0.25, 0.75, 0.25, 0.5, 0.75]), 1)
  world.add(30, 30, square, bedrock)
  world.commit()
  const islands = new Islands(world, { blocks: [3, bedrock], cells: [{ i0: 40, j0: 50, i1: 41, j1: 51 }, rect] })
  const anchors = (i, j) => islands.island(islands.of(world.polygonsAt(i, j)[0].id)).anchors
  assert.deepEqual(inside.map((cell) => anchors(...cell)), inside.map(() => 1))
  assert.deepEqual(outside.map((cell) => anchors(...cell)), outside.map(() => 0))
  assert.equal(anchors(30, 30), 1)
  for (const each of [islands, world]) each.free()
})

test('a change of blocks alone is followed; the same changes twice are nothing', () => {
  const world = arm(), islands = new Islands(world, { blocks: [bedrock] })
  for (let i = -10; i <= 20; ++i) world.setBlock(world.polygonsAt(i, -1)[0].id, i === 5 ? bedrock : 2)
  const changes = world.commit()
  islands.update(changes)
  islands.update(changes)
  assert.equal(islands.island(islands.all()[0]).anchors, 1)
  assert.deepEqual(islands.loose(), [], 'nothing is new')
  world.setBlock(world.polygonsAt(5, -1)[0].id, 2)
  islands.update(world.commit())
  assert.deepEqual(islands.loose(), islands.all(), 'it lost its anchor')
  world.commit()
  islands.update(world.commit())
  assert.deepEqual(islands.loose(), [])
  world.free()
  assert.throws(() => islands.all(), code('freed'))
  islands.free()
})

test('a world that was loaded has islands, too', () => {
  const world = arm(), loaded = loadWorld(world.save()), islands = new Islands(loaded, { blocks: [bedrock] })
  loaded.carve(circle(1.5, 3.5, 0.9))
  islands.update(loaded.commit())
  assert.equal(islands.loose().length, 1)
  islands[Symbol.dispose]()
  for (const each of [world, loaded]) each.free()
})
