// What one sees first: a rock that falls, where to dig, on a phone too, and which scene it is.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { openBrowser } from './browser.js'

let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

test('who comes for the first time sees a rock fall, and where to dig the next one; nothing of it is kept', () =>
  browser.onPath(
    async (page) => {
      await page.waitForFunction(() => window.sandbox.game.rocks.of(window.sandbox.game.sides[0]).length > 0)
      assert.ok(await page.locator('input[name=tool][value=dig]').isChecked())
      await page.waitForFunction(() => window.sandbox.game.rocks.of(window.sandbox.game.sides[0]).length === 0)
      assert.equal(await page.evaluate(() => localStorage.getItem('localgridseg-sandbox')), null)
      await page.mouse.move(500, 200)
      await page.mouse.down()
      await page.mouse.up()
      assert.equal(await page.evaluate(() => localStorage.getItem('localgridseg-welcomed')), 'yes')
    },
    '?welcome',
  ))

test('on a phone all targets are 44 pixels high, and nothing is beyond its sides', () =>
  browser.onPage(
    async (page) => {
      for (const more of [false, true]) {
        if (more) await page.locator('#more').click()
        const small = await page.evaluate(() =>
          [...document.querySelectorAll('#bar label, #bar button, #bar select, header button, nav a')]
            .filter((each) => each.offsetParent !== null)
            .map((each) => [each.textContent, each.getBoundingClientRect()])
            .filter(([, { height, left, right }]) => height < 43.5 || left < 0 || right > 390)
            .map(([text, { height, left, right }]) => `${text}: ${height} high, ${left} to ${right}`),
        )
        assert.deepEqual(small, [])
      }
    },
    { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
  ))

test('the menu says which scene is open', () =>
  browser.onPage(async (page) => {
    const shown = () => page.evaluate(() => document.querySelector('#scene').selectedOptions[0].textContent)
    assert.equal(await shown(), 'Hills')
    await page.locator('#scene').selectOption('cave')
    await page.waitForFunction(() => window.sandbox.game.ground.world.bounds().i0 === 0)
    assert.match(await shown(), /^Cave/)
    // Who is in the cave has the cave's roof above.
    const below = await page.evaluate(() => {
      const { game } = window.sandbox, { world } = game.ground, top = world.bounds().j1 + 1
      const hasRoof = ({ start: { x, y } }) => world.rayCast(x, y, x, top) !== null
      return game.sides[0].riders.filter(hasRoof).length / game.sides[0].riders.length
    })
    assert.ok(below > 0.8, `${below} of them`)
  }))
