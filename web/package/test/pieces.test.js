// Convex pieces, against their definition by whole numbers: areas, convexity, and portals by all pairs. That they are
// right is the matter of proptests/views; here it is seen that they come over whole.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import fc from 'fast-check'
import { createWorld, init, loadWorld, Pieces, unitSquare } from 'localgridseg/pieces'

before(() => init())

const code = (wanted) => (error) => error.code === wanted || assert.fail(`${error.code}: ${error.message}`)
const shapes = [
  [0, 0, 4, 0, 4, 4, 0, 4], [0, 0, 4, 0, 4, 4], [0, 0, 4, 4, 0, 4], [1, 1, 3, 1, 3, 3, 1, 3], [0, 0, 4, 0, 4, 1, 0, 1],
  [2, 0, 4, 2, 2, 4, 0, 2], [0, 0, 4, 0, 4, 4, 3, 4, 3, 1, 0, 1],
]

const cornersOf = (v) => Array.from({ length: v.length / 2 }, (_, k) => [v[2 * k], v[2 * k + 1]])
const turn = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
const edgesOf = (v) => cornersOf(v).map((a, k, all) => [a, all[(k + 1) % all.length]])
const areaOf = (v) => edgesOf(v).reduce((sum, [[ax, ay], [bx, by]]) => sum + ax * by - ay * bx, 0) / 2
/** Of two convex polygons: an edge of one of them has the other on its right. */
const areApart = (a, b) => [[a, b], [b, a]].some(([one, other]) =>
  edgesOf(one).some(([p, q]) => cornersOf(other).every((r) => turn(p, q, r) <= 0)))

function assertIsPiece(vertices, [i, j], most) {
  const corners = cornersOf(vertices)
  assert.ok(corners.length >= 3 && corners.length <= most)
  corners.forEach((a, k) => assert.ok(turn(a, corners[(k + 1) % corners.length], corners[(k + 2) % corners.length]) > 0))
  assert.deepEqual(corners[0], [...corners].sort(([ax, ay], [bx, by]) => ax - bx || ay - by)[0])
  for (const [x, y] of corners) assert.ok(x >= i && x <= i + 1 && y >= j && y <= j + 1)
}

/** What two pieces have in common, if that is more than a point: its ends, as seen from the first one. */
function portalOf(a, b) {
  for (const [p, q] of edgesOf(a))
    for (const [s, r] of edgesOf(b)) {
      if (turn(p, q, r) !== 0 || turn(p, q, s) !== 0) continue
      const along = ([x, y]) => (x - p[0]) * (q[0] - p[0]) + (y - p[1]) * (q[1] - p[1])
      const right = along(r) > 0 ? r : p, left = along(s) < along(q) ? s : q
      if (along(right) < along(left)) return { right, left }
    }
  return null
}

const around = { i0: -1, j0: -1, i1: 3, j1: 3 }
function* cellsIn({ i0, j0, i1, j1 }) { for (let i = i0; i <= i1; ++i) for (let j = j0; j <= j1; ++j) yield [i, j] }
const all = (pieces) => new Map(Array.from(cellsIn(around), ([i, j]) => [`${i} ${j}`,
  { solid: pieces.solidPieces(i, j).map(({ vertices }) => vertices), free: pieces.freePieces(i, j) }]))

function assertAreRight(pieces, world, most) {
  const free = []
  for (const [i, j] of cellsIn(around)) {
    const polygons = world.polygonsAt(i, j), solid = pieces.solidPieces(i, j), left = pieces.freePieces(i, j)
    left.forEach(({ vertices }, index) => free.push({ i, j, index, vertices }))
    const every = [...solid, ...left]
    for (const { vertices } of every) assertIsPiece(vertices, [i, j], most)
    every.forEach((a, k) => { for (const b of every.slice(0, k)) assert.ok(areApart(a.vertices, b.vertices)) })
    assert.ok(Math.abs(every.reduce((sum, { vertices }) => sum + areaOf(vertices), 0) - 1) < 1e-9)
    for (const { id, block, vertices } of polygons) {
      const own = solid.filter(({ polygon }) => polygon === id)
      assert.ok(Math.abs(own.reduce((sum, piece) => sum + areaOf(piece.vertices), 0) - areaOf(vertices)) < 1e-9)
      for (const piece of own) assert.equal(piece.block, block)
    }
    assert.equal(new Set(solid.map(({ polygon }) => polygon)).size, polygons.length)
  }
  for (const a of free) {
    const expected = free.flatMap((b) => {
      const portal = a === b ? null : portalOf(a.vertices, b.vertices)
      return portal === null ? [] : [JSON.stringify({ to: { i: b.i, j: b.j, index: b.index }, ...portal })]
    })
    const found = pieces.portals(a).filter(({ to }) => to.i >= -1 && to.i <= 3 && to.j >= -1 && to.j <= 3)
    assert.deepEqual(found.map((portal) => JSON.stringify(portal)).sort(), expected.sort())
    const [x, y] = cornersOf(a.vertices).reduce(([sx, sy], [px, py], _, { length }) => [sx + px / length, sy + py / length], [0, 0])
    assert.deepEqual(pieces.freePieceAt(x, y), { i: a.i, j: a.j, index: a.index })
  }
}

