// What is refused: bad polygons by the engine, arguments of the wrong kind before they reach it. Nothing changes then.
import assert from 'node:assert/strict'
import { before, beforeEach, test } from 'node:test'
import { LgsError, circle, createWorld, init, loadWorld, rectangle, thickLine, unitSquare } from 'localgridseg'

before(() => init())
let world, square
beforeEach(() => {
  world = createWorld()
  square = world.shape(unitSquare)
  world.add(0, 0, square, 1)
  world.commit()
})
const refuses = (code, f, where = {}) =>
  assert.throws(f, (error) => {
    assert.ok(error instanceof LgsError, String(error))
    assert.equal(error.code, code, error.message)
    for (const [name, value] of Object.entries(where)) assert.deepEqual(error[name], value, name)
    return true
  })

test('polygons that are none', () => {
  const cases = [
    ['too-few-vertices', [0, 0, 1, 0], {}],
    ['not-finite', [0, 0, NaN, 0, 1, 1], { vertex: 1 }],
    ['not-finite', [0, 0, Infinity, 0, 1, 1], { vertex: 1 }],
    ['outside-cell', [0, 0, 1.5, 0, 1, 1], { vertex: 1 }],
    ['repeated-vertex', [0, 0, 1, 0, 1, 0, 1, 1], { vertex: 1, vertex2: 2 }],
    ['zero-area', [0, 0, 0.5, 0, 1, 0], {}],
    ['self-intersecting', [0, 0, 1, 1, 1, 0, 0, 0.75], {}],
    ['clockwise', [0, 0, 0, 1, 1, 1], {}],
  ]
  for (const [code, vertices, where] of cases) {
    refuses(code, () => world.shape(vertices), { ...where, cell: null })
    refuses(code, () => world.addPolygon(2, 3, vertices, 1), { ...where, cell: { i: 2, j: 3 } })
  }
  assert.equal(world.stats().polygons, 1)
})

test('edits that do not fit', () => {
  refuses('overlap', () => world.add(0, 0, square, 1), { cell: { i: 0, j: 0 }, otherBlock: 1 })
  refuses('overlap', () => world.fill({ i0: -1, j0: 0, i1: 1, j1: 0 }, square, 1))
  refuses('unknown-shape', () => world.add(1, 0, 77, 1))
  const other = createWorld(), theirs = other.shape(unitSquare)
  refuses('unknown-shape', () => world.add(1, 0, theirs, 1))
  refuses('unknown-shape', () => world.replace(1, 0, theirs, 1))
  refuses('unknown-shape', () => world.addMany(Int32Array.of(1, 0, theirs, 1)))
  refuses('unknown-shape', () => other.fill({ i0: 1, j0: 0, i1: 1, j1: 0 }, square, 1))
  const loaded = loadWorld(other.save())
  loaded.add(1, 0, theirs, 1)
  loaded.commit()
  assert.equal(loadWorld(loaded.save()).shape(unitSquare), loaded.shape(unitSquare))
  loaded.free()
  other.free()
  refuses('cell-out-of-range', () => world.add(2 ** 30 + 1, 0, square, 1))
  refuses('cell-out-of-range', () => world.clear({ i0: -(2 ** 31), j0: 0, i1: 0, j1: 0 }))
  assert.equal(world.stats().polygons, 1)
})

test('options that there are not: a word that is misspelt is named, with those that there are', () => {
  const says = (text, call) => assert.throws(call, ({ code, message }) => code === 'bad-argument' && message === text)
  says("options has no 'precison', but preserve, precision", () => createWorld({ precison: 'float' }))
  says("options has no 'merged', but merge", () => world.loops({ merged: true }))
  says("region has no 'fillRule', but rings, rule", () => world.carve({ ...circle(0, 0, 1), fillRule: 'evenOdd' }))
})

test('handles that are none', () => {
  const nobody = [0, 1, -1, 0.5, NaN, Infinity, 2 ** 53, 2 ** 60, 123456789]
  for (const id of nobody) {
    refuses('stale-handle', () => world.remove(id))
    refuses('stale-handle', () => world.polygon(id))
    refuses('stale-handle', () => world.setBlock(id, 1))
    refuses('stale-handle', () => world.removeMany([id]))
  }
  assert.equal(world.stats().polygons, 1)
})

test('numbers of the wrong kind', () => {
  const wrongInts = [0.5, NaN, Infinity, 2 ** 31, '0', null, undefined, {}, 1n]
  for (const v of wrongInts) {
    refuses('bad-argument', () => world.add(v, 0, square, 1))
    refuses('bad-argument', () => world.add(0, v, square, 1))
    refuses('bad-argument', () => world.clear(v, 0))
    refuses('bad-argument', () => world.polygonsAt(0, v))
    refuses('bad-argument', () => world.segments({ i0: v, j0: 0, i1: 0, j1: 0 }))
  }
  for (const v of [-1, 2 ** 32, 0.5, NaN, '1', undefined]) {
    refuses('bad-argument', () => world.add(1, 0, square, v))
    refuses('bad-argument', () => world.add(1, 0, v, 1))
    refuses('bad-argument', () => world.segment(v))
  }
  for (const v of ['1', null, undefined, {}, 1n]) {
    refuses('bad-argument', () => world.at(v, 0))
    refuses('bad-argument', () => world.nearest(0, 0, v))
    refuses('bad-argument', () => world.rayCast(0, 0, 0, v))
    refuses('bad-argument', () => world.remove(v))
  }
  for (const v of [1n, -1, 0.5, 2 ** 53, NaN, '1', undefined]) {
    refuses('bad-argument', () => world.rollBack(v))
    refuses('bad-argument', () => world.redo(v))
  }
  assert.equal(world.stats().polygons, 1)
})

test('arrays of the wrong kind or length', () => {
  for (const v of [[0, 0, 1], [[0, 0], [1]], [[0, 0], 1, 1], ['0', '0', '1', '0', '1', '1'], null, undefined, 7, {},
    [[0, 0], [1, 'x'], [1, 1]]])
    refuses('bad-argument', () => world.shape(v))
  refuses('too-few-vertices', () => world.shape([]))
  for (const v of [Int32Array.of(1, 2, 3), [1, 2, 3, 4], null]) refuses('bad-argument', () => world.addMany(v))
  for (const v of [null, {}, { rings: 7 }, { rings: [[0, 0, 1]] }, { rings: [], rule: 'odd' }])
    refuses('bad-argument', () => world.carve(v))
  refuses('bad-argument', () => world.paint(circle(0, 0, 1), 1, 'over'))
  refuses('bad-argument', () => circle(NaN, 0, 1))
  refuses('bad-argument', () => circle(0, 0, -1))
  refuses('bad-argument', () => circle(0, 0, 1, 0))
  refuses('bad-argument', () => rectangle(0, 0, 1, 0, Infinity, 1))
  refuses('bad-argument', () => thickLine([0, 0, NaN, 1], 1))
  refuses('bad-argument', () => createWorld({ preserve: 7 }))
  refuses('bad-argument', () => createWorld({ precision: 'half' }))
  assert.equal(world.stats().polygons, 1)
})
