// Plants bugs of law 13 in the terrains, one at a time, and runs buried.test.js against each: it must fail. That takes
// minutes, so by itself this only sees that each bug fits the code:
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

/** Runs the tests of law 13 for an engine in a copy with these substitutions. */
async function judge(edits, engine) {
  const folder = mkdtempSync(join(tmpdir(), 'lgs-planted-'))
  try {
    await build({
      entryPoints: ['index', 'planck', 'box2d3'].map((name) => here(`../src/${name}.ts`)),
      outdir: join(folder, 'dist'), format: 'esm', target: 'es2022', bundle: true, splitting: true, external: ['planck'],
      plugins: [{
        name: 'planted',
        setup: ({ onLoad }) => onLoad({ filter: /src.[^/\\]*\.ts$/ }, ({ path }) =>
          ({ contents: planted(path.match(/[^/\\]*$/)[0], edits), loader: 'ts' })),
      }],
    })
    copyFileSync(here('../dist/lgs.wasm'), join(folder, 'dist/lgs.wasm'))
    writeFileSync(join(folder, 'package.json'), '{ "type": "module" }')
    symlinkSync(here('../../node_modules'), join(folder, 'node_modules'))
    mkdirSync(join(folder, 'test'))
    for (const name of ['buried.test.js', 'turmoil.js', 'crowds.js', 'box2d3.js']) copyFileSync(here(name), join(folder, 'test', name))
    const { NODE_TEST_CONTEXT: _, ...env } = process.env // else the child reports to this test
    return spawnSync(process.execPath, ['--test', `--test-name-pattern=^${engine}:`, join(folder, 'test/buried.test.js')],
      { encoding: 'utf8', env, timeout: 600_000 })
  } finally {
    rmSync(folder, { recursive: true })
  }
}

const failed = (output) => [...output.matchAll(/^not ok \d+ - (.*)|^✖ (.*?) \(/gm)].map(([, tap, spec]) => tap ?? spec)

for (const { game, edits, engines } of bugs) {
  test(`${engines.length === 1 ? `${engines[0]}: ` : ''}${game}`, async (t) => {
    for (const file of new Set(edits.map((edit) => edit.file))) planted(file, edits)
    if (!process.env.LGS_PLANT) return
    for (const engine of engines) {
      const { status, stdout } = await judge(edits, engine)
      assert.equal(status, 1, `${engine}: a test finds it`)
      t.diagnostic(`${engine}: found by ${failed(stdout).join('; ')}`)
    }
  })
}

test('without a bug the copy passes', { skip: !process.env.LGS_PLANT }, async () => {
  for (const engine of ['planck', 'box2d3-wasm']) assert.equal((await judge([], engine)).status, 0, engine)
})
