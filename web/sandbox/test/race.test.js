// The race. In a real browser; the build must be there: npm run build -w sandbox
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { openBrowser } from './browser.js'

let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

const run = (page) => page.evaluate(() => window.sandbox.race.step(400, 0))

test('the wheel with ghosts wins clearly, and the page says so', () =>
  browser.onPage(async (page) => {
    await page.locator('#race').click()
    await page.evaluate(() => {
      const { fillText } = CanvasRenderingContext2D.prototype
      window.written = new Set()
      CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
        window.written.add(text)
        return fillText.call(this, text, ...rest)
      }
    })
    await run(page)
    const written = await page.evaluate(() => [...window.written].join('; '))
    for (const word of [/Speed along the track/, /cells a second/, /distance in cells/, /finish/, /Each kick costs speed: 5\.\d is left of 7\.\d/, /first kick/, /ghost vertex: the floor goes on/, /hits the end of the next edge/, /^.*; kick;/]) assert.match(written, word)
    const { times, kicks, replay } = await page.evaluate(() => {
      const { lanes } = window.sandbox.race.race
      return { times: lanes.map(({ time }) => time), kicks: lanes.map(({ kicks }) => kicks.length), replay: lanes[1].replay.length }
    })
    assert.equal(kicks[0], 0)
    assert.ok(kicks[1] >= 5, `${kicks[1]} kicks`)
    assert.ok(times[0] < 5 && times[1] > times[0] + 0.5, `${times}`)
    assert.ok(replay > 10, 'the lens has a kick to show')
    assert.match(await page.locator('#race-result').textContent(), /With ghost vertices: \d\.\d\d s\. Without: .* \d\.\d\d s later, after \d+ kicks/)
    await page.locator('#race-again').click()
    assert.equal(await page.evaluate(() => window.sandbox.race.race.lanes[0].time), null)
    await page.locator('#race-close').click()
    await page.waitForFunction(() => window.sandbox.race.race === null) // a dialog says so a little later
  }))

test('a link opens it; without motion its end is there at once', () =>
  browser.onPage(
    async (page) => {
      assert.match(await page.locator('#race-result').textContent(), /later, after/)
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390)
    },
    { hash: '#race', context: { viewport: { width: 390, height: 844 }, reducedMotion: 'reduce', hasTouch: true, isMobile: true } },
  ))

test('the strip below the digger says whose kicks they are, and what the rings are; its caption, what the library does', () =>
  browser.onPath(
    async (page) => {
      const written = () => page.evaluate(() => [...window.written].join('; '))
      for (const word of ['With ghost vertices:', 'Without:', 'ghost vertex: the floor goes on']) await page.waitForFunction((word) => window.written.has(word), word)
      assert.doesNotMatch(await written(), /[○●]/)
      assert.match(await page.locator('#dig-race figcaption').textContent(), /Every cut makes new seams; LocalGridSeg keeps the ghost vertices right after each\./)
      assert.ok(await page.locator('#what').isVisible(), 'what it is stands below the name')
    },
    '',
    {
      context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
      before: (page) => page.addInitScript(() => {
        const { fillText } = CanvasRenderingContext2D.prototype
        window.written = new Set()
        CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
          window.written.add(text)
          return fillText.call(this, text, ...rest)
        }
      }),
    },
  ))
