// What still hangs, and what is not paid for: the digger says so.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { openBrowser } from './browser.js'
import { calm, cutAt, lead, rocks, spot } from './land.js'

let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

const first = (test, context) => browser.onPath(test, '', { context: { ...calm, ...context } })
const gold = async (page) => parseInt(await page.locator('#dig-gold').textContent())
const rings = (page) => page.evaluate(() => window.sandbox.digger.goal.rings.map(([x]) => Math.round(x)))
/** A drag between two points of the page. */
async function drag(page, [x0, y0], [x1, y1]) {
  await page.mouse.move(x0, y0)
  await page.mouse.down()
  await page.mouse.move(x1, y1, { steps: 8 })
  await page.mouse.up()
}

test('gold that a rewind takes back buys no boulder: it is disarmed', () =>
  first(async (page) => {
    await cutAt(page, 14.5, 20.6, 11)
    await page.waitForFunction(() => parseInt(document.getElementById('dig-gold').textContent) >= 3)
    await page.locator('#dig-boulder').click()
    await lead(page, 'Tap where')
    await page.keyboard.down('z')
    await page.waitForFunction(() => parseInt(document.getElementById('dig-gold').textContent) < 3)
    await page.keyboard.up('z')
    await page.waitForFunction(() => !document.getElementById('digger').matches('.rewinds'))
    const left = await gold(page)
    assert.ok(await page.evaluate(() => !document.getElementById('digger').matches('.places')), 'it is disarmed')
    await page.mouse.click(...(await spot(page, 46, 12)))
    await page.waitForTimeout(200)
    assert.equal(await rocks(page), 0)
    assert.equal(await gold(page), left)
  }))

test('a dig that does not cut a crystal loose says where it hangs, however it was cut before', () =>
  first(async (page) => {
    await drag(page, [516, 318], [550, 320])
    await lead(page, 'Not through yet')
    const [ring] = await rings(page)
    assert.ok(ring > 15 && ring < 32, `${ring}`)
    await drag(page, [440, 250], [500, 250])
    await lead(page, 'Not through yet')
    assert.ok((await rings(page)).length > 0)
    assert.equal(await rocks(page), 0)
  }, { viewport: { width: 1280, height: 800 } }))

for (const [width, height] of [[1280, 800], [390, 844], [844, 390]])
  test(`at ${width} x ${height} a boulder without gold is told what it costs, and a finger sees it`, () =>
    first(async (page) => {
      await page.locator('#dig-boulder').tap({ force: true })
      await lead(page, '3 gold needed: dig the yellow diamonds')
      const { x, width: wide } = await page.locator('#dig-lead strong').boundingBox()
      assert.ok(x >= 0 && x + wide <= width, `${x}, ${wide}`)
      assert.ok(!(await page.locator('#digger').getAttribute('class'))?.includes('places'))
    }, { viewport: { width, height }, hasTouch: true, isMobile: width < 1000 }))
