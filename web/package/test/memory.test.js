// Worlds that make the memory of WebAssembly grow, and worlds that come and go.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import { World as Physics } from 'planck'
import { createWorld, init, unitSquare } from 'localgridseg'
import { PlanckTerrain } from 'localgridseg/planck'

let memory
before(async () => {
  const { instantiate } = WebAssembly
  WebAssembly.instantiate = async (...all) => {
    const instance = await instantiate(...all)
    memory = instance.exports.memory
    return instance
  }
  await init()
  WebAssembly.instantiate = instantiate
})
const ramp = [0, 0, 1, 0, 0, 1]

// The first one: after the others there is room for a million cells.
test('a terrain that goes from world to world leaves nothing in them', () => {
  const worlds = [createWorld(), createWorld()], terrain = new PlanckTerrain(new Physics(), worlds[0])
  const goAround = (times) => {
    for (let k = 0; k < times; ++k) for (const world of [worlds[1], worlds[0]]) terrain.resync(world)
    return memory.buffer.byteLength
  }
  const first = goAround(10)
  assert.equal(goAround(40_000), first)
  for (const world of worlds) world.free()
})

test('lists stay good while another world makes the memory grow', () => {
  const small = createWorld()
  small.add(0, 0, small.shape(ramp), 1)
  const { added } = small.commit()
  const before = Array.from(added.geometry)
  const kept = added.geometry
  const large = createWorld()
  const shape = large.shape(ramp)
  // A million cells, each with three segments of its own but where they touch.
  assert.equal(large.fill({ i0: 0, j0: 0, i1: 999, j1: 999 }, shape, 1), 1e6)
  const changes = large.commit()
  assert.deepEqual(Array.from(kept), before, 'no call empties an array')
  assert.deepEqual(Array.from(added.geometry), before)
  // Legs on a side that a hypotenuse leaves free stay; the rest of the outline is hypotenuses and the two outer legs.
  assert.equal(changes.added.length, large.stats().segments)
  assert.equal(changes.added.geometry.length, 8 * changes.added.length)
  const last = 8 * (changes.added.length - 1)
  const { start, end } = large.segment(changes.added.id.at(-1))
  assert.deepEqual(Array.from(changes.added.geometry.subarray(last, last + 4)), [...start, ...end])
  large.clear(500, 500)
  assert.ok(large.commit().removed.length > 0)
  large.free()
  small.free()
})

test('worlds come and go, and take no more memory', () => {
  const use = () => {
    const world = createWorld()
    world.fill({ i0: 0, j0: 0, i1: 63, j1: 63 }, world.shape(unitSquare), 1)
    world.commit()
    world.segments()
    world.free()
    return memory.buffer.byteLength
  }
  const first = use()
  for (let k = 0; k < 200; ++k) use()
  assert.equal(use(), first)
})
