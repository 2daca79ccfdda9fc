// The attack: through every public function of the package with every hostile value of each argument, then with every two
// of them, then with any in any order. A call does what it says, or throws an LgsError and has changed nothing; the engine
// never ends; and at the end the outline is that of the same polygons in a new world. The functions are those that
// the sources export (proptests/attack/declared.py): one that is new is attacked at once. LGS_TEST_SCALE=100 takes hours.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { inspect } from 'node:util'
import fc from 'fast-check'
import * as full from 'localgridseg/full'
import * as islands from 'localgridseg/islands'
import * as pieces from 'localgridseg/pieces'
import * as oracle from 'localgridseg/oracle'
import * as trace from 'localgridseg/trace'
import * as draw from 'localgridseg/draw'
import * as planck from 'localgridseg/planck'
import * as box2d3 from 'localgridseg/box2d3'
import { LgsError, createWorld } from 'localgridseg/islands'
import { Mine, Scene, seen, valuesFor } from './values.js'

const scale = Number(process.env.LGS_TEST_SCALE ?? 1)
const modules = { '': full, islands, pieces, trace, oracle, draw, planck, box2d3 }

/** The types of arguments: commas within brackets part none. */
function split(text) {
  const types = []
  let depth = 0, from = 0
  for (let k = 0; k <= text.length; ++k) {
    if (k === text.length || (text[k] === ',' && depth === 0)) {
      if (text.slice(from, k).trim() !== '') types.push(text.slice(from, k).trim())
      from = k + 1
    } else if ('([{<'.includes(text[k])) ++depth
    else if (')]}>'.includes(text[k]) && text[k - 1] !== '=') --depth
  }
  return types
}

/** A declared function as something to call. */
function doorOf(declared) {
  const [, module, of, name, types] = /^(?:(\w+)\/)?(?:(\w+)\.)?([\w[\].]+)\((.*)\)$/.exec(declared)
  const exported = modules[module ?? '']
  const call = (scene, args) => {
    if (of === undefined) return exported[name](...args)
    if (name === 'constructor') return new exported[of](...args)
    const receiver = scene.receiver(of, module), member = name === '[Symbol.dispose]' ? receiver[Symbol.dispose] : receiver[name]
    return typeof member === 'function' ? member.apply(receiver, args) : member
  }
  return { name: declared, types: split(types), call }
}

const script = fileURLToPath(new URL('../../../../proptests/attack/declared.py', import.meta.url))
const declared = execFileSync('python3', [script], { encoding: 'utf8' }).trim().split('\n')
/** All but those of doors.txt: init(), which is the engine's beginning, and what a refusal is made of. */
export const doors = declared.filter((name) => !/^([\w-]+\/init|LgsError\.constructor)\(/.test(name)).map(doorOf)

const shown = (value) => inspect(value, { depth: 1, maxArrayLength: 6, breakLength: Infinity, compact: true }).slice(0, 80)
const told = (scene, { door, picks }) => `${door.name}: ${argumentsOf(scene, door, picks).map(shown).join(', ')}`
const argumentsOf = (scene, door, picks) =>
  door.types.map((type, k) => {
    const values = valuesFor(scene, door.name, type)
    return values[picks[k] % values.length]
  })

/** Makes a call; throws if the package breaks its word. */
function strike(scene, { door, picks }) {
  const args = argumentsOf(scene, door, picks), before = scene.worlds.map(seen)
  try {
    const answer = door.call(scene, args)
    if (typeof answer === 'object' && answer !== null) for (const key in answer) void answer[key] // lists are made when asked for
  } catch (error) {
    if (error instanceof Mine) return
    if (!(error instanceof LgsError)) throw error
    assert.ok(error.code !== 'crashed' && error.code !== 'out-of-memory', error.message)
    if (error.code === 'preserve-failed' || error.code === 'not-a-copy') return
    assert.deepEqual(scene.worlds.map(seen), before, `it was refused, and has changed something: ${error.message}`)
  }
}

/** The same polygons in a new world have the same outline. */
function expectSameOutline(world) {
  if (seen(world) === 'freed') return
  world.reloadEmpty({ i0: -(2 ** 30), j0: -(2 ** 30), i1: 2 ** 30, j1: 2 ** 30 })
  world.commit()
  const fresh = createWorld()
  for (const { i, j, block, vertices } of world.polygons()) fresh.addPolygon(i, j, vertices, block)
  fresh.commit()
  assert.equal(trace.dump(world), trace.dump(fresh))
  fresh.free()
}

function strikeAll(blows) {
  const scene = new Scene(blows.map(({ door }) => door))
  try {
    for (const blow of blows) strike(scene, blow)
    for (const world of scene.worlds) expectSameOutline(world)
  } finally {
    scene.free()
  }
}

/** How many values each argument of a door has. */
function countsOf(door) {
  const scene = new Scene([door]), counts = door.types.map((type) => valuesFor(scene, door.name, type).length)
  scene.free()
  return counts
}

/** Tries each, and fails with all doors that break their word, each with the first calls that show it. */
async function tryEach(blows, init) {
  const found = new Map()
  for (const blow of blows) {
    try {
      strikeAll([blow])
    } catch (error) {
      await init() // if the engine has ended
      const scene = new Scene([blow.door]), lines = found.get(blow.door) ?? []
      if (lines.length < 4) lines.push(`${told(scene, blow)}: ${error.stack.split('\n').slice(0, 3).join(' ')}`)
      found.set(blow.door, lines)
      scene.free()
    }
  }
  if (found.size > 0) assert.fail([...found.values()].flat().join('\n'))
}

/** The tests of these doors, in the engine that init() loads. */
export function attack(doors, init) {
  test('every value of every argument', async (t) => {
    const blows = doors.flatMap((door) => [{ door, picks: door.types.map(() => 0) },
      ...countsOf(door).flatMap((count, at) => Array.from({ length: count - 1 }, (_, k) => ({ door, picks: door.types.map((_, n) => (n === at ? k + 1 : 0)) })))])
    t.diagnostic(`${blows.length} calls`)
    await tryEach(blows, init)
  })

  test('every two values', async (t) => {
    const stride = Math.max(1, Math.round(97 / scale)), blows = []
    let number = 0
    for (const door of doors) {
      const counts = countsOf(door)
      for (let b = 1; b < counts.length; ++b)
        for (let a = 0; a < b; ++a)
          for (let k = 1; k < counts[a]; ++k)
            for (let m = 1; m < counts[b]; ++m)
              if (number++ % stride === 0) blows.push({ door, picks: door.types.map((_, n) => (n === a ? k : n === b ? m : 0)) })
    }
    t.diagnostic(`${blows.length} of ${number} calls`)
    await tryEach(blows, init)
  })

  test('any values in any order', async () => {
    const pick = fc.oneof({ weight: 3, arbitrary: fc.constant(0) }, { weight: 2, arbitrary: fc.nat(99) })
    const blow = fc.record({ door: fc.constantFrom(...doors), picks: fc.array(pick, { minLength: 6, maxLength: 6 }) })
      .map((drawn) => Object.defineProperty(drawn, 'toString', { value: () => told(new Scene([drawn.door]), drawn) }))
    const holds = fc.asyncProperty(fc.array(blow, { maxLength: 40 }), async (blows) => {
      await init()
      strikeAll(blows)
    })
    await fc.assert(holds, { numRuns: Math.ceil(150 * scale), seed: 34 })
  })
}
