// The package under the harness: checked by CGAL commit by commit, and compared with the native command.
import assert from 'node:assert/strict'
import { execFile } from 'node:child_process'
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { promisify } from 'node:util'
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

/** Runs jobs, as many at a time as there are cores on a small machine. */
async function all(jobs) {
  const work = async () => { for (let job; (job = jobs.pop()); ) await job() }
  await Promise.all([work(), work(), work()])
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
    await all(files.map((file, k) => async () => {
      const text = readFileSync(file, 'utf8')
      const trace = parseTrace(text)
      brushes += trace.edits.some((edit) => edit.kind === 'carve' || edit.kind === 'paint')
      const world = createWorld({ preserve: preserveOf(trace) })
      const player = new TracePlayer(world)
      for (const edit of trace.edits) player.apply(edit)
      world.commit()
      assert.equal(dump(world), await native(folder, String(k), text), file)
      world.free()
    }))
    assert.ok(brushes >= 2, `${brushes} with brushes`)
  }))

test('how the edits of a trace are made does not matter', () => {
  const square = '0 0 1 0 1 1 0 1'
  const text = `lgs-trace 3\nadd by 0 0 1 ${square} by fill 3 marked\nadd b 1 0 1 ${square} by fill too\ncommit by 2\nremove by by 7\n`
  const plain = `lgs-trace 1\nadd by 0 0 1 ${square}\nadd b 1 0 1 ${square}\ncommit\nremove by\n`
  assert.deepEqual(parseTrace(text), parseTrace(plain))
})

test('a bad line of a trace is named', () => {
  for (const [line, text] of [[1, 'lgs-trace 4\n'], [1, ''], [2, 'lgs-trace 1\nput a\n'], [3, 'lgs-trace 1\n\nadd a 0 0 1 0 0 1\n'],
    [2, 'lgs-trace 1\nadd a 0 0 1 0 0 1 0 x 1\n'], [2, 'lgs-trace 1\ncarve 0 0 1 0 1 1\n'], [2, 'lgs-trace 1\nadd a 0.5 0 1 0 0 1 0 1 1'],
    [2, 'lgs-trace 1\nadd a 0 0 1 0 0 1/0 0 1 1'], [3, 'lgs-trace 1\ncommit\npreserve 1 2'], [2, 'lgs-trace 2\npaint 1 over 0 0 1 0 1 1']])
    assert.throws(() => parseTrace(text), (error) => error instanceof LgsError && error.code === 'bad-trace' && error.line === line, text)
  const world = createWorld()
  const play = (text) => () => parseTrace(text).edits.reduce((player, edit) => (player.apply(edit), player), new TracePlayer(world))
  assert.throws(play('lgs-trace 1\nremove a'), (error) => error.code === 'bad-trace' && error.line === 2)
  assert.throws(play('lgs-trace 1\nadd a 0 0 1 0 0 2 0 0 1'), (error) => error.code === 'outside-cell' && error.line === 2 && error.vertex === 1)
  assert.throws(play('lgs-trace 1\nadd a 0 0 1 0 0 1 0 0 1\nadd a 1 0 1 0 0 1 0 0 1'), (error) => error.code === 'bad-trace' && error.line === 3)
})
