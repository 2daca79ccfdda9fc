// Editing and looking, by mouse, keyboard and touch.
// In a real browser; the build must be there: npm run build -w sandbox
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { blockAt, click, drag, message, openBrowser, outline } from './browser.js'

let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

const step = (page, count) => page.evaluate((count) => window.sandbox.step(count), count)
const scene = (page, name) => page.locator('#scene').selectOption(name)
const tool = (page, name) => page.locator(`input[name=tool][value=${name}]`).check()

test('dig, undo, redo', () =>
  browser.onPage(async (page) => {
    await tool(page, 'dig')
    const before = await outline(page)
    assert.equal(await blockAt(page, 16, 4.2), 1)
    await drag(page, [[14, 5], [15, 4.5], [16, 4.2], [17, 4.1]])
    assert.equal(await blockAt(page, 16, 4.2), 0)
    const dug = await outline(page)
    assert.notEqual(dug, before)
    assert.match(await page.locator('#removed').textContent(), /^[1-9]\d* removed/)
    assert.match(await page.locator('#added').textContent(), /^[1-9]\d* added/)
    assert.match(await page.locator('#times').textContent(), /^stroke: .*commit .*[µm]s/)
    await page.locator('#undo').click()
    assert.equal(await outline(page), before)
    assert.ok(await page.locator('#undo').isDisabled())
    await page.locator('#redo').click()
    assert.equal(await outline(page), dug)
    await page.keyboard.press('Control+z')
    assert.equal(await outline(page), before)
    await page.keyboard.press('Control+Shift+z')
    assert.equal(await outline(page), dug)
    await page.keyboard.press('z')
    assert.equal(await outline(page), before)
  }))

for (const [width, height] of [[1280, 800], [390, 844]])
  test(`at ${width} x ${height} no panel covers a world, and what the edit did is not cut off`, () =>
    browser.onPage(async (page) => {
      await tool(page, 'paint')
      await page.locator('#more').click()
      const boxes = (selector) => page.locator(selector).evaluateAll((all) => all.map((each) => each.getBoundingClientRect().toJSON()).filter(({ width }) => width > 0))
      const panes = await boxes('.pane'), bars = await boxes('#options, #bar, #facts')
      assert.equal(panes.length, 2)
      for (const pane of panes) for (const bar of bars) assert.ok(bar.top >= pane.bottom || bar.bottom <= pane.top, JSON.stringify({ pane, bar }))
      for (const fact of await boxes('#facts > *')) assert.ok(fact.left >= 0 && fact.right <= width && fact.bottom <= height, JSON.stringify(fact))
    }, { context: { viewport: { width, height } } }))

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
    for (const [x, y] of [
      [30, 6],
      [34, 6],
      [34, 8],
    ])
      await click(page, x, y)
    await page.keyboard.press('Enter')
    assert.equal(await blockAt(page, 33, 6.5), 102)
    await page.locator('#check').click()
    await message(page, /No mismatch/)
  }))

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

test('everything by keyboard, and every control has a name', () =>
  browser.onPage(async (page) => {
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll('button, input, canvas')]
        .filter(
          (each) =>
            !(
              each.ariaLabel ||
              each.textContent.trim() ||
              each.labels?.[0]?.textContent.trim() ||
              each.closest('[aria-label]')
            ),
        )
        .map((each) => each.outerHTML),
    )
    assert.deepEqual(nameless, [])
    await tool(page, 'dig')
    const reached = new Set()
    for (let k = 0; k < 40; ++k) {
      await page.keyboard.press('Tab')
      reached.add(
        await page.evaluate(
          () => document.activeElement.id || document.activeElement.name || document.activeElement.tagName,
        ),
      )
    }
    for (const id of ['CANVAS', 'tool', 'size', 'play', 'step', 'slow', 'restart', 'view', 'overlay', 'copy', 'share', 'open', 'check', 'help'])
      assert.ok(reached.has(id), id)
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
    for (const [key, name] of [['p', 'paint'], ['t', 'tile'], ['v', 'hand'], ['c', 'car']]) {
      await page.keyboard.press(key)
      assert.ok(await page.locator(`input[name=tool][value=${name}]`).isChecked())
    }
  }))

test('zoom and pan by wheel, by the right button, and by two fingers', () =>
  browser.onPage(async (page) => {
    const unit = () => page.evaluate(() => window.sandbox.toPage(11, 5).x - window.sandbox.toPage(10, 5).x)
    const place = () => page.evaluate(() => window.sandbox.toPage(10, 5))
    const before = await unit()
    const at = await place()
    await page.mouse.move(at.x, at.y)
    await page.mouse.wheel(0, -300)
    await page.waitForFunction(
      (least) => window.sandbox.toPage(11, 5).x - window.sandbox.toPage(10, 5).x > least,
      before * 1.2,
    )
    const zoomed = await place()
    assert.ok(Math.hypot(zoomed.x - at.x, zoomed.y - at.y) < 1, 'the place below the pointer stays')
    await page.mouse.down({ button: 'right' })
    await page.mouse.move(at.x + 50, at.y + 20)
    await page.mouse.up({ button: 'right' })
    const panned = await place()
    assert.ok(Math.abs(panned.x - zoomed.x - 50) < 1 && Math.abs(panned.y - zoomed.y - 20) < 1)
    const ground = await outline(page)
    await page.locator('#pane-0 canvas').evaluate((canvas) => {
      const box = canvas.getBoundingClientRect()
      const touch = (type, pointerId, x) =>
        canvas.dispatchEvent(
          new PointerEvent(type, {
            pointerId,
            pointerType: 'touch',
            clientX: box.left + x,
            clientY: box.top + 30,
            bubbles: true,
          }),
        )
      canvas.setPointerCapture = () => {}
      touch('pointerdown', 7, 100)
      touch('pointerdown', 8, 200)
      touch('pointermove', 8, 300)
      touch('pointerup', 7, 100)
      touch('pointerup', 8, 300)
    })
    assert.ok((await unit()) > before * 2)
    assert.equal(await outline(page), ground, 'two fingers in the air dig nothing')
  }))

