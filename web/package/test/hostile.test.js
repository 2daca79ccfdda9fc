// Arguments that change while they are read, that free the world, or that lie in the memory of WebAssembly, which moves.
// And calls that end badly: what they leave behind.
import assert from 'node:assert/strict'
import { beforeEach, test } from 'node:test'
import { LgsError, circle, createWorld, loadWorld, rectangle, thickLine, unitSquare } from 'localgridseg'
import { importMap, init } from 'localgridseg/full'

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

test('arrays with holes, of other numbers, of no length, of too many', () => {
  refuses('outside-cell', () => world.shape(new Float64Array(20).fill(1e9)))  // what is in the memory before
  refuses('bad-argument', () => world.paint({ rings: [, ramp] }, 1))
  refuses('bad-argument', () => world.paint({ rings: [[0, 0, , 0, 1, 1]] }, 1))
  refuses('bad-argument', () => world.shape(new BigInt64Array(6)))
  refuses('bad-argument', () => thickLine(new BigInt64Array(6), 1))
  for (const v of [null, undefined, 'abc', [1n], ['1'], new Array(2 ** 28), { length: 2 ** 32 }])
    refuses('bad-argument', () => world.removeMany(v))
  world.removeMany({ length: -1 })
  refuses('bad-argument', () => world.remove(Object.create(null)))
  refuses('bad-argument', () => world.remove({ toString() { throw new Error('no') } }))
  assert.throws(() => world.remove(new Array(1e6).fill(7)), (error) => error.message.length < 100)
})

test('lengths that only look like numbers', () => {
  for (const v of [5n, '5', true, [], { valueOf() { throw new Error('no') } }]) {
    refuses('bad-argument', () => circle(0, 0, v))
    refuses('bad-argument', () => rectangle(0, 0, 1, 0, 1, v))
    refuses('bad-argument', () => thickLine([0, 0, 1, 1], v))
  }
  assert.equal(world.stats().polygons, 0, 'the engine runs')
})

test('a handle and a half is no handle', () => {
  const id = world.add(0, 0, square, 1)
  refuses('stale-handle', () => world.remove(id + 0.5))
  refuses('stale-handle', () => world.removeMany([id + 0.25]))
  assert.equal(world.stats().polygons, 1)
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

test('files and options that would end the importer', () => {
  const map = { 'a.tmx': '<map/>' }
  for (const content of [5, null, [1n], {}]) refuses('bad-argument', () => importMap('a.tmx', { 'a.tmx': content }))
  for (const options of [{ numbers: [1, 2] }, { numbers: { '\ud800': 1 } }, { layers: [, 'a'] }, { objects: ['\udfff'] }])
    refuses('bad-argument', () => importMap('a.tmx', map, options))
  refuses('bad-map', () => importMap('a.tmx', map))
  assert.equal(world.stats().polygons, 0, 'the engine runs')
})
