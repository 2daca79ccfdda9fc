// The page in a real browser. The build must be there: npm run build -w sandbox
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { blockAt, click, drag, message, openBrowser, outline } from './browser.js'

let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

const kicks = (page) => page.evaluate(() => window.sandbox.kicks())
const step = (page, count) => page.evaluate((count) => window.sandbox.step(count), count)
const riders = (page) => page.evaluate(() => window.sandbox.game.sides.map((side) => side.riders.length))
const tool = (page, name) => page.locator(`input[name=tool][value=${name}]`).check()

test('the first second: two worlds, everything rolls, and only without ghosts there are kicks', () =>
  browser.onPage(async (page) => {
    assert.equal(await page.locator('.pane:visible').count(), 2)
    assert.match(await page.locator('#lead').textContent(), /seams/)
    const places = () => page.evaluate(() => window.sandbox.game.sides.map((side) => side.riders.map((rider) => rider.bodies[0].getPosition().x)))
    const [start] = await places()
    await step(page, 30)
    const [half] = await places()
    assert.ok(half.every((x, k) => x > start[k]), 'all riders move to the right')
    await step(page, 570)
    const [smooth, rough] = await kicks(page)
    assert.equal(smooth, 0)
    assert.ok(rough > 50, `${rough} kicks`)
    await page.waitForFunction((count) => document.querySelector('#pane-1 [data-count=kicks]').textContent === String(count), rough)
  }))

test('the clock runs by itself, pauses, and steps', () =>
  browser.onPage(async (page) => {
    const now = () => page.evaluate(() => window.sandbox.game.sides[0].kicks.step)
    await page.locator('#step').click()
    const begin = await now()
    await page.locator('#step').click()
    assert.equal(await now(), begin + 1)
    await page.locator('#play').click()
    await page.waitForFunction((from) => window.sandbox.game.sides[0].kicks.step > from + 20, begin)
    await page.locator('#slow').check()
    await page.locator('#play').click()
    assert.equal(await page.locator('#play').textContent(), 'Play')
  }))

test('dig, undo, redo', () =>
  browser.onPage(async (page) => {
    const before = await outline(page)
    assert.equal(await blockAt(page, 16, 4.2), 1)
    await drag(page, [[14, 5], [15, 4.5], [16, 4.2], [17, 4.1]])
    assert.equal(await blockAt(page, 16, 4.2), 0)
    const dug = await outline(page)
    assert.notEqual(dug, before)
    assert.match(await page.locator('#removed').textContent(), /^[1-9]\d* removed/)
    assert.match(await page.locator('#added').textContent(), /^[1-9]\d* added/)
    assert.match(await page.locator('#times').textContent(), /commit .*[µm]s/)
    await page.waitForFunction(() => /recompute.* ms/.test(document.getElementById('recompute').textContent))
    await page.locator('#undo').click()
    assert.equal(await outline(page), before)
    assert.ok(await page.locator('#undo').isDisabled())
    await page.locator('#redo').click()
    assert.equal(await outline(page), dug)
    await page.keyboard.press('Control+z')
    assert.equal(await outline(page), before)
    await page.keyboard.press('Control+Shift+z')
    assert.equal(await outline(page), dug)
  }))

test('paint with a material, put tiles, draw a polygon', () =>
  browser.onPage(async (page) => {
    await tool(page, 'paint')
    await page.locator('input[name=block][value="102"]').check()
    await drag(page, [[14, 7], [16, 7]])
    assert.equal(await blockAt(page, 15, 7), 102)
    await tool(page, 'tile')
    await page.locator('input[name=tile][value="1"]').check()
    await page.locator('#turn').click()
    await click(page, 20.5, 7.5)
    assert.equal(await blockAt(page, 20.2, 7.1), 0)
    assert.equal(await blockAt(page, 20.8, 7.9), 102)
    await page.locator('input[name=tile][value="-1"]').check()
    await click(page, 20.5, 7.5)
    assert.equal(await blockAt(page, 20.8, 7.9), 0)
    await tool(page, 'polygon')
    for (const [x, y] of [[30, 6], [34, 6], [34, 8]]) await click(page, x, y)
    await page.keyboard.press('Enter')
    assert.equal(await blockAt(page, 33, 6.5), 102)
    await page.locator('#check').click()
    await message(page, /is that of the full recompute/)
  }))

