// What the package says of its types: a file that uses everything compiles, and has errors where they belong.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'

test('types: a file that uses everything', () => {
  const tsc = fileURLToPath(import.meta.resolve('typescript/bin/tsc'))
  const project = fileURLToPath(new URL('types', import.meta.url))
  const { stdout } = spawnSync(process.execPath, [tsc, '-p', project], { encoding: 'utf8' })
  assert.equal(stdout, '')
})
