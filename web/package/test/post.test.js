// What can be posted to a worker, kept in JSON, and read one by one.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import { MessageChannel } from 'node:worker_threads'
import { LgsError, circle, createWorld, init, loadWorld, unitSquare } from 'localgridseg'

before(() => init())
const refuses = (code, f, pattern = /./) =>
  assert.throws(f, (error) => {
    assert.ok(error instanceof LgsError, String(error))
    assert.equal(error.code, code, error.message)
    assert.match(error.message, pattern)
    return true
  })

function dug(precision = 'double') {
  const world = createWorld({ precision })
  world.fill({ i0: 0, j0: 0, i1: 9, j1: 3 }, world.shape(unitSquare), 5)
  world.commit()
  world.carve(circle(4, 4, 1.5))
  return { world, changes: world.commit() }
}
const numbers = ({ removed, added, relinked, before, after }) =>
  [removed, before, after, ...[added, relinked].flatMap((list) =>
    [list.length, list.id, list.geometry, list.block, list.cell, list.owner, list.predecessor, list.successor])]

for (const precision of ['double', 'float'])
  test(`copies of changes can be cloned, and handed over: ${precision}`, async () => {
    const { world, changes } = dug(precision)
    const copy = changes.copy()
    assert.deepEqual(numbers(copy), numbers(changes))
    assert.ok(copy.removed.length > 0 && copy.added.length > 0 && copy.relinked.length > 0)
    assert.deepEqual(numbers(structuredClone(copy)), numbers(changes))
    const { port1, port2 } = new MessageChannel()
    const arrived = new Promise((done) => port2.once('message', done))
    const [buffer, ...more] = copy.buffers()
    assert.equal(more.length, 0)
    port1.postMessage(copy, copy.buffers())
    assert.deepEqual(numbers(await arrived), numbers(changes))
    assert.equal(buffer.byteLength, 0, 'it was handed over')
    assert.equal(copy.added.id.length, 0)
    port1.close()
    const list = world.segments().copy()
    assert.deepEqual(structuredClone(list).geometry, list.geometry)
    world.free()
  })

test('what is not a copy can not be posted, and that is said', () => {
  const { world, changes } = dug()
  for (const value of [changes, changes.added, world.segments(), { changes }, { ...changes }, [changes.relinked]])
    refuses('not-a-copy', () => structuredClone(value), /copy\(\)/)
  // An array alone is an array. It brings no more than the lists with it.
  assert.ok(changes.added.geometry.buffer.byteLength < 20_000)
  world.free()
})

test('versions and marks go into JSON, and out again', () => {
  const { world, changes } = dug()
  const mark = world.mark()
  const { version, back } = JSON.parse(JSON.stringify({ version: world.version, back: mark }))
  assert.equal(version, changes.after)
  world.clear(0, 0)
  world.commit()
  world.rollBack(back)
  assert.equal(world.version, version)
  world.free()
})

test('a world as text', () => {
  const { world } = dug()
  const large = createWorld()
  large.fill({ i0: 0, j0: 0, i1: 99, j1: 99 }, large.shape([0, 0, 1, 0, 0.5, 1]), 5)
  large.commit()
  for (const one of [world, large]) {
    const text = JSON.parse(JSON.stringify(one.saveText()))
    assert.match(text, /^[A-Za-z0-9+/]+={0,2}$/)
    assert.deepEqual(loadWorld(text).save(), one.save())
  }
  refuses('not-a-snapshot', () => loadWorld('no text of that kind'))
  refuses('not-a-snapshot', () => loadWorld(btoa('another')))
  refuses('bad-argument', () => loadWorld(7))
  world.free()
})

test('segments one by one', () => {
  const { world, changes: { added } } = dug()
  const byId = Array.from(added.id, (id) => world.segment(id))
  assert.deepEqual([...added], byId)
  assert.deepEqual([...added.copy()], byId)
  const lone = createWorld({ preserve: (a, b) => a === 2 && b === 3 }), square = lone.shape(unitSquare)
  for (const [i, j, block] of [[0, 0, 2], [0, 1, 1], [1, 0, 3], [1, 1, 3]]) lone.add(i, j, square, block)
  for (const segment of lone.commit().added) assert.deepEqual(segment, lone.segment(segment.id))
  for (const ghost of ['ghost1', 'ghost2']) assert.ok([...lone.segments()].some((segment) => segment[ghost] === null))
  world.free()
})

test('lists of brushes are made when they are read, until the next brush', () => {
  const world = createWorld()
  world.fill({ i0: 0, j0: 0, i1: 3, j1: 3 }, world.shape(unitSquare), 1)
  const first = world.carve(circle(2, 2, 1.5)), { removed } = first
  const second = world.paint(circle(2, 2, 0.5), 3)
  assert.equal(first.removed, removed)
  refuses('stale-list', () => first.changed, /brush/)
  refuses('out-of-reach', () => world.carve({ rings: [[0, 0, 9000, 0, 0, 1]] }))
  assert.ok(second.added.length > 0, 'a refused brush leaves it')
  const other = createWorld()
  other.paint(circle(2, 2, 3), 1)
  assert.ok(second.added.every((id) => world.polygon(id).block === 3), 'so does one in another world')
  assert.deepEqual(second.changed, [])
  world.free()
  refuses('freed', () => second.rounded)
})

test('a preserve that gives a promise is refused', () => {
  for (const preserve of [async () => false, () => ({ then() {} })]) {
    const world = createWorld({ preserve })
    world.add(0, 0, world.shape(unitSquare), 1)
    world.add(1, 0, world.shape(unitSquare), 2)
    assert.throws(() => world.commit(), ({ code, cause }) => code === 'preserve-failed' && /true or false/.test(cause.message))
    world.free()
  }
})
