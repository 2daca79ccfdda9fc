// The outline as polylines: after each commit the chunks that it returns are exactly those whose lines may differ.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import { circle, createWorld, Ground, init, unitSquare } from 'localgridseg/islands'
import { GroundMeshes, GroundPicture, OutlineLines, linesIn, trianglesIn } from 'localgridseg/draw'

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

test('a line that leaves the rectangle is one line, from where it comes in', () => {
  const world = createWorld()
  world.fill({ i0: 0, j0: 0, i1: 9, j1: 1 }, world.shape(unitSquare), 1)
  world.commit()
  const [left, ...others] = linesIn(world, { i0: 0, j0: 0, i1: 3, j1: 9 })
  assert.deepEqual([...left], [4, 2, 0, 2, 0, 0, 4, 0])
  assert.equal(others.length, 0)
  const middle = linesIn(world, { i0: 4, j0: 0, i1: 7, j1: 9 }).map((line) => [...line].join())
  assert.deepEqual(middle.sort(), ['4,0,8,0', '8,2,4,2'])
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
  const mark = world.mark()
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

// The area of each block, by triangles and by polygons.
function areasOfMeshes(meshes) {
  const areas = new Map()
  for (const { positions: p, indices, blocks } of meshes) {
    for (let k = 0; k < indices.length; k += 3) {
      const [a, b, c] = indices.subarray(k, k + 3)
      const area = ((p[2 * b] - p[2 * a]) * (p[2 * c + 1] - p[2 * a + 1]) - (p[2 * c] - p[2 * a]) * (p[2 * b + 1] - p[2 * a + 1])) / 2
      assert.ok(area >= 0, 'counter-clockwise')
      assert.ok(blocks[a] === blocks[b] && blocks[b] === blocks[c])
      areas.set(blocks[a], (areas.get(blocks[a]) ?? 0) + area)
    }
  }
  return [...areas].sort(([a], [b]) => a - b).map(([block, area]) => [block, area.toFixed(4)])
}
function areasOfPolygons(world) {
  const areas = new Map()
  for (const { block, vertices: v } of world.polygons()) {
    let twice = 0
    for (let k = 0, n = v.length; k < n; k += 2) twice += v[k] * v[(k + 3) % n] - v[k + 1] * v[(k + 2) % n]
    areas.set(block, (areas.get(block) ?? 0) + twice / 2)
  }
  return [...areas].sort(([a], [b]) => a - b).map(([block, area]) => [block, area.toFixed(4)])
}

test('meshes that draw the changed chunks anew cover the ground, block by block, far from the origin too', () => {
  for (const far of [0, 2 ** 29]) {
    const world = createWorld()
    world.fill({ i0: far - 12, j0: -6, i1: far + 12, j1: 6 }, world.shape(unitSquare), 1)
    world.commit()
    const ground = new GroundMeshes(world, 4)
    const picture = new Map(ground.all().map((mesh) => [mesh.key, mesh]))
    assert.deepEqual(areasOfMeshes(picture.values()), [[1, (25 * 13).toFixed(4)]])
    let random = 7
    const next = (n) => (random = (random * 48271) % 2147483647) % n
    const mark = world.mark()
    const show = (changes) => {
      const updated = ground.update(changes)
      for (const mesh of updated) mesh.indices.length === 0 ? picture.delete(mesh.key) : picture.set(mesh.key, mesh)
      assert.deepEqual(areasOfMeshes(picture.values()), areasOfPolygons(world))
      return updated
    }
    for (let k = 0; k < 20; ++k) {
      const region = circle(far + next(28) - 14, next(16) - 8, 0.5 + next(3))
      if (next(3) === 0) world.paint(region, 1 + next(3), 'replace')
      else world.carve(region)
      show(world.commit())
    }
    world.setBlock(world.polygons()[0].id, 9)
    assert.equal(show(world.commit()).length, 1, 'one chunk, though no segment may have changed')
    show(world.rollBack(mark))
    world.clear({ i0: far - 20, j0: -20, i1: far + 20, j1: 20 })
    show(world.commit())
    assert.equal(picture.size, 0)
    world.free()
  }
})

test('meshes: when they can be made, and changes that were left out', () => {
  const world = createWorld(), square = world.shape(unitSquare)
  world.add(0, 0, square, 1)
  assert.throws(() => new GroundMeshes(world), ({ code }) => code === 'uncommitted')
  world.commit()
  const mark = world.mark()
  assert.throws(() => new GroundMeshes(world), ({ code }) => code === 'uncommitted')
  world.forget(mark)
  for (const cells of [0, 1.5, '16', NaN]) {
    assert.throws(() => new GroundMeshes(world, cells), ({ code }) => code === 'bad-argument')
    assert.throws(() => new OutlineLines(world, cells), ({ code }) => code === 'bad-argument')
  }
  const ground = new GroundMeshes(world)
  world.add(1, 0, square, 1)
  world.commit()
  world.add(2, 0, square, 1)
  assert.throws(() => ground.update(world.commit()), ({ code }) => code === 'left-out')
  assert.throws(() => ground.update(world.commit()), ({ code }) => code === 'left-out', 'also where nothing was done since')
  world.free()
})

test('changes that are not the last ones are refused, and not taken for drawn', () => {
  for (const View of [OutlineLines, GroundMeshes]) {
    const world = createWorld(), square = world.shape(unitSquare), view = new View(world)
    world.add(40, 0, square, 1)
    const changes = world.commit()
    world.commit()
    for (let k = 0; k < 2; ++k) assert.throws(() => view.update(changes), ({ code }) => code === 'stale-list')
    world.add(0, 0, square, 1)
    assert.throws(() => view.update(world.commit()), ({ code }) => code === 'left-out')
    world.free()
  }
})

test('a polygon with a bay, and lines across a wide rectangle', () => {
  const world = createWorld()
  world.addPolygon(0, 0, [0, 0, 1, 0, 1, 1, 0.75, 1, 0.5, 0.25, 0.25, 1, 0, 1], 4)
  world.fill({ i0: 1, j0: 0, i1: 40, j1: 0 }, world.shape(unitSquare), 4)
  world.commit()
  const { positions, indices, blocks } = trianglesIn(world, { i0: 0, j0: 0, i1: 0, j1: 0 })
  assert.equal(indices.length, 15)
  assert.deepEqual(areasOfMeshes([{ positions, indices, blocks }]), [[4, '0.8125']])
  const [line, ...others] = linesIn(world, { i0: 0, j0: 0, i1: 99, j1: 0 })
  assert.equal(others.length, 0)
  assert.ok(line.length <= 20, 'straight on is one line')
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

test('a GroundPicture fills whole cells as few rectangles, each block all of its area', () => {
  const filled = new Map() // a style, and the rings that were filled with it
  globalThis.Path2D = class {
    rings = []
    moveTo(x, y) { this.rings.push([x, y]) }
    lineTo(x, y) { this.rings.at(-1).push(x, y) }
    closePath() {}
  }
  const context = new Proxy({ fill(path) { filled.set(this.fillStyle, [...(filled.get(this.fillStyle) ?? []), ...path.rings]) } }, { get: (all, name) => all[name] ?? (() => {}) })
  const canvas = { clientWidth: 100, clientHeight: 100, getContext: () => context }
  const ground = new Ground(), pattern = {}
  ground.edit((world) => {
    const square = world.shape(unitSquare)
    world.fill({ i0: 0, j0: 0, i1: 9, j1: 4 }, square, 1)
    world.fill({ i0: 3, j0: 5, i1: 4, j1: 5 }, square, 2)
    world.clear(7, 2)
    world.addPolygon(7, 2, [0, 0, 1, 0, 0, 1], 1)
  })
  new GroundPicture(ground, canvas, { 1: pattern, 2: 'red' }).draw()
  const area = (rings) => rings.reduce((sum, v) => sum + v.reduce((s, _, k) => (k % 2 ? s : s + (v[k] * v[(k + 3) % v.length] - v[k + 1] * v[(k + 2) % v.length]) / 2), 0), 0)
  assert.deepEqual([...filled].map(([style, rings]) => [style, area(rings), rings.length]), [[pattern, 49.5, 5], ['red', 2, 1]])
  ground.free()
  delete globalThis.Path2D
})
