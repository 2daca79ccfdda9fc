// Chunks that leave memory and come back: what is refused meanwhile, and what is beyond. That the rest is as in the whole
// world any traces show (harness.test.js).
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import { beyond, createWorld, init, Islands, LgsError, unitSquare } from 'localgridseg/islands'
import { Pieces } from 'localgridseg/pieces'

before(() => init())

const chunkAt = (i, j) => ({ i0: 32 * i, j0: 32 * j, i1: 32 * i + 31, j1: 32 * j + 31 })
const everywhere = { i0: -(2 ** 30), j0: -(2 ** 30), i1: 2 ** 30, j1: 2 ** 30 }
const refuses = (code, call, details = {}) =>
  assert.throws(call, (error) => {
    assert.ok(error instanceof LgsError, String(error))
    assert.equal(error.code, code)
    for (const [name, value] of Object.entries(details)) assert.deepEqual(error[name], value)
    return true
  })
test('handles are refused while their chunk is away, and valid again', () => {
  const world = createWorld()
  const square = world.shape(unitSquare), here = world.add(40, 3, square, 1), away = world.add(31, 3, square, 2)
  world.commit()
  const [{ bytes }] = world.unload(chunkAt(0, 0))
  const { removed, added } = world.commit()
  assert.deepEqual([removed.length, added.length], [4, 0])
  for (const call of [(id) => world.remove(id), (id) => world.polygon(id), (id) => world.setBlock(id, 3), (id) => world.removeMany([id])])
    refuses('unloaded', () => call(away), { other: away })
  assert.equal(world.polygon(here).block, 1)
  for (const call of [() => world.fill({ i0: 30, j0: 0, i1: 33, j1: 0 }, square, 1), () => world.clear(31, 3), () => world.carve({ rings: [[30, 2, 34, 2, 34, 5]] }),
    () => world.nearest(20, 3, 9), () => world.rayCast(39, 3.5, 10, 3.5)])
    refuses('unloaded', call)
  refuses('unloaded', () => world.save())
  assert.equal(world.at(31.5, 3.5).where, 'unloaded')
  assert.deepEqual(world.firstUnloaded(everywhere), { i: 0, j: 0 })
  assert.equal(world.polygonsAt(31, 3).length, 0)
  refuses('damaged', () => world.reload(bytes.map((byte, k) => (k === 9 ? byte ^ 1 : byte))))
  refuses('cut', () => world.reload(bytes.subarray(0, 6)))
  refuses('not-a-snapshot', () => world.reload(new Uint8Array(40)))
  assert.deepEqual(world.reload(bytes), { i: 0, j: 0 })
  refuses('loaded', () => world.reload(bytes))
  assert.equal(world.polygon(away).block, 2)
  world.setBlock(away, 7)
  world.unload(chunkAt(0, 0))
  refuses('other-bytes', () => world.reload(bytes))
  assert.equal(world.reloadEmpty(everywhere), 1)
  refuses('stale-handle', () => world.remove(away), { other: away })
  world.commit()
  assert.equal(world.firstUnloaded(everywhere), null)
  assert.equal(world.segments().length, 4)
})

test('a ray says unloaded only where it would have to look there', () => {
  const world = createWorld()
  world.fill({ i0: 0, j0: 0, i1: 95, j1: 0 }, world.shape(unitSquare), 1)
  world.commit()
  world.unload(chunkAt(1, 0))
  world.commit()
  assert.ok(world.rayCast(5.5, 9, 5.5, -3))
  refuses('unloaded', () => world.rayCast(5.5, 9, 60.5, 9))
  refuses('unloaded', () => world.nearest(40.5, 1.5, 3))
  assert.equal(world.nearest(5.5, 1.5, 3).distance, 0.5)
})

test('a rectangle beyond the world is refused', () => {
  const world = createWorld(), beyond = { i0: 0, j0: 0, i1: 2 ** 30 + 1, j1: 0 }, cell = { i: 2 ** 30 + 1, j: 0 }
  for (const call of ['unload', 'reloadEmpty']) refuses('cell-out-of-range', () => world[call](beyond), { cell })
  world.free()
})