const edit = fc.record({
  i: fc.nat(2), j: fc.nat(2), shape: fc.nat(shapes.length), block: fc.nat(2), how: fc.constantFrom('replace', 'add'),
})
const commits = fc.array(fc.array(edit, { minLength: 1, maxLength: 5 }), { minLength: 1, maxLength: 6 })

test('random worlds: pieces make up the cells, portals are what two of them share, and changed cells are told', () => {
  fc.assert(fc.property(commits, fc.constantFrom(3, 4, 8), (steps, maxVertices) => {
    const world = createWorld(), ids = shapes.map((shape) => world.shape(shape.map((v) => v / 4)))
    const pieces = new Pieces(world, { maxVertices })
    const mark = world.mark()
    let known = all(pieces)
    const follow = (changes) => {
      const was = known, told = pieces.update(changes), now = all(pieces)
      const differ = [...now.keys()].filter((key) => JSON.stringify(now.get(key)) !== JSON.stringify(was.get(key)))
      assert.deepEqual(told.map(({ i, j }) => `${i} ${j}`).sort(), differ.sort())
      known = now
      assertAreRight(pieces, world, maxVertices)
    }
    for (const step of steps) {
      for (const { i, j, shape, block, how } of step) {
        if (shape === shapes.length) world.clear(i, j)
        else try { world[how](i, j, ids[shape], block) } catch (error) { code('overlap')(error) }
      }
      follow(world.commit())
    }
    follow(world.rollBack(mark))
    pieces.free()
    world.free()
  }), { numRuns: 40 })
})

test('whole cells are merged, and a polygon that only gets another block keeps its pieces', () => {
  const world = createWorld(), square = world.shape(unitSquare)
  world.fill({ i0: 0, j0: 0, i1: 9, j1: 4 }, square, 1)
  world.commit()
  const pieces = new Pieces(world)
  assert.deepEqual(pieces.wholeCells({ i0: -5, j0: -5, i1: 20, j1: 20 }, 'solid'), [{ i0: 0, j0: 0, i1: 9, j1: 4 }])
  assert.deepEqual(pieces.wholeCells({ i0: 0, j0: 0, i1: 9, j1: 9 }, 'free'), [{ i0: 0, j0: 5, i1: 9, j1: 9 }])
  assert.deepEqual(pieces.wholeCells({ i0: 5, j0: 5, i1: 4, j1: 5 }, 'free'), [])
  world.setBlock(world.polygonsAt(3, 3)[0].id, 7)
  assert.throws(() => pieces.solidPieces(3, 3), code('uncommitted'))
  assert.deepEqual(pieces.update(world.commit()), [])
  assert.equal(pieces.solidPieces(3, 3)[0].block, 7)
  assert.equal(pieces.freePieceAt(3.5, 3.5), null)
  pieces.free()
  world.free()
})

test('in a cell of two polygons each piece has the block of its own one', () => {
  const world = createWorld()
  const [rock, ledge] = [world.addPolygon(0, 0, [0, 0, 1, 0, 1, 0.5], 1), world.addPolygon(0, 0, [0, 0.75, 1, 0.75, 1, 1], 2)]
  world.commit()
  const pieces = new Pieces(world)
  const told = pieces.solidPieces(0, 0).map(({ polygon, block }) => ({ polygon, block }))
  assert.deepEqual(told, [{ polygon: rock, block: 1 }, { polygon: ledge, block: 2 }])
  pieces.free()
  world.free()
})

test('what is refused, and has changed nothing', () => {
  const world = createWorld(), square = world.shape(unitSquare)
  world.add(0, 0, square, 1)
  assert.throws(() => new Pieces(world), code('uncommitted'))
  world.commit()
  const pieces = new Pieces(world), late = new Pieces(world)
  world.add(1, 0, square, 1)
  const first = world.commit()
  assert.throws(() => late.solidPieces(0, 0), code('left-out'))
  pieces.update(first)
  assert.deepEqual(pieces.update(first), [], 'the same changes twice are nothing')
  const empty = world.commit()
  assert.throws(() => late.update(empty), code('left-out'), 'an empty commit does not tell what was before it')
  world.add(2, 0, square, 1)
  const second = world.commit()
  assert.throws(() => pieces.update(first), code('not-the-last'))
  pieces.update(second)
  assert.throws(() => late.update(second), code('left-out'))
  world.add(3, 0, square, 1)
  assert.throws(() => pieces.update(second), code('uncommitted'))
  for (const each of [pieces, late, world]) each.free()
  assert.throws(() => pieces.freePieces(0, 0), code('freed'))
  assert.throws(() => new Pieces(world), code('freed'))
})

test('a world that was loaded has pieces, too; and far from the origin', () => {
  const far = 2 ** 30, world = createWorld()
  world.addPolygon(far, -far, [0, 0, 1, 0, 1, 1], 1)
  world.commit()
  const loaded = loadWorld(world.save()), pieces = new Pieces(loaded)
  assert.deepEqual([...pieces.solidPieces(far, -far)[0].vertices], [far, -far, far + 1, -far, far + 1, 1 - far])
  assert.equal(pieces.portals({ i: far, j: -far, index: 0 }).length, 2)
  for (const each of [pieces, world, loaded]) each.free()
})
