// Every method of a world, with answers worked out by hand.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import { LgsError, circle, createWorld, init, loadWorld, rectangle, thickLine, unitSquare } from 'localgridseg'

before(() => init())

const ramp = [0, 0, 1, 0, 1, 1]
const fails = (code, f, where = {}) =>
  assert.throws(f, (error) => {
    assert.ok(error instanceof LgsError, String(error))
    assert.equal(error.code, code, error.message)
    assert.ok(error.message.length > 10)
    for (const [name, value] of Object.entries(where)) assert.deepEqual(error[name], value, name)
    return true
  })
/** A floor of cells (0, 0) to (count - 1, 0) of block 1. */
function floor(count = 3, options = {}) {
  const world = createWorld(options)
  const square = world.shape(unitSquare)
  world.fill({ i0: 0, j0: 0, i1: count - 1, j1: 0 }, square, 1)
  return { world, square }
}
/** [start, end, ghost1, ghost2] of the segments of a list. */
const quads = (list) => Array.from({ length: list.length }, (_, k) => Array.from(list.geometry.subarray(8 * k, 8 * k + 8)))
const sorted = (list) => quads(list).sort((a, b) => a.findIndex((v, k) => v !== b[k]) < 0 ? 0 : a[a.findIndex((v, k) => v !== b[k])] - b[a.findIndex((v, k) => v !== b[k])])

test('a square has four segments, each with its ghosts, block, cell and owner', () => {
  const world = createWorld()
  const square = world.shape(unitSquare)
  const polygon = world.add(3, -4, square, 7)
  const { removed, added, relinked } = world.commit()
  assert.equal(removed.length, 0)
  assert.equal(relinked.length, 0)
  assert.equal(added.length, 4)
  assert.deepEqual(sorted(added), [
    [3, -4, 4, -4, 3, -3, 4, -3],
    [3, -3, 3, -4, 4, -3, 4, -4],
    [4, -4, 4, -3, 3, -4, 3, -3],
    [4, -3, 3, -3, 4, -4, 3, -4],
  ])
  assert.deepEqual(Array.from(added.block), [7, 7, 7, 7])
  assert.deepEqual(Array.from(added.cell), [3, -4, 3, -4, 3, -4, 3, -4])
  assert.deepEqual(Array.from(added.owner), [polygon, polygon, polygon, polygon])
  for (let k = 0; k < 4; ++k) {
    const next = added.id.indexOf(added.successor[k])
    assert.equal(added.predecessor[next], added.id[k])
  }
})

test('versions lead from one commit to the next', () => {
  const { world, square } = floor(1)
  const first = world.commit()
  assert.equal(first.after, world.version)
  world.add(5, 5, square, 1)
  const second = world.commit()
  assert.equal(second.before, first.after)
  assert.notEqual(second.after, second.before)
  const nothing = world.commit()
  assert.equal(nothing.before, nothing.after)
})

test('lists are stale after the next of their kind, and copies are not', () => {
  const { world } = floor(1)
  const changes = world.commit()
  const list = changes.added
  const copy = changes.copy()
  const geometry = Array.from(list.geometry)
  const all = world.segments()
  world.segment(list.id[0])
  world.add(5, 5, world.shape(ramp), 1)
  assert.deepEqual(Array.from(list.geometry), geometry)  // questions and edits leave lists as they are
  world.commit()
  fails('stale-list', () => list.geometry)
  fails('stale-list', () => changes.removed)
  fails('stale-list', () => changes.copy())
  assert.deepEqual(Array.from(copy.added.geometry), geometry)
  assert.equal(copy.copy(), copy)
  assert.equal(copy.added.copy(), copy.added)
  assert.equal(all.id.length, 4)
  const last = world.segments()
  fails('stale-list', () => all.id)
  world.free()
  fails('stale-list', () => last.id)
})

