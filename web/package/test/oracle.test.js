// localgridseg/oracle says what the command says, byte by byte.
import assert from 'node:assert/strict'
import { execFileSync, spawnSync } from 'node:child_process'
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { LgsError, createWorld, init as initEngine } from 'localgridseg'
import { answer, check, init, outline, page } from 'localgridseg/oracle'
import { dump } from 'localgridseg/trace'
import { lgs, skip } from './lgs.js'

const here = (path) => fileURLToPath(new URL(path, import.meta.url))
const folder = mkdtempSync(join(tmpdir(), 'lgs-oracle-'))
before(async () => {
  const { instantiate } = WebAssembly
  let count = 0
  WebAssembly.instantiate = (...all) => {
    ++count
    return instantiate(...all)
  }
  await Promise.all([init(), init()])
  WebAssembly.instantiate = instantiate
  assert.equal(count, 1, 'two at once are one')
})
after(() => rmSync(folder, { recursive: true }))

const traces = ['proptests/regressions', 'docs/departures', 'docs'].flatMap((part) =>
  readdirSync(here(`../../../${part}`)).filter((name) => name.endsWith('.trace')).map((name) => here(`../../../${part}/${name}`)))

test('the project\'s traces: outline, report and page are those of the command', { skip }, () => {
  assert.ok(traces.length > 20, `${traces.length} traces`)
  for (const file of traces) {
    const text = readFileSync(file, 'utf8')
    const run = (...options) => execFileSync(lgs, ['replay', file, '--check', '--oracle', 'naive', ...options], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] })
    assert.deepEqual(check(text, file), { isRight: true, report: run() }, file)
    assert.equal(outline(text), run('--dump', '-'), file)
    assert.equal(page(text, file), run('--html', '-'), file)
  }
})

test('line by line, the answers are those of lgs oracle', { skip }, () => {
  const recorder = `'${process.execPath}' '${here('record.mjs')}' '${folder}'`
  execFileSync(lgs, ['check', '--engine', recorder, '--edits', '1500', '--seed', '5', '--oracle', 'naive'])
  const random = readdirSync(folder).map((file) => JSON.parse(readFileSync(join(folder, file), 'utf8')).lines.join('\n'))
  assert.ok(random.length > 10, `${random.length} worlds`)
  const bad = 'lgs-engine 1\nput\r\n\n# nothing\nadd a 0 0 1 0 0 1 0 0 1\nadd a 0 0 1 0 0 1 0 0 1\ncommit\npreserve 1 2\nreset\npreserve 1 2\nremove b\ncommit now\ncommit'
  for (const lines of [...random, bad])
    assert.equal(answer(lines), spawnSync(lgs, ['oracle', '--oracle', 'naive'], { input: lines, encoding: 'utf8' }).stdout, lines)
})

test('where an engine differs, the outline says so; a bad trace is named with its line', async () => {
  await initEngine()
  const trace = 'lgs-trace 1\nadd a 0 0 1  0 0, 1 0, 0 1\nadd b 1 0 1  0 0, 1 0, 1 1, 0 1\n', world = createWorld()
  world.addPolygon(0, 0, [0, 0, 1, 0, 0, 1], 1)
  world.commit()
  assert.notEqual(dump(world), outline(trace))
  world.addPolygon(1, 0, [0, 0, 1, 0, 1, 1, 0, 1], 1)
  world.commit()
  assert.equal(dump(world), outline(trace))
  world.free()
  for (const ask of [outline, check, page])
    assert.throws(() => ask('lgs-trace 1\nput a'), (error) => error instanceof LgsError && error.code === 'bad-trace' && error.line === 2)
  assert.throws(() => check('lgs-trace 1\nremove a'), (error) => error.code === 'bad-trace' && error.line === 2)
  assert.throws(() => check(7), (error) => error.code === 'bad-argument')
})
