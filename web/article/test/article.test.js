// The article in a real browser. The build must be there: npm run build -w sandbox -w article
import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { gzipSync } from 'node:zlib'
import { openBrowser } from '../../sandbox/test/browser.js'

let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

const names = ['seams', 'ghosts', 'cuts', 'cancel', 'cells', 'fan', 'touch', 'million', 'rounding', 'proof']
const calm = { context: { viewport: { width: 320, height: 700 }, reducedMotion: 'reduce', colorScheme: 'dark', hasTouch: true, isMobile: true } }
const says = (page, name) => page.locator(`#${name} output`).textContent()
const saysSoon = (page, name, pattern) =>
  page.waitForFunction(
    ([name, source]) => new RegExp(source).test(document.querySelector(`#${name} output`).textContent),
    [name, pattern.source],
  )
const handle = (page, name, k = 0) => page.locator(`#${name} .handle`).nth(k)
const press = (page, name, text) => page.locator(`#${name} button`, { hasText: text }).click()

/** Drags a handle by some cells of its figure. */
async function drag(page, name, dx, dy, k = 0) {
  await page.locator(`#${name} svg`).scrollIntoViewIfNeeded()
  const box = await handle(page, name, k).locator('.hit').boundingBox()
  const unit = await page.locator(`#${name} svg`).evaluate((svg) => svg.getScreenCTM().a)
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(x + (dx * unit) / 2, y - (dy * unit) / 2)
  await page.mouse.move(x + dx * unit, y - dy * unit)
  await page.mouse.up()
}

test('each of the ten figures answers to the mouse and to the arrow keys', () =>
  browser.onPath(async (page) => {
    assert.deepEqual(await page.locator('figure[data-ready]').evaluateAll((all) => all.map(({ id }) => id)), names)
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320)
    await page.locator('#million').scrollIntoViewIfNeeded()
    await saysSoon(page, 'million', /Drag to dig/)
    const ways = { seams: [3, 0], cuts: [0, 0.3], cancel: [-1, 0], cells: [1, 0], fan: [0.2, 0.3], touch: [1, 0] }
    for (const name of names) {
      const state = () => page.locator(`#${name}`).evaluate((figure) => figure.querySelector('svg').innerHTML)
      const before = await state()
      await drag(page, name, ...(ways[name] ?? [0.5, 0.3]))
      const dragged = await state()
      assert.notEqual(dragged, before, `${name}: dragged`)
      await handle(page, name).focus()
      await page.keyboard.press('ArrowLeft')
      assert.notEqual(await state(), dragged, `${name}: by key`)
    }
  }, 'article/', calm))

test('without ghosts the ball is thrown into the air, twice, and loses speed; with them it glides', () =>
  browser.onPath(async (page) => {
    await saysSoon(page, 'seams', /^Without: 1 kick, 7\.\d cells\/s\. With: 0 kicks, 8\.6/)
    assert.match(await page.locator('#seams svg').textContent(), /Without ghost vertices: 1 kick.*With ghost vertices: 0 kicks/)
    assert.equal(await page.locator('#seams .push.wrong').count(), 1, 'an arrow shows the kick')
    assert.match(await page.locator('#seams svg').textContent(), /the ball hits the end of the next edge.*ghost vertex: the floor goes on/)
    assert.ok((await page.locator('#seams .seam').count()) > 8)
    await drag(page, 'seams', 12, 0)
    const [, kicks, slow] = /^Without: (\d) kicks, (\d\.\d) cells\/s\. With: 0 kicks, 8\.6 cells\/s\.$/.exec(await says(page, 'seams'))
    assert.ok(kicks >= 3 && slow < 6.5, `${kicks} kicks, ${slow}`)
    const highest = await page.locator('#seams .way.rough').evaluate((way) => way.getBBox().height)
    assert.ok(highest > 0.3, `${highest} cells`)
    await page.locator('#seams input').fill('3')
    assert.match(await says(page, 'seams'), /^Without: 0 kicks, 3\.0 .* With: 0 kicks, 3\.0/)
    await drag(page, 'seams', 12, 0)
    assert.match(await says(page, 'seams'), /^Without: [1-9] kicks, 2\.\d .* With: 0 kicks, 3\.0/)
    assert.ok((await page.locator('#seams .way.smooth').evaluate((way) => way.getBBox().height)) < 0.02)
  }, 'article/'))