test('segments of a rectangle, and one by one', () => {
  const { world } = floor(3)
  world.commit()
  const list = world.segments({ i0: 0, j0: 0, i1: 0, j1: 0 })
  assert.deepEqual(sorted(list), [[0, 0, 1, 0, 0, 1, 2, 0], [0, 1, 0, 0, 1, 1, 1, 0], [1, 1, 0, 1, 2, 1, 0, 0]])
  const top = list.id[Array.from(list.geometry).findIndex((v, k, g) => k % 8 === 0 && v === 1 && g[k + 1] === 1) / 8]
  const segment = world.segment(top)
  assert.deepEqual({ ...segment, predecessor: 0, successor: 0, polygon: 0 }, {
    id: top, start: [1, 1], end: [0, 1], ghost1: [2, 1], ghost2: [0, 0], predecessor: 0, successor: 0, block: 1,
    polygon: 0, i: 0, j: 0,
  })
  assert.deepEqual(world.segment(segment.predecessor).start, [2, 1])
  assert.deepEqual(world.segment(segment.successor).end, [0, 0])
  assert.deepEqual(world.hit(top), { polygon: segment.polygon, block: 1, i: 0, j: 0 })
  assert.ok(world.maxSegmentId >= top)
  fails('unknown-segment', () => world.segment(9999), { segment: 9999 })
  fails('unknown-segment', () => world.hit(0))
})

test('polygons: of a cell, of a rectangle, of an id, at a point', () => {
  const { world } = floor(2)
  const hill = world.addPolygon(0, 1, ramp, 9)
  assert.deepEqual(world.polygon(hill), { id: hill, i: 0, j: 1, block: 9, vertices: Float64Array.from(ramp) })
  assert.deepEqual(world.polygonsAt(0, 1), [world.polygon(hill)])
  assert.deepEqual(world.polygonsAt(7, 7), [])
  assert.equal(world.polygons().length, 3)
  assert.equal(world.polygons({ i0: 0, j0: 0, i1: 9, j1: 0 }).length, 2)
  assert.deepEqual(world.at(0.75, 1.25), { where: 'inside', polygon: hill, block: 9, i: 0, j: 1 })
  assert.deepEqual(world.at(0.5, 1.5), { where: 'edge', polygon: hill, block: 9, i: 0, j: 1 })
  assert.deepEqual(world.at(0.25, 1.75), { where: 'outside', polygon: 0, block: 0, i: 0, j: 1 })
  for (const x of [NaN, Infinity, -3e9]) fails('out-of-reach', () => world.at(x, 0))
  assert.deepEqual(world.bounds(), { i0: 0, j0: 0, i1: 1, j1: 1 })
  assert.equal(createWorld().bounds(), null)
})

test('bounds: the least rectangle of cells', () => {
  const world = createWorld(), square = world.shape(unitSquare)
  world.add(2, -7, square, 1)
  world.add(5, -1, square, 1)
  assert.deepEqual(world.bounds(), { i0: 2, j0: -7, i1: 5, j1: -1 })
})

test('add, addMany, remove, removeMany, replace, setBlock, clear', () => {
  const world = createWorld()
  const square = world.shape(unitSquare)
  const half = world.shape([[0, 0], [1, 0], [1, 0.5], [0, 0.5]])
  const ids = world.addMany(Int32Array.of(0, 0, square, 1, 1, 0, half, -1))
  assert.equal(ids.length, 2)
  assert.equal(world.polygon(ids[1]).block, 4294967295)
  fails('overlap', () => world.addMany(Int32Array.of(5, 5, square, 1, 1, 0, square, 1)),
    { index: 1, cell: { i: 1, j: 0 }, other: ids[1], otherBlock: 4294967295 })
  assert.deepEqual(world.polygonsAt(5, 5), [])
  const instead = world.replace(0, 0, half, 3)
  fails('stale-handle', () => world.polygon(ids[0]), { other: ids[0] })
  world.setBlock(instead, 4)
  assert.equal(world.polygon(instead).block, 4)
  fails('stale-handle', () => world.removeMany([instead, instead]), { index: 1, index2: 0 })
  world.removeMany([instead, ids[1]])
  assert.equal(world.stats().polygons, 0)
  const again = world.add(0, 0, square, 1)
  world.remove(again)
  fails('stale-handle', () => world.remove(again))
  world.fill({ i0: -2, j0: -2, i1: 2, j1: 2 }, square, 1)
  assert.equal(world.clear({ i0: 0, j0: 0, i1: 2, j1: 0 }), 3)
  assert.equal(world.stats().polygons, 22)
})