test('drop marbles, boxes and a car, and drive it', () =>
  browser.onPage(async (page) => {
    const [count] = await riders(page)
    for (const [k, kind] of ['marble', 'box', 'car'].entries()) {
      await tool(page, kind)
      await click(page, 14 + 4 * k, 7)
    }
    assert.deepEqual(await riders(page), [count + 3, count + 3])
    await page.locator('#empty').click()
    await tool(page, 'tile')
    await drag(page, Array.from({ length: 14 }, (_, k) => [k + 2.5, 0.5]))
    await tool(page, 'car')
    await click(page, 12, 2)
    const car = () => page.evaluate(() => window.sandbox.game.sides[0].riders.at(-1).bodies[0].getPosition().x)
    await page.locator('#pane-0 canvas').focus()
    await page.keyboard.down('ArrowLeft')
    const from = await car()
    await step(page, 240)
    assert.ok((await car()) < from)
    await page.keyboard.up('ArrowLeft')
    await page.locator('#landscape').click()
    assert.deepEqual(await riders(page), [count, count])
  }))

test('ghosts switched off in one world: kicks are counted', () =>
  browser.onPage(async (page) => {
    await page.locator('input[name=view][value=with]').check()
    assert.equal(await page.locator('.pane:visible').count(), 1)
    await step(page, 200)
    assert.deepEqual(await kicks(page), [0])
    await page.locator('input[name=view][value=without]').check()
    await step(page, 300)
    const [rough] = await kicks(page)
    assert.ok(rough > 10, `${rough} kicks`)
    await page.locator('input[name=view][value=both]').check()
    assert.equal(await page.locator('.pane:visible').count(), 2)
    const places = await page.evaluate(() => window.sandbox.game.sides.map((side) => side.riders.map((rider) => rider.bodies[0].getPosition().x)))
    assert.deepEqual(places[0], places[1])
  }))

const trace = `lgs-trace 1
add a 0 0 1  0 0  1 0  1 1  0 1
add b 1 0 2  0 0  1 0  0 1
commit
`

test('a trace is opened, copied, and dropped', () =>
  browser.onPage(async (page) => {
    await page.locator('#file').setInputFiles({ name: 'two.trace', mimeType: 'text/plain', buffer: Buffer.from(trace) })
    await message(page, /two\.trace: 2 polygons/)
    const opened = await outline(page)
    assert.equal(opened.split('\n').length, 5)
    await page.locator('#copy').click()
    await message(page, /copied/)
    const copy = await page.evaluate(() => navigator.clipboard.readText())
    assert.match(copy, /^lgs-trace \d/)
    await page.locator('#landscape').click()
    const data = await page.evaluateHandle((text) => {
      const transfer = new DataTransfer()
      transfer.items.add(new File([text], 'again.trace'))
      return transfer
    }, copy)
    await page.dispatchEvent('body', 'drop', { dataTransfer: data })
    await message(page, /again\.trace/)
    assert.equal(await outline(page), opened)
  }))

const maps = new URL('../../../examples/maps/', import.meta.url).pathname

test('maps of Tiled and LDtk are opened', () =>
  browser.onPage(async (page) => {
    for (const files of [['landscape.tmx', 'landscape.tsx'], ['cave.tmx', 'crate.tx'], ['quarry.ldtk']]) {
      await page.locator('#file').setInputFiles(files.map((name) => maps + name))
      await message(page, new RegExp(`${files[0]}: \\d\\d+ polygons`))
      await page.locator('#check').click()
      await message(page, /is that of the full recompute/)
    }
    await page.locator('#file').setInputFiles([`${maps}landscape.tmx`])
    await message(page, /landscape\.tsx/)
  }))

