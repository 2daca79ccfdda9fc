// The comparison of two outlines, without a browser.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { build } from 'esbuild'

const { outputFiles } = await build({
  entryPoints: [new URL('../src/outline-compare.ts', import.meta.url).pathname],
  write: false,
  format: 'esm',
})
const { differences } = await import(
  `data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`
)

const square = [0, 0, 2, 0, 2, 0, 2, 1, 2, 1, 0, 1, 0, 1, 0, 0]

test('an outline is itself, however its edges are cut and ordered', () => {
  const cut = [2, 0, 2, 1, 1, 0, 2, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1.5, 1, 0, 1, 2, 1, 1.5, 1]
  assert.equal(differences(square, cut).length, 0)
  assert.equal(differences(square, [...cut, 1, 0, 1, 1, 1, 1, 1, 0]).length, 0, 'an edge both ways counts nothing')
})

test('what is left out, is there too much, or runs the wrong way is found', () => {
  assert.deepEqual([...differences(square, square.slice(4))], [0, 0, 2, 0])
  assert.deepEqual([...differences(square, [...square, 5, 5, 6, 7])], [5, 5, 6, 7])
  assert.deepEqual([...differences(square, [2, 0, 0, 0, ...square.slice(4)])], [0, 0, 2, 0])
  assert.deepEqual([...differences(square, [0, 0, 1.5, 0, ...square.slice(4)])], [1.5, 0, 2, 0])
})

test('lines that nearly coincide are different lines', () => {
  const unit = 1 / 65536
  assert.equal(differences([0, 0, 100, unit], [0, 0, 100, 0]).length, 8)
})