test('what comes back waits for its commit: pieces say so until then', () => {
  const world = createWorld(), square = world.shape(unitSquare)
  for (const i of [3, 40]) world.add(i, 3, square, 1)
  world.commit()
  const pieces = new Pieces(world)
  const away = () => {
    const [{ bytes }] = world.unload(chunkAt(1, 0))
    pieces.update(world.commit())
    return bytes
  }
  for (const back of [(bytes) => world.reload(bytes), () => world.reloadEmpty(chunkAt(1, 0))]) {
    const bytes = away()
    assert.equal(pieces.solidPieces(3, 3).length, 1)
    assert.deepEqual(pieces.solidPieces(40, 3), [])
    back(bytes)
    refuses('uncommitted', () => pieces.solidPieces(3, 3))
    pieces.update(world.commit())
  }
  assert.equal(world.reloadEmpty(chunkAt(1, 0)), 0)
  assert.equal(pieces.solidPieces(3, 3).length, 1, 'nothing came back: no edit waits')
  for (const each of [pieces, world]) each.free()
})

test('what reaches the edge of memory is beyond, and never loose', () => {
  const world = createWorld(), square = world.shape(unitSquare)
  world.fill({ i0: 20, j0: 3, i1: 40, j1: 3 }, square, 1)  // from chunk to chunk
  world.fill({ i0: 3, j0: 3, i1: 4, j1: 3 }, square, 1)
  const [{ id }] = (world.commit(), world.polygonsAt(35, 3))
  const islands = new Islands(world, { blocks: [9] }), open = new Islands(world, { blocks: [9] }, 'open')
  refuses('bad-argument', () => new Islands(world, {}, 'shut'))
  const update = () => {
    const changes = world.commit()
    for (const view of [islands, open]) view.update(changes)
  }
  assert.equal(islands.all().length, 2)
  const [{ bytes }] = world.unload(chunkAt(0, 0))
  update()
  assert.equal(open.island(open.loose()[0]).area, 9, 'it ends at the edge of memory')
  assert.equal(open.of(id), open.all()[0])
  assert.deepEqual(islands.all(), [], 'one is away, the other leads there')
  assert.equal(islands.of(id), beyond)
  assert.deepEqual([islands.loose(), islands.island(beyond)], [[], null])
  refuses('stale-handle', () => islands.take(beyond))
  world.clear(33, 3)
  update()
  assert.equal(islands.loose().length, 1, 'it does not lead there any more')
  const anew = new Islands(world, { blocks: [9] })
  assert.equal(anew.all().length, 1)
  world.reload(bytes)
  update()
  assert.equal(islands.loose().length, 2, 'what came in is told')
  assert.equal(open.all().length, 3)
  for (const view of [islands, open, anew]) view.free()
  world.free()
})

test('memory goes down when chunks leave, and stays down', () => {
  const world = createWorld()
  world.fill({ i0: 0, j0: 0, i1: 255, j1: 255 }, world.shape([0.25, 0, 0.75, 0, 1, 0.5, 0.5, 1, 0, 0.5]), 1)
  world.commit()
  let full = world.stats().bytes, left = 0
  for (let k = 0; k < 20; ++k) {
    const chunks = world.unload({ i0: 0, j0: 32, i1: 255, j1: 255 })
    assert.equal(chunks.length, 56)
    world.commit()
    if (k === 1) left = world.stats().bytes
    // 344,064 segments of 28 bytes go. The first time three lists of their ids come: what went, the same without what was
    // hidden, and what is available, which a commit fills at once. Each has room for 2^19 ids of 4 bytes.
    const less = k === 0 ? 3e6 : 9.5e6
    assert.ok(world.stats().bytes < full - less, `${world.stats().bytes} of ${full} bytes`)
    if (k > 1) assert.equal(world.stats().bytes, left)
    for (const { bytes } of chunks) world.reload(bytes)
    world.commit()
    full = world.stats().bytes  // with the lists of changes, which are as long as they ever were
  }
})
