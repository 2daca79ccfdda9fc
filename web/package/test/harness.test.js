// The package under the harness: checked by CGAL commit by commit, and compared with the native command.
import assert from 'node:assert/strict'
import { execFile } from 'node:child_process'
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { promisify } from 'node:util'
import fc from 'fast-check'
import { LgsError, createWorld, init } from 'localgridseg'
import { TracePlayer, dump, parseTrace, preserveOf } from 'localgridseg/trace'
import { lgs, skip } from './lgs.js'

const run = promisify(execFile)
const here = (path) => fileURLToPath(new URL(path, import.meta.url))
before(() => init())

/** What the native command says of a trace. */
async function native(folder, name, text) {
  const trace = join(folder, `${name}.trace`), out = join(folder, `${name}.dump`)
  writeFileSync(trace, text)
  await run(lgs, ['replay', trace, '--dump', out])
  return readFileSync(out, 'utf8')
}

/** Runs jobs, some at a time. Ends when all have ended, and then throws what the first failure threw. */
async function all(jobs) {
  const failures = []
  const work = async () => { for (let job; (job = jobs.pop()); ) await job().catch((error) => failures.push(error)) }
  await Promise.all([work(), work(), work()])
  if (failures.length > 0) throw failures[0]
}

async function inFolder(use) {
  const folder = mkdtempSync(join(tmpdir(), 'lgs-web-'))
  try {
    return await use(folder)
  } finally {
    rmSync(folder, { recursive: true })
  }
}

test('lgs check finds no mismatch in the package', { skip }, async () => {
  const engine = `'${process.execPath}' '${here('../examples/engine.mjs')}'`
  const { stdout } = await run(lgs, ['check', '--engine', engine, '--edits', '2500', '--seed', '2'])
  assert.match(stdout, /no mismatch/)
  assert.match(stdout, /a preserve relation at work/)
})

test('trace by trace the outline is that of the native command: random degenerate worlds', { skip }, () =>
  inFolder(async (folder) => {
    const recorder = `'${process.execPath}' '${here('record.mjs')}' '${folder}'`
    await run(lgs, ['check', '--engine', recorder, '--edits', '5500', '--seed', '7', '--oracle', 'naive'])
    let commits = 0
    const jobs = readdirSync(folder).flatMap((file) => {
      const { lines, dumps } = JSON.parse(readFileSync(join(folder, file), 'utf8'))
      commits += dumps.length
      // Each trace at its end, and after each tenth commit: the native command starts anew for each dump.
      return dumps.filter((_, k) => k % 10 === 0 || k === dumps.length - 1).map(([length, mine], k) => async () => {
        const text = ['lgs-trace 1', ...lines.slice(0, length), ''].join('\n')
        assert.equal(mine, await native(folder, `${file}-${k}`, text), `${file}, dump ${k}`)
      })
    })
    assert.ok(commits >= 2000, `${commits} commits`)
    await all(jobs)
  }))

test('the project\'s traces: those that once showed a bug, those of the docs; with brushes too', { skip }, () =>
  inFolder(async (folder) => {
    const files = ['proptests/regressions', 'docs/departures', 'docs'].flatMap((part) => {
      const path = here(`../../../${part}`)
      return readdirSync(path).filter((file) => file.endsWith('.trace')).map((file) => join(path, file))
    })
    assert.ok(files.length > 20, `${files.length} traces`)
    let brushes = 0
    const left = []  // with calls that the package lacks
    await all(files.map((file, k) => async () => {
      const text = readFileSync(file, 'utf8')
      const world = (trace) => {
        const player = new TracePlayer(createWorld({ preserve: preserveOf(trace) }))
        player.play(trace)
        return player.world
      }
      try {
        const trace = parseTrace(text), played = world(trace)
        brushes += trace.edits.some((edit) => edit.kind === 'carve' || edit.kind === 'paint')
        assert.equal(dump(played), await native(folder, String(k), text), file)
        played.free()
      } catch (error) {
        if (!error.message.endsWith('the lgs command plays this line')) throw error
        left.push(file)
      }
    }))
    assert.ok(left.length < files.length / 5, `${left} have calls that JavaScript lacks`)  // most of them forgetChunks()
    assert.ok(brushes >= 2, `${brushes} with brushes`)
  }))

