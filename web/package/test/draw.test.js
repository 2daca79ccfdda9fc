// The outline as polylines: after each commit the chunks that it returns are exactly those whose lines may differ.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import { circle, createWorld, init, unitSquare } from '../dist/index.js'
import { OutlineLines } from '../dist/draw.js'

before(() => init())

test('a floor is one closed line of four corners', () => {
  const world = createWorld()
  world.fill({ i0: 0, j0: 0, i1: 9, j1: 1 }, world.shape(unitSquare), 1)
  world.commit()
  const chunks = new OutlineLines(world).all()
  assert.equal(chunks.length, 1)
  assert.deepEqual(chunks[0].cells, { i0: 0, j0: 0, i1: 15, j1: 15 })
  assert.equal(chunks[0].lines.length, 1)
  const corners = new Set()
  const [line] = chunks[0].lines
  for (let k = 0; k < line.length; k += 2) corners.add(`${line[k]} ${line[k + 1]}`)
  for (const corner of ['0 0', '10 0', '10 2', '0 2']) assert.ok(corners.has(corner))
  assert.deepEqual([...line.subarray(0, 2)], [...line.subarray(-2)])
  world.free()
})

test('a picture that draws the changed chunks anew is the picture of the world', () => {
  const world = createWorld()
  world.fill({ i0: -12, j0: -6, i1: 12, j1: 6 }, world.shape(unitSquare), 1)
  world.commit()
  const outline = new OutlineLines(world, 4)
  const picture = new Map(outline.all().map((chunk) => [chunk.key, chunk.lines]))
  let random = 7
  const next = (n) => (random = (random * 48271) % 2147483647) % n
  const mark = world.checkpoint()
  const show = (changes) => {
    for (const { key, lines } of outline.update(changes)) {
      if (lines.length === 0) picture.delete(key)
      else picture.set(key, lines)
    }
    assert.ok(Math.abs(areaOf(picture) - areaOfSegments(world)) < 1e-9)
    assert.deepEqual(new Set(picture.keys()), new Set(new OutlineLines(world, 4).all().map(({ key }) => key)))
    assert.equal(lengthOf(picture).toFixed(9), lengthOfSegments(world).toFixed(9))
  }
  for (let k = 0; k < 40; ++k) {
    const region = circle(next(28) - 14, next(16) - 8, 0.5 + next(3))
    if (next(3) === 0) world.paint(region, 1)
    else world.carve(region)
    show(world.commit())
  }
  show(world.rollBack(mark))
  assert.equal(world.clear({ i0: -20, j0: -20, i1: 20, j1: 20 }) > 0, true)
  show(world.commit())
  assert.equal(picture.size, 0)
  world.free()
})

test('changes that were left out are missed', () => {
  const world = createWorld()
  const square = world.shape(unitSquare)
  world.add(0, 0, square, 1)
  world.commit()
  const outline = new OutlineLines(world)
  assert.deepEqual(outline.update(world.commit()), [])
  world.add(60, 0, square, 1)
  world.commit()
  world.clear(60, 0)
  assert.throws(() => outline.update(world.commit()), /do not follow/)
  world.free()
})

function* edgesOf(picture) {
  for (const lines of picture.values()) {
    for (const line of lines)
      for (let k = 2; k < line.length; k += 2) yield [line[k - 2], line[k - 1], line[k], line[k + 1]]
  }
}

function* segmentsOf(world) {
  const { geometry, length } = world.segments()
  for (let k = 0; k < 8 * length; k += 8) yield geometry.subarray(k, k + 4)
}

const sum = (edges, of) => [...edges].reduce((total, edge) => total + of(edge), 0)
const cross = ([x0, y0, x1, y1]) => (x0 * y1 - x1 * y0) / 2
const lengthOfEdge = ([x0, y0, x1, y1]) => Math.hypot(x1 - x0, y1 - y0)
const areaOf = (picture) => sum(edgesOf(picture), cross)
const areaOfSegments = (world) => sum(segmentsOf(world), cross)
const lengthOf = (picture) => sum(edgesOf(picture), lengthOfEdge)
const lengthOfSegments = (world) => sum(segmentsOf(world), lengthOfEdge)