test('a bad file is refused in words, and changes nothing', () =>
  browser.onPage(async (page) => {
    const before = await outline(page)
    await page.locator('#file').setInputFiles({ name: 'bad.trace', mimeType: 'text/plain', buffer: Buffer.from('nonsense') })
    await message(page, /./)
    assert.equal(await outline(page), before)
  }))

test('share puts the ground into the address, and the address opens it', async () => {
  let hash
  let shared
  await browser.onPage(async (page) => {
    await drag(page, [[14, 5], [16, 4.2]])
    shared = await outline(page)
    await page.locator('#share').click()
    await message(page, /address/)
    hash = new URL(page.url()).hash
    assert.ok(hash.length < 8000, `${hash.length} characters`)
  })
  await browser.onPage(async (page) => assert.equal(await outline(page), shared), { hash })
  await browser.onPage((page) => message(page, /./), { hash: '#trace=damaged' })
})

test('the overlay tells about a segment', () =>
  browser.onPage(async (page) => {
    await page.locator('#overlay').check()
    const at = await page.evaluate(() => window.sandbox.toPage(16.5, 5))
    await page.mouse.move(at.x, at.y)
    await page.waitForFunction(() => !document.getElementById('inspector').hidden)
    const text = await page.locator('#inspector').textContent()
    assert.match(text, /cell \(16, 4\)/)
    assert.match(text, /predecessor \d+ .*ghost \(18, 5\)/)
    assert.match(text, /successor \d+ .*ghost \(15, 5\)/)
  }))

test('check finds a difference if there is one', () =>
  browser.onPage(async (page) => {
    await page.locator('#check').click()
    await message(page, /is that of the full recompute/)
    await page.evaluate(() => {
      const { world } = window.sandbox.game.ground
      const segments = world.segments.bind(world)
      world.segments = (cells) => {
        const list = segments(cells).copy()
        list.geometry[0] += 0.5 // a wrong outline
        return list
      }
    })
    await page.locator('#check').click()
    await message(page, /differs in \d+ places/)
  }))

test('everything by keyboard, and every control has a name', () =>
  browser.onPage(async (page) => {
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll('button, input, canvas')]
        .filter((each) => !(each.ariaLabel || each.textContent.trim() || each.labels?.[0]?.textContent.trim() || each.closest('[aria-label]')))
        .map((each) => each.outerHTML),
    )
    assert.deepEqual(nameless, [])
    const reached = new Set()
    for (let k = 0; k < 40; ++k) {
      await page.keyboard.press('Tab')
      reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.name || document.activeElement.tagName))
    }
    for (const id of ['CANVAS', 'tool', 'size', 'play', 'step', 'slow', 'restart', 'view', 'overlay', 'copy', 'share', 'open', 'check', 'help']) assert.ok(reached.has(id), id)
    await page.locator('#pane-0 canvas').focus()
    const before = await outline(page)
    await page.keyboard.press('d')
    await page.keyboard.press('Shift+ArrowLeft')
    for (let k = 0; k < 4; ++k) await page.keyboard.press('Shift+ArrowDown')
    await page.keyboard.press('Enter')
    assert.notEqual(await outline(page), before)
    await page.keyboard.press('?')
    assert.ok(await page.locator('#help-dialog').isVisible())
    await page.keyboard.press('Escape')
    for (const [key, name] of [['p', 'paint'], ['t', 'tile'], ['v', 'move'], ['c', 'car']]) {
      await page.keyboard.press(key)
      assert.ok(await page.locator(`input[name=tool][value=${name}]`).isChecked())
    }
  }))

test('a phone, the dark, and no motion', () =>
  browser.onPage(
    async (page) => {
      await step(page, 120)
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390)
      const at = await page.evaluate(() => window.sandbox.toPage(8, 5.5))
      const before = await outline(page)
      await page.touchscreen.tap(at.x, at.y)
      assert.notEqual(await outline(page), before)
    },
    { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, colorScheme: 'dark', reducedMotion: 'reduce' },
  ))
