// A Ground with tens of thousands of chunks on its shelf: each of them is asked for once, whatever is done, and no list of
// them is handed over as arguments of a call, of which there can not be so many.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import { Ground, init, unitSquare } from 'localgridseg/islands'
import { anchors } from './ground.js'

before(() => init())

const here = { i0: 0, j0: 0, i1: 31, j1: 31 }

/** A square in each of side × side chunks, of which one is in memory. */
function shelved(side, chunks = new Map()) {
  const count = { put: 0, get: 0, asked: 0 }, ground = new Ground({ anchors, shelf: {
    put: (i, j, bytes) => { ++count.put; chunks.set(`${i} ${j}`, bytes) },
    get: (i, j) => { ++count.get; return chunks.get(`${i} ${j}`) },
  } })
  const { world } = ground, firstUnloaded = world.firstUnloaded.bind(world)
  world.firstUnloaded = (cells) => { ++count.asked; return firstUnloaded(cells) }
  if (side > 0) ground.edit((world) => {
    const shape = world.shape(unitSquare)
    for (let j = 0; j < side; ++j) for (let i = 0; i < side; ++i) world.add(32 * i + 5, 32 * j, shape, 9)
  })
  ground.forgetUndo()
  ground.window(here)
  const counted = (call) => {
    Object.assign(count, { put: 0, get: 0, asked: 0 })
    call()
    return { ...count }
  }
  return { ground, chunks, counted }
}

test('with four times as many chunks on the shelf four times as many are asked for, and no more', () => {
  for (const side of [16, 32]) {
    const { ground, counted } = shelved(side), away = side ** 2 - 1
    assert.deepEqual(counted(() => ground.window({ i0: 0, j0: 0, i1: 32 * side - 1, j1: 32 * side - 1 })), { put: 0, get: away, asked: away + 1 })
    assert.deepEqual(counted(() => ground.window(here)), { put: away, get: 0, asked: 1 })
    assert.deepEqual(counted(() => ground.save()), { put: 0, get: away, asked: 0 })
    ground.place(9, 9, [0, 0, 1, 0, 1, 1, 0, 1], 9)
    assert.deepEqual(counted(() => ground.undo() && ground.redo()), { put: 0, get: 0, asked: 0 })
    ground.free()
  }
})

test('46,656 chunks are saved, loaded, and brought in', () => {
  const side = 216, { ground, chunks } = shelved(side), bytes = ground.save()
  assert.equal(chunks.size, side ** 2 - 1)
  const twin = shelved(0)
  twin.ground.load(bytes)
  assert.equal(twin.chunks.size, side ** 2 - 1)
  assert.deepEqual(twin.ground.save(), bytes)
  assert.ok(twin.ground.window({ i0: 0, j0: 32, i1: 32 * side - 1, j1: 63 }))
  assert.equal(twin.ground.world.polygons().length, side)
  for (const each of [ground, twin.ground]) each.free()
})
