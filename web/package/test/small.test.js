// What is compiled for size does the same: the tests of worlds, of refusals and of hashes with `localgridseg/small`.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'

for (const file of ['world', 'refusals', 'hashes'])
  test(`${file}.test.js with localgridseg/small`, () => {
    const { NODE_TEST_CONTEXT: _, ...env } = process.env
    const { status, stdout } = spawnSync(process.execPath, ['--import', './as-small.mjs', '--test', `${file}.test.js`],
      { cwd: fileURLToPath(new URL('.', import.meta.url)), encoding: 'utf8', env })
    assert.equal(status, 0, stdout)
  })