/** Traces of version 4: any call that the package has, some of them to be refused. */
const call = (() => {
  const at = fc.integer({ min: -2, max: 3 }), block = fc.nat(2), nth = fc.nat(3)
  const pick = (...of) => fc.constantFrom(...of)
  const text = (format, ...parts) => fc.tuple(...parts).map((values) => format.replace(/%/g, () => values.shift()))
  const shape = pick('0 0 1 0 1 1 0 1', '0 0 1 0 1 1', '0 0, 1 0, 0 1/2', '0 0.5 1 0.5 1 1 0 1', '0 0 1 1 1 0', 'none', 'id 1', 'id 9')
  const polygon = shape.map((s) => (s.startsWith('id') ? '0 0 1 1 0 1' : s)), name = pick('a', 'b', 'c')
  const named = fc.oneof(name, text('%:%#%', at, at, nth), text('given#%', fc.nat(30)))
  const rect = fc.tuple(at, at, fc.nat(2), fc.nat(2)).map(([i, j, w, h]) => `${i} ${j} ${i + w} ${j + h}`)
  const chunks = pick('-32 -32 -1 31', '0 0 31 31', '-32 -32 31 31', '-32 0 -1 31')
  const plain = fc.oneof(
    text('add % % % % %', fc.oneof(name, pick('-')), at, at, block, polygon), text('place % % % % as %', at, at, block, polygon, name),
    text('place % % % %', at, at, block, shape), text('replace % % % %', at, at, block, shape),
    text('many % % % % as % ; % % % %', at, at, block, polygon, name, at, at, block, polygon), text('remove %', named),
    text('removeMany % %:%#all', named, at, at), text('setBlock % %', named, block), text('fill % % %', rect, block, shape),
    text('clear %', rect), text('shape %', shape), text('carve % 0.2 3 0.7 1 2.5', at), text('paint % % -1.3 0.1 1.2 % 0.4 2', block, pick('fill', 'replace'), at))
  const moves = fc.oneof(pick('mark', 'commit', 'commit', 'load'), text('back % %', nth, pick('', 'keep')), text('forward %', nth), text('forget %', nth),
    text('unload %', chunks), text('reload % %', chunks, nth), text('reloadEmpty %', chunks))
  const one = fc.oneof({ weight: 3, arbitrary: plain }, { weight: 2, arbitrary: moves })
  return fc.oneof({ weight: 20, arbitrary: one }, { weight: 1, arbitrary: text('repeat %\n%\n%\ncommit\nend', nth, plain, plain) })
})()

/** Keeps what a world tells of its changes, and nothing else: that must be its outline, and each link lead to its ghost. */
function mirrored(world) {
  const mirror = new Map()
  const of = (list, k) => ({
    place: [...list.geometry.subarray(8 * k, 8 * k + 8)], block: list.block[k], owner: list.owner[k], cell: [...list.cell.subarray(2 * k, 2 * k + 2)],
  })
  for (const name of ['commit', 'rollBack', 'redo']) {
    const call = world[name].bind(world)
    world[name] = (...told) => {
      const { removed, added, relinked } = call(...told)
      for (const id of removed) assert.ok(mirror.delete(id))
      for (const list of [added, relinked])
        list.id.forEach((id, k) => {
          assert.equal(mirror.has(id), list === relinked)
          mirror.set(id, of(list, k))
        })
      const all = world.segments(), there = new Set(all.id)
      assert.equal(all.length, mirror.size)
      all.id.forEach((id, k) => {
        assert.deepEqual(mirror.get(id), of(all, k))
        const { polygon, block } = world.hit(id), next = all.successor[k]
        assert.deepEqual([polygon, block], [all.owner[k], all.block[k]])
        const { place } = mirror.get(id)
        if (there.has(next)) assert.deepEqual(mirror.get(next).place.slice(0, 4), [...place.slice(2, 4), ...place.slice(6, 8)])
      })
    }
  }
  return world
}