test('a phone, the dark, and no motion', () =>
  browser.onPage(
    async (page) => {
      await step(page, 120)
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390)
      await tool(page, 'dig')
      const at = await page.evaluate(() => window.sandbox.toPage(2, 7.5))
      const before = await outline(page)
      await page.touchscreen.tap(at.x, at.y)
      assert.notEqual(await outline(page), before)
    },
    {
      context: {
        viewport: { width: 390, height: 844 },
        hasTouch: true,
        isMobile: true,
        colorScheme: 'dark',
        reducedMotion: 'reduce',
      },
    },
  ))

test('the hand throws a body, and moves the view where there is none; it does the ground no harm', () =>
  browser.onPage(async (page) => {
    await tool(page, 'hand')
    const ground = await outline(page)
    const rider = () =>
      page.evaluate(() => {
        const [body] = window.sandbox.game.sides[0].riders[9].bodies
        const { x, y } = body.getPosition()
        return { x: 4 * x, y: 4 * y, up: body.getLinearVelocity().y }
      })
    const { x, y } = await rider()
    const at = (x, y) => page.evaluate(([x, y]) => window.sandbox.toPage(x, y), [x, y])
    const from = await at(x, y)
    await page.mouse.move(from.x, from.y)
    await page.mouse.down()
    for (let k = 1; k <= 12; ++k) {
      const to = await at(x, y + k / 4)
      await page.mouse.move(to.x, to.y)
      await step(page, 2)
    }
    await page.mouse.up()
    const thrown = await rider()
    assert.ok(thrown.y > y + 1 && thrown.up > 0.3, `at ${thrown.y}, ${thrown.up} m/s upwards`)
    await step(page, 240)
    assert.ok((await rider()).y < thrown.y, 'it falls')
    const before = await at(20, 9)
    await page.mouse.move(before.x, before.y)
    await page.mouse.down()
    await page.mouse.move(before.x + 40, before.y + 10)
    await page.mouse.up()
    const moved = await at(20, 9)
    assert.ok(Math.abs(moved.x - before.x - 40) < 1 && Math.abs(moved.y - before.y - 10) < 1)
    await page.locator('#pane-0 canvas').focus()
    await page.keyboard.press('Control+ArrowRight')
    assert.ok((await at(20, 9)).x < moved.x - 40, 'the view moves by keyboard')
    assert.equal(await outline(page), ground)
  }))

test('undo, and another document, in the middle of a stroke', () =>
  browser.onPage(async (page) => {
    const before = await outline(page)
    await tool(page, 'dig')
    const at = await page.evaluate(() => window.sandbox.toPage(14, 4.5))
    for (const end of [() => page.keyboard.press('Control+z'), () => scene(page, 'anew')]) {
      await page.mouse.move(at.x, at.y)
      await page.mouse.down()
      await page.mouse.move(at.x + 30, at.y)
      await end()
      await page.mouse.move(at.x + 90, at.y)
      await page.mouse.up()
      assert.equal(await outline(page), before)
    }
    assert.match(await page.locator('#removed').textContent(), /^0 removed/)
    assert.match(await page.locator('#times').textContent(), /^Dig/)
  }))

test('who lies still for long comes back; who was dropped stays', () =>
  browser.onPage(async (page) => {
    const count = await page.evaluate(() => {
      const { game } = window.sandbox
      game.removeRiders()
      game.ground.begin()
      game.ground.edit({ kind: 'carve', region: { rings: [[14, 2, 16, 2, 16, 6, 14, 6]] } })
      game.ground.end()
      const start = { kind: 'marble', x: 15, y: 2.5, speed: 0, size: 0.4, colour: 0 }
      game.drop(start)
      game.drop({ ...start, x: 14.5, size: 0.3, stays: true })
      return game.sides[0].riders.length
    })
    assert.equal(count, 2)
    const places = () =>
      page.evaluate(() => window.sandbox.game.sides[0].riders.map(({ bodies }) => 4 * bodies[0].getPosition().x))
    let steps = 0
    for (; steps < 2000 && (await places())[0] > 13; steps += 50) await step(page, 50)
    assert.ok(steps > 400 && steps < 2000, `back after ${steps} steps`)
    const [, stays] = await places()
    assert.ok(stays > 14 && stays < 16, `${stays}`)
  }))

test('a phone on its side shows both worlds, and undo', () =>
  browser.onPage(
    async (page) => {
      const boxes = await page.locator('.pane:visible').evaluateAll((all) => all.map((each) => each.getBoundingClientRect().toJSON()))
      for (const { width, height } of boxes) assert.ok(width > 350 && height > 200, `${width} x ${height}`)
      for (const id of ['undo', 'race']) {
        const box = await page.locator(`#${id}`).boundingBox()
        assert.ok(box.x >= 0 && box.x + box.width <= 844 && box.y >= 0 && box.y + box.height <= 390, id)
      }
    },
    { context: { viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true } },
  ))
