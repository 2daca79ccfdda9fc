// Plants bugs in src/, one at a time, and runs the tests against each that must fail. That takes minutes, so by itself this
// only sees that each bug fits the code:
//
//     LGS_PLANT=1 node --test web/package/test/planted.test.js
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { build } from 'esbuild'
import { bugs } from './planted-bugs.js'

const here = (path) => fileURLToPath(new URL(path, import.meta.url))

/** The text of a file of src/ with substitutions, each of which must fit in one place. */
function planted(file, edits) {
  return edits.filter((edit) => edit.file === file).reduce((text, { find, replace }) => {
    assert.equal(text.split(find).length, 2, `${file} has one place: ${find}`)
    return text.replace(find, () => replace)
  }, readFileSync(here(`../src/${file}`), 'utf8'))
}

/** Runs some tests in a copy with these substitutions. */
async function judge(edits, { file, begin }) {
  const folder = mkdtempSync(join(tmpdir(), 'lgs-planted-'))
  try {
    await build({
      entryPoints: ['index', 'islands', 'pieces', 'draw', 'planck', 'box2d3'].map((name) => here(`../src/${name}.ts`)),
      outdir: join(folder, 'dist'), format: 'esm', target: 'es2022', bundle: true, splitting: true, external: ['planck'],
      plugins: [{
        name: 'planted',
        setup: ({ onLoad }) => onLoad({ filter: /src.[^/\\]*\.ts$/ }, ({ path }) =>
          ({ contents: planted(path.match(/[^/\\]*$/)[0], edits), loader: 'ts' })),
      }],
    })
    for (const name of ['lgs.wasm', 'lgs-islands.wasm']) copyFileSync(here(`../dist/${name}`), join(folder, 'dist', name))
    writeFileSync(join(folder, 'package.json'), '{ "type": "module" }')
    symlinkSync(here('../../node_modules'), join(folder, 'node_modules'))
    mkdirSync(join(folder, 'test'))
    for (const name of [file, 'turmoil.js', 'crowds.js', 'box2d3.js', 'falling.js']) copyFileSync(here(name), join(folder, 'test', name))
    const { NODE_TEST_CONTEXT: _, ...env } = process.env // else the child reports to this test
    return spawnSync(process.execPath, ['--test', `--test-name-pattern=^${begin}`, join(folder, 'test', file)],
      { encoding: 'utf8', env, timeout: 600_000 })
  } finally {
    rmSync(folder, { recursive: true })
  }
}

const failed = (output) => [...output.matchAll(/^not ok \d+ - (.*)|^✖ (.*?) \(/gm)].map(([, tap, spec]) => tap ?? spec)

for (const { game, edits, runs } of bugs) {
  test(`${runs.map(({ file, begin }) => begin || file).join(' ')} ${game}`, async (t) => {
    for (const file of new Set(edits.map((edit) => edit.file))) planted(file, edits)
    if (!process.env.LGS_PLANT) return
    for (const run of runs) {
      const { status, stdout } = await judge(edits, run)
      assert.equal(status, 1, `${run.begin}${run.file}: a test finds it`)
      t.diagnostic(`${run.begin}${run.file}: found by ${failed(stdout).join('; ')}`)
    }
  })
}

test('without a bug the copy passes', { skip: !process.env.LGS_PLANT }, async () => {
  const all = new Map(bugs.flatMap(({ runs }) => runs).map((run) => [run.begin + run.file, run]))
  for (const [name, run] of all) assert.equal((await judge([], run)).status, 0, name)
})