test('traces of any calls: the outline is that of the native command, and what the changes say', { skip }, () =>
  inFolder(async (folder) => {
    const traces = fc.sample(fc.array(call, { minLength: 10, maxLength: 60 }), { numRuns: 60, seed: 4 })
    await all(traces.map((lines, k) => async () => {
      const text = ['lgs-trace 4', 'preserve 1 2', ...lines, 'reloadEmpty -64 -64 63 63', ''].join('\n')
      const trace = parseTrace(text), player = new TracePlayer(mirrored(createWorld({ preserve: preserveOf(trace) })))
      player.play(trace)
      assert.equal(dump(player.world), await native(folder, String(k), text), text)
      player.world.free()
    }))
  }))

test('a call that the package has not is refused, with the line and what there is', () => {
  for (const line of ['group keep', 'copy', 'take a', 'put 0', 'foresee', 'leave 0 0 1 1', 'exchange 0 0 a', 'place 0 0 1 0 0 1 0 1 1 | 0 0 1 1 0 1', 'remove handle#3:1',
    'carve 0 0 1 0 1 1 around 3', 'add a 0 0 1 0 0 1 0 1 1 in floats 2', 'place 0 0 1 0 0 1 0 1 1 room 2'])
    assert.throws(() => parseTrace(`lgs-trace 4\ncommit\n${line}\n`),
      (error) => error.code === 'bad-trace' && error.line === 3 && /JavaScript has no .*: the lgs command plays this line/.test(error.message), line)
  for (const [line, text] of [[2, 'repeat 3\ncommit'], [2, 'repeat 1001\nend'], [3, 'repeat 2\nmark\nend'], [2, 'back'], [2, 'remove a#b'], [2, 'clear 0 0 1'], [2, 'commit 1 2'], [2, 'end']])
    assert.throws(() => parseTrace(`lgs-trace 4\n${text}\n`), (error) => error.code === 'bad-trace' && error.line === line, text)
})

test('how the edits of a trace are made does not matter', () => {
  const square = '0 0 1 0 1 1 0 1'
  const text = `lgs-trace 3\nadd by 0 0 1 ${square} by fill 3 marked\nadd b 1 0 1 ${square} by fill too\ncommit by 2\nremove by by 7\n`
  const plain = `lgs-trace 1\nadd by 0 0 1 ${square}\nadd b 1 0 1 ${square}\ncommit\nremove by\n`
  assert.deepEqual(parseTrace(text), parseTrace(plain))
})

test('a bad line of a trace is named', () => {
  for (const [line, text] of [[1, 'lgs-trace 5\n'], [1, ''], [2, 'lgs-trace 1\nput a\n'], [3, 'lgs-trace 1\n\nadd a 0 0 1 0 0 1\n'],
    [2, 'lgs-trace 1\nadd a 0 0 1 0 0 1 0 x 1\n'], [2, 'lgs-trace 1\ncarve 0 0 1 0 1 1\n'], [2, 'lgs-trace 1\nadd a 0.5 0 1 0 0 1 0 1 1'],
    [2, 'lgs-trace 1\nadd a 0 0 1 0 0 1/0 0 1 1'], [3, 'lgs-trace 1\ncommit\npreserve 1 2'], [2, 'lgs-trace 2\npaint 1 over 0 0 1 0 1 1']])
    assert.throws(() => parseTrace(text), (error) => error instanceof LgsError && error.code === 'bad-trace' && error.line === line, text)
  const world = createWorld()
  const play = (text) => () => parseTrace(text).edits.reduce((player, edit) => (player.apply(edit), player), new TracePlayer(world))
  assert.throws(play('lgs-trace 1\nremove a'), (error) => error.code === 'bad-trace' && error.line === 2)
  assert.throws(play('lgs-trace 1\nadd a 0 0 1 0 0 2 0 0 1'), (error) => error.code === 'outside-cell' && error.line === 2 && error.vertex === 1)
  assert.throws(play('lgs-trace 1\nadd a 0 0 1 0 0 1 0 0 1\nadd a 1 0 1 0 0 1 0 0 1'), (error) => error.code === 'bad-trace' && error.line === 3)
})