test('at a seam the ball is pushed askew without ghosts; it rolls by itself, until somebody takes it', () =>
  browser.onPath(async (page) => {
    await page.locator('#ghosts svg').scrollIntoViewIfNeeded()
    await saysSoon(page, 'ghosts', /pushes twice: straight up, and back/)
    await page.waitForFunction(() => document.querySelector('#ghosts input').checked)
    await page.locator('#ghosts input').uncheck()
    await handle(page, 'ghosts').focus()
    for (let k = 0; k < 60 && !/back/.test(await says(page, 'ghosts')); ++k) await page.keyboard.press('ArrowLeft')
    assert.match(await says(page, 'ghosts'), /pushes twice: straight up, and back/)
    const words = () => page.locator('#ghosts svg').textContent()
    assert.match(await words(), /its edge.*rolls.*the ball hits the end of the next edge.*pushes back.*pushes up/)
    await page.locator('#ghosts input').check()
    assert.match(await says(page, 'ghosts'), /pushes once: straight up/)
    assert.match(await words(), /ghost vertexghost vertex.*pushes up/)
    assert.doesNotMatch(await words(), /back/)
    assert.equal(await page.locator('#ghosts button').textContent(), 'Play')
  }, 'article/'))

for (const width of [320, 1000])
  test(`at ${width} pixels no words of the second figure are on others, or cut off; its edges have no heads`, () =>
    browser.onPath(async (page) => {
      await page.locator('#ghosts svg').scrollIntoViewIfNeeded()
      for (const isOn of [false, true]) {
        await page.locator('#ghosts input').setChecked(isOn)
        await handle(page, 'ghosts').focus()
        for (let k = 0; k < 60; ++k) {
          await page.keyboard.press(isOn ? 'ArrowLeft' : 'ArrowRight')
          const { boxes, frame } = await page.locator('#ghosts svg').evaluate((svg) => ({
            frame: svg.getBoundingClientRect().toJSON(),
            boxes: [...svg.querySelectorAll('.label')].map((each) => ({ text: each.textContent, ...each.getBoundingClientRect().toJSON() })),
          }))
          for (const [n, a] of boxes.entries()) {
            assert.ok(a.left >= frame.left - 1 && a.right <= frame.right + 1, JSON.stringify(a))
            for (const b of boxes.slice(n + 1)) assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top + 4 || b.bottom <= a.top + 4, JSON.stringify({ a, b }))
          }
        }
      }
      assert.ok((await page.locator('#ghosts .chosen').getAttribute('d')).split('M').length === 2)
    }, 'article/', { context: { viewport: { width, height: 700 }, reducedMotion: 'reduce' } }))

test('what was dragged stands for a while, and goes on', () =>
  browser.onPath(async (page) => {
    await saysSoon(page, 'seams', /^Without: 1 kick/)
    await drag(page, 'seams', 12, 0)
    const dragged = await says(page, 'seams')
    await page.waitForTimeout(1000)
    assert.equal(await says(page, 'seams'), dragged)
    assert.equal(await page.locator('#seams button').textContent(), 'Pause')
    await page.waitForFunction((dragged) => document.querySelector('#seams output').textContent !== dragged, dragged)
  }, 'article/'))

test('a finger drags the ball all the way, and the page does not scroll instead', () =>
  browser.onPath(async (page) => {
    await page.locator('#ghosts svg').scrollIntoViewIfNeeded()
    const session = await page.context().newCDPSession(page)
    const touch = (type, ...points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y]) => ({ x, y })) })
    const { x, y, width, height } = await handle(page, 'ghosts').locator('.hit').boundingBox(), from = [x + width / 2, y + height / 2]
    await touch('touchStart', from)
    for (let k = 1; k <= 8; ++k) await touch('touchMove', [from[0] + 5 * k, from[1]])
    await touch('touchEnd')
    const { x: to } = await handle(page, 'ghosts').locator('.hit').boundingBox()
    assert.ok(Math.abs(to - x - 40) < 2, `${to - x} pixels of 40`)
  }, 'article/', calm))

test('law 1: a tip cuts the wall, a tile cancels its neighbours\' edges', () =>
  browser.onPath(async (page) => {
    assert.match(await says(page, 'cuts'), /touches the wall: the wall is 2 pieces/)
    await drag(page, 'cuts', 0.5, 0)
    assert.match(await says(page, 'cuts'), /free: the wall is 1 piece\./)
    assert.match(await says(page, 'cancel'), /^3 pairs.* 14 segments left/)
    await drag(page, 'cancel', -2, -1)
    assert.match(await says(page, 'cancel'), /^5 pairs.* 10 segments left/)
    await page.locator('#cancel input').check()
    assert.match(await says(page, 'cancel'), /^5 pairs/)
  }, 'article/', { context: { reducedMotion: 'reduce' } }))

test('what is outside of the 3x3 changes nothing in the cell', () =>
  browser.onPath(async (page) => {
    for (let k = 0; k < 20; ++k) await press(page, 'cells', 'outside')
    assert.match(await says(page, 'cells'), /Shuffled 20 times: nothing/)
    for (let k = 0; k < 6; ++k) await press(page, 'cells', 'neighbours')
    assert.doesNotMatch(await says(page, 'cells'), /Shuffled 6 times/)
  }, 'article/', { context: { reducedMotion: 'reduce' } }))

