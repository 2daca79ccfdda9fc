// What is cut off falls, and is ground again where it came to rest.
// In a real browser; the build must be there: npm run build -w sandbox
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { blockAt, drag, openBrowser, outline } from './browser.js'

let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

const scene = (page, name) => page.locator('#scene').selectOption(name)
const tool = (page, name) => page.locator(`input[name=tool][value=${name}]`).check()
const rocks = (page) => page.evaluate(() => window.sandbox.game.sides.map((side) => window.sandbox.game.rocks.of(side).length))
const edit = (page, ...edits) =>
  page.evaluate((edits) => {
    const { ground } = window.sandbox.game
    ground.begin()
    for (const each of edits) ground.edit(each)
    ground.end()
  }, edits)
const box = (x0, y0, x1, y1) => ({ rings: [[x0, y0, x1, y0, x1, y1, x0, y1]] })
const carve = (...corners) => ({ kind: 'carve', region: box(...corners) })
const paint = (...corners) => ({ kind: 'paint', region: box(...corners), block: 1 })

/** A floor, and a table on one leg over it. */
async function table(page) {
  await scene(page, 'empty')
  await page.waitForFunction(() => window.sandbox.game.sides[0].riders.length === 0)
  await edit(page, paint(0, 0, 20, 1), paint(9, 1, 10, 5), paint(6, 5, 12, 6))
  assert.deepEqual(await rocks(page), [0, 0])
}

/** Steps until nothing falls any more. */
const rest = (page) =>
  page.evaluate(() => {
    const { game, step } = window.sandbox
    for (let k = 0; k < 1200 && game.rocks.of(game.sides[0]).length > 0; ++k) step()
    return game.rocks.of(game.sides[0]).length
  })

test('a table whose leg is dug away falls in both worlds, lies, is ground again, and can be dug', () =>
  browser.onPage(async (page) => {
    await table(page)
    const whole = await outline(page)
    await tool(page, 'dig')
    await page.locator('#size').fill('0.8')
    await drag(page, [
      [8, 3],
      [9, 3],
      [11, 3],
    ])
    assert.deepEqual(await rocks(page), [1, 1])
    assert.match(await page.locator('#times').textContent(), /^stroke: /, 'times are those of strokes')
    assert.equal(await blockAt(page, 7, 5.5), 0)
    await page.evaluate(() => window.sandbox.step(5))
    const heights = await page.evaluate(() =>
      window.sandbox.game.sides.map((side) => window.sandbox.game.rocks.of(side)[0].body.getPosition().y),
    )
    assert.ok(heights.every((y) => y < 5 / 4), `${heights}`)
    assert.equal(await rest(page), 0)
    assert.deepEqual(await rocks(page), [0, 0])
    const islands = await page.evaluate(() => {
      const area = (v) => {
        let sum = 0
        for (let k = 0; k < v.length; k += 2) sum += v[k] * v[(k + 3) % v.length] - v[k + 1] * v[(k + 2) % v.length]
        return sum
      }
      return window.sandbox.game.ground.world.loops().filter((loop) => area(loop.vertices) > 0).length
    })
    assert.equal(islands, 1, 'it lies on the floor')
    const before = await outline(page)
    await edit(page, carve(0, 1, 20, 1.6))
    assert.notEqual(await outline(page), before, 'what lies can be dug')
    await page.keyboard.press('Control+z')
    assert.equal(await outline(page), before)
    await page.keyboard.press('Control+z')
    assert.equal(await outline(page), whole, 'with the stroke the fall is undone')
    assert.deepEqual(await rocks(page), [0, 0])
    await page.keyboard.press('Control+Shift+z')
    assert.deepEqual(await rocks(page), [1, 1], 'it falls again')
  }))

test('an undo of something else brings back who fell when it was done', () =>
  browser.onPage(async (page) => {
    await table(page)
    await edit(page, carve(8, 2, 11, 3))
    assert.deepEqual(await rocks(page), [1, 1])
    await page.evaluate(() => window.sandbox.step(10))
    await edit(page, carve(1, 0.5, 2, 1))
    assert.equal(await rest(page), 0)
    await page.keyboard.press('Control+z')
    assert.deepEqual(await rocks(page), [1, 1], 'it lies there, and is no ground yet')
    assert.equal(await rest(page), 0)
    await page.keyboard.press('Control+z')
    assert.equal(await blockAt(page, 7, 5.5), 1)
  }))

test('one world falls like two; what is painted in the air stays; who falls out of the world is gone', () =>
  browser.onPage(async (page) => {
    await table(page)
    await edit(page, carve(8, 2, 11, 3))
    await page.evaluate(() => window.sandbox.step(10))
    await page.locator('input[name=view][value=with]').check()
    assert.deepEqual(await rocks(page), [1])
    await page.locator('input[name=view][value=both]').check()
    assert.deepEqual(await rocks(page), [1, 1])
    const [a, b] = await page.evaluate(() =>
      window.sandbox.game.sides.map((side) => window.sandbox.game.rocks.of(side)[0].body.getPosition().y),
    )
    assert.equal(a, b)
    assert.equal(await rest(page), 0)
    await edit(page, paint(2, 8, 8, 9))
    assert.deepEqual(await rocks(page), [0, 0])
    await edit(page, carve(3, 7, 4, 10))
    assert.deepEqual(await rocks(page), [1, 1], 'the smaller part')
    assert.equal(await blockAt(page, 6, 8.5), 1)
    assert.equal(await rest(page), 0)
    await edit(page, paint(30, 0, 31, 6), paint(30, 5, 40, 6))
    await edit(page, carve(30, 4.5, 31, 7))
    assert.deepEqual(await rocks(page), [1, 1])
    assert.equal(await rest(page), 0)
    assert.equal(await blockAt(page, 35, 5.5), 0)
  }))
