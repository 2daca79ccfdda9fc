// What one sees first: the digger, on a phone, too.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { openBrowser } from './browser.js'
import { area, calm, cutAt, cutStem, lead, rocks, spot, tapBack } from './land.js'

let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

test('on a phone all targets are 44 pixels wide and high, and nothing is beyond its sides', () =>
  browser.onPage(
    async (page) => {
      for (const more of [false, true]) {
        if (more) await page.locator('#more').click()
        const small = await page.evaluate(() =>
          [...document.querySelectorAll('#bar label, #bar button, #bar select, header button, nav a')]
            .filter((each) => each.offsetParent !== null)
            .map((each) => [each.textContent, each.getBoundingClientRect()])
            .filter(([, { height, width, left, right }]) => height < 43.5 || width < 43.5 || left < 0 || right > innerWidth)
            .map(([text, { height, left, right }]) => `${text}: ${height} high, ${left} to ${right}`),
        )
        assert.deepEqual(small, [])
      }
    },
    { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
  ))

/** The page as who comes for the first time has it: a digger. */
const first = (test, context) => browser.onPath(test, '', { context })
const free = (page, cavern) => page.evaluate((cavern) => window.sandbox.digger.goal.crystals.count(cavern), cavern)
const isFree = (page, cavern, count) => page.waitForFunction(([cavern, count]) => window.sandbox.digger.goal.crystals.count(cavern) === count, [cavern, count])
const goTo = (page, x) => page.evaluate((x) => { window.sandbox.digger.picture.x = x }, x)

test('who comes first sees a hand that digs; whoever digs takes over, and the code beside is that which runs', () =>
  first(async (page) => {
    await isFree(page, 0, 1)
    assert.ok(await page.locator('#dig-race canvas').isVisible())
    assert.ok(!(await page.locator('#panes').isVisible()))
    await page.waitForFunction(() => document.querySelector('#dig-code code').textContent !== '')
    const code = await page.locator('#dig-code code').textContent()
    assert.equal(code, readFileSync(new URL('../../examples/digger.js', import.meta.url), 'utf8'))
    const lines = code.slice(code.indexOf('export async function'), code.indexOf('\nexport function land')).trim().split('\n')
    assert.ok(lines.length - 2 <= 20, `${lines.length - 2} lines`)
    await cutStem(page)
    assert.ok(await page.locator('#dig-hand').isHidden())
    assert.ok(await page.evaluate(() => document.getElementById('dig').clientHeight / window.sandbox.digger.size >= 24), 'the land is seen in its whole height')
    await page.locator('#dig-race').click()
    assert.ok(await page.locator('#race-dialog').isVisible())
  }, { viewport: { width: 1280, height: 800 } }))

test('a stem is cut, its cap falls and is ground again; a tap takes one dig back, and held, the button all', () =>
  first(async (page) => {
    const whole = await area(page)
    await cutStem(page)
    assert.equal(await rocks(page), 1)
    const cut = await area(page)
    assert.ok(cut < whole - 0.5 && cut > whole - 5, `${whole}, ${cut}`)
    await page.waitForFunction(() => window.sandbox.digger.ground.rocks().length === 0, null, { timeout: 60_000 })
    assert.ok(Math.abs((await area(page)) - cut) < 0.2)
    const { x, y } = await page.locator('#dig-back').boundingBox()
    await page.mouse.move(...(await spot(page, 14, 21)))
    await page.mouse.down()
    await page.mouse.move(...(await spot(page, 21, 21)), { steps: 60 }) // longer than a tap has frames
    await page.mouse.up()
    assert.ok((await area(page)) < cut - 3)
    await page.mouse.move(x + 9, y + 9)
    await tapBack(page)
    while (Math.abs((await area(page)) - cut) > 0.2) await page.waitForTimeout(50)
    await page.mouse.down()
    await page.waitForFunction(() => !window.sandbox.digger.ground.canUndo)
    await page.mouse.up()
    assert.ok(Math.abs((await area(page)) - whole) < 1e-6, `${await area(page)} and not ${whole}`)
  }, calm))

test('a crystal that is cut free breaks and is counted, its shards fly to its place, and it gets lighter; undo takes it back', () =>
  first(async (page) => {
    const whole = await area(page), full = () => page.locator('#dig-places .full').count()
    await page.locator('#dig-sound').check() // nothing of it throws
    await cutAt(page, 7, 16)
    await isFree(page, 0, 1)
    await page.waitForFunction(() => document.querySelectorAll('#dig-places .full').length === 1)
    assert.equal(await rocks(page), 0)
    assert.match(await page.locator('#dig-goal').getAttribute('aria-label'), /^1 crystal, 1 dig · par 7/)
    assert.match(await page.locator('#dig-carried').textContent(), /^Your crystal rolls home/)
    await tapBack(page)
    await isFree(page, 0, 0)
    await page.waitForFunction(() => document.querySelectorAll('#dig-places .full').length === 0)
    assert.equal(await full(), 0)
    await page.waitForFunction(() => !document.getElementById('digger').matches('.rewinds')) // of a dig's strokes one made it fall
    assert.ok(Math.abs((await area(page)) - whole) < 1e-6)
    await cutAt(page, 5, 20.8) // through gold
    await page.waitForFunction(() => document.getElementById('dig-gold').textContent === '1')
    await lead(page, 'Three pieces buy a boulder')
    await page.keyboard.down('z')
    await page.waitForFunction(() => document.getElementById('dig-gold').textContent === '0')
    await page.keyboard.up('z')
  }, calm))

test('a boulder breaks the crystal below it, in a cavern that counts its own; a tap goes back there, and nothing digs bedrock', () =>
  first(async (page) => {
    await goTo(page, 62)
    await page.waitForFunction(() => document.getElementById('dig-lead').textContent.includes('boulders'))
    const whole = await area(page, 1)
    await cutAt(page, 72, 16, 2)
    await isFree(page, 1, 1)
    await page.waitForFunction(() => document.querySelectorAll('#dig-places .full').length === 1)
    assert.equal(await free(page, 0), 0)
    await goTo(page, 0)
    await page.waitForFunction(() => document.querySelectorAll('#dig-places .full').length === 0)
    await tapBack(page)
    await isFree(page, 1, 0)
    await page.waitForFunction(() => !document.getElementById('digger').matches('.rewinds'))
    const seen = await page.evaluate(() => window.sandbox.digger.picture.x)
    assert.ok(seen > 15 && seen < 72, `it acts where one sees it: ${seen}`)
    await goTo(page, 62)
    await page.waitForFunction(() => window.sandbox.digger.ground.rocks().length === 0)
    await page.waitForTimeout(300)
    assert.ok(Math.abs((await area(page, 1)) - whole) < 1e-6)
    const bedrock = () => page.evaluate(() => [0.5, 23.5].every((y) => window.sandbox.digger.ground.world.at(90.3, y).block === 2))
    for (const y of [0.5, 23.5]) await cutAt(page, 90, y)
    assert.ok((await area(page, 1)) < whole - 1)
    assert.ok(await bedrock())
  }, calm))

/** What became of what fell, from now on. */
const noteHits = (page) => page.evaluate(() => {
  const { crystals } = window.sandbox.digger.goal, step = crystals.step.bind(crystals)
  window.hits = []
  crystals.step = (...all) => {
    const hits = step(...all)
    window.hits.push(...hits.map(({ what }) => what))
    return hits
  }
})
const falls = (page) => page.evaluate(() => window.sandbox.digger.goal.crystals.falls(20).filter(({ from: [x] }) => x > 0 && x < 64).map(({ what }) => what))

test('a crystal that falls low stays whole, and the page says why; over a pit it bursts, as its line shows', () =>
  first(async (page) => {
    assert.deepEqual((await falls(page)).sort(), ['bursts', 'bursts', 'is thrown up', 'stays whole'])
    await cutAt(page, 41, 13)
    await lead(page, 'too short')
    assert.equal(await free(page, 0), 0)
    await tapBack(page)
    await page.waitForFunction(() => !window.sandbox.digger.ground.canUndo)
    await cutAt(page, 41, 3.2, 2.6) // down from the floor, which is at 3.7
    assert.ok(!(await falls(page)).includes('stays whole'))
    await cutAt(page, 41, 13)
    await isFree(page, 0, 1)
    assert.equal(await page.locator('#dig-score').textContent(), '2 digs · par 7')
  }, calm))

test('a cut that is not through is told, and a ring shows what still holds; a rope, too', () =>
  first(async (page) => {
    const rings = () => page.evaluate(() => window.sandbox.digger.goal.rings.map((at) => at.map(Math.round)))
    await cutAt(page, 12.9, 17.4, 0.3)
    await lead(page, 'Not through yet')
    assert.deepEqual(await rings(), [[14, 17]])
    await cutAt(page, 14.5, 17.4)
    await isFree(page, 0, 1)
    assert.deepEqual(await rings(), [])
    await cutAt(page, 23, 16, 2) // the left rope of two
    const [[x], ...more] = await rings()
    assert.ok(x > 26 && more.length === 0, `${x}`)
    await cutAt(page, 3, 10, 1) // where nothing hangs
    assert.deepEqual(await rings(), [])
  }, calm))

test('a mushroom throws a crystal up, and does not break it; it bursts where it comes down', () =>
  first(async (page) => {
    await noteHits(page)
    await cutAt(page, 14, 17.4)
    await page.waitForFunction(() => window.hits.includes('is thrown up'))
    await isFree(page, 0, 1)
    assert.ok(await page.evaluate(() => window.hits.indexOf('is thrown up') < window.hits.indexOf('burst')))
  }, calm))

test('three pieces of gold buy a boulder, which falls where one taps if there is room; a tap back gives the gold back', () =>
  first(async (page) => {
    const gold = async () => parseInt(await page.locator('#dig-gold').textContent())
    assert.equal(await page.locator('#dig-boulder').getAttribute('aria-disabled'), 'true')
    await cutAt(page, 14.5, 20.6, 11)
    await page.waitForFunction(() => parseInt(document.getElementById('dig-gold').textContent) >= 3)
    const before = await gold(), digs = await page.locator('#dig-score').textContent()
    assert.ok(parseInt(digs) >= 2, `a dig is no longer than 8 cells: ${digs}`)
    await page.locator('#dig-boulder').click()
    await lead(page, 'Tap where')
    await page.mouse.click(...(await spot(page, 32, 21)))
    assert.equal(await rocks(page), 0)
    await noteHits(page)
    await page.mouse.click(...(await spot(page, 46, 12)))
    assert.equal(await rocks(page), 1)
    await page.waitForFunction((left) => parseInt(document.getElementById('dig-gold').textContent) === left, before - 3)
    assert.equal(await page.locator('#dig-score').textContent(), digs)
    await page.waitForFunction(() => window.hits.includes('lands'))
    await tapBack(page)
    await page.waitForFunction((all) => parseInt(document.getElementById('dig-gold').textContent) === all, before)
    assert.equal(await rocks(page), 0)
  }, calm))

test('a cavern can be begun again, with what was best; what was done is there the next time, also after all tools', () =>
  browser.onPath(async (page) => {
    const whole = await area(page), score = () => page.locator('#dig-score').textContent()
    await cutAt(page, 7, 16)
    await isFree(page, 0, 1)
    await page.waitForFunction(() => document.getElementById('dig-carried').textContent === 'Your crystal rolls home.')
    await page.locator('#dig-again').click()
    await isFree(page, 0, 0)
    assert.ok(Math.abs((await area(page)) - whole) < 1e-6)
    await page.waitForFunction(() => document.getElementById('dig-carried').textContent === '')
    await page.waitForFunction(() => document.getElementById('dig-score').textContent === '0 digs · par 7')
    await cutAt(page, 7, 16)
    await isFree(page, 0, 1)
    const left = await area(page), said = await score()
    await page.waitForFunction(() => JSON.parse(localStorage.getItem('localgridseg-digger-1'))?.winnings.won.length === 1)
    await page.locator('#dig-more').focus()
    await page.keyboard.press('Enter')
    await page.waitForSelector('#pane-0 canvas:focus') // keys go there now
    await page.goto(page.url().replace(/#.*/, ''))
    await page.reload()
    await page.waitForSelector('body[data-ready]')
    assert.ok(await page.locator('#dig').isVisible())
    assert.equal(await free(page, 0), 1)
    await page.waitForFunction((said) => document.getElementById('dig-score').textContent === said, said)
    assert.equal(await page.locator('#dig-places .full').count(), 1)
    assert.ok(Math.abs((await area(page)) - left) < 1e-6)
  }, '?keep', { context: calm }))

for (const [width, height] of [[1280, 800], [390, 844], [844, 390]])
  test(`at ${width} x ${height} nothing covers the land but the ways to walk, and all is seen that there is room for`, () =>
    first(async (page) => {
      const { top, bottom, bars } = await page.evaluate(() => {
        const { picture, size } = window.sandbox.digger, { bottom } = document.getElementById('dig').getBoundingClientRect()
        const bars = [...document.querySelectorAll('#dig-top > *, #dig-buttons > *')].map((each) => each.getBoundingClientRect().toJSON())
        return { top: bottom - (24 - picture.y) * size, bottom: bottom + picture.y * size, bars: bars.filter(({ width }) => width > 0) }
      })
      assert.ok(bottom - top > height / 3, `${bottom - top}`)
      for (const [k, a] of bars.entries()) for (const b of bars.slice(k + 1)) assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, JSON.stringify({ a, b }))
      for (const bar of bars) assert.ok(bar.bottom <= top + 1 || bar.top >= bottom - 1, JSON.stringify({ top, bottom, bar }))
      if (width < 1000) return
      await page.waitForFunction(() => window.sandbox.digger.goal.crystals.glowing.filter(([x]) => x > 0 && x < 64).length === 5)
      const seen = await page.evaluate(() => {
        const { goal, picture } = window.sandbox.digger, { i0, i1 } = picture.cells
        return goal.crystals.glowing.filter(([x]) => x > 0 && x < 64).map(([x]) => x - 2 > i0 && x + 2 < i1)
      })
      assert.deepEqual(seen, [true, true, true, true, true])
    }, { ...calm, viewport: { width, height } }))

test('by keys: arrows walk; with Shift they move a cursor, Enter digs, Z undoes', () =>
  first(async (page) => {
    const last = () => page.evaluate(() => window.sandbox.digger.ground.world.bounds().i1), before = await last()
    await page.keyboard.down('ArrowRight')
    await page.waitForFunction((before) => window.sandbox.digger.ground.world.bounds().i1 > before, before)
    await page.keyboard.up('ArrowRight')
    assert.ok(await page.locator('#dig-hand').isHidden())
    for (let k = 0; k < 30; ++k) await page.keyboard.press('Shift+ArrowDown')
    await page.keyboard.press('Enter')
    assert.ok(await page.evaluate(() => window.sandbox.digger.ground.canUndo))
    await page.keyboard.down('z')
    await page.waitForFunction(() => !window.sandbox.digger.ground.canUndo)
    await page.evaluate(() => dispatchEvent(new Event('blur'))) // the key is let go elsewhere
    await page.keyboard.press('Enter')
    await page.waitForTimeout(200)
    assert.ok(await page.evaluate(() => window.sandbox.digger.ground.canUndo))
    await page.keyboard.up('z')
  }, calm))

test('before any code is there one sees the place of the digger, and not that of all tools', () =>
  browser.onPath(async (page) => assert.ok(await page.evaluate(() => window.early)), '', { before: (page) =>
    page.route('**/main.js', async (route) => {
      await page.waitForSelector('#dig-more')
      await page.evaluate(() => { window.early = document.getElementById('dig').offsetParent !== null && document.getElementById('panes').offsetParent === null })
      await route.continue()
    }) }))

test('on a phone: targets of 44 pixels, nothing beyond its sides; and all tools are one touch away', () =>
  first(async (page) => {
    const small = await page.evaluate(() =>
      [...document.querySelectorAll('#digger button, #digger label, header button, nav a')]
        .filter((each) => each.offsetParent !== null)
        .map((each) => [each.textContent, each.getBoundingClientRect()])
        .filter(([, { height, width, left, right }]) => height < 43.5 || width < 43.5 || left < 0 || right > 390)
        .map(([text, { height, left, right }]) => `${text}: ${height} high, ${left} to ${right}`))
    assert.deepEqual(small, [])
    await page.locator('#dig-show').check()
    assert.ok(await page.locator('#dig-code pre').isVisible())
    await page.locator('#dig-show').uncheck()
    await cutStem(page)
    assert.equal(await rocks(page), 1)
    const last = () => page.evaluate(() => window.sandbox.digger.ground.world.bounds().i1)
    const { x, y } = await page.locator('#dig-right').boundingBox(), before = await last()
    await page.mouse.move(x + 9, y + 9)
    await page.mouse.down() // and so one walks
    await page.waitForFunction((before) => window.sandbox.digger.ground.world.bounds().i1 > before, before)
    await page.mouse.up()
    const view = () => page.evaluate(() => window.sandbox.digger.picture.x), from = await view()
    await page.locator('#dig-left').tap() // and a tap is a view, not a step
    await page.waitForFunction((from) => window.sandbox.digger.picture.x < from - 5, from)
    await page.locator('#dig-more').tap()
    await page.locator('#pane-0').waitFor()
    assert.ok(await page.locator('#digger').isHidden())
  }, { ...calm, viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }))
