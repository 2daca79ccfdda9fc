// Arguments that change while they are read, that free the world, or that lie in the memory of WebAssembly, which moves.
// And calls that end badly: what they leave behind.
import assert from 'node:assert/strict'
import { beforeEach, test } from 'node:test'
import { LgsError, createWorld, loadWorld, unitSquare } from 'localgridseg'
import { init } from 'localgridseg/full'

let world, square
beforeEach(async () => {
  await init()
  world = createWorld()
  square = world.shape(unitSquare)
})
const refuses = (code, f) =>
  assert.throws(f, (error) => {
    assert.ok(error instanceof LgsError, String(error))
    assert.equal(error.code, code, error.message)
    return true
  })
const ramp = [0, 0, 1, 0, 1, 1]
/** Long enough that the memory of WebAssembly grows when it is an argument. */
function longView() {
  const large = createWorld()
  large.fill({ i0: 0, j0: 0, i1: 999, j1: 99 }, large.shape([0.25, 0.25, 0.75, 0.25, 0.5, 0.75]), 1)
  return large.commit().added
}

test('a list as an argument arrives, though the memory grows', () => {
  const { owner } = longView()
  refuses('stale-handle', () => world.removeMany(owner.subarray(0, 250_000)))
  const { geometry, length } = longView()
  refuses('out-of-reach', () => {
    const ring = geometry.subarray(0, 2_000_000)
    world.carve({ rings: [ring, [1e300, 0, 1, 0, 0, 1]] })
  })
  assert.equal(geometry.length, 8 * length, 'no call empties a list')
})

test('getters of arguments free the world', () => {
  const freeing = (o, name) => {
    const value = o[name]
    return Object.defineProperty(o, name, { get: () => (world.free(), value), enumerable: true })
  }
  const rect = () => freeing({ i0: 0, j0: 0, i1: 0, j1: 0 }, 'j1')
  for (const f of [
    () => world.shape(freeing([...ramp], 3)),
    () => world.addPolygon(0, 0, freeing([...ramp], 3), 1),
    () => world.removeMany(freeing([1], 0)),
    () => world.paint({ rings: [freeing([...ramp], 3)] }, 1),
    () => world.carve(freeing({ rings: [ramp] }, 'rings')),
    () => world.fill(rect(), square, 1),
    () => world.clear(rect()),
    () => world.segments(rect()),
    () => world.polygons(rect()),
    () => world.loops(freeing({ merge: true }, 'merge')),
  ]) {
    world = createWorld()
    refuses('freed', f)
  }
  createWorld().free()
})

test('arguments that change while they are read', () => {
  let reads = 0
  const growing = { get length() { return reads++ < 1 ? 6 : 6e5 }, ...ramp }
  world.shape(growing)
  reads = 0
  const changing = Object.defineProperty([...ramp], 2, { get: () => (reads++ === 0 ? 1 : NaN) })
  world.shape(changing)
  reads = 0
  const cells = { get i0() { return reads++ === 0 ? 0 : 0.5 }, j0: 0, i1: 0, j1: 0 }
  assert.equal(world.fill(cells, square, 1), 1)
  const entries = Int32Array.of(5, 0, square, 1)
  Object.defineProperty(entries, 'length', { value: 4e6 })
  assert.equal(world.addMany(entries).length, 1)
  const bytes = (world.commit(), world.save())
  Object.defineProperty(bytes, 'length', { value: 4e6 })
  assert.equal(loadWorld(bytes).stats().polygons, 2)
})

test('lists are stale after a commit in which preserve() threw', () => {
  const world = createWorld({ preserve() { throw new Error('no') } })
  world.add(0, 0, world.shape(unitSquare), 1)
  const { added } = world.commit()
  world.addPolygon(1, 0, unitSquare, 2)
  refuses('preserve-failed', () => world.commit())
  refuses('stale-list', () => added.id)
  const { added: before } = world.commit()
  refuses('unknown-mark', () => world.rollBack(77))
  assert.equal(before.id.length, 0, 'a refused call has changed nothing')
})

test('free() within preserve() is refused, and the world lives', () => {
  let refused
  const world = createWorld({ preserve() { try { world.free() } catch (error) { refused = error } return true } })
  const shape = world.shape(unitSquare)
  world.add(0, 0, shape, 1)
  world.add(1, 0, shape, 2)
  world.add(2, 0, shape, 3)
  assert.equal(world.commit().added.length, 12)
  assert.equal(refused.code, 'busy')
  world.free()
  refuses('freed', () => world.stats())
})