test('loops, kept and merged', () => {
  const { world } = floor(3)
  world.commit()
  const [kept] = world.loops()
  assert.equal(kept.vertices.length, 16)
  assert.deepEqual(world.segment(kept.segments[0]).start, [0, 0])
  const [merged] = world.loops({ merge: true })
  assert.deepEqual(Array.from(merged.vertices), [0, 0, 3, 0, 3, 1, 0, 1])
  assert.equal(merged.segments.length, 0)
})

test('nearest and rays', () => {
  const { world } = floor(3)
  world.commit()
  const near = world.nearest(1.5, 3, 5)
  assert.deepEqual({ ...near, segment: 0 }, { segment: 0, x: 1.5, y: 1, distance: 2 })
  assert.equal(world.nearest(1.5, 30, 5), null)
  const hit = world.rayCast(1.5, 3, 1.5, -1)
  assert.deepEqual({ ...hit, segment: 0 }, { segment: 0, fraction: 0.5, x: 1.5, y: 1, nx: 0, ny: 1 })
  assert.equal(world.rayCast(0, 3, 9, 3), null)
  for (const wrong of [() => world.nearest(NaN, 0, 1), () => world.nearest(0, 0, -1), () => world.nearest(0, 0, 5000),
    () => world.rayCast(0, 0, Infinity, 0), () => world.rayCast(0, 0, 20000, 0)]) fails('out-of-reach', wrong)
})

test('brushes paint and carve, and name what changed', () => {
  const { world } = floor(3)
  world.commit()
  const middle = world.polygonsAt(1, 0)[0].id
  const carved = world.carve(circle(1.5, 1, 0.25, 16))
  assert.equal(carved.changed.length, 1)
  assert.equal(carved.changed[0].old, middle)
  assert.deepEqual(carved.changed[0].now, [world.polygonsAt(1, 0)[0].id])
  assert.equal(world.carve(rectangle(0.5, 0.5, 1, 0, 0.5, 0.5)).removed.length, 1)
  const painted = world.paint(thickLine([[0, 3], [2, 3]], 0.25), 5)
  assert.ok(painted.added.length > 0)
  assert.equal(world.polygon(painted.added[0]).block, 5)
  assert.equal(world.paint({ rings: [[2, 0, 3, 0, 3, 1, 2, 1]] }, 6, 'replace').changed.length, 1)
  assert.equal(world.polygonsAt(2, 0)[0].block, 6)
  const ring = { rings: [[10, 0, 14, 0, 14, 4, 10, 4], [11, 1, 13, 1, 13, 3, 11, 3]] }
  world.paint({ ...ring, rule: 'evenOdd' }, 1)
  assert.equal(world.at(12, 2).where, 'outside')
  world.paint(ring, 1)
  assert.equal(world.at(12, 2).where !== 'outside', true)
  fails('out-of-reach', () => world.carve({ rings: [[0, 0, 1, 0, NaN, 1]] }), { polygon: 0, vertex: 2 })
  fails('out-of-reach', () => world.carve({ rings: [[0, 0, 9000, 0, 0, 1]] }))
  const { removed, added, changed, rounded } = world.carve({ rings: [] })
  assert.deepEqual({ removed, added, changed, rounded }, { removed: [], added: [], changed: [], rounded: [] })
})

test('save and load go on exactly', () => {
  const { world, square } = floor(3)
  fails('uncommitted', () => world.save())
  world.commit()
  const other = loadWorld(world.save())
  for (const w of [world, other]) w.clear(1, 0)
  const a = world.commit(), b = other.commit()
  assert.deepEqual(Array.from(a.removed), Array.from(b.removed))
  assert.deepEqual(Array.from(a.added.id), Array.from(b.added.id))
  assert.equal(world.add(1, 0, square, 1), other.add(1, 0, square, 1))
  const bytes = other.commit() && other.save()
  bytes[bytes.length - 1] ^= 1
  fails('damaged', () => loadWorld(bytes))
  fails('cut', () => loadWorld(bytes.subarray(0, 10)))
  fails('not-a-snapshot', () => loadWorld(Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16)), { offset: 0 })
})

