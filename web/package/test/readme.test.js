// The example of the README prints what the README says.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { existsSync, readFileSync } from 'node:fs'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'

test('the example of the README', () => {
  const page = readFileSync(new URL('../README.md', import.meta.url), 'utf8')
  const [, code] = /```js\n([^]*?)```/.exec(page)
  const [, text] = /```text\n([^]*?)```/.exec(page)
  const cwd = fileURLToPath(new URL('.', import.meta.url))
  assert.equal(execFileSync(process.execPath, ['--input-type=module', '-e', code], { cwd, encoding: 'utf8' }), text)
})

test('the other examples of the README run: that of Ground alone, the others one after the other', () => {
  const page = readFileSync(new URL('../README.md', import.meta.url), 'utf8')
  const blocks = [...page.matchAll(/```js\n([^]*?)```/g)].map(([, code]) => code).filter((code) => !code.includes('vite.config'))
  assert.equal(blocks.length, 8, "blocks")
  const cwd = fileURLToPath(new URL('.', import.meta.url))
  const printed = (code) => execFileSync(process.execPath, ['--input-type=module', '-e', code], { cwd, encoding: 'utf8' })
  const isOfGround = (code) => code.includes('new Ground(')
  assert.match(printed(blocks.find(isOfGround)), /^1 falls$[^]*^0 fall$/m)
  const others = blocks.filter((code) => !isOfGround(code)).join('')
  assert.match(printed(others.replace('world.free()\n', '').replaceAll("from 'localgridseg'", "from 'localgridseg/islands'")), /^1 island$[^]*triangles/m)
})

test('the game of the README is the example', () => {
  const [page, example] = ['../README.md', '../../examples/digger.js'].map((name) => readFileSync(new URL(name, import.meta.url), 'utf8'))
  const [, code] = /```ts\n([^]*?)```/.exec(page)
  assert.ok(example.includes(code))
})

test('no link leads to a place that is not there', () => {
  const page = readFileSync(new URL('../README.md', import.meta.url), 'utf8'), { homepage } = JSON.parse(readFileSync(new URL('../package.json', import.meta.url), 'utf8'))
  for (const text of [page, readFileSync(new URL('../package.json', import.meta.url), 'utf8')]) assert.doesNotMatch(text, /\.invalid/)
  // Pages of the project are named by their paths, until there is an address.
  if (homepage === undefined) assert.doesNotMatch(page, /\]\((?!#)/)
  for (const [name] of page.matchAll(/\b(docs|web)\/[\w./-]+\.(md|mjs)\b/g)) assert.ok(existsSync(new URL(`../../../${name}`, import.meta.url)), name)
})