test('law 2: the hand stops at the successor and at the predecessor, and a walk leads through the free wedge', () =>
  browser.onPath(async (page) => {
    await drag(page, 'fan', -0.6, -0.05, 6)
    const degrees = async () => Number(/After (\d+) degrees the hand meets a segment\. It is the (?:suc|prede)cessor/.exec(await says(page, 'fan'))[1])
    const before = await degrees()
    await page.getByLabel('The upper left wedge').uncheck() // without the wedge there the next one is met
    await drag(page, 'fan', -0.6, -0.9, 6)
    assert.ok((await degrees()) > before)
    assert.match(await says(page, 'fan'), /successor/)
    await page.getByLabel('Predecessor').check()
    assert.match(await says(page, 'fan'), /has met no segment yet/)
    await drag(page, 'fan', -0.6, -0.36, 6)
    assert.equal(await degrees(), 114)
    assert.match(await says(page, 'fan'), /predecessor/)
    assert.match(await says(page, 'touch'), /in one point.*1 closed loop/)
    await drag(page, 'touch', 1, 0)
    assert.match(await says(page, 'touch'), /2 closed loops/)
  }, 'article/', { context: { reducedMotion: 'reduce' } }))

test('a dig in a million cells, and a vertex under the lens', () =>
  browser.onPath(async (page) => {
    await page.locator('#million').scrollIntoViewIfNeeded()
    await saysSoon(page, 'million', /Drag to dig/)
    await press(page, 'million', 'Dig here')
    const dug = /reached [1-9] cells; .* of a million cells\. \d+ segments? removed, [1-9]\d* added/
    assert.match(await says(page, 'million'), dug)
    const mine = await says(page, 'million')
    await handle(page, 'million').focus() // Enter on the grip digs, and so does a tap on it
    await page.keyboard.press('ArrowRight')
    await page.keyboard.press('Enter')
    const entered = await says(page, 'million')
    assert.notEqual(entered, mine)
    assert.match(entered, dug)
    const grip = await handle(page, 'million').locator('.hit').boundingBox()
    await page.mouse.click(grip.x + grip.width / 2 + 15, grip.y + grip.height / 2)
    assert.notEqual(await says(page, 'million'), entered)
    assert.match(await says(page, 'million'), dug)
    const off = async () => Math.max(...(await says(page, 'rounding')).match(/\d\.\d+(?= units)/g))
    for (let k = 0; k < 5; ++k) {
      await drag(page, 'rounding', 0.037, 0.053, 2)
      assert.ok((await off()) <= 1)
    }
  }, 'article/', { context: { reducedMotion: 'reduce' } }))

test('a drag digs in a million cells, and specks fly', () =>
  browser.onPath(async (page) => {
    await page.locator('#million svg').scrollIntoViewIfNeeded()
    await saysSoon(page, 'million', /Drag to dig/)
    const { x, y, width, height } = await page.locator('#million svg').boundingBox()
    const rock = () => page.locator('#million .ground').evaluateAll((all) => all.map((each) => each.getAttribute('d')).join())
    const seen = [await rock()]
    await page.mouse.move(x + 0.06 * width, y + 0.88 * height)
    await page.mouse.down()
    for (const k of [1, 2, 3]) {
      await page.mouse.move(x + (0.06 + 0.06 * k) * width, y + 0.88 * height)
      seen.push(await rock())
    }
    assert.equal(new Set(seen).size, 4, 'each move digs')
    assert.ok((await page.locator('#million .speck').count()) > 0)
    await page.mouse.up()
    await page.mouse.move(x + 0.4 * width, y + 0.88 * height)
    assert.equal(await rock(), seen[3])
  }, 'article/'))

test('the engine agrees with the reference; with a planted bug it does not, and what fails is made small', () =>
  browser.onPath(async (page) => {
    await press(page, 'proof', 'Test it')
    await saysSoon(page, 'proof', /200 random worlds, and the engine agreed/)
    await page.locator('#proof input').check()
    await press(page, 'proof', 'Test it')
    await saysSoon(page, 'proof', /are enough\. The same segments, but \d+ have another ghost/)
    const [, before, after] = /Of its (\d+) polygons these (\d+)/.exec(await says(page, 'proof'))
    assert.ok(Number(before) > 5 && Number(after) <= 4, `${before} to ${after}`)
  }, 'article/'))

test('a figure that cannot start leaves the others alone', () =>
  browser.onPath(async (page) => {
    assert.match(await page.locator('#proof .stage').textContent(), /could not start/)
    assert.equal(await page.locator('figure[data-ready]').count(), 9)
  }, 'article/', { before: (page) => page.route('**/reference.wasm', (route) => route.abort()), wrongs: [/ERR_FAILED/] }))

test('all of it weighs at most 470 kB with gzip, 190 of them the engine, for speed', () => {
  const folder = new URL('../../sandbox/dist/article/', import.meta.url)
  const sizes = readdirSync(folder).map((file) => gzipSync(readFileSync(new URL(file, folder)), { level: 9 }).length)
  const total = sizes.reduce((a, b) => a + b, 0)
  console.log(`the article: ${(total / 1000).toFixed(0)} kB`)
  assert.ok(total <= 470_000, `${total} bytes`)
})
