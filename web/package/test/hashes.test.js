// Hashes of the ground, against the words of docs/sync.md, by BigInt.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import fc from 'fast-check'
import { createWorld, GroundHashes, init, loadWorld, unitSquare } from 'localgridseg'

before(() => init())

const bits = (n) => BigInt.asUintN(64, n)
const pair = (high, low) => (BigInt.asUintN(32, BigInt(high)) << 32n) | BigInt.asUintN(32, BigInt(low))
function mix(h) {
  h = bits((h ^ (h >> 33n)) * 0xff51afd7ed558ccdn)
  h = bits((h ^ (h >> 33n)) * 0xc4ceb9fe1a85ec53n)
  return h ^ (h >> 33n)
}
function hashOf({ i, j, block, vertices }) {
  const points = Array.from({ length: vertices.length / 2 }, (_, k) => [vertices[2 * k] * 65536, vertices[2 * k + 1] * 65536])
  const least = points.reduce((least, [x, y], k) => (x < points[least][0] || (x === points[least][0] && y < points[least][1]) ? k : least), 0)
  const words = [pair(i, j), pair(block, points.length), ...[...points.slice(least), ...points.slice(0, least)].map(([x, y]) => pair(x, y))]
  return words.reduce((h, word) => mix(h ^ word), 0n)
}
const hashOfAll = (polygons) => bits(polygons.reduce((sum, polygon) => sum + hashOf(polygon), 0n))
const everywhere = { i0: -(2 ** 30), j0: -(2 ** 30), i1: 2 ** 30, j1: 2 ** 30 }
const shapes = [[0, 0, 1, 0, 1, 1, 0, 1], [1, 0, 1, 1, 0, 0], [0.25, 0.25, 0.75, 0.25, 0.5, 0.75]]

function assertRight(hashes, world) {
  const polygons = world.polygons()
  assert.equal(hashes.hash, hashOfAll(polygons))
  for (const { level, cells, hash } of hashes.in(everywhere)) {
    assert.equal(level, 0)
    assert.deepEqual([cells.i1 - cells.i0, cells.j1 - cells.j0, cells.i0 & 31, cells.j0 & 31], [31, 31, 0, 0])
    assert.equal(hash, hashOfAll(polygons.filter(({ i, j }) => i >= cells.i0 && i <= cells.i1 && j >= cells.j0 && j <= cells.j1)))
  }
  const chunks = new Set(polygons.map(({ i, j }) => `${i >> 5},${j >> 5}`))
  assert.equal(hashes.in(everywhere).length, chunks.size)
}

test('they are those of all polygons, after each commit and roll-back', () => {
  const index = fc.oneof(fc.integer({ min: -3, max: 3 }), fc.integer({ min: -70, max: 70 }))
  const edit = fc.record({ i: index, j: index, shape: fc.nat(2), block: fc.nat(3), what: fc.nat(9) })
  fc.assert(fc.property(fc.array(edit, { maxLength: 40 }), (edits) => {
    const world = createWorld(), hashes = new GroundHashes(world), marks = []
    for (const { i, j, shape, block, what } of edits) {
      if (what === 0) marks.push(world.mark())
      else if (what === 1 && marks.length > 0) world.rollBack(marks.at(-1))
      else if (what === 2) world.clear(i, j)
      else world.replace(i, j, world.shape(shapes[shape]), block)
      if (what !== 1 || marks.length === 0) world.commit()
      hashes.update()
      assertRight(hashes, world)
    }
    const loaded = loadWorld(world.save()), others = new GroundHashes(loaded)
    assert.equal(others.hash, hashes.hash)
    assert.deepEqual(hashes.differences(others), [])
    loaded.replace(100, -40, loaded.shape(unitSquare), 7)
    loaded.commit()
    others.update()
    assert.deepEqual(hashes.differences(others), [{ i0: 96, j0: -64, i1: 127, j1: -33 }])
    for (const gone of [hashes, others, world, loaded]) gone.free()
  }), { numRuns: 60 })
})

test('a number that is the same for ever', () => {
  const world = createWorld()
  world.add(-3, 7, world.shape([0, 0, 1, 0, 0, 1 / 65536]), 9)
  world.commit()
  const hashes = new GroundHashes(world)
  assert.equal(hashes.hash, 2597067710786626438n)
  assert.deepEqual(hashes.whole(), { level: 0, cells: { i0: -32, j0: 0, i1: -1, j1: 31 }, hash: hashes.hash })
  assert.equal(hashes.in({ i0: 0, j0: 0, i1: 9, j1: 9 }, 14)[0].hash, hashes.hash)
})

test('what is wrong is said, and changes nothing', () => {
  const world = createWorld()
  world.add(0, 0, world.shape(unitSquare), 1)
  assert.throws(() => new GroundHashes(world), { code: 'uncommitted' })
  world.commit()
  assert.throws(() => new GroundHashes({}), { code: 'bad-argument' })
  const hashes = new GroundHashes(world), before = hashes.hash
  world.clear(0, 0)
  assert.throws(() => hashes.update(), { code: 'uncommitted' })
  world.commit()
  world.add(0, 0, world.shape(unitSquare), 2)
  world.commit()
  assert.throws(() => hashes.update(), { code: 'left-out' })
  assert.equal(hashes.hash, before)
  const late = new GroundHashes(world)
  world.clear(0, 0)
  world.commit()
  world.commit()
  assert.throws(() => late.update(), { code: 'left-out' }, 'an empty commit does not tell what was before it')
  late.free()
  for (const level of [-1, 15, NaN, '1', 1.5]) assert.throws(() => hashes.in(everywhere, level), { code: 'bad-argument' })
  assert.throws(() => hashes.in(null), { code: 'bad-argument' })
  for (const other of [null, undefined, {}, world]) assert.throws(() => hashes.differences(other), { code: 'bad-argument' })
  assert.deepEqual(hashes.in({ i0: 9, j0: 9, i1: 0, j1: 0 }), [])
  const others = new GroundHashes(world)
  others.free()
  others.free()
  assert.throws(() => hashes.differences(others), { code: 'freed' })
  assert.throws(() => others.hash, { code: 'freed' })
  world.free()
  assert.throws(() => hashes.update(), { code: 'freed' })
  assert.equal(hashes.hash, before)
  hashes[Symbol.dispose]()
})
