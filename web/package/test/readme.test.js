// The example of the README prints what the README says.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'

test('the example of the README', () => {
  const page = readFileSync(new URL('../README.md', import.meta.url), 'utf8')
  const [, code] = /```js\n([^]*?)```/.exec(page)
  const [, text] = /```text\n([^]*?)```/.exec(page)
  const cwd = fileURLToPath(new URL('.', import.meta.url))
  assert.equal(execFileSync(process.execPath, ['--input-type=module', '-e', code], { cwd, encoding: 'utf8' }), text)
})
