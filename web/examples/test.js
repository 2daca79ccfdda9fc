// Each program runs. Those of browsers show ground, and less of it after a click.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { existsSync } from 'node:fs'
import { before, test } from 'node:test'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { browse, skip } from '../package/test/browser.js'

const here = fileURLToPath(new URL('.', import.meta.url))
const run = (name) => execFileSync(process.execPath, [`${here}${name}`], { encoding: 'utf8' })

test('Node: a world is saved, loaded and dug', () => {
  const [first, ...segments] = run('node.js').trimEnd().split('\n')
  assert.match(first, /^2 cells are empty, \d+ are cut$/)
  assert.ok(segments.length > 8 && segments.every((line) => line.startsWith('block 1: ')))
})
for (const name of ['planck.js', 'box2d3.js'])
  test(`${name}: ground goes and comes back, and nobody is lost`, () => {
    const [, caught, left] = run(name).trimEnd().split('\n')
    assert.ok(parseInt(caught) > 0, caught)
    assert.match(left, /^10 of 10 /)
  })

before(() => run('build.js'))
for (const name of ['canvas', 'worker', 'pixi', 'phaser'])
  test(`${name}: a click digs`, { skip }, async (t) => {
    if (!existsSync(`${here}dist/${name}.html`)) return t.skip('npm install has not been run here')
    await browse(pathToFileURL(`${here}dist/`), `${name}.html`, async (page) => {
      await page.waitForSelector('body[data-ready]', { timeout: 60_000 })
      const picture = async () => {
        await page.waitForTimeout(500)
        return page.locator('canvas').screenshot()
      }
      const full = await picture()
      await page.locator('canvas').click({ position: { x: 320, y: 160 } })
      const dug = await picture()
      if (process.env.LGS_PICTURES) await page.screenshot({ path: `${process.env.LGS_PICTURES}/${name}.png` })
      assert.ok(!full.equals(dug))
    })
  })
