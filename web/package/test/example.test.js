// The game of the examples in a browser: it prints what those in C++, C and Python print.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { browse, skip } from './browser.js'

const root = new URL('../../../', import.meta.url)

test('the game in a browser prints what the other doors print', { skip }, async () => {
  const said = await browse(root, 'examples/browser_game.html', async (page) => {
    await page.waitForSelector('body[data-state=done]')
    assert.equal(await page.textContent('#text'), readFileSync(new URL('examples/game.txt', root), 'utf8'))
  })
  assert.deepEqual(said, [])
})