test('marks: there and back', () => {
  const { world } = floor(3)
  world.commit()
  const mark = world.mark()
  assert.ok(Number.isSafeInteger(mark))
  const before = sorted(world.segments())
  world.carve(circle(1.5, 0.5, 1))
  world.commit()
  const back = world.rollBack(mark)
  assert.ok(back.removed.length > 0)
  assert.ok(back.added.length > 0)
  assert.deepEqual(sorted(world.segments()), before)
  world.forget(mark)
  fails('unknown-mark', () => world.rollBack(mark))
  fails('unknown-mark', () => world.forget(mark))
  fails('unknown-mark', () => world.rollBack(0))
})

test('a preserve relation keeps edges, and is asked once for each pair', () => {
  const asked = []
  const world = createWorld({ preserve: (a, b) => (asked.push([a, b]), a === 1 && b === 2) })
  const square = world.shape(unitSquare)
  for (const [i, block] of [[0, 2], [1, 1], [2, 2], [3, 3]]) world.add(i, 0, square, block)
  const { added } = world.commit()
  // 16 edges: the two between 1 and 2 stay, each twice; those between 2 and 3 go.
  assert.equal(added.length, 14)
  assert.deepEqual(new Set(asked.map(String)), new Set(['1,2', '2,3']))
  assert.equal(asked.length, 2)
  for (let k = 0; k < added.length; ++k) {
    assert.equal(added.predecessor[k] === 0, Number.isNaN(added.geometry[8 * k + 4]))
    assert.equal(added.successor[k] === 0, Number.isNaN(added.geometry[8 * k + 6]))
  }
})

test('a preserve relation that throws or calls back', () => {
  const cause = new Error('mine')
  const world = createWorld({ preserve: () => { throw cause } })
  const square = world.shape(unitSquare)
  const place = () => {
    world.add(0, 0, square, 1)
    world.add(1, 0, square, 2)
    world.commit()
  }
  assert.throws(place, (error) => error.code === 'preserve-failed' && error.cause === cause)
  world.commit()
  assert.equal(world.segments().length, 6)  // the pair is cancelled
  const nosy = createWorld({ preserve: () => nosy.stats().cells > 0 })
  const again = nosy.shape(unitSquare)
  assert.throws(() => {
    nosy.add(0, 0, again, 1)
    nosy.add(1, 0, again, 2)
    nosy.commit()
  }, (error) => error.code === 'preserve-failed' && error.cause.code === 'busy')
})

test('float geometry', () => {
  const { world } = floor(1, { precision: 'float' })
  world.addPolygon(3, 0, [0, 0, 1 / 3, 0, 0, 1], 1)
  const { added } = world.commit()
  assert.ok(added.geometry instanceof Float32Array)
  assert.ok(added.copy().geometry instanceof Float32Array)
  assert.ok(added.geometry.includes(Math.fround(3 + Math.round(65536 / 3) / 65536)))
})

test('free() twice, and using what was freed', () => {
  const { world } = floor(1)
  world.commit()
  world.free()
  world.free()
  world[Symbol.dispose ?? Symbol.for('Symbol.dispose')]?.()
  for (const use of [() => world.add(0, 0, 1, 1), () => world.commit(), () => world.stats(), () => world.segments(),
    () => world.carve(circle(0, 0, 1)), () => world.version, () => world.save(), () => world.shape(unitSquare),
    () => world.polygons(), () => world.mark(), () => world.at(0, 0), () => world.bounds(), () => world.loops()])
    fails('freed', use)
})

test('stats', () => {
  const { world } = floor(3)
  world.commit()
  const { polygons, cells, segments, shapes, chunks, bytes } = world.stats()
  assert.deepEqual({ polygons, cells, segments, shapes, chunks }, { polygons: 3, cells: 3, segments: 8, shapes: 1, chunks: 1 })
  assert.ok(bytes > 1000)
})
